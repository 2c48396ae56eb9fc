using System.CommandLine;
using System.Globalization;
using System.Text;
using MeshLab.Cli.Hosting;
using MeshLab.Cutting;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Cli.Verbs;

internal sealed class SectionVerb : Verb
{
    private readonly Argument<string> input = InputArgument();
    private readonly Argument<string?> output = new("OUTPUT") { Description = "Where the lines are written: .svg or .obj.", Arity = ArgumentArity.ZeroOrOne };
    private readonly Option<string> plane = PlaneArgument.Option();
    private readonly Option<double> tolerance = new("--tolerance") { Description = "Vertices within this distance count as on the plane." };

    public override string Name => "section";

    public override string Summary => "Cut a mesh by a plane and measure or draw the lines.";

    public override string Example => "section models/creature.obj creature-section.svg --plane 0,0,1,0.1";

    public override void Configure(Command command)
    {
        command.Arguments.Add(input);
        command.Arguments.Add(output);
        command.Options.Add(plane);
        command.Options.Add(tolerance);
    }

    public override void Run(VerbContext context)
    {
        CuttingPlane cut = PlaneArgument.Parse(context.Get(plane));
        if (context.Get(tolerance) < 0)
            throw new UsageException("--tolerance must not be negative");
        string? path = context.Get(output);
        bool svg = path?.EndsWith(".svg", StringComparison.OrdinalIgnoreCase) == true;
        if (path is not null && !svg && !path.EndsWith(".obj", StringComparison.OrdinalIgnoreCase))
            throw new UsageException($"{path}: lines are written as .svg or .obj");
        Mesh mesh = PlaneArgument.Triangles(context.ReadMesh(context.Get(input)));
        PlaneSectionResult section = context.Time(() => mesh.ComputeSection(cut, context.Get(tolerance)));
        if (path is not null)
            Write(path, svg ? ToSvg(section) : ToObj(section));
        context.Result
            .Add("length", section.Length)
            .Add("segments", section.Segments)
            .Add("closedLoops", section.ClosedLoops)
            .Add("openChains", section.OpenChains)
            .Add("area", section.Area)
            .Add("polylines", section.Polylines.Select(line => new ResultFields()
                .Add("closed", line.IsClosed).Add("points", line.Points.Count).Add("length", line.Length).Add("area", line.Area)
                .Add("parent", line.Parent).Add("depth", line.Depth)));
    }

    private static string ToSvg(PlaneSectionResult section)
    {
        Vector3D origin = section.Plane.Normal * section.Plane.Offset;
        Vector2D[] Flat(SectionPolyline line) => SvgPolylines.ToPlane(line.Points, origin, section.Plane.Normal);
        return new SvgPolylines().ToSvg(
            [.. section.Polylines.Where(line => line.IsClosed).Select(Flat)],
            [.. section.Polylines.Where(line => !line.IsClosed).Select(Flat)]);
    }

    private static string ToObj(PlaneSectionResult section)
    {
        var text = new StringBuilder();
        int first = 1;
        foreach (SectionPolyline line in section.Polylines)
        {
            foreach (Vector3D p in line.Points)
                text.Append(CultureInfo.InvariantCulture, $"v {p.X:R} {p.Y:R} {p.Z:R}\n");
            text.Append('l');
            for (int i = 0; i < line.Points.Count; i++)
                text.Append(CultureInfo.InvariantCulture, $" {first + i}");
            text.Append(line.IsClosed ? string.Create(CultureInfo.InvariantCulture, $" {first}\n") : "\n");
            first += line.Points.Count;
        }
        return text.ToString();
    }

    private static void Write(string path, string text)
    {
        string temporary = path + ".part";
        File.WriteAllText(temporary, text);
        File.Move(temporary, path, overwrite: true);
    }
}
