using MeshLab.Curvature;
using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter10;

/// <summary>§10.8 主曲率: four ways to the principal curvatures, their directions, and the textbook's traits.</summary>
[Demo("10.8", "主曲率", "Principal curvatures and directions")]
public static class Section_10_8
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh triangles = mesh.IsTriangleMesh ? mesh : Triangulation.Triangulate(mesh).Mesh;
        foreach (PrincipalCurvatureMethod method in Enum.GetValues<PrincipalCurvatureMethod>())
        {
            PrincipalCurvatures principal = triangles.ComputePrincipalCurvatures(method);
            double[] max = [.. principal.Max.Where(double.IsFinite).Order()], min = [.. principal.Min.Where(double.IsFinite).Order()];
            if (max.Length > 0)
                output.Line($"{method}: medians k1 = {max[max.Length / 2]}, k2 = {min[min.Length / 2]}");
        }

        triangles.WriteCurvatureTraits();
        output.Line($"as traits of {triangles.Vertices[0]}: MaxCurvature {triangles.Vertices[0].Traits.MaxCurvature}, along {triangles.Vertices[0].Traits.MaxCurvatureDirection}");

        PrincipalCurvatures tensor = triangles.ComputePrincipalCurvatures(PrincipalCurvatureMethod.TensorAveraging);
        output.Picture("directions", triangles, new RenderOptions
        {
            Coloring = Coloring.VertexScalars(tensor.Max, ColorMap.Coolwarm, "k1 (tensor)").WithoutOutliers(0.03).Symmetric(),
            Polylines = [.. Strokes(triangles, tensor.MaxDirection, new Color(0.1f, 0.1f, 0.1f))],
        });
    }

    private static IEnumerable<Polyline> Strokes(Mesh mesh, Vector3D[] directions, Color color)
    {
        double half = 0.3 * mesh.MeanEdgeLength;
        int step = Math.Max(1, mesh.Vertices.Count / 4000);
        return mesh.Vertices
            .Where(v => v.Index % step == 0 && directions[v.Index].Length > 0)
            .Select(v => new Polyline([v.Position - directions[v.Index] * half, v.Position + directions[v.Index] * half], color, 1));
    }
}
