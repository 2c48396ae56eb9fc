using MeshLab.FiveSixSeven;
using MeshLab.Generation;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.FiveSixSeven;

[Trait("Section", "9.6")]
public class RefinementTests
{
    [Theory]
    [InlineData("torus")]
    [InlineData("cube")]
    [InlineData("grid")]
    [InlineData("tetrahedron")]
    [InlineData("holes")]
    public void TowardsCount_FourTimesAsMany_KeepsValencesAndAddsSixes(string name)
    {
        Mesh mesh = Models.Create(name);
        WorkMesh work = WorkMesh.From(mesh);
        InputSurface surface = FiveSixSevenMeshing.SurfaceOf(work, new());
        long penalty = work.Penalty;
        int creases = work.Crease.Sum();

        Refinement.TowardsCount(new Guard(work, surface), 16 * mesh.Faces.Count + 3, default);

        Assert.Equal((16 * mesh.Faces.Count, penalty), (work.LiveFaces, work.Penalty));
        Assert.Equal(4 * creases, work.Crease.Take(work.EdgeSlots).Sum());
        (Vector3D[] positions, int[] corners, _) = work.Export();
        Mesh result = MeshBuilder.FromTriangles(positions, corners);
        Assert.Empty(result.Validate());
        Assert.Equal(mesh.Area, result.Area, 12);
        foreach (Vertex v in result.Vertices)
            Assert.Equal(v.Index < mesh.VertexSlots ? mesh.Vertices[v.Index].Valence : v.IsBoundary ? 4 : 6, v.Valence);
    }

    [Fact]
    public void TowardsCount_LessThanFourTimes_ChangesNothing()
    {
        WorkMesh work = WorkMesh.From(Models.Torus(12, 8));
        InputSurface surface = FiveSixSevenMeshing.SurfaceOf(work, new());
        Refinement.TowardsCount(new Guard(work, surface), 4 * work.LiveFaces - 1, default);
        Assert.Equal(192, work.LiveFaces);
    }

    [Theory]
    [InlineData(FiveSixSevenEngine.Repair)]
    [InlineData(FiveSixSevenEngine.Textbook)]
    public void ToFiveSixSeven_ManyTimesTheFacesOfSharpSolids_ReachesTheCount(FiveSixSevenEngine engine)
    {
        // All edges of an icosahedron are creases, which no flip may cross.
        FiveSixSevenResult result = Polyhedra.Icosahedron().ToFiveSixSeven(new() { TargetFaces = 400, Engine = engine });
        FiveSixSevenTests.CheckTopology(Polyhedra.Icosahedron(), result);
        Assert.InRange(result.Mesh.Faces.Count, 398, 402);
        Assert.Equal(FiveSixSevenStop.Reached, result.StopReason);
    }
}
