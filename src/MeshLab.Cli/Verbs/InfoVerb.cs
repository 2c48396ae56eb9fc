using System.CommandLine;
using System.Globalization;
using MeshLab.Cli.Hosting;
using MeshLab.Geometry;
using MeshLab.Neighborhoods;
using MeshLab.Structure;
using MeshLab.Topology;

namespace MeshLab.Cli.Verbs;

internal sealed class InfoVerb : Verb
{
    private readonly Argument<string> input = InputArgument();

    public override string Name => "info";

    public override string Summary => "Count and measure a mesh: topology, area, volume, lengths, angles.";

    public override string Example => "info models/creature.obj";

    public override void Configure(Command command) => command.Arguments.Add(input);

    public override void Run(VerbContext context)
    {
        Mesh mesh = context.ReadMesh(context.Get(input));
        (TopologyReport topology, MeshMeasures measures, int boundaryEdges) =
            context.Time(() => (mesh.ComputeTopology(), MeshMeasures.Of(mesh), mesh.BoundaryEdges.Length));
        context.Result
            .Add("vertices", mesh.Vertices.Count)
            .Add("edges", mesh.Edges.Count)
            .Add("faces", mesh.Faces.Count)
            .Add("halfEdges", mesh.HalfEdges.Count)
            .Add("isolatedVertices", topology.IsolatedVertices)
            .Add("components", topology.Components.Count)
            .Add("boundaryLoops", topology.BoundaryLoops)
            .Add("boundaryEdges", boundaryEdges)
            .Add("eulerCharacteristic", topology.EulerCharacteristic)
            .Add("genus", topology.Genus)
            .Add("isClosed", mesh.IsClosed)
            .Add("isTriangleMesh", mesh.IsTriangleMesh)
            .Add("faceDegrees", Histogram(measures.FaceDegrees))
            .Add("area", measures.Mass.Area)
            .Add("volume", measures.Mass.Volume)
            .Add("centroidSurface", measures.Mass.SurfaceCentroid)
            .Add("centroidVolume", measures.Mass.VolumeCentroid)
            .Add("boundingBox", new ResultFields()
                .Add("min", measures.BoundingBox.Min)
                .Add("max", measures.BoundingBox.Max)
                .Add("diagonal", measures.BoundingBox.Diagonal))
            .Add("edgeLength", Range(measures.EdgeLength))
            .Add("valence", Range(measures.Valence).Add("histogram", Histogram(measures.ValenceHistogram)))
            .Add("angleDefectSum", measures.AngleDefectSum)
            .Add("dihedral", new ResultFields().Add("min", measures.Dihedral.Min).Add("max", measures.Dihedral.Max))
            .Add("zeroAreaFaces", measures.Mass.ZeroAreaFaces);
        context.Table("Components", ["first vertex", "V", "E", "F", "χ", "loops", "genus"], topology.Components.Take(20).Select(TopologyVerb.Row));
    }

    private static ResultFields Range(ValueRange range) => new ResultFields().Add("min", range.Min).Add("mean", range.Mean).Add("max", range.Max);

    private static ResultFields Histogram(IReadOnlyDictionary<int, int> histogram)
    {
        var fields = new ResultFields();
        foreach ((int n, int count) in histogram)
            fields.Add(n.ToString(CultureInfo.InvariantCulture), count);
        return fields;
    }
}
