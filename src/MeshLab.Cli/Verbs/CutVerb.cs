using System.CommandLine;
using System.Globalization;
using MeshLab.Cli.Hosting;
using MeshLab.Cutting;
using MeshLab.IO;
using MeshLab.Structure;
using MeshLab.Topology;

namespace MeshLab.Cli.Verbs;

internal sealed class CutVerb : Verb
{
    private readonly Argument<string> input = InputArgument();
    private readonly Argument<string> output = OutputArgument();
    private readonly Option<string?> edges = new("--edges") { Description = "A file with the ends of an edge to cut on each line: i j." };
    private readonly Option<bool> toDisk = new("--to-disk") { Description = "Cut every component open into one disk." };
    private readonly Option<double> opening = new("--opening") { Description = "How far the two sides move apart, each.", DefaultValueFactory = _ => 0 };

    public override string Name => "cut";

    public override string Summary => "Cut a mesh open along edges.";

    public override string Example => "cut models/creature.obj disk.obj --to-disk";

    public override void Configure(Command command)
    {
        command.Arguments.Add(input);
        command.Arguments.Add(output);
        command.Options.Add(edges);
        command.Options.Add(toDisk);
        command.Options.Add(opening);
        command.Options.Add(MeshFiles.Ascii);
        command.Options.Add(MeshFiles.Binary);
    }

    public override void Run(VerbContext context)
    {
        string? file = context.Get(edges);
        if (file is null != context.Get(toDisk))
            throw new UsageException("one of --edges FILE and --to-disk is needed");
        Mesh mesh = context.ReadMesh(context.Get(input));
        IReadOnlyList<Edge> listed = file is null ? [] : ReadEdges(mesh, file);
        EdgeCutResult cut = context.Time(() => EdgeCutting.CutAlong(mesh, file is null ? mesh.FindCutGraph() : listed, context.Get(opening)));
        TopologyReport report = cut.Mesh.ComputeTopology();
        context.WriteMesh(cut.Mesh, context.Get(output));
        context.Result
            .Add("components", report.Components.Count)
            .Add("boundaryLoops", report.BoundaryLoops)
            .Add("genus", report.Genus)
            .Add("eulerCharacteristic", report.EulerCharacteristic)
            .Add("uncut", cut.Uncut.Select(e => (int[])[e.Vertex0.Index, e.Vertex1.Index]));
    }

    private static List<Edge> ReadEdges(Mesh mesh, string file)
    {
        var found = new List<Edge>();
        int number = 0;
        foreach (string line in File.ReadLines(file))
        {
            number++;
            string[] words = line.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
            if (words.Length == 0 || words[0].StartsWith('#'))
                continue;
            if (words.Length != 2 || !IsVertex(words[0], out int a) || !IsVertex(words[1], out int b))
                throw new MeshFormatException(file, number, 1, $"'{line}'", $"two vertices from 0 to {mesh.VertexSlots - 1}");
            Edge edge = mesh.FindEdge(mesh.Vertices[a], mesh.Vertices[b]);
            if (edge.IsNone)
                throw new MeshFormatException(file, number, 1, $"'{line}'", "the two ends of an edge");
            found.Add(edge);
        }
        return found;

        bool IsVertex(string word, out int index) =>
            int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out index) && index < mesh.VertexSlots;
    }
}
