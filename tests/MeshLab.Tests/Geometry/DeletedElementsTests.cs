using MeshLab.Curvature;
using MeshLab.Editing;
using MeshLab.Geodesics;
using MeshLab.Geometry;
using MeshLab.LinearAlgebra;
using MeshLab.Neighborhoods;
using MeshLab.Numerics;
using MeshLab.Smoothing;
using MeshLab.Spatial;
using MeshLab.Structure;
using MeshLab.Topology;
using Xunit;

namespace MeshLab.Tests.Geometry;

/// <summary>Slots of deleted elements change nothing: every measure of a mesh with gaps is that of the same mesh renumbered.</summary>
[Trait("Section", "10.1")]
[Trait("Section", "5.1")]
[Trait("Section", "11.1")]
public class DeletedElementsTests
{
    private static readonly Mesh Gaps = WithGaps();
    private static readonly Mesh Dense = Gaps.Clone();
    private static readonly CompactionMaps Maps = Dense.Compact();

    /// <summary>A torus that lost its first vertex, its last face, an edge within, and has a vertex of its own.</summary>
    private static Mesh WithGaps()
    {
        Mesh mesh = AnalyticSurface.Torus.Mesh(10);
        int last = mesh.FaceSlots - 1;
        mesh.Vertices[0].Delete();
        mesh.Faces[last].Delete();
        mesh.FindEdge(mesh.Vertices[90], mesh.Vertices[91]).Delete();
        mesh.Faces[mesh.FaceSlots / 2].Delete();
        mesh.AddVertex(new(9, 9, 9));
        Assert.False(mesh.IsCompact);
        Assert.Empty(mesh.Validate());
        return mesh;
    }

