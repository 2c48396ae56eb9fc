using System.Text.Json;
using MeshLab.Cutting;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Topology;
using Xunit;

namespace MeshLab.Tests.Cutting;

[Trait("Section", "6.2")]
public class PlaneCutTests
{
    private static readonly PlaneCutOptions Capped = new() { Cap = true };

    [Theory]
    [InlineData(0.5, 0.5, 0.5)]
    [InlineData(0.25, 0.75, 0.25)]
    public void Split_UnitCubeAcross_GivesTwoBoxes(double z, double above, double below)
    {
        Mesh cube = Models.Create("cube");
        ulong before = cube.StateHash();
        (PlaneCutResult up, PlaneCutResult down) = cube.Split(new(Vector3D.UnitZ, z), Capped);
        AssertClosed(up, above);
        AssertClosed(down, below);
        Assert.Equal(2 + 4 * (1 - z), up.Part.Mesh.Area, 1e-14);
        Assert.Equal(1, up.CapLoops);
        Assert.Equal(before, cube.StateHash());

        PlaneCutResult open = cube.Clip(new(Vector3D.UnitZ, z), PlaneSide.Above);
        Assert.Equal(1 + 4 * (1 - z), open.Part.Mesh.Area, 1e-14);
        Assert.Equal(1, open.Part.Mesh.ComputeTopology().BoundaryLoops);
        Assert.Empty(open.Part.Mesh.Validate());
    }

    [Fact]
    public void Split_CubeThroughADiagonal_RunsThroughVerticesAndEdges()
    {
        // x = y holds two opposite edges and two face diagonals, of which the triangulation may have either.
        Mesh cube = Models.Create("cube");
        (PlaneCutResult up, PlaneCutResult down) = cube.Split(new(new(1, -1, 0), 0), Capped);
        AssertClosed(up, 0.5);
        AssertClosed(down, 0.5);
        Assert.Equal(1 + 2 + Math.Sqrt(2), up.Part.Mesh.Area, 1e-14);
        PlaneSectionResult section = cube.ComputeSection(new(new(1, -1, 0), 0));
        Assert.Equal((1, 0), (section.ClosedLoops, section.OpenChains));
        Assert.Equal(2 + 2 * Math.Sqrt(2), section.Length, 1e-14);
        Assert.Equal(Math.Sqrt(2), section.Area!.Value, 1e-14);
    }

    [Fact]
    public void Clip_PlaneInACubesFace_IsAllOrNothing()
    {
        Mesh cube = Models.Create("cube");
        AssertClosed(cube.Clip(new(Vector3D.UnitZ, 0), PlaneSide.Above, Capped), 1);
        Assert.Equal(0, cube.Clip(new(Vector3D.UnitZ, 0), PlaneSide.Below, Capped).Part.Mesh.Faces.Count);
        AssertClosed(cube.Clip(new(Vector3D.UnitZ, 1), PlaneSide.Below, Capped), 1);
        Assert.Equal(0, cube.Clip(new(Vector3D.UnitZ, 1), PlaneSide.Above, Capped).Part.Mesh.Faces.Count);
        // Without caps the face in the plane belongs to the part above.
        Assert.Equal(1, cube.Clip(new(Vector3D.UnitZ, 1), PlaneSide.Above).Part.Mesh.Area, 1e-14);
        Assert.Equal(5, cube.Clip(new(Vector3D.UnitZ, 1), PlaneSide.Below).Part.Mesh.Area, 1e-14);
        Assert.Equal(4, cube.ComputeSection(new(Vector3D.UnitZ, 1)).Length, 1e-14);
        Assert.Empty(cube.ComputeSection(new(Vector3D.UnitZ, 0)).Polylines);
    }

