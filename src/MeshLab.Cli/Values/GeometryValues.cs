using MeshLab.Curvature;
using MeshLab.Geometry;
using MeshLab.LinearAlgebra;
using MeshLab.Neighborhoods;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Cli.Values;

/// <summary>Values of chapter 10: areas, normals, angles, curvatures. Vertices without faces have none.</summary>
internal static class GeometryValues
{
    [MeshValue("normal-uniform", ElementKind.Vertex, Signed = true)]
    public static Vector3D[] NormalUniform(Mesh mesh, ValueOptions options) => Normals(mesh, VertexNormalWeight.Uniform);

    [MeshValue("normal-area", ElementKind.Vertex, Signed = true)]
    public static Vector3D[] NormalArea(Mesh mesh, ValueOptions options) => Normals(mesh, VertexNormalWeight.Area);

    [MeshValue("normal-angle", ElementKind.Vertex, Signed = true)]
    public static Vector3D[] NormalAngle(Mesh mesh, ValueOptions options) => Normals(mesh, VertexNormalWeight.Angle);

    [MeshValue("normal-max", ElementKind.Vertex, Signed = true)]
    public static Vector3D[] NormalMax(Mesh mesh, ValueOptions options) => Normals(mesh, VertexNormalWeight.InscribedSphere);

    [MeshValue("mixed-area", ElementKind.Vertex)]
    public static double[] MixedArea(Mesh mesh, ValueOptions options) => OfUsed(mesh, mesh.ComputeMixedAreas());

    [MeshValue("voronoi-area", ElementKind.Vertex)]
    public static double[] VoronoiArea(Mesh mesh, ValueOptions options) => OfUsed(mesh, mesh.ComputeVoronoiAreas());

    [MeshValue("barycentric-area", ElementKind.Vertex)]
    public static double[] BarycentricArea(Mesh mesh, ValueOptions options) => OfUsed(mesh, mesh.ComputeBarycentricAreas());

    [MeshValue("angle-defect", ElementKind.Vertex, Signed = true, Unit = "rad")]
    public static double[] AngleDefect(Mesh mesh, ValueOptions options) => mesh.ComputeAngleDefects();

    [MeshValue("gaussian", ElementKind.Vertex, Signed = true)]
    public static double[] Gaussian(Mesh mesh, ValueOptions options) => mesh.ComputeGaussianCurvature();

    [MeshValue("mean", ElementKind.Vertex, Signed = true)]
    public static double[] Mean(Mesh mesh, ValueOptions options) => mesh.ComputeMeanCurvature();

    /// <summary>The mean curvature from the bending of the edges.</summary>
    [MeshValue("mean-bending", ElementKind.Vertex, Signed = true)]
    public static double[] MeanBending(Mesh mesh, ValueOptions options) => mesh.ComputeBendingCurvature();

    [MeshValue("k1", ElementKind.Vertex, Signed = true)]
    public static double[] K1(Mesh mesh, ValueOptions options) => mesh.ComputePrincipalCurvatures(PrincipalCurvatureMethod.MeanAndGaussian).Max;

    [MeshValue("k2", ElementKind.Vertex, Signed = true)]
    public static double[] K2(Mesh mesh, ValueOptions options) => mesh.ComputePrincipalCurvatures(PrincipalCurvatureMethod.MeanAndGaussian).Min;

    [MeshValue("k1-tensor", ElementKind.Vertex, Signed = true)]
    public static double[] K1Tensor(Mesh mesh, ValueOptions options) => TensorAveraging.Compute(mesh).Max;

    [MeshValue("k2-tensor", ElementKind.Vertex, Signed = true)]
    public static double[] K2Tensor(Mesh mesh, ValueOptions options) => TensorAveraging.Compute(mesh).Min;

    [MeshValue("direction1", ElementKind.Vertex, IsAxis = true)]
    public static Vector3D[] Direction1(Mesh mesh, ValueOptions options) => OfUsed(mesh, TensorAveraging.Compute(mesh).MaxDirection);

    [MeshValue("direction2", ElementKind.Vertex, IsAxis = true)]
    public static Vector3D[] Direction2(Mesh mesh, ValueOptions options) => OfUsed(mesh, TensorAveraging.Compute(mesh).MinDirection);

    [MeshValue("k1-jet", ElementKind.Vertex, Signed = true)]
    public static double[] K1Jet(Mesh mesh, ValueOptions options) => JetFitting.Compute(mesh, new JetFittingOptions()).Max;

    [MeshValue("k2-jet", ElementKind.Vertex, Signed = true)]
    public static double[] K2Jet(Mesh mesh, ValueOptions options) => JetFitting.Compute(mesh, new JetFittingOptions()).Min;

    [MeshValue("dihedral", ElementKind.Edge, Signed = true, Unit = "rad")]
    public static double[] Dihedral(Mesh mesh, ValueOptions options) => mesh.ComputeDihedralAngles();

    /// <summary>Half the sum of the cotangents opposite an edge.</summary>
    [MeshValue("cotangent", ElementKind.Edge, Signed = true)]
    public static double[] Cotangent(Mesh mesh, ValueOptions options) => mesh.ComputeCotangentWeights();

    [MeshValue("area", ElementKind.Face)]
    public static double[] Area(Mesh mesh, ValueOptions options) => mesh.ComputeFaceAreas();

    [MeshValue("normal", ElementKind.Face, Signed = true)]
    public static Vector3D[] Normal(Mesh mesh, ValueOptions options) => mesh.ComputeFaceNormals();

    [MeshValue("barycenter", ElementKind.Face)]
    public static Vector3D[] Barycenter(Mesh mesh, ValueOptions options) => mesh.ComputeFaceBarycenters();

    [MeshValue("circumcenter", ElementKind.Face)]
    public static Vector3D[] Circumcenter(Mesh mesh, ValueOptions options)
    {
        var centers = new Vector3D[mesh.FaceSlots];
        foreach (Face f in mesh.Faces)
            centers[f.Index] = f.Triangle.Circumcenter;
        return centers;
    }

    [MeshValue("quality", ElementKind.Face)]
    public static double[] Quality(Mesh mesh, ValueOptions options) => mesh.ComputeFaceQualities();

    /// <summary>Faces joined across edges that bend by at most the sharp angle.</summary>
    [MeshValue("region", ElementKind.Face, IsLabel = true)]
    public static double[] Region(Mesh mesh, ValueOptions options)
    {
        double[] angles = mesh.ComputeDihedralAngles();
        FaceRegions regions = mesh.FindRegions(Array.ConvertAll(angles, angle => Math.Abs(angle) > options.SharpAngle));
        return Array.ConvertAll(regions.Labels, label => (double)label);
    }

    [MeshValue("angle", ElementKind.HalfEdge, Unit = "rad")]
    public static double[] Angle(Mesh mesh, ValueOptions options) => mesh.ComputeCornerAngles();

    private static Vector3D[] Normals(Mesh mesh, VertexNormalWeight weight) => OfUsed(mesh, mesh.ComputeVertexNormals(weight));

    private static double[] OfUsed(Mesh mesh, double[] values)
    {
        for (int v = 0; v < values.Length; v++)
        {
            if (mesh.Outgoing[v] < 0)
                values[v] = double.NaN;
        }
        return values;
    }

    private static Vector3D[] OfUsed(Mesh mesh, Vector3D[] values)
    {
        for (int v = 0; v < values.Length; v++)
        {
            if (mesh.Outgoing[v] < 0)
                values[v] = new(double.NaN, double.NaN, double.NaN);
        }
        return values;
    }
}
