using MeshLab.Generation;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Subdivision;
using Xunit;

namespace MeshLab.Tests.Subdivision;

/// <summary>§8.3: two √3 steps cut every edge of the boundary in three, as cubic B-splines are refined.</summary>
[Trait("Section", "8.3")]
public class BoundaryTrisectionTests
{
    // The refinement by three of cubic B-splines: ((1 + z + z²)/3)⁴ times 3.
    private static double[] Mask()
    {
        double[] mask = [3];
        for (int i = 0; i < 4; i++)
        {
            var product = new double[mask.Length + 2];
            for (int j = 0; j < mask.Length; j++)
            {
                for (int k = 0; k < 3; k++)
                    product[j + k] += mask[j] / 3;
            }
            mask = product;
        }
        return mask;
    }

    [Fact]
    public void Subdivide_Boundary_IsTheRefinedSpline()
    {
        Mesh mesh = Prisms.OpenCylinder(9, 3);
        var random = new Random(1);
        foreach (ref Vector3D p in mesh.Positions)
            p += 0.2 * new Vector3D(random.NextDouble(), random.NextDouble(), random.NextDouble());

        Mesh finer = mesh.Subdivide(SubdivisionScheme.Sqrt3, new() { BeginWithBoundaryTrisection = true });

        double[] mask = Mask();
        int old = 0;
        foreach (HalfEdge h in finer.HalfEdges)
        {
            if (!h.IsBoundary || h.Source.Index >= mesh.VertexSlots)
                continue;
            // Along the border of the input: five vertices, the second of them this one.
            Vertex v = mesh.Vertices[h.Source.Index];
            HalfEdge at = v.Outgoing;
            Vector3D[] p = [at.Previous.Source.Position, v.Position, at.Target.Position, at.Next.Target.Position];
            AssertNear(mask[1] * p[2] + mask[4] * p[1] + mask[7] * p[0], h.Source.Position);
            AssertNear(mask[2] * p[2] + mask[5] * p[1] + mask[8] * p[0], h.Target.Position);
            AssertNear(mask[0] * p[3] + mask[3] * p[2] + mask[6] * p[1], h.Next.Target.Position);
            old++;
        }
        Assert.Equal(18, old);

        static void AssertNear(Vector3D expected, Vector3D actual) => Assert.True(Vector3D.Distance(expected, actual) < 1e-14, $"{expected} {actual}");
    }

    [Fact]
    public void Subdivide_TwoBoundaryEdgesAtAFace_IsRefusedWithItsName()
    {
        Mesh mesh = MeshBuilder.FromTriangles([default, new(1, 0, 0), new(1, 1, 0), new(0, 1, 0)], [0, 1, 2, 0, 2, 3]);
        TopologyException error = Assert.Throws<TopologyException>(() => mesh.Subdivide(SubdivisionScheme.Sqrt3, new() { BeginWithBoundaryTrisection = true }));
        Assert.Contains("f0", error.Message, StringComparison.Ordinal);
        Assert.Empty(mesh.Subdivide(SubdivisionScheme.Sqrt3, new() { Steps = 2 }).Validate());
    }
}