    [Fact]
    public void Split_OctahedronThroughItsEquator_GivesPyramids()
    {
        Mesh octahedron = Models.Create("octahedron");
        foreach (Vector3D axis in (Vector3D[])[Vector3D.UnitX, Vector3D.UnitY, Vector3D.UnitZ])
        {
            (PlaneCutResult up, PlaneCutResult down) = octahedron.Split(new(axis, 0), new PlaneCutOptions { Cap = true, Tolerance = 1e-12 });
            AssertClosed(up, 2.0 / 3);
            AssertClosed(down, 2.0 / 3);
            Assert.Equal(5, up.Part.Mesh.Vertices.Count);
            Assert.Equal(2 + Math.Sqrt(12), up.Part.Mesh.Area, 1e-12);
        }
        Assert.Equal(4, octahedron.ComputeSection(new(Vector3D.UnitZ, 0)).Polylines.Single().Points.Count);
    }

    [Fact]
    public void Clip_GridThroughAColumnOfVertices_KeepsThem()
    {
        Mesh grid = MeshLab.Geometry.Triangulation.Triangulate(Models.QuadGrid(4, 4)).Mesh;
        PlaneCutResult right = grid.Clip(new(Vector3D.UnitX, 0.5), PlaneSide.Above), left = grid.Clip(new(Vector3D.UnitX, 0.5), PlaneSide.Below);
        Assert.Equal((15, 16), (right.Part.Mesh.Vertices.Count, right.Part.Mesh.Faces.Count));
        Assert.Equal((15, 16), (left.Part.Mesh.Vertices.Count, left.Part.Mesh.Faces.Count));
        Assert.DoesNotContain(-1, right.Part.SourceVertex);
        Assert.Equal(1, right.OpenChains);
        SectionPolyline line = grid.ComputeSection(new(Vector3D.UnitX, 0.5)).Polylines.Single();
        Assert.False(line.IsClosed);
        Assert.Equal(1, line.Length, 1e-14);
        Assert.Equal(5, line.Points.Count);
    }

    [Fact]
    public void Split_Torus_CapsARingAndTwoDisks()
    {
        Mesh torus = Models.Torus(40, 24);
        (PlaneCutResult up, _) = torus.Split(new(Vector3D.UnitZ, 0.01), Capped);
        Assert.Equal(2, up.CapLoops);
        PlaneSectionResult ring = torus.ComputeSection(new(Vector3D.UnitZ, 0.01));
        Assert.Equal([1, 0], ring.Polylines.Select(line => line.Depth).OrderDescending());
        Assert.Equal(1, ring.Polylines.Count(line => line.Area < 0));
        Assert.Equal(0, up.Part.Mesh.EulerCharacteristic);
        AssertClosed(up, up.Part.Mesh.Volume);
        (PlaneCutResult half, _) = torus.Split(new(Vector3D.UnitX, 0.01), Capped);
        Assert.Equal(2, half.CapLoops);
        Assert.Equal(2, half.Part.Mesh.EulerCharacteristic);
    }

