using System.CommandLine;
using System.Globalization;
using MeshLab.Cli.Hosting;
using MeshLab.Cli.Values;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Cli.Verbs;

internal sealed class RenderVerb : Verb
{
    private readonly Argument<string> input = InputArgument();
    private readonly Argument<string> output = new("OUTPUT") { Description = "The picture to write (.png)." };
    private readonly Option<string> size = new("--size") { Description = "Width and height in pixels, as 900x700.", DefaultValueFactory = _ => "900x700" };
    private readonly Option<string?> values = new("--values") { Description = "Paint a value: any name of 'values --of'." };
    private readonly Option<bool> wireframe = new("--wireframe") { Description = "Draw the edges." };
    private readonly Option<bool> flat = new("--flat") { Description = "Flat faces instead of a smooth surface." };
    private readonly Option<string> view = new("--view") { Description = "Azimuth and elevation in degrees.", DefaultValueFactory = _ => "30,20" };
    private readonly Option<string> up = new("--up") { Description = "The axis that points up.", DefaultValueFactory = _ => "z" };
    private readonly Option<string?> labels = new("--labels") { Description = "A file with one whole number per face, to paint." };

    public override string Name => "render";

    public override string Summary => "Draw a mesh to a PNG file.";

    public override string Example => "render models/creature.obj creature.png --values valence --wireframe";

    public override void Configure(Command command)
    {
        command.Arguments.Add(input);
        command.Arguments.Add(output);
        up.AcceptOnlyFromAmong("y", "z");
        values.CompletionSources.Add([.. MeshValue.All.Keys]);
        foreach (Option option in new Option[] { size, values, wireframe, flat, view, up, labels, ValueArguments.From, ValueArguments.Fixed, ValueArguments.Angle })
            command.Options.Add(option);
    }

    public override void Run(VerbContext context)
    {
        string path = context.Get(output);
        if (!path.EndsWith(".png", StringComparison.OrdinalIgnoreCase))
            throw new UsageException($"{path}: render writes .png files");
        int[] pixels = Integers(context.Get(size), 'x', "--size");
        double[] angles = Numbers(context.Get(view), "--view");
        if (context.Get(values) is not null && context.Get(labels) is not null)
            throw new UsageException("--values and --labels exclude each other");
        MeshValue? value = context.Get(values) is { } name ? MeshValue.Named(name) : null;

        Mesh mesh = context.ReadMesh(context.Get(input));
        Image image = context.Time(() =>
        {
            var options = new RenderOptions
            {
                Width = pixels[0],
                Height = pixels[1],
                Wireframe = context.Get(wireframe),
                Shading = context.Get(flat) ? Shading.Flat : Shading.Smooth,
                View = new View(angles[0], angles[1]) { Up = context.Get(up) == "y" ? UpAxis.Y : UpAxis.Z },
                Coloring = ColoringOf(mesh, value, context),
            };
            context.CancellationToken.ThrowIfCancellationRequested();
            return MeshRenderer.Render(mesh, options);
        });
        image.SavePng(path);
        context.Result.Add("width", pixels[0]).Add("height", pixels[1]);
    }

    private Coloring ColoringOf(Mesh mesh, MeshValue? value, VerbContext context)
    {
        if (context.Get(labels) is { } file)
            return Coloring.FaceLabels(ReadLabels(file, mesh), "label");
        return value is null ? ColoringOfFile(mesh) : ValueColoring.Of(mesh, value, ValueArguments.Parse(context));
    }

    /// <summary>The colours that the file has itself.</summary>
    private static Coloring ColoringOfFile(Mesh mesh)
    {
        if (mesh.TryGetVertexTrait(TraitNames.Color, out VertexTrait<Color>? ofVertices))
            return Coloring.VertexColors(ofVertices.Values.ToArray());
        return mesh.TryGetFaceTrait(TraitNames.Color, out FaceTrait<Color>? ofFaces) ? Coloring.FaceColors(ofFaces.Values.ToArray()) : Coloring.Default;
    }

    private static int[] ReadLabels(string file, Mesh mesh)
    {
        var read = new List<int>();
        int line = 0;
        foreach (string text in File.ReadLines(file))
        {
            line++;
            if (text.Trim().Length == 0)
                continue;
            if (!int.TryParse(text.Trim(), CultureInfo.InvariantCulture, out int label))
                throw new IO.MeshFormatException(file, line, 1, $"'{text.Trim()}'", "a whole number");
            read.Add(label);
        }
        if (read.Count != mesh.Faces.Count)
            throw new IO.MeshFormatException(file, line, 1, $"{read.Count} labels", $"{mesh.Faces.Count}, one per face");
        return [.. read];
    }

    private static int[] Integers(string text, char separator, string option)
    {
        string[] words = text.Split(separator);
        if (words.Length != 2 || !words.All(word => int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out _)))
            throw new UsageException($"{option} {text}: expected two whole numbers with '{separator}' between them");
        return [.. words.Select(word => int.Parse(word, CultureInfo.InvariantCulture))];
    }

    private static double[] Numbers(string text, string option)
    {
        string[] words = text.Split(',');
        if (words.Length != 2 || !words.All(word => double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out _)))
            throw new UsageException($"{option} {text}: expected two numbers with a comma between them");
        return [.. words.Select(word => double.Parse(word, CultureInfo.InvariantCulture))];
    }
}
