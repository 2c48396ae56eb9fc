using MeshLab.Numerics;
using MeshLab.Remeshing;
using MeshLab.Spatial;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Remeshing;

/// <summary>Back to the surface, by the walk and by the tree.</summary>
[Trait("Section", "L4")]
public class SurfaceProjectionTests
{
    [Theory]
    [InlineData(0)]
    [InlineData(0.05)]
    [InlineData(10)]
    public void Project_PointsNearTheSurface_AreTheClosestOnes(double trusted)
    {
        Mesh mesh = Models.Create("bumpy-sphere");
        var projection = new SurfaceProjection(mesh, trusted);
        FaceTree tree = FaceTree.Build(mesh);
        var random = new Random(1);
        int face = 0;
        for (int i = 0; i < 500; i++)
        {
            // From the face found last, wherever it is: close points, but from one to the next over the whole surface.
            Face start = mesh.Faces[random.Next(mesh.Faces.Count)];
            Vector3D point = start.Vertices.Aggregate(default(Vector3D), (sum, v) => sum + v.Position) / 3 * (1 + 0.02 * (random.NextDouble() - 0.5));
            if (trusted > 1)
                face = start.Index;
            Vector3D place = projection.Project(point, ref face);
            ClosestPoint expected = tree.FindClosest(point);
            Assert.Equal(Vector3D.Distance(point, expected.Point), Vector3D.Distance(point, place), 1e-12);
            Assert.InRange(Vector3D.Distance(place, tree.FindClosest(place).Point), 0, 1e-12);
            Assert.Contains(face, mesh.Faces.Where(f => OnFace(f, place)).Select(f => f.Index));
        }
    }

    /// <summary>Two sheets above each other: the walk on the lower one ends below, and only the tree finds the upper one.</summary>
    [Theory]
    [InlineData(0.5, 1)]
    [InlineData(0.5, 0)]
    [InlineData(2, 0)]
    public void Project_FarFromTheWalk_AsksTheTree(double trusted, int expectedSheet)
    {
        Mesh mesh = MeshBuilder.FromTriangles(
            [new(0, 0, 0), new(4, 0, 0), new(0, 4, 0), new(0, 0, 1), new(4, 0, 1), new(0, 4, 1)], [0, 1, 2, 3, 4, 5]);
        double z = expectedSheet == 1 ? 0.8 : trusted > 1 ? 0.8 : 0.45;
        int face = 0;
        Vector3D place = new SurfaceProjection(mesh, trusted).Project(new(1, 1, z), ref face);
        Assert.Equal(expectedSheet, face);
        Assert.Equal(new Vector3D(1, 1, expectedSheet), place);
    }

    private static bool OnFace(Face f, Vector3D p) => TriangleMath.ClosestDistanceSquared(
        p, f.HalfEdge.Source.Position, f.HalfEdge.Target.Position, f.HalfEdge.Next.Target.Position, out _) < 1e-20;
}