    [Theory]
    [MemberData(nameof(Models.ClosedTriangleMeshes), MemberType = typeof(Models))]
    public void Split_RandomAndTouchingPlanes_HalvesAreClosedAndAddUp(string name)
    {
        Mesh mesh = Models.Create(name);
        var random = new Random(5);
        double volume = mesh.Volume;
        for (int i = 0; i < 60; i++)
        {
            Vector3D normal = i % 5 == 0 ? Vector3D.UnitZ : i % 5 == 1 ? Vector3D.UnitX : new(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5);
            // Every other plane runs through a vertex.
            Vector3D point = mesh.Positions[random.Next(mesh.VertexSlots)];
            if (i % 2 == 0)
                point = Vector3D.Lerp(point, mesh.Positions[random.Next(mesh.VertexSlots)], random.NextDouble());
            AssertHalves(mesh, CuttingPlane.Through(point, normal), volume, name);
        }
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void Split_OpenModels_AreasAddUp(string name)
    {
        Mesh mesh = Models.Create(name);
        if (mesh.Vertices.Count == 0)
            return;
        Vector3D center = mesh.BoundingBox.Center;
        double area = mesh.Area;
        if (area == 0)
            return;
        foreach (Vector3D normal in (Vector3D[])[Vector3D.UnitX, Vector3D.UnitZ, new(1, 2, 3), new(-1, 1, 0)])
        {
            (PlaneCutResult up, PlaneCutResult down) = mesh.Split(CuttingPlane.Through(center, normal));
            Assert.Empty(up.Part.Mesh.Validate());
            Assert.Empty(down.Part.Mesh.Validate());
            Assert.Equal(1, (up.Part.Mesh.Area + down.Part.Mesh.Area) / area, 1e-9);
        }
    }

    [Fact]
    public void Clip_Traits_AreInterpolated()
    {
        Mesh mesh = Models.Sphere(8, 10);
        VertexTrait<double> height = mesh.AddVertexTrait<double>("height", 0, Blend.Linear);
        foreach (Vertex v in mesh.Vertices)
            height[v] = v.Position.Z;
        FaceTrait<int> number = mesh.AddFaceTrait<int>("number", -7);
        foreach (Face f in mesh.Faces)
            number[f] = f.Index;
        HalfEdgeTrait<double> corner = mesh.AddHalfEdgeTrait<double>("corner", -9, Blend.Linear);
        foreach (HalfEdge h in mesh.HalfEdges)
            corner[h] = h.Target.Position.X;
        EdgeTrait<int> edge = mesh.AddEdgeTrait<int>("edge", -1);
        foreach (Edge e in mesh.Edges)
            edge[e] = e.Index;

        var plane = new CuttingPlane(new(1, 1, 2), 0.1);
        MeshPart part = mesh.Clip(plane, PlaneSide.Above, Capped).Part;
        // Every vertex is an old one, or lies on an old edge and on the plane.
        foreach (Vertex v in part.Mesh.Vertices)
        {
            Assert.NotEqual(part.SourceVertex[v.Index] < 0, part.SourceEdge[v.Index] < 0);
            if (part.SourceEdge[v.Index] < 0)
                continue;
            Edge cut = mesh.Edges[part.SourceEdge[v.Index]];
            Assert.Equal(0, plane.Distance(v.Position), 1e-14);
            Assert.Equal(Vector3D.Distance(cut.Vertex0.Position, cut.Vertex1.Position), Vector3D.Distance(cut.Vertex0.Position, v.Position) + Vector3D.Distance(v.Position, cut.Vertex1.Position), 1e-14);
        }
        Assert.True(part.Mesh.TryGetVertexTrait("height", out VertexTrait<double>? newHeight));
        Assert.All(part.Mesh.Vertices, v => Assert.Equal(v.Position.Z, newHeight![v], 1e-14));
        Assert.True(part.Mesh.TryGetFaceTrait("number", out FaceTrait<int>? newNumber));
        Assert.All(part.Mesh.Faces, f => Assert.Equal(part.SourceFace[f.Index] < 0 ? -7 : part.SourceFace[f.Index], newNumber![f]));
        Assert.True(part.Mesh.TryGetHalfEdgeTrait("corner", out HalfEdgeTrait<double>? newCorner));
        Assert.All(part.Mesh.HalfEdges, h => Assert.Equal(part.SourceFace[h.Face.Index] < 0 ? -9 : h.Target.Position.X, newCorner![h], 1e-14));
        Assert.True(part.Mesh.TryGetEdgeTrait("edge", out EdgeTrait<int>? newEdge));
        foreach (Edge e in part.Mesh.Edges)
        {
            int a = part.SourceVertex[e.Vertex0.Index], b = part.SourceVertex[e.Vertex1.Index];
            if (a >= 0 && b >= 0)
                Assert.Equal(mesh.FindEdge(mesh.Vertices[a], mesh.Vertices[b]).Index, newEdge![e]);
        }
    }

    [Fact]
    public void CuttingPlane_NormalOfAnyLength_IsTheSamePlane()
    {
        var plane = new CuttingPlane(new(0, 0, 4), 1);
        Assert.Equal((Vector3D.UnitZ, 0.25), (plane.Normal, plane.Offset));
        Assert.Equal(0.5, plane.Distance(new(7, 8, 0.75)));
        Assert.Equal(plane, CuttingPlane.Through(new(7, 8, 0.25), new(0, 0, 4)));
        // Twice as long, a quarter up: a box of height 0.75 above.
        AssertClosed(Models.Create("cube").Clip(plane, PlaneSide.Above, Capped), 0.75);
        Assert.Equal(new Vector3D(0, 0.6, 0.8), new CuttingPlane(new(0, 3, 4), 5).Normal);
        Assert.Equal(1, new CuttingPlane(new(0, 3, 4), 5).Offset);
    }

    [Fact]
    public void ComputeSection_VerticesJustWithinTheTolerance_LieOnThePlane()
    {
        Mesh cube = Models.Create("cube");
        var plane = new CuttingPlane(Vector3D.UnitZ, 1.25);
        Assert.Equal(4, cube.ComputeSection(plane, 0.25).Length);
        Assert.All(cube.ComputeSection(plane, 0.25).Polylines.Single().Points, p => Assert.Equal(1, p.Z));
        Assert.Empty(cube.ComputeSection(plane, 0.2499).Polylines);
        AssertClosed(cube.Clip(plane, PlaneSide.Below, new PlaneCutOptions { Cap = true, Tolerance = 0.25 }), 1);
    }

    [Fact]
    public void ComputeSection_OpenLine_HasNoArea()
    {
        Mesh grid = Models.Triangulated(Models.QuadGrid(4, 4));
        PlaneSectionResult section = grid.ComputeSection(new(Vector3D.UnitX, 0.3));
        Assert.Equal((0, 1), (section.ClosedLoops, section.OpenChains));
        Assert.Null(section.Area);
        Assert.Equal(0, section.Polylines.Single().Area);
        // A line that is open takes the area from the whole section, though the other line is closed.
        grid.Append(Models.Create("cube"));
        section = grid.ComputeSection(new(Vector3D.UnitX, 0.3));
        Assert.Equal((1, 1), (section.ClosedLoops, section.OpenChains));
        Assert.Null(section.Area);
    }

    [Fact]
    public void ComputeSection_TipOnThePlane_IsCrossedButLeavesNoLine()
    {
        PlaneSectionResult section = Models.Create("octahedron").ComputeSection(new(Vector3D.UnitZ, 1));
        Assert.Equal((4, 0), (section.Segments, section.Polylines.Count));
        Assert.Equal((0.0, 0.0), (section.Length, section.Area!.Value));
    }

    [Theory]
    [MemberData(nameof(Models.ClosedTriangleMeshes), MemberType = typeof(Models))]
    public void ComputeSection_PlanesThroughVertices_RepeatNoPoint(string name)
    {
        Mesh mesh = Models.Create(name);
        for (int v = 0; v < Math.Min(mesh.VertexSlots, 40); v++)
        {
            foreach (Vector3D normal in (Vector3D[])[Vector3D.UnitX, -Vector3D.UnitY, new(1, -2, 3)])
            {
                foreach (SectionPolyline line in mesh.ComputeSection(CuttingPlane.Through(mesh.Positions[v], normal)).Polylines)
                {
                    Assert.True(line.IsClosed && line.Points.Count > 1);
                    for (int i = 0; i < line.Points.Count; i++)
                        Assert.NotEqual(line.Points[i], line.Points[(i + 1) % line.Points.Count]);
                }
            }
        }
    }

    [Theory]
    [InlineData(3, 2, 1)]
    [InlineData(1, 2, 3)]
    [InlineData(2, 3, 1)]
    [InlineData(2, 1, 3)]
    public void ComputeSection_BoxesInBoxes_NamesTheSmallestAround(params int[] sizes)
    {
        var boxes = new Mesh();
        foreach (int size in sizes)
        {
            Mesh box = Models.Create("cube");
            foreach (Vertex v in box.Vertices)
                v.Position = (v.Position - new Vector3D(0.5, 0.5, 0.5)) * size;
            boxes.Append(box);
        }
        IReadOnlyList<SectionPolyline> lines = boxes.ComputeSection(new(Vector3D.UnitZ, 0.125)).Polylines;
        Assert.Equal(sizes.Select(size => (double)size * size), lines.Select(line => line.Area));
        Assert.Equal(sizes.Select(size => 3 - size), lines.Select(line => line.Depth));
        Assert.Equal(sizes.Select(size => Array.IndexOf(sizes, size + 1)), lines.Select(line => line.Parent));
    }

    [Fact]
    public void Split_PlaneAlongARidge_TouchesItAndCapsNothing()
    {
        // A roof: the line runs along the ridge of two edges and back.
        Mesh roof = MeshBuilder.FromTriangles(
            [new(0, 0, 0), new(2, 0, 0), new(2, 2, 0), new(0, 2, 0), new(0, 1, 1), new(1, 1, 1), new(2, 1, 1)],
            [0, 2, 1, 0, 3, 2, 0, 1, 5, 0, 5, 4, 1, 6, 5, 2, 3, 5, 2, 5, 6, 3, 4, 5, 1, 2, 6, 0, 4, 3]);
        Assert.Empty(roof.Validate());
        Assert.True(roof.IsClosed);
        (PlaneCutResult above, PlaneCutResult below) = roof.Split(new(Vector3D.UnitZ, 1), Capped);
        Assert.Equal(0, above.Part.Mesh.Faces.Count);
        AssertClosed(below, 2);
        Assert.Equal((7, 10, 0), (below.Part.Mesh.Vertices.Count, below.Part.Mesh.Faces.Count, below.CapFaces));
        Assert.Equal(Enumerable.Range(0, 7), below.Part.SourceVertex.Order());
    }

    [Fact]
    public void Clip_IsolatedVertices_AreLeftOut()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(9, 9, 9), new(0, 0, 0), new(1, 0, 0), new(0, 0, 1), new(0, 1, 0)], [1, 3, 2, 1, 2, 4, 2, 3, 4, 3, 1, 4]);
        MeshPart part = mesh.Clip(new(Vector3D.UnitZ, -1), PlaneSide.Above).Part;
        Assert.Equal([1, 2, 3, 4], part.SourceVertex);
        Assert.Equal([-1, 0, 1, 2, 3], part.NewVertex);
    }

    [Fact]
    public void Clip_FaceInTwoPieces_NamesTheLowest()
    {
        // One triangle with two vertices above: a quadrilateral, cut in two.
        Mesh triangle = MeshBuilder.FromTriangles([new(0, 0, 0), new(2, 2, 0), new(-2, 2, 0)], [0, 1, 2]);
        MeshPart part = triangle.Clip(new(Vector3D.UnitY, 1), PlaneSide.Above).Part;
        Assert.Equal([0, 0], part.SourceFace);
        Assert.Equal([0], part.NewFace);
        Assert.Equal([-1, 0, 1], part.NewVertex);
        Assert.Equal([1, 2, -1, -1], part.SourceVertex);
        Assert.Equal(
            new[] { -1, -1, triangle.FindEdge(triangle.Vertices[0], triangle.Vertices[1]).Index, triangle.FindEdge(triangle.Vertices[2], triangle.Vertices[0]).Index }.Order(),
            part.SourceEdge.Order());
        Assert.Equal(3, part.Mesh.Area, 1e-15);
    }

    [Fact]
    public void Cut_BadInput_IsRefused()
    {
        ArgumentException zero = Assert.Throws<ArgumentException>(() => new CuttingPlane(default, 1));
        Assert.Equal("normal", zero.ParamName);
        Assert.Contains("not zero", zero.Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => new CuttingPlane(new(double.NaN, 0, 1), 1));
        Assert.Throws<ArgumentException>(() => new CuttingPlane(new(0, 0, double.PositiveInfinity), 1));
        Assert.Throws<ArgumentException>(() => new CuttingPlane(Vector3D.UnitX, double.NaN));
        Assert.Throws<ArgumentException>(() => Models.Create("cube").ComputeSection(default));
        Assert.Contains("f0", Assert.Throws<ArgumentException>(() => Models.Create("cube-quads").ComputeSection(new(Vector3D.UnitZ, 0.5))).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>(() => new PlaneCutOptions { Tolerance = -1 });
        Assert.Empty(Models.Create("cube").ComputeSection(new(Vector3D.UnitZ, 9)).Polylines);
        Assert.Equal(0, Models.Create("cube").Clip(new(Vector3D.UnitZ, 9), PlaneSide.Above, Capped).Part.Mesh.Vertices.Count);
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void SectionAndHalves_PublicModels_EqualTheReference(string name)
    {
        JsonElement root = ReferenceData.Json(name, "section").RootElement;
        Mesh mesh = ReferenceData.Load(name);
        foreach (string at in (string[])["mid", "at_0.377"])
        {
            JsonElement own = root.GetProperty(at).GetProperty("own");
            var plane = new CuttingPlane(Vector3D.UnitZ, root.GetProperty(at).GetProperty("z").GetDouble());
            PlaneSectionResult section = mesh.ComputeSection(plane);
            Close(own.GetProperty("length"), section.Length, "length");
            Assert.Equal(own.GetProperty("segments").GetInt32(), section.Segments);
            Assert.Equal(own.GetProperty("closed_loops").GetInt32(), section.ClosedLoops);
            Assert.Equal(own.GetProperty("open_chains").GetInt32(), section.OpenChains);
            bool closed = own.GetProperty("section_area").ValueKind != JsonValueKind.Null;
            if (closed)
                Close(own.GetProperty("section_area"), section.Area!.Value, "area");
            foreach (PlaneSide side in (PlaneSide[])[PlaneSide.Above, PlaneSide.Below])
            {
                JsonElement half = own.GetProperty(side == PlaneSide.Above ? "upper" : "lower");
                Mesh open = mesh.Clip(plane, side).Part.Mesh;
                Close(half.GetProperty("area_open"), open.Area, $"{side} area");
                Assert.Empty(open.Validate());
                if (!closed)
                    continue;
                Mesh capped = mesh.Clip(plane, side, Capped).Part.Mesh;
                Assert.True(capped.IsClosed);
                Assert.Empty(capped.Validate());
                Close(half.GetProperty("area_capped"), capped.Area, $"{side} capped area");
                Close(half.GetProperty("volume_capped"), capped.Volume, $"{side} volume");
            }
        }

        void Close(JsonElement expected, double actual, string what) => Assert.True(
            Math.Abs(actual - expected.GetDouble()) <= 1e-9 * Math.Abs(expected.GetDouble()), $"{name} {what}: {actual:R}, expected {expected.GetDouble():R}.");
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void Split_TwoHundredRandomPlanes_HalvesAreClosedAndAddUp(string name)
    {
        Mesh mesh = ReferenceData.Load(name);
        if (!mesh.IsClosed)
            return;
        var random = new Random(17);
        BoundingBox box = mesh.BoundingBox;
        double volume = mesh.Volume;
        var planes = new CuttingPlane[200];
        for (int i = 0; i < planes.Length; i++)
        {
            Vector3D normal = new(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5);
            Vector3D point = box.Min + new Vector3D(random.NextDouble() * box.Size.X, random.NextDouble() * box.Size.Y, random.NextDouble() * box.Size.Z);
            planes[i] = CuttingPlane.Through(i % 4 == 3 ? mesh.Positions[random.Next(mesh.VertexSlots)] : point, normal);
        }
        Parallelism.ForBlocks(planes.Length, 5, (from, to) =>
        {
            for (int i = from; i < to; i++)
                AssertHalves(mesh, planes[i], volume, name);
        });
    }

    private static void AssertHalves(Mesh mesh, CuttingPlane plane, double volume, string name)
    {
        (PlaneCutResult up, PlaneCutResult down) = mesh.Split(plane, Capped);
        foreach (PlaneCutResult half in (PlaneCutResult[])[up, down])
        {
            Assert.True(half.Part.Mesh.IsClosed, $"{name} {plane} is open.");
            Assert.Empty(half.Part.Mesh.Validate());
        }
        double sum = (up.Part.Mesh.Faces.Count == 0 ? 0 : up.Part.Mesh.Volume) + (down.Part.Mesh.Faces.Count == 0 ? 0 : down.Part.Mesh.Volume);
        Assert.True(Math.Abs(sum - volume) <= 1e-9 * Math.Abs(volume), $"{name} {plane}: {sum:R}, expected {volume:R}.");
    }

    private static void AssertClosed(PlaneCutResult half, double volume)
    {
        Assert.True(half.Part.Mesh.IsClosed);
        Assert.Empty(half.Part.Mesh.Validate());
        Assert.Equal(volume, half.Part.Mesh.Volume, 1e-12);
    }
}
