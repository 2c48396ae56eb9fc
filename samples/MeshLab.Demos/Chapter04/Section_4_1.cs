using MeshLab.Demos.Hosting;
using MeshLab.Editing;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter04;

/// <summary>§4.1 添加面: takes faces out and puts them back, and asks for faces that cannot be.</summary>
[Demo("4.1", "添加面", "Adding a face")]
public static class Section_4_1
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Vertex center = mesh.Vertices.FirstOrDefault(v => !v.IsBoundary && v.Neighbors.All(w => !w.IsBoundary));
        if (center.IsNone)
        {
            output.Line($"every vertex of this model is on a boundary or beside one, so no star can be taken out and put back");
            output.Picture("model", mesh);
            return;
        }
        Vertex[][] star = [.. center.Faces.Select(f => f.Vertices.ToArray())];
        mesh.DeleteFaces(center.Faces.ToArray(), new RemovalOptions { DeleteOrphans = false });
        output.Line($"{star.Length} faces around {center} taken out; {center} is isolated: {center.IsIsolated}");
        output.Picture("hole", mesh);

        mesh.AddFaces(star);
        output.Line($"put back; {center} has valence {center.Valence}, violated rules: {mesh.Validate().Count}");
        output.Picture("filled", mesh);

        Vertex far = mesh.AddVertex(center.Position * 2);
        mesh.CanAddFace([center, center.Neighbors.First(), far], out AddFaceRefusal why);
        output.Line($"a third face at an inner vertex: {why}");
    }
}
