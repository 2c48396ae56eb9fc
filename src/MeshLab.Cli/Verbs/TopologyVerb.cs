using System.CommandLine;
using System.Globalization;
using MeshLab.Cli.Hosting;
using MeshLab.Structure;
using MeshLab.Topology;

namespace MeshLab.Cli.Verbs;

internal sealed class TopologyVerb : Verb
{
    private readonly Argument<string> input = InputArgument();
    private readonly Option<bool> generators = new("--generators") { Description = "List 2g independent loops, by tree and cotree." };
    private readonly Option<bool> shorten = new("--shorten") { Description = "Choose and shorten the generators for length." };
    private readonly Option<bool> cutGraph = new("--cut-graph") { Description = "List the edges along which every component opens into a disk." };

    public override string Name => "topology";

    public override string Summary => "Components, Euler characteristic, boundary loops, genus; generators and cut graph.";

    public override string Example => "topology models/creature.obj --generators";

    public override void Configure(Command command)
    {
        command.Arguments.Add(input);
        command.Options.Add(generators);
        command.Options.Add(shorten);
        command.Options.Add(cutGraph);
    }

    public override void Run(VerbContext context)
    {
        Mesh mesh = context.ReadMesh(context.Get(input));
        TopologyReport report = context.Time(mesh.ComputeTopology);
        context.Result
            .Add("components", report.Components.Select(Fields))
            .Add("eulerCharacteristic", report.EulerCharacteristic)
            .Add("boundaryLoops", report.BoundaryLoops)
            .Add("genus", report.Genus);
        if (context.Get(generators))
        {
            var options = new HomologyOptions { Shorten = context.Get(shorten) };
            IReadOnlyList<MeshLoop> loops = context.Time(() => HomologyGenerators.Compute(mesh, options, context.CancellationToken));
            context.Result
                .Add("generators", loops.Select(loop => (int[])[.. loop.Vertices.Select(v => v.Index)]))
                .Add("generatorLengths", (double[])[.. loops.Select(loop => loop.Length)]);
        }
        if (context.Get(cutGraph))
        {
            Edge[] cut = context.Time(mesh.FindCutGraph);
            context.Result.Add("cutGraph", cut
                .Select(e => (Low: Math.Min(e.Vertex0.Index, e.Vertex1.Index), High: Math.Max(e.Vertex0.Index, e.Vertex1.Index)))
                .Order()
                .Select(pair => (int[])[pair.Low, pair.High]));
        }
        context.Table("Components", ["first vertex", "V", "E", "F", "χ", "loops", "genus"], report.Components.Take(50).Select(Row));
        context.Table("Euler's theorem", [""], [[report.ToString()]]);
    }

    private static ResultFields Fields(ComponentTopology c) => new ResultFields()
        .Add("firstVertex", c.FirstVertex)
        .Add("vertices", c.Vertices)
        .Add("edges", c.Edges)
        .Add("faces", c.Faces)
        .Add("eulerCharacteristic", c.EulerCharacteristic)
        .Add("boundaryLoops", c.BoundaryLoops)
        .Add("genus", c.Genus);

    /// <summary>A component as a row of a table for people.</summary>
    internal static IReadOnlyList<string> Row(ComponentTopology c) => [.. new[]
    {
        c.FirstVertex, c.Vertices, c.Edges, c.Faces, c.EulerCharacteristic, c.BoundaryLoops, c.Genus,
    }.Select(n => n.ToString(CultureInfo.InvariantCulture))];
}
