using System.CommandLine;
using MeshLab.Cli.Hosting;
using MeshLab.Cli.Values;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Cli.Verbs;

internal sealed class ValuesVerb : Verb
{
    private readonly Argument<string> input = InputArgument();
    private readonly Option<string> of = new("--of") { Description = $"Which value: {string.Join(" ", MeshValue.All.Keys)}.", Required = true };

    public override string Name => "values";

    public override string Summary => "Print a value of every vertex, edge, face or corner.";

    public override string Example => "values models/creature.obj --of valence --json";

    public override void Configure(Command command)
    {
        command.Arguments.Add(input);
        of.CompletionSources.Add([.. MeshValue.All.Keys]);
        command.Options.Add(of);
        command.Options.Add(ValueArguments.From);
        command.Options.Add(ValueArguments.Fixed);
        command.Options.Add(ValueArguments.Angle);
    }

    public override void Run(VerbContext context)
    {
        MeshValue value = MeshValue.Named(context.Get(of));
        ValueOptions options = ValueArguments.Parse(context);
        Mesh mesh = context.ReadMesh(context.Get(input));

        double[] flat = context.Time(() => value.Components == 1 ? value.Scalars(mesh, options) : Flatten(value.Vectors(mesh, options)));
        (string element, int[] order) = Order(mesh, value.Mark.Kind);
        int components = value.Components;
        var values = new double[order.Length * components];
        int skipped = 0;
        for (int i = 0; i < order.Length; i++)
        {
            Array.Copy(flat, order[i] * components, values, i * components, components);
            if (IsUnused(mesh, value.Mark.Kind, order[i]))
                skipped++;
        }

        context.Result
            .Add("value", value.Mark.Name)
            .Add("element", element)
            .Add("count", order.Length)
            .Add("components", components);
        if (value.Mark.Kind == ElementKind.Edge)
            context.Result.Add("pairs", Pairs(mesh, order));
        mesh.ComputeFaceNormals(out int zeroAreaFaces);
        context.Result.Add("values", values).Add("skipped", skipped).Add("zeroAreaFaces", zeroAreaFaces);
    }

    /// <summary>The slots in the order of the contract: vertices and faces as in the file, corners face by face, edges by their smaller, then larger vertex.</summary>
    private static (string Element, int[] Order) Order(Mesh mesh, ElementKind kind)
    {
        switch (kind)
        {
            case ElementKind.Vertex:
                return ("vertex", [.. mesh.Vertices.Select(v => v.Index)]);
            case ElementKind.Face:
                return ("face", [.. mesh.Faces.Select(f => f.Index)]);
            case ElementKind.HalfEdge:
                // The corner at a face's vertex is kept at the half-edge that points to it.
                return ("corner", [.. mesh.Faces.SelectMany(f => f.HalfEdges.Select(h => h.Previous.Index))]);
            default:
                int[] edges = [.. mesh.Edges.Select(e => e.Index)];
                long[] keys = Array.ConvertAll(edges, e => Key(mesh.Edges[e]));
                Array.Sort(keys, edges);
                return ("edge", edges);
        }
    }

    private static long Key(Edge e)
    {
        int a = e.Vertex0.Index, b = e.Vertex1.Index;
        return ((long)Math.Min(a, b) << 32) | (uint)Math.Max(a, b);
    }

    private static IEnumerable<int[]> Pairs(Mesh mesh, int[] edges) => edges.Select(e =>
    {
        long key = Key(mesh.Edges[e]);
        return (int[])[(int)(key >> 32), (int)key];
    });

    private static bool IsUnused(Mesh mesh, ElementKind kind, int slot) => kind == ElementKind.Vertex && mesh.Outgoing[slot] < 0;

    private static double[] Flatten(Vector3D[] vectors)
    {
        var flat = new double[3 * vectors.Length];
        for (int i = 0; i < vectors.Length; i++)
            (flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]) = vectors[i];
        return flat;
    }
}
