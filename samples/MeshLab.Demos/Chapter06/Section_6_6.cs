using MeshLab.Cutting;
using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter06;

/// <summary>§6.6 分割钝角: splits triangles with an angle of more than 120° at the foot of their altitude.</summary>
[Demo("6.6", "分割钝角", "Splitting obtuse triangles")]
public static class Section_6_6
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh split = mesh.IsTriangleMesh ? mesh.Clone() : Triangulation.Triangulate(mesh).Mesh;
        int before = split.Faces.Count;
        ObtuseSplitResult result = split.SplitObtuse(Math.PI * 2 / 3);
        output.Line($"{result.Splits} edges split in {result.Passes} passes: {before} faces became {split.Faces.Count}; {result.Remaining.Count} still have a larger angle. Coloured: the triangles that were split.");
        output.Picture("split", split, Coloring.FaceLabels([.. result.SourceFace.Select(f => f >= 0 && result.Pieces[f].Count > 1 ? 1 : 0)]));
    }
}
