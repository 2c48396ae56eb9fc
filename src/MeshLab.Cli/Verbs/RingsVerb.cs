using System.CommandLine;
using MeshLab.Cli.Hosting;
using MeshLab.Neighborhoods;
using MeshLab.Structure;

namespace MeshLab.Cli.Verbs;

internal sealed class RingsVerb : Verb
{
    private readonly Argument<string> input = InputArgument();
    private readonly Option<int?> vertex = new("--vertex") { Description = "The vertex asked for." };
    private readonly Option<int?> edge = new("--edge") { Description = "The edge asked for; edges are numbered by first appearance in the file." };
    private readonly Option<int?> face = new("--face") { Description = "The face asked for." };
    private readonly Option<int> rings = new("--k") { Description = "How many edges away the ring is.", DefaultValueFactory = _ => 1 };

    public override string Name => "rings";

    public override string Summary => "List what surrounds a vertex, an edge or a face.";

    public override string Example => "rings models/creature.obj --vertex 10 --k 2";

    public override void Configure(Command command)
    {
        command.Arguments.Add(input);
        command.Options.Add(vertex);
        command.Options.Add(edge);
        command.Options.Add(face);
        command.Options.Add(rings);
    }

    public override void Run(VerbContext context)
    {
        int? v = context.Get(vertex), e = context.Get(edge), f = context.Get(face);
        if (new[] { v, e, f }.Count(index => index is not null) != 1)
            throw new UsageException("one of --vertex, --edge, --face is needed");
        int k = context.Get(rings);
        if (k < 0)
            throw new UsageException($"--k {k}: the number of rings is 0 or more");
        Mesh mesh = context.ReadMesh(context.Get(input));
        context.Time(() =>
        {
            if (v is not null)
                OfVertex(context.Result, mesh.Vertices[Checked(v.Value, mesh.VertexSlots, "--vertex")], k);
            else if (e is not null)
                OfEdge(context.Result, mesh.Edges[Checked(e.Value, mesh.EdgeSlots, "--edge")], k);
            else
                OfFace(context.Result, mesh.Faces[Checked(f!.Value, mesh.FaceSlots, "--face")], k);
        });
    }

    private static void OfVertex(ResultFields result, Vertex v, int k)
    {
        result.Add("vertex", v.Index).Add("k", k).Add("vertices", Indices(v.RingVertices));
        AddEdges(result, "spokeEdges", v.SpokeEdges);
        AddEdges(result, "linkEdges", v.LinkEdges);
        result.Add("faces", Indices(v.IncidentFaces)).Add("ring", Indices(v.Ring(k))).Add("disk", Indices(v.Disk(k)));
    }

    private static void OfEdge(ResultFields result, Edge e, int k)
    {
        result.Add("edge", e.Index).Add("ends", (int[])[e.Vertex0.Index, e.Vertex1.Index]).Add("k", k).Add("vertices", Indices(e.LoopVertices));
        AddEdges(result, "loopEdges", e.LoopEdges);
        result.Add("faces", Indices(e.TouchingFaces)).Add("ring", Indices(e.Ring(k))).Add("disk", Indices(e.AsGroup().Disk(k)));
    }

    private static void OfFace(ResultFields result, Face f, int k)
    {
        result
            .Add("face", f.Index)
            .Add("k", k)
            .Add("facesSharingVertex", Indices(f.FacesSharingVertex))
            .Add("facesSharingEdge", Indices(f.FacesSharingEdge))
            .Add("vertices", Indices(f.RingVertices));
        AddEdges(result, "ringEdges", f.RingEdges);
        result.Add("ring", Indices(f.Ring(k))).Add("disk", Indices(f.AsGroup().Disk(k)));
    }

    /// <summary>Edges by index, and by their ends for those who number them otherwise.</summary>
    private static void AddEdges(ResultFields result, string name, Edge[] edges) => result
        .Add(name, (int[])[.. edges.Select(e => e.Index)])
        .Add(name + "Pairs", edges
            .Select(e => (Low: Math.Min(e.Vertex0.Index, e.Vertex1.Index), High: Math.Max(e.Vertex0.Index, e.Vertex1.Index)))
            .Order()
            .Select(pair => (int[])[pair.Low, pair.High]));

    private static int[] Indices(Vertex[] vertices) => Array.ConvertAll(vertices, v => v.Index);

    private static int[] Indices(Face[] faces) => Array.ConvertAll(faces, f => f.Index);

    private static int Checked(int index, int count, string option) => index >= 0 && index < count
        ? index
        : throw new UsageException($"{option} {index}: there are 0 to {count - 1}");
}