    private static readonly Dictionary<string, (ElementKind Kind, Func<Mesh, double[]> Of)> Measures = new(StringComparer.Ordinal)
    {
        ["face areas"] = (ElementKind.Face, m => m.ComputeFaceAreas()),
        ["face normals"] = (ElementKind.Face, m => Flat(m.ComputeFaceNormals())),
        ["face barycenters"] = (ElementKind.Face, m => Flat(m.ComputeFaceBarycenters())),
        ["face qualities"] = (ElementKind.Face, m => m.ComputeFaceQualities()),
        ["corner angles"] = (ElementKind.HalfEdge, m => m.ComputeCornerAngles()),
        ["edge lengths"] = (ElementKind.Edge, m => m.ComputeEdgeLengths()),
        ["dihedral angles"] = (ElementKind.Edge, m => m.ComputeDihedralAngles()),
        ["unsigned dihedral angles"] = (ElementKind.Edge, m => m.ComputeUnsignedDihedralAngles()),
        ["angle defects"] = (ElementKind.Vertex, m => m.ComputeAngleDefects()),
        ["voronoi areas"] = (ElementKind.Vertex, m => m.ComputeVoronoiAreas()),
        ["mixed areas"] = (ElementKind.Vertex, m => m.ComputeMixedAreas()),
        ["barycentric areas"] = (ElementKind.Vertex, m => m.ComputeBarycentricAreas()),
        ["normals, uniform"] = (ElementKind.Vertex, m => Flat(m.ComputeVertexNormals(VertexNormalWeight.Uniform))),
        ["normals, area"] = (ElementKind.Vertex, m => Flat(m.ComputeVertexNormals(VertexNormalWeight.Area))),
        ["normals, angle"] = (ElementKind.Vertex, m => Flat(m.ComputeVertexNormals(VertexNormalWeight.Angle))),
        ["normals, sphere"] = (ElementKind.Vertex, m => Flat(m.ComputeVertexNormals(VertexNormalWeight.InscribedSphere))),
        ["gaussian"] = (ElementKind.Vertex, m => m.ComputeGaussianCurvature()),
        ["mean"] = (ElementKind.Vertex, m => m.ComputeMeanCurvature()),
        ["mean normals"] = (ElementKind.Vertex, m => Flat(m.ComputeMeanCurvatureNormals())),
        ["bending"] = (ElementKind.Vertex, m => m.ComputeBendingCurvature()),
        ["k1"] = (ElementKind.Vertex, m => m.ComputePrincipalCurvatures(PrincipalCurvatureMethod.MeanAndGaussian).Max),
        ["k2, tensor"] = (ElementKind.Vertex, m => m.ComputePrincipalCurvatures(PrincipalCurvatureMethod.TensorAveraging).Min),
        ["k1, normals"] = (ElementKind.Vertex, m => m.ComputePrincipalCurvatures(PrincipalCurvatureMethod.NormalLaplacian).Max),
        ["direction, jets"] = (ElementKind.Vertex, m => Flat(m.ComputePrincipalCurvatures(PrincipalCurvatureMethod.JetFitting).MaxDirection)),
        ["cotangent weights"] = (ElementKind.Edge, m => m.ComputeCotangentWeights()),
        ["lumped masses"] = (ElementKind.Vertex, m => m.ComputeLumpedMasses()),
        ["laplacian of x²"] = (ElementKind.Vertex, m => m.ComputeLaplacian().Multiply(OfX(m))),
        ["mean value laplacian of x²"] = (ElementKind.Vertex, m => m.ComputeLaplacian(LaplacianWeights.MeanValue).Multiply(OfX(m))),
        ["uniform laplacian of x²"] = (ElementKind.Vertex, m => m.ComputeLaplacian(LaplacianWeights.Uniform).Multiply(OfX(m))),
        ["intrinsic laplacian of x²"] = (ElementKind.Vertex, m => IntrinsicDelaunay.Of(m).ComputeLaplacian().Multiply(OfX(m))),
        ["mass of x²"] = (ElementKind.Vertex, m => m.ComputeMassMatrix(MassKind.Full).Multiply(OfX(m))),
        ["harmonic height"] = (ElementKind.Vertex, m => m.ComputeHarmonicHeight()),
        ["second eigenvector"] = (ElementKind.Vertex, m => m.ComputeSmallestEigenpairs(2).Vectors[1]),
        ["edge distances"] = (ElementKind.Vertex, m => m.ComputeEdgeDistances(Start(m))),
        ["heat distances"] = (ElementKind.Vertex, m => new HeatGeodesics(m).ComputeDistances(Start(m))),
        ["heat distances as given"] = (ElementKind.Vertex, m => new HeatGeodesics(m, new HeatOptions { IntrinsicDelaunay = false }).ComputeDistances(Start(m))),
        ["components of vertices"] = (ElementKind.Vertex, m => [.. m.FindComponents().VertexLabels.Select(l => (double)l)]),
        ["components of faces"] = (ElementKind.Face, m => [.. m.FindComponents().FaceLabels.Select(l => (double)l)]),
        ["regions"] = (ElementKind.Face, m => [.. m.FindRegions(m.Edges.Where(e => e.DihedralAngle > 0.5)).Labels.Select(l => (double)l)]),
        ["smoothed uniformly"] = (ElementKind.Vertex, m => Smoothed(m, c => c.SmoothUniformly(new UniformSmoothingOptions { Steps = 2 }))),
        ["smoothed by cotangents"] = (ElementKind.Vertex, m => Smoothed(m, c => c.SmoothByCotangents(new CotangentSmoothingOptions { Steps = 2 }))),
        ["smoothed by Taubin"] = (ElementKind.Vertex, m => Smoothed(m, c => c.SmoothByTaubin(new TaubinSmoothingOptions { Steps = 2, Boundary = SmoothingBoundary.AlongCurve }))),
        ["smoothed implicitly"] = (ElementKind.Vertex, m => Smoothed(m, c => c.SmoothImplicitly(new ImplicitSmoothingOptions { Steps = 2, Boundary = SmoothingBoundary.Free }))),
    };

    public static TheoryData<string> MeasureNames => new(Measures.Keys);

    [Theory]
    [MemberData(nameof(MeasureNames))]
    public void Measure_MeshWithGaps_IsThatOfTheRenumberedMesh(string name)
    {
        (ElementKind kind, Func<Mesh, double[]> of) = Measures[name];
        int[] map = kind switch
        {
            ElementKind.Vertex => Maps.Vertices,
            ElementKind.HalfEdge => Maps.HalfEdges,
            ElementKind.Edge => Maps.Edges,
            _ => Maps.Faces,
        };
        double[] gaps = of(Gaps), dense = of(Dense);
        int width = gaps.Length / map.Length;
        Assert.Equal(map.Length * width, gaps.Length);
        Assert.Equal(dense.Length / width, map.Count(i => i >= 0));
        for (int i = 0; i < map.Length; i++)
        {
            for (int k = 0; k < width && map[i] >= 0; k++)
            {
                double expected = dense[(map[i] * width) + k], actual = gaps[(i * width) + k];
                Assert.True(expected.Equals(actual) || Math.Abs(expected - actual) <= 1e-9 * (1 + Math.Abs(expected)), $"{name} of {kind} {i}: {actual:R}, expected {expected:R}");
            }
        }
    }

