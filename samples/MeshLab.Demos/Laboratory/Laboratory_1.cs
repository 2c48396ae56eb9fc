using MeshLab.Demos.Hosting;
using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Laboratory;

/// <summary>L1 局部操作: flip, split and collapse, inside and on the boundary; what is refused leaves the mesh untouched.</summary>
[Demo("L1", "局部操作", "Local operations")]
public static class Laboratory_1
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        var rows = new List<object[]>();
        Try("flip", "an edge inside", Patch(), p => Flip(p.FindEdge(p.Vertices[6], p.Vertices[12])));
        Try("flip", "an edge of the boundary", Patch(), p => Flip(p.FindEdge(p.Vertices[1], p.Vertices[2])));
        Try("flip", "an edge of a tetrahedron", Tetrahedron(), p => Flip(p.Edges[0]));
        Try("split", "an edge inside", Patch(), p => p.FindEdge(p.Vertices[6], p.Vertices[12]).Split());
        Try("split", "an edge of the boundary", Patch(), p => p.FindEdge(p.Vertices[1], p.Vertices[2]).Split());
        Try("collapse", "an edge inside", Patch(), p => Collapse(p.FindHalfEdge(p.Vertices[6], p.Vertices[12])));
        Try("collapse", "an edge of the boundary", Patch(), p => Collapse(p.FindHalfEdge(p.Vertices[1], p.Vertices[2])));
        Try("collapse", "from the boundary inwards", Patch(), p => Collapse(p.FindHalfEdge(p.Vertices[0], p.Vertices[6])));
        Try("collapse", "an edge inside between two boundary vertices", Patch(), p => Collapse(p.FindHalfEdge(p.Vertices[3], p.Vertices[9])));
        Try("collapse", "an edge of a tetrahedron", Tetrahedron(), p => Collapse(p.HalfEdges[0]));
        output.Table("on a grid of 4 × 4, and on a tetrahedron", ["operation", "on", "result", "vertices", "edges", "faces"], rows);

        OnTheModel(mesh, output);

        void Try(string operation, string place, Mesh patch, Func<Mesh, object> act)
        {
            object result = act(patch);
            rows.Add([operation, place, result, patch.Vertices.Count, patch.Edges.Count, patch.Faces.Count]);
            output.Picture($"{rows.Count}-{operation}", patch, new RenderOptions { Wireframe = true, View = patch.IsClosed ? new View() : new View(0, 89) });
        }
    }

    private static object Flip(Edge edge) => edge.TryFlip(out FlipRefusal why) ? "done" : why;

    private static object Collapse(HalfEdge h) => h.TryCollapse(Middle(h.Edge), out CollapseRefusal why) ? "done" : why;

    /// <summary>Every hundredth edge of the model: flipped, split and collapsed, and all taken back.</summary>
    private static void OnTheModel(Mesh mesh, DemoOutput output)
    {
        ulong before = mesh.StateHash();
        int flips = 0, splits = 0, collapses = 0, refused = 0;
        using OperationHistory history = mesh.StartRecording();
        for (int e = 0, edges = mesh.EdgeSlots; e < edges; e += 100)
        {
            if (mesh.IsDeletedEdge(e))
                continue;
            switch (e / 100 % 3)
            {
                case 0:
                    Count(mesh.Edges[e].TryFlip(out _), ref flips);
                    break;
                case 1:
                    Count(mesh.Edges[e].TrySplit(Middle(mesh.Edges[e]), out _, out _), ref splits);
                    break;
                default:
                    Count(mesh.Edges[e].HalfEdge0.TryCollapse(Middle(mesh.Edges[e]), out _), ref collapses);
                    break;
            }
        }
        output.Line($"on the model: {flips} flips, {splits} splits, {collapses} collapses, {refused} refused; rules broken: {mesh.Validate().Count}");
        output.Picture("model", mesh);
        history.UndoAll();
        output.Line($"taken back, the mesh is the same to the last bit: {mesh.StateHash() == before}");

        void Count(bool done, ref int counter)
        {
            counter += done ? 1 : 0;
            refused += done ? 0 : 1;
        }
    }

    private static Vector3D Middle(Edge edge) => (edge.Vertex0.Position + edge.Vertex1.Position) * 0.5;

    private static Mesh Patch()
    {
        const int N = 4;
        var builder = new MeshBuilder();
        for (int i = 0; i <= N; i++)
        {
            for (int j = 0; j <= N; j++)
                builder.AddVertex(new(j, i, 0));
        }
        for (int i = 0; i < N; i++)
        {
            for (int j = 0; j < N; j++)
            {
                int a = i * (N + 1) + j, b = a + 1, c = a + N + 1, d = c + 1;
                builder.AddFace(a, b, d);
                builder.AddFace(a, d, c);
            }
        }
        return builder.Build();
    }

    private static Mesh Tetrahedron() => MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 0, 0), new(0, 1, 0), new(0, 0, 1)], [0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2]);
}
