using MeshLab.Numerics;
using MeshLab.Remeshing;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Remeshing;

/// <summary>Where single vertices go.</summary>
[Trait("Section", "L4")]
public class TangentialSmoothingTests
{
    // A square with one more vertex on its left side: the middle of the corners is at x = 4/5, the middle of the area at x = 1.
    private static readonly Vector3D[] Rim = [new(0, 0, 0), new(2, 0, 0), new(2, 2, 0), new(0, 2, 0), new(0, 1, 0)];

    private static Vector3D[] Smoothed(RemeshSurface s, bool byArea)
    {
        var places = new Vector3D[s.VertexSlots];
        TangentialSmoothing.Run(s, places, 0, s.VertexSlots, byArea);
        return places;
    }

    private static Vector3D CenterAfter(Mesh mesh, bool byArea) => Smoothed(RemeshSurfaces.Of(mesh).Surface, byArea)[0];

    private static void AssertNear(Vector3D expected, Vector3D actual) => Assert.True(Vector3D.Distance(expected, actual) < 1e-14, $"{expected} {actual}");

    [Theory]
    [InlineData(false, 0.8)]
    [InlineData(true, 1)]
    public void Run_InThePlane_GoesToTheMiddle(bool byArea, double x) =>
        AssertNear(new(x, 1, 0), CenterAfter(RemeshSurfaces.Fan(new(0.5, 0.75, 0), Rim), byArea));

    [Fact]
    public void Run_OnATip_MovesTheTipAlongTheSurfaceOnly()
    {
        // The area vector of the faces is that of their rim, wherever the tip is: the tip keeps its height.
        AssertNear(new(0.8, 1, 3), CenterAfter(RemeshSurfaces.Fan(new(0.5, 0.75, 3), Rim), byArea: false));

        // By area: triangles of the areas w stand over the five sides.
        Vector3D p = new(0.5, 0.75, 3), sum = default;
        double total = 0;
        for (int i = 0; i < Rim.Length; i++)
        {
            Vector3D q = Rim[i], r = Rim[(i + 1) % Rim.Length];
            double w = Vector3D.Cross(q - p, r - p).Length;
            sum += w * (p + q + r) / 3;
            total += w;
        }
        Vector3D middle = sum / total;
        AssertNear(new(middle.X, middle.Y, 3), CenterAfter(RemeshSurfaces.Fan(p, Rim), byArea: true));
    }

    [Fact]
    public void Run_OnLines_SlidesBetweenTheNeighborsThereAndKeepsCorners()
    {
        // The last vertex of the rim is no corner of the square: its other neighbour, the centre, does not pull.
        Mesh mesh = RemeshSurfaces.Fan(new(0.5, 0.75, 0), [.. Rim[..4], new(0, 0.5, 0)]);
        foreach (bool byArea in new[] { false, true })
        {
            Vector3D[] places = Smoothed(RemeshSurfaces.Of(mesh).Surface, byArea);
            Assert.Equal(Rim[..4], places[1..5]);
            Assert.Equal(new Vector3D(0, 0.75, 0), places[5]);
        }
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Run_FacesWithoutArea_GivesNumbers(bool byArea)
    {
        // All on one line, the second time all in one point.
        Vector3D line = CenterAfter(RemeshSurfaces.Fan(default, new(1, 0, 0), new(-1, 0, 0), new(3, 0, 0)), byArea);
        AssertNear(byArea ? default : new(1, 0, 0), line);
        AssertNear(new(1, 1, 1), CenterAfter(RemeshSurfaces.Fan(new(1, 1, 1), new(1, 1, 1), new(1, 1, 1), new(1, 1, 1)), byArea));
    }

    [Fact]
    public void Run_PartOfTheVertices_LeavesTheOthers()
    {
        RemeshSurface s = RemeshSurfaces.Of(RemeshSurfaces.Fan(new(0.5, 0.75, 0), Rim)).Surface;
        var places = new Vector3D[s.VertexSlots];
        TangentialSmoothing.Run(s, places, 1, 3, byArea: false);
        Assert.Equal([default, Rim[0], Rim[1], default, default, default], places);
    }
}
