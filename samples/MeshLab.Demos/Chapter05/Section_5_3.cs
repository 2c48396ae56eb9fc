using MeshLab.Demos.Hosting;
using MeshLab.Neighborhoods;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter05;

/// <summary>§5.3 面的邻域: the faces that share an edge or a vertex with a face, and the ring around it.</summary>
[Demo("5.3", "面的邻域", "Around a face")]
public static class Section_5_3
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Face face = Closeup.InnerVertex(mesh).IncidentFaces[0];
        output.Table(
            $"around {face} of {string.Join(", ", face.Vertices)}",
            ("sharing an edge", string.Join(" ", face.FacesSharingEdge)),
            ("sharing a vertex", string.Join(" ", face.FacesSharingVertex)),
            ("ring vertices", string.Join(" ", face.RingVertices)),
            ("ring edges", string.Join(" ", face.RingEdges)));
        Closeup.Show(
            output,
            "face and its ring",
            face.AsGroup(),
            2,
            [("the face", [face]), ("sharing a vertex", face.FacesSharingVertex), ("sharing an edge", face.FacesSharingEdge)],
            (Closeup.Red, face.RingEdges));
    }
}
