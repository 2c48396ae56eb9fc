using MeshLab.Demos.Hosting;
using MeshLab.Neighborhoods;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter05;

/// <summary>§5.2 边的邻域 and §5.3 面的邻域: the loop around an edge, and the faces around a face.</summary>
[Demo("5.2", "边和面的邻域", "Around an edge and a face")]
public static class Section_5_2
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Edge edge = mesh.Edges.FirstOrDefault(e => !e.Vertex0.IsBoundary && !e.Vertex1.IsBoundary);
        if (edge.IsNone)
            edge = mesh.Edges.First();
        output.Line($"{edge} joins vertices of valence {edge.Vertex0.Valence} and {edge.Vertex1.Valence}:");
        output.Line($"{edge.LoopEdges.Length} edges in the loop around it, {edge.TouchingFaces.Length} faces touch it.");

        Face face = edge.Face0.IsNone ? edge.Face1 : edge.Face0;
        output.Line($"{face} shares an edge with {face.FacesSharingEdge.Length} faces and a vertex with {face.FacesSharingVertex.Length}.");
        var labels = new int[mesh.FaceSlots];
        Array.Fill(labels, -1);
        foreach (Face f in face.FacesSharingVertex)
            labels[f.Index] = 2;
        foreach (Face f in face.FacesSharingEdge)
            labels[f.Index] = 1;
        labels[face.Index] = 0;
        output.Picture("face", mesh, new RenderOptions
        {
            Coloring = Coloring.FaceLabels(labels, "the face, sharing an edge, sharing a vertex"),
            HighlightedEdges = [new([.. edge.LoopEdges.Select(e => e.Index)], new Color(0.8f, 0.1f, 0.1f))],
        });
    }
}
