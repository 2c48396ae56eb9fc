using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter10;

/// <summary>§10.3 面法向: unit normals of faces; a face of zero area has the null vector, and is counted.</summary>
[Demo("10.3", "面法向", "Face normals")]
public static class Section_10_3
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Vector3D[] normals = mesh.ComputeFaceNormals(out int zeroAreaFaces);
        Vector3D sum = default;
        foreach (Face f in mesh.Faces)
            sum += f.Area * normals[f.Index];
        output.Table(
            "face normals",
            ("faces", mesh.Faces.Count),
            ("of zero area, without a normal", zeroAreaFaces),
            ("Σ area · normal", sum),
            ("that is 0 on closed surfaces", mesh.IsClosed ? $"of an area of {mesh.Area:G6}" : "this one is open"));

        // A few hundred are enough to see them.
        int step = Math.Max(1, mesh.Faces.Count / 700);
        double length = 0.035 * mesh.BoundingBox.Diagonal;
        output.Picture("normals", mesh, new RenderOptions
        {
            Shading = Shading.Flat,
            Coloring = Coloring.FaceColors(Array.ConvertAll(normals, AsColor), "normal", [.. Axes.SelectMany(axis => new LegendEntry[]
            {
                new($"+{axis.Name}", AsColor(axis.Direction)), new($"-{axis.Name}", AsColor(-axis.Direction)),
            })]),
            Polylines = [.. mesh.Faces.Where(f => f.Index % step == 0).Select(f => new Polyline([f.Barycenter, f.Barycenter + (length * normals[f.Index])], new Color(0.1f, 0.1f, 0.1f), 1.2))],
        });
    }

    private static IEnumerable<(string Name, Vector3D Direction)> Axes => [("x", Vector3D.UnitX), ("y", Vector3D.UnitY), ("z", Vector3D.UnitZ)];

    private static Color AsColor(Vector3D normal) => new((float)(normal.X + 1) / 2, (float)(normal.Y + 1) / 2, (float)(normal.Z + 1) / 2);
}
