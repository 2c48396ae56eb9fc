using MeshLab.Demos.Hosting;
using MeshLab.Generation;
using MeshLab.Structure;
using MeshLab.Subdivision;

namespace MeshLab.Demos.Chapter08;

/// <summary>§8.4 效果比较: the schemes side by side, in numbers and pictures.</summary>
[Demo("8.4", "效果比较", "The schemes compared")]
public static class Section_8_4
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh coarse = Coarse.Of(mesh);
        Show(output, "triangle schemes, three steps", SchemeComparison.Compare(coarse, 3));
        Show(output, "polygon schemes on a cube, three steps", SchemeComparison.Compare(Polyhedra.Cube(), 3, SubdivisionScheme.CatmullClark, SubdivisionScheme.DooSabin));
    }

    private static void Show(DemoOutput output, string title, IReadOnlyList<SchemeResult> results)
    {
        output.Table(
            title,
            ["scheme", "V", "F", "area", "volume", "rms bend (rad)", "to the limit", "shrinkage"],
            results.Select(r => new object[]
            {
                r.Scheme, r.Mesh.Vertices.Count, r.Mesh.Faces.Count, r.Area, r.Volume, r.Bend, r.DistanceToLimit, r.Shrinkage,
            }));
        foreach (SchemeResult r in results)
            output.Picture(r.Scheme.ToString(), r.Mesh);
    }
}
