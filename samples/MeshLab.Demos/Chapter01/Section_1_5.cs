using MeshLab.Demos.Hosting;
using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter01;

/// <summary>§1.5 半边结构的实现: the nine relations at one face, traits of the book and own ones, and an operation undone.</summary>
[Demo("1.5", "半边结构的实现", "Relations, traits, undo")]
public static class Section_1_5
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Face f = mesh.Faces.First();
        Edge e = f.HalfEdge.Edge;
        Vertex v = f.HalfEdge.Source;
        output.Table(
            $"the nine relations at {f}, {e}, {v}",
            ["", "vertices", "edges", "faces"],
            [
                [$"of {v}", string.Join(" ", v.Neighbors), string.Join(" ", v.Edges), string.Join(" ", v.Faces)],
                [$"of {e}", string.Join(" ", e.Vertices), string.Join(" ", e.Neighbors), string.Join(" ", e.Faces)],
                [$"of {f}", string.Join(" ", f.Vertices), string.Join(" ", f.Edges), string.Join(" ", f.Neighbors)],
            ]);

        // The book's traits are there when first written; own ones say how an operation blends them.
        v.Traits.SelectedFlag = 1;
        VertexTrait<double> height = mesh.AddVertexTrait<double>("height", 0, Blend.Linear);
        foreach (Vertex w in mesh.Vertices)
            height[w] = w.Position.Z;

        ulong before = mesh.StateHash();
        using OperationHistory history = mesh.StartRecording();
        (double start, double end) = (height[e.Vertex0], height[e.Vertex1]);
        Vertex m = e.Split(Vector3D.Lerp(e.Vertex0.Position, e.Vertex1.Position, 0.25));
        output.Line($"{e} split at a quarter: {m} has height {height[m]:G6}, a quarter of the way from {start:G6} to {end:G6}");
        history.UndoAll();
        output.Line($"undone, to the last bit: {(mesh.StateHash() == before ? "yes" : "no")}");
        output.Picture("model", mesh);
    }
}
