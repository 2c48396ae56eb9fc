using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Simplification;

[Trait("Section", "7.2")]
public class WorkingMeshTests
{
    /// <summary>The working mesh allows what the collapse on the mesh itself allows.</summary>
    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void LinkConditionHolds_EveryModel_IsThatOfTheMesh(string name)
    {
        Mesh mesh = Models.Create(name);
        var working = new WorkingMesh(mesh);
        int stamp = 0;

        foreach (HalfEdge h in mesh.HalfEdges)
            Assert.True(h.CanCollapse(out CollapseRefusal why) == working.LinkConditionHolds(h.Index, ++stamp), $"{h}: {why}");
    }

    /// <summary>Small open and closed meshes, in which nearly everything is special: strips, fans, single triangles with tails.</summary>
    [Fact]
    public void LinkConditionHolds_SmallMeshes_IsThatOfTheMesh()
    {
        int[][] cornersOf =
        [
            [0, 1, 2],
            [0, 1, 2, 2, 1, 3],
            [0, 1, 2, 2, 1, 3, 2, 3, 4],
            [0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5, 4, 5, 0, 0, 5, 1],
            [0, 1, 2, 0, 2, 3, 0, 3, 1],
            [0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1],
            [0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 4, 4, 3, 5],
            [0, 1, 2, 0, 2, 3, 0, 3, 1, 3, 2, 1],
        ];
        foreach (int[] corners in cornersOf)
        {
            Mesh mesh = MeshBuilder.FromTriangles([.. Enumerable.Range(0, corners.Max() + 1).Select(i => new Vector3D(i, i * i, i * i * i))], corners);
            var working = new WorkingMesh(mesh);
            int stamp = 0;
            foreach (HalfEdge h in mesh.HalfEdges)
                Assert.True(h.CanCollapse(out CollapseRefusal why) == working.LinkConditionHolds(h.Index, ++stamp), $"{string.Join(' ', corners)}: {h}, {why}");
        }
    }

    /// <summary>A hexagon with radius 1, whose middle moves while it is contracted into corner 1; corner 4 lies on corner 3, so that one face has no area.</summary>
    [Theory]
    [InlineData(0.9, 0, true)]
    [InlineData(0, 0.9, false)]
    [InlineData(-0.9, 0, false)]
    public void KeepsOrientation_FaceWithoutArea_DoesNotCount(double x, double y, bool kept)
    {
        Vector3D[] positions = [default, .. Enumerable.Range(0, 6).Select(i => new Vector3D(Math.Cos(i * Math.PI / 3), Math.Sin(i * Math.PI / 3), 0))];
        positions[4] = positions[3];
        Mesh mesh = MeshBuilder.FromTriangles(positions, [.. Enumerable.Range(0, 6).SelectMany(i => new[] { 0, 1 + i, 1 + (i + 1) % 6 })]);
        var working = new WorkingMesh(mesh);

        Assert.Equal(kept, working.KeepsOrientation(mesh.FindHalfEdge(mesh.Vertices[0], mesh.Vertices[1]).Index, working.Normalized(new(x, y, 0))));
    }

    [Theory]
    [InlineData(QuadricMode.Fast)]
    [InlineData(QuadricMode.Accurate)]
    public void Simplify_AllVerticesInOnePoint_StayThere(QuadricMode mode)
    {
        var point = new Vector3D(3, -2, 7);
        Mesh mesh = Shapes.Moved(Shapes.Torus(10, 6), _ => point);

        mesh.Simplify(new() { TargetFaces = 60, Mode = mode });

        Assert.Equal(60, mesh.Faces.Count);
        Assert.All(mesh.Vertices, v => Assert.Equal(point, v.Position));
        Assert.Empty(mesh.Validate());
    }
}
