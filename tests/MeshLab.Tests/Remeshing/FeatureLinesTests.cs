using MeshLab.Numerics;
using MeshLab.Remeshing;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Remeshing;

/// <summary>What is a line, what a corner, and how far edges and vertices may leave the lines.</summary>
[Trait("Section", "L4")]
public class FeatureLinesTests
{
    // A roof over [−1, 1]² whose ridge is the line x = 0 at the height 0.4: both ends of the ridge are on the boundary.
    private static Mesh Roof() => MeshBuilder.FromTriangles(
        [new(-1, -1, 0), new(0, -1, 0.4), new(1, -1, 0), new(1, 1, 0), new(0, 1, 0.4), new(-1, 1, 0)],
        [0, 1, 4, 0, 4, 5, 1, 2, 3, 1, 3, 4]);

    // A strip along the polyline given: the line is its boundary, the faces lie 1 below.
    private static Mesh Strip(params Vector3D[] line)
    {
        int n = line.Length;
        Vector3D[] positions = [.. line, .. line.Select(p => p - new Vector3D(0, 1, 0))];
        return MeshBuilder.FromTriangles(positions, [.. Enumerable.Range(0, n - 1).SelectMany(i => new[] { i, n + i, n + i + 1, i, n + i + 1, i + 1 })]);
    }

