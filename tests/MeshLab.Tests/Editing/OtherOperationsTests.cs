using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Editing;

[Trait("Section", "4.8")]
public class OtherOperationsTests
{
    [Theory]
    [InlineData(double.NaN)]
    [InlineData(-1)]
    [InlineData(double.PositiveInfinity)]
    public void AddNoise_BadAmplitude_Throws(double amplitude) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => Models.Tetrahedron().AddNoise(amplitude));

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void AddNoise_SameSeed_SameMeshAndUndone(string name)
    {
        Mesh mesh = Models.Create(name), other = Models.Create(name);
        ulong before = mesh.StateHash();
        using OperationHistory history = mesh.StartRecording();
        mesh.AddNoise(0.5, seed: 4);
        other.AddNoise(0.5, seed: 4);
        Assert.Equal(other.StateHash(), mesh.StateHash());
        Assert.Empty(mesh.Validate());
        history.UndoAll();
        Assert.Equal(before, mesh.StateHash());
    }

    [Fact]
    public void AddNoise_Sphere_MovesAlongTheNormalByAtMostHalfTheAmplitude()
    {
        Mesh sphere = Models.Create("sphere"), mesh = sphere.Clone();
        double length = sphere.Edges.Average(e => e.Length);
        mesh.AddNoise(0.4, seed: 1);
        for (int v = 0; v < mesh.VertexSlots; v++)
        {
            double moved = Vector3D.Distance(sphere.Positions[v], mesh.Positions[v]);
            Assert.InRange(moved, 0, 0.2 * length);
        }
        Assert.NotEqual(sphere.StateHash(), mesh.StateHash());
    }

    [Fact]
    public void AddNoise_Smooth_DiffersLessFromNeighborToNeighbor()
    {
        double Roughness(int steps)
        {
            Mesh mesh = Models.Sphere(20, 30);
            mesh.AddNoise(0.4, seed: 2, smoothingSteps: steps);
            return mesh.Edges.Average(e => Math.Abs(e.Vertex0.Position.Length - e.Vertex1.Position.Length));
        }
        Assert.True(Roughness(5) < 0.6 * Roughness(0));
    }

    [Fact]
    public void BoxCorners_OfACube_AreItsVertices()
    {
        Vector3D[] corners = Models.Create("cube").BoxCorners();
        Assert.Equal(new Vector3D(0, 0, 0), corners[0]);
        Assert.Equal(new Vector3D(1, 0, 0), corners[1]);
        Assert.Equal(new Vector3D(0, 1, 0), corners[2]);
        Assert.Equal(new Vector3D(1, 1, 1), corners[7]);
    }

    [Fact]
    public void Placement_ScaleMoveNormalize_DoWhatTheySay()
    {
        Mesh mesh = Models.Create("far-away");
        mesh.MoveCenterToOrigin();
        Assert.InRange(mesh.BoundingBox.Center.Length, 0, 1e-9);
        mesh.ScaleToSize(10);
        Vector3D sides = mesh.BoundingBox.Max - mesh.BoundingBox.Min;
        Assert.Equal(10, Math.Max(sides.X, Math.Max(sides.Y, sides.Z)), 1e-12);

        mesh = Models.Create("bumpy-sphere");
        ulong before = mesh.StateHash();
        using OperationHistory history = mesh.StartRecording();
        mesh.Normalize();
        Assert.InRange(mesh.BoundingBox.Center.Length, 0, 1e-15);
        Assert.Equal(1, history.Count);
        history.UndoAll();
        Assert.Equal(before, mesh.StateHash());
    }

    [Fact]
    public void Placement_BadInput_Throws()
    {
        Assert.Throws<InvalidOperationException>(() => new Mesh().BoxCorners());
        Assert.Throws<ArgumentOutOfRangeException>(() => Models.Tetrahedron().ScaleToSize(0));
        var point = new Mesh();
        point.AddVertex(default);
        Assert.Throws<InvalidOperationException>(() => point.Normalize());
    }

    // 0 ─ 1 ─ 2 ─ 3 ─ 4 with 0, 1, 3, 4 selected: two groups
    [Fact]
    public void LabelSelectedGroups_TwoPatches_NumbersThemBySmallestVertex()
    {
        Mesh mesh = Models.QuadGrid(4, 1);
        Assert.Equal(0, mesh.LabelSelectedGroups());
        foreach (int v in (int[])[3, 4, 9, 0, 1])
            mesh.Vertices[v].Traits.SelectedFlag = 77;

        Assert.Equal(2, mesh.LabelSelectedGroups());

        Assert.Equal([1, 1, 0, 2, 2, 0, 0, 0, 0, 2], mesh.Vertices.Select(v => v.Traits.SelectedFlag));
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void ReorderBySpace_EveryModel_IsTheSameMeshUnderItsMaps(string name)
    {
        Mesh mesh = Models.Create(name);
        if (mesh.Faces.Count > 3)
            mesh.Faces[2].TryDelete(out _);
        (VertexTrait<int> vertex, HalfEdgeTrait<int> halfEdge, EdgeTrait<int> edge, FaceTrait<int> face) = IndexTraits.AddTo(mesh);
        Mesh old = mesh.Clone();

        CompactionMaps maps = mesh.ReorderBySpace();

        Assert.True(mesh.IsCompact);
        Assert.Empty(mesh.Validate());
        foreach (Vertex v in old.Vertices)
            Assert.Equal((v.Position, v.Index), (mesh.Positions[maps.Vertices[v.Index]], vertex[maps.Vertices[v.Index]]));
        foreach (HalfEdge h in old.HalfEdges)
        {
            HalfEdge now = mesh.HalfEdges[maps.HalfEdges[h.Index]];
            Assert.Equal(maps.Vertices[h.Target.Index], now.Target.Index);
            Assert.Equal(maps.HalfEdges[h.Next.Index], now.Next.Index);
            Assert.Equal((h.Index, h.Edge.Index), (halfEdge[now], edge[now.Edge]));
            Assert.Equal(h.IsBoundary ? -1 : h.Face.Index, now.IsBoundary ? -1 : face[now.Face]);
        }
        ulong once = mesh.StateHash();
        mesh.ReorderBySpace();
        Assert.Equal(once, mesh.StateHash());
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void ReverseOrientation_Twice_IsTheIdentityAndKeepsTraits(string name)
    {
        Mesh mesh = Models.Create(name);
        HalfEdgeTrait<int> corner = mesh.AddHalfEdgeTrait("corner", -1);
        foreach (HalfEdge h in mesh.HalfEdges)
        {
            if (!h.IsBoundary)
                corner[h] = (1000 * h.Face.Index) + h.Target.Index;
        }
        List<int[]> faces = [.. mesh.Faces.Select(f => f.Vertices.Select(v => v.Index).ToArray())];
        ulong before = mesh.StateHash();

        mesh.ReverseOrientation();

        Assert.Empty(mesh.Validate());
        foreach (Face f in mesh.Faces)
        {
            int[] was = faces[f.Index];
            Assert.Equal([was[0], .. was.Skip(1).Reverse()], f.Vertices.Select(v => v.Index));
            Assert.All(f.HalfEdges, h => Assert.Equal((1000 * f.Index) + h.Target.Index, corner[h]));
        }
        mesh.ReverseOrientation();
        Assert.Equal(before, mesh.StateHash());
    }

    [Fact]
    public void ReverseOrientation_WithNormals_TurnsThem()
    {
        Mesh mesh = Models.Tetrahedron();
        mesh.Faces[0].Traits.Normal = Vector3D.UnitX;
        mesh.ReverseOrientation();
        Assert.Equal(-Vector3D.UnitX, mesh.Faces[0].Traits.Normal);
        using OperationHistory history = mesh.StartRecording();
        Assert.Throws<InvalidOperationException>(() => mesh.ReverseOrientation());
        Assert.Throws<InvalidOperationException>(() => mesh.ReorderBySpace());
    }

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void WithConsistentOrientation_SomeFacesTurned_MakesThemAgreeAgain(string name)
    {
        Mesh mesh = Models.Create(name);
        var random = new Random(9);
        int[][] faces = [.. mesh.Faces.Select(f => f.Vertices.Select(v => v.Index).ToArray())];
        int turned = 0;
        foreach (int[] face in faces)
        {
            if (random.Next(3) != 0)
                continue;
            Array.Reverse(face);
            turned++;
        }
        PolygonSoup soup = PolygonSoup.From(mesh.Positions, faces);

        SoupOrientationResult result = soup.WithConsistentOrientation();

        Assert.Empty(result.NonOrientable);
        Mesh again = MeshBuilder.FromPolygons(result.Soup);
        Assert.Empty(again.Validate());
        Assert.Equal(mesh.Faces.Count, again.Faces.Count);
        Assert.True(turned == 0 || mesh.Faces.Count < 2 || result.Reversed.Count > 0 || !mesh.IsClosed);
    }

    [Fact]
    public void WithConsistentOrientation_InsideOutCube_TurnsOutward()
    {
        Mesh cube = Models.Create("cube");
        cube.ReverseOrientation();
        PolygonSoup soup = PolygonSoup.From(cube.Positions, [.. cube.Faces.Select(f => f.Vertices.Select(v => v.Index).ToArray())]);
        Assert.Equal(12, soup.WithConsistentOrientation().Reversed.Count);
        Assert.Empty(soup.WithConsistentOrientation(outward: false).Reversed);
    }

    [Fact]
    public void WithConsistentOrientation_MoebiusStrip_SaysNonOrientable()
    {
        // Five quads in a strip whose ends are joined crosswise.
        int[][] quads = [.. Enumerable.Range(0, 5).Select(i => i < 4 ? new[] { 2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1 } : [8, 1, 0, 9])];
        SoupOrientationResult result = PolygonSoup.From(new Vector3D[10], quads).WithConsistentOrientation();
        Assert.Single(result.NonOrientable);
        Assert.Equal(1, result.Components);
        Assert.Empty(result.Reversed);
    }

    [Fact]
    public void ReorderBySpace_ShuffledGrid_FollowsTheMortonCurve()
    {
        const int Side = 16;
        int[] place = [.. Enumerable.Range(0, Side * Side)];
        new Random(3).Shuffle(place);
        var positions = new Vector3D[place.Length];
        for (int i = 0; i < place.Length; i++)
            positions[place[i]] = new(i % Side, i / Side, 0);
        int[][] faces =
        [
            .. from y in Enumerable.Range(0, Side - 1)
               from x in Enumerable.Range(0, Side - 1)
               let i = x + (Side * y)
               select (int[])[place[i], place[i + 1], place[i + Side + 1], place[i + Side]],
        ];
        Mesh mesh = MeshBuilder.FromPolygons(positions, faces);
        mesh.ReorderBySpace();

        // In a square of 2ᵏ points the curve visits the four quarters one after the other: bits of x and y alternate.
        int[] codes = [.. mesh.Vertices.Select(v => Code((int)v.Position.X, (int)v.Position.Y))];
        Assert.Equal(codes.Order(), codes);
        int[] smallest = [.. mesh.Faces.Select(f => f.Vertices.Min(v => v.Index))];
        Assert.Equal(smallest.Order(), smallest);
        Assert.Empty(mesh.Validate());

        static int Code(int x, int y) => Enumerable.Range(0, 4).Sum(bit => ((x >> bit & 1) << (2 * bit)) + ((y >> bit & 1) << ((2 * bit) + 1)));
    }
}
