using MeshLab.Generation;
using MeshLab.Numerics;
using MeshLab.Remeshing;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Remeshing;

[Trait("Section", "L4")]
public class SizingFieldTests
{
    private static Mesh Icosahedron(double radius, bool insideOut = false)
    {
        Mesh mesh = Polyhedra.Icosahedron();
        Vector3D[] positions = [.. mesh.Vertices.Select(v => radius * v.Position.Normalized())];
        return MeshBuilder.FromTriangles(positions, [.. mesh.Faces.SelectMany(f =>
        {
            int[] corners = [.. f.Vertices.Select(v => v.Index)];
            return insideOut ? [corners[0], corners[2], corners[1]] : corners;
        })]);
    }

    [Fact]
    public void Of_NoTolerance_IsOneLength() =>
        Assert.All(SizingField.Of(Icosahedron(1), new(), 0.3), size => Assert.Equal(0.3, size));

    /// <summary>All neighbours on a sphere lie on circles of its curvature: an edge of length √(6εr − 3ε²) is off by ε.</summary>
    [Theory]
    [InlineData(1.0)]
    [InlineData(2.0)]
    public void Of_Sphere_IsTheLengthThatIsOffByTheTolerance(double radius)
    {
        const double Length = 3, Tolerance = 0.1, Error = Tolerance * Length;
        foreach (bool insideOut in new[] { false, true })
        {
            double expected = Math.Sqrt(6 * Error * radius - 3 * Error * Error);
            Mesh mesh = Icosahedron(radius, insideOut);
            Assert.All(SizingField.Of(mesh, new() { CurvatureTolerance = Tolerance }, Length), size => Assert.Equal(expected, size, 1e-12));
        }
    }

    [Fact]
    public void Of_Sphere_StaysBetweenTheShortestAndTheLength()
    {
        RemeshingOptions options = new() { CurvatureTolerance = 0.1, SmallestRelativeLength = 0.25 };
        Assert.All(SizingField.Of(Icosahedron(100), options, 3), size => Assert.Equal(3, size));
        Assert.All(SizingField.Of(Icosahedron(1e-3), options, 3), size => Assert.Equal(0.75, size));
    }

    [Fact]
    public void Of_BoundaryVertex_TakesTheNormalOfItsFaces()
    {
        // Normals (0, 0, 1) and (−1, 0, 1): together (−1, 0, 2)/√5, and the first neighbour is the most curved.
        Mesh mesh = MeshBuilder.FromTriangles([default, new(1, 0, 0), new(0, 1, 0), new(-1, 0, -1)], [0, 1, 2, 0, 2, 3]);
        double[] sizes = SizingField.Of(mesh, new() { CurvatureTolerance = 0.05 }, 2);
        const double Error = 0.1;
        Assert.Equal(Math.Sqrt(6 * Error * Math.Sqrt(5) / 2 - 3 * Error * Error), sizes[0], 1e-14);
    }

    /// <summary>Away from the one tip of a plane, the length is what gradation leaves: no more than the neighbour's and half the way, and one neighbour says so.</summary>
    [Fact]
    public void Of_TipInAPlane_GrowsByHalfTheDistance()
    {
        const int N = 10;
        const double Length = 4;
        Mesh mesh = RemeshSurfaces.Sheet(N, 1, 0.3);
        int tip = 3 * (N + 1) + 3;
        mesh.Vertices[tip].Position += new Vector3D(0, 0, 0.5);
        double[] sizes = SizingField.Of(mesh, new() { CurvatureTolerance = 0.02, SmallestRelativeLength = 0.05 }, Length);

        HashSet<int> curved = [tip, .. mesh.Vertices[tip].Neighbors.Select(v => v.Index)];
        Assert.InRange(sizes[tip], 0.05 * Length, 0.3 * Length);
        int limited = 0;
        foreach (Vertex v in mesh.Vertices)
        {
            double limit = v.Neighbors.Min(w => sizes[w.Index] + 0.5 * Vector3D.Distance(v.Position, w.Position));
            Assert.True(sizes[v.Index] <= limit + 1e-12, $"{v}");
            if (curved.Contains(v.Index))
                continue;
            Assert.Equal(Math.Min(Length, limit), sizes[v.Index], 1e-12);
            limited += sizes[v.Index] < Length ? 1 : 0;
        }
        Assert.InRange(limited, 40, (N + 1) * (N + 1) - curved.Count - 5);
    }

    [Fact]
    public void Of_IsolatedVertex_HasTheLength()
    {
        Mesh mesh = Icosahedron(1);
        Vertex alone = mesh.AddVertex(new(5, 5, 5));
        double[] sizes = SizingField.Of(mesh, new() { CurvatureTolerance = 0.05 }, 1);
        Assert.Equal(1, sizes[alone.Index]);
        Assert.InRange(sizes[0], 0.2, 0.9);
    }
}