    [Fact]
    public void Sums_MeshWithGaps_AreThoseOfTheRenumberedMesh()
    {
        MassProperties gaps = Gaps.ComputeMassProperties(), dense = Dense.ComputeMassProperties();
        Assert.Equal(dense.Area, gaps.Area, 1e-12);
        Assert.Equal(dense.Volume, gaps.Volume, 1e-12);
        Assert.Equal(0, gaps.ZeroAreaFaces);
        Assert.Equal(MeshMeasures.Of(Dense).EdgeLength, MeshMeasures.Of(Gaps).EdgeLength);
        Assert.Equal(MeshMeasures.Of(Dense).Valence, MeshMeasures.Of(Gaps).Valence);
        Assert.Equal(GaussBonnet.Check(Dense).Difference, GaussBonnet.Check(Gaps).Difference, 1e-11);
        Assert.Equal(0, GaussBonnet.Check(Gaps).Difference, 1e-11);
        Gaps.ComputeFaceNormals(out int zeroAreaFaces);
        Assert.Equal(0, zeroAreaFaces);
    }

    [Fact]
    public void Topology_MeshWithGaps_IsThatOfTheRenumberedMesh()
    {
        TopologyReport gaps = Gaps.ComputeTopology(), dense = Dense.ComputeTopology();
        Assert.Equal(dense.ToString(), gaps.ToString());
        Assert.Equal(1, gaps.Genus);
        Assert.Equal((Dense.Genus, Dense.EulerCharacteristic, Dense.BoundaryLoopCount), (Gaps.Genus, Gaps.EulerCharacteristic, Gaps.BoundaryLoopCount));
        Assert.Equal(Dense.FindBoundaryLoops().Select(l => l.Length).Order(), Gaps.FindBoundaryLoops().Select(l => l.Length).Order());
        Assert.Equal(Dense.BoundaryEdges.Select(e => e.Index), Gaps.BoundaryEdges.Select(e => Maps.Edges[e.Index]));
        Assert.Equal(Dense.FindCutGraph().Select(e => e.Index), Gaps.FindCutGraph().Select(e => Maps.Edges[e.Index]));
        foreach (bool shorten in (bool[])[false, true])
        {
            var options = new HomologyOptions { Shorten = shorten };
            Assert.Equal(
                HomologyGenerators.Compute(Dense, options).Select(l => l.Vertices.Select(v => v.Index).ToArray()),
                HomologyGenerators.Compute(Gaps, options).Select(l => l.Vertices.Select(v => Maps.Vertices[v.Index]).ToArray()));
        }
    }

    [Fact]
    public void Queries_MeshWithGaps_AreThoseOfTheRenumberedMesh()
    {
        FaceTree gaps = FaceTree.Build(Gaps), dense = FaceTree.Build(Dense);
        var random = new Random(3);
        for (int i = 0; i < 200; i++)
        {
            Vector3D point = new((5 * random.NextDouble()) - 2.5, (5 * random.NextDouble()) - 2.5, random.NextDouble() - 0.5);
            ClosestPoint found = gaps.FindClosest(point), expected = dense.FindClosest(point);
            Assert.Equal(expected.Face, Maps.Faces[found.Face]);
            Assert.Equal(expected.DistanceSquared, found.DistanceSquared);
        }
        Assert.Equal(dense.FindSelfIntersections().Length, gaps.FindSelfIntersections().Length);
        foreach (Vertex v in Gaps.Vertices.Where(v => v.Index % 7 == 1))
        {
            Vertex same = Dense.Vertices[Maps.Vertices[v.Index]];
            Assert.Equal(same.Ring(2).Select(w => w.Index), v.Ring(2).Select(w => Maps.Vertices[w.Index]));
            Assert.Equal(same.LinkEdges.Select(e => e.Index), v.LinkEdges.Select(e => Maps.Edges[e.Index]));
            Assert.Equal(same.Component.Length, v.Component.Length);
        }
    }

    private static Vertex Start(Mesh mesh) => mesh.Vertices.First(v => v.Position == Gaps.Positions[44]);

    private static double[] OfX(Mesh mesh) => [.. mesh.Positions.ToArray().Select(p => p.X * p.X)];

    private static double[] Smoothed(Mesh mesh, Action<Mesh> smooth)
    {
        Mesh copy = mesh.Clone();
        smooth(copy);
        Assert.Empty(copy.Validate());
        return Flat(copy.Positions.ToArray());
    }

    private static double[] Flat(Vector3D[] vectors) => ReferenceMesh.Flat(vectors);
}