    [Theory]
    [InlineData(77, false)]
    [InlineData(80, true)]
    public void Mark_Turn_IsACornerBeyond78Degrees(double degrees, bool expected)
    {
        double turn = degrees * Math.PI / 180;
        (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(RemeshSurfaces.Fan(new(0.5, 0.3, 0), default, new(1, 0, 0), new(1 + Math.Cos(turn), Math.Sin(turn), 0)));
        Assert.Equal([true, expected, true], s.IsCorner[1..4]);
        Assert.Equal(expected ? 3 : 2, lines.Corners);
        Assert.Equal(0, lines.FeatureEdges);
    }

    [Fact]
    public void Mark_Cube_HasFeaturesSharperThanTheAngleOnly()
    {
        Mesh cube = Models.Create("cube");
        Assert.Equal((0, 0), Counts(Math.PI / 2));
        Assert.Equal((12, 8), Counts(Math.BitDecrement(Math.PI / 2)));

        (int, int) Counts(double angle)
        {
            FeatureLines lines = RemeshSurfaces.Of(cube, 1, angle).Lines;
            return (lines.FeatureEdges, lines.Corners);
        }
    }

    /// <summary>A fold that fades out at the vertex in the middle: one sharp edge, and the line's end never moves.</summary>
    [Fact]
    public void Mark_EndOfALine_IsACorner()
    {
        Vector3D[] rim = RemeshSurfaces.Polygon(24);
        for (int i = 0; i < rim.Length; i++)
        {
            double angle = 2 * Math.PI * Math.Min(i, rim.Length - i) / rim.Length;
            rim[i] -= new Vector3D(0, 0, 0.5 * (angle - angle * angle / (2 * Math.PI)));
        }
        (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(RemeshSurfaces.Fan(default, rim), 1, 0.6);
        Assert.Equal(1, lines.FeatureEdges);
        Assert.Equal(1, s.LineCount[0]);
        Assert.True(s.IsCorner[0]);
    }

    [Fact]
    public void Mark_FaceWithoutArea_MakesNoFeature()
    {
        // Below the square a face without area, and behind it one more, upright.
        Mesh mesh = MeshBuilder.FromTriangles(
            [new(0, 0, 0), new(2, 0, 0), new(0, 2, 0), new(1, 0, 0), new(1, 0, -1)], [0, 1, 2, 0, 3, 1, 0, 4, 3]);
        Assert.Equal(0, RemeshSurfaces.Of(mesh, 1, 0.1).Lines.FeatureEdges);
    }

    [Fact]
    public void AllowsChord_OnStraightLines_AsLongAsTheWayIsThere()
    {
        FeatureLines lines = RemeshSurfaces.Of(Roof(), 1, 0.5).Lines;
        Assert.True(lines.AllowsChord(new(-1, -0.9, 0), new(-1, 0.9, 0), new(-1, 0.3, 0)));
        // From one side to the other: the middle is on the ridge of a flat roof, the rest is not.
        Assert.False(lines.AllowsChord(new(-1, 0, 0.4), new(1, 0, 0.4), new(0, 0, 0.4)));
        // Over a corner.
        Assert.False(lines.AllowsChord(new(-1, 0.5, 0), new(0, 1, 0.4), new(-1, 1, 0)));
        // Across a face, from line to line.
        Assert.False(lines.AllowsChord(new(-1, 0, 0), new(0, 0, 0.4), new(-0.5, 0, 0.2)));
        // Along the line, but not to where the third point is: that end would be lost.
        Assert.False(lines.AllowsChord(new(-1, -0.5, 0), new(-1, 0.2, 0), new(-1, 0.9, 0)));
    }

    /// <summary>Bends count from 3 % of the length wanted, or from 4 ten-thousandths of the diagonal.</summary>
    [Theory]
    [InlineData(10, 0.95, true)]
    [InlineData(10, 1.05, false)]
    [InlineData(0.01, 0.95, true)]
    [InlineData(0.01, 1.05, false)]
    public void AllowsChord_OverABend_UpToTheTolerance(double length, double share, bool expected)
    {
        double diagonal = Math.Sqrt(5), tolerance = Math.Min(0.03 * length, 4e-4 * diagonal);
        Vector3D a = new(-1, 0, 0), b = new(1, 0, 0), between = new(0, share * tolerance, 0);
        FeatureLines lines = RemeshSurfaces.Of(Strip(a, between, b), length).Lines;
        Assert.Equal(expected, lines.AllowsChord(a, b, between));
    }

    [Fact]
    public void Slide_AlongAStraightLine_GoesToTheClosestPoint()
    {
        (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(Strip(new(0, 0, 0), new(1, 0, 0), new(2, 0, 0)));
        Assert.Equal(new Vector3D(1.25, 0, 0), lines.Slide(s, 1, new(1.25, 0.5, -2)));
    }

    [Fact]
    public void Slide_WhereAnEdgeWouldLeaveTheLine_Stays()
    {
        // The line bends at the second vertex; the surface has it no more there, so that every place but the bend is off.
        Mesh strip = Strip(new(0, 0, 0), new(1, 0, 0), new(1.5, 0.5, 0), new(2, 1, 0));
        (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(strip);
        Assert.Equal(new Vector3D(1, 0, 0), lines.Slide(s, 1, new(1.1, 0.1, 0)));
        Assert.Equal(new Vector3D(1, 0, 0), lines.Slide(s, 1, new(0.9, 0, 0)));
        // However short the way is: the edge behind the bend counts.
        s.Positions[1] = new(0.5, 0, 0);
        Assert.Equal(new Vector3D(0.5, 0, 0), lines.Slide(s, 1, new(0.4999, 0, 0)));
        // Straight on beyond the bend.
        s.Positions[1] = new(1, 0, 0);
        Assert.Equal(new Vector3D(1.75, 0.75, 0), lines.Slide(s, 2, new(1.75, 0.75, 0)));
    }

    /// <summary>A flat triangle of lines: its top does not slide down to the opposite side, where both edges beside it would lie on lines too.</summary>
    [Fact]
    public void Slide_OntoTheOppositeSide_Stays()
    {
        (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(MeshBuilder.FromTriangles([new(-1, 0, 0), new(1, 0, 0), new(0, 0.3, 0)], [0, 1, 2]));
        Assert.False(s.IsCorner[2]);
        Assert.Equal(new Vector3D(0, 0.3, 0), lines.Slide(s, 2, new(0.5, -0.1, 0)));
    }

    [Fact]
    public void Project_NoLines_IsThePoint()
    {
        FeatureLines lines = RemeshSurfaces.Of(Models.Create("octahedron")).Lines;
        Assert.Equal((0, 0), (lines.FeatureEdges, lines.Corners));
        Assert.Equal(new Vector3D(1, 2, 3), lines.Project(new(1, 2, 3)));
    }
}
