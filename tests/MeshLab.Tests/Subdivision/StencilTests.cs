using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Subdivision;
using MeshLab.Tests.Simplification;
using Xunit;

namespace MeshLab.Tests.Subdivision;

/// <summary>One step by hand: fractional sharpness, and which old elements the traits of new ones come from.</summary>
[Trait("Section", "8")]
public class StencilTests
{
    private static Mesh Bumpy(int n) => Shapes.Sheet(n, (x, y) => 0.2 * Math.Sin(5 * x + 1) * Math.Cos(4 * y) + x * x);

    [Theory]
    [InlineData(SubdivisionScheme.Loop)]
    [InlineData(SubdivisionScheme.CatmullClark)]
    public void Subdivide_SharpnessBelowOne_MixesBothRulesByIt(SubdivisionScheme scheme)
    {
        Mesh mesh = Bumpy(6);
        // Two edges at an inner vertex, and two that end at the border.
        Vertex inner = mesh.Vertices[24], border = mesh.Vertices[3];
        Edge[] at = [mesh.FindEdge(inner, mesh.Vertices[23]), mesh.FindEdge(inner, mesh.Vertices[25]), .. border.Edges.Where(e => !e.IsBoundary).Take(2)];
        double[] sharpness = [0.4, 0.8, 0.2, 0.6];
        Assert.False(inner.IsBoundary);
        Assert.True(border.IsBoundary);
        Mesh smooth = mesh.Subdivide(scheme);
        for (int i = 0; i < at.Length; i++)
            Creases.Set(mesh, [at[i]], sharpness[i]);

        Mesh finer = mesh.Subdivide(scheme);

        for (int i = 0; i < at.Length; i++)
        {
            int v = mesh.VertexSlots + at[i].Index;
            Near(Vector3D.Lerp(smooth.Positions[v], (at[i].Vertex0.Position + at[i].Vertex1.Position) * 0.5, sharpness[i]), finer.Positions[v]);
        }
        // Their mean along a line; where lines meet, as at the border, the largest.
        Vector3D onLine = 0.75 * inner.Position + 0.125 * (mesh.Positions[23] + mesh.Positions[25]);
        Near(Vector3D.Lerp(smooth.Positions[24], onLine, 0.6), finer.Positions[24]);
        Near(Vector3D.Lerp(smooth.Positions[3], border.Position, 0.6), finer.Positions[3]);

        static void Near(Vector3D expected, Vector3D actual) => Assert.True(Vector3D.Distance(expected, actual) < 1e-14, $"{expected} {actual}");
    }

    /// <summary>A trait that holds the positions and is blended with the scheme's own weights is the position again.</summary>
    [Fact]
    public void DooSabin_TraitOfPositions_IsThePosition()
    {
        Mesh mesh = Bumpy(4);
        VertexTrait<Vector3D> place = mesh.AddVertexTrait<Vector3D>("place", default, Blend.Linear);
        foreach (Vertex v in mesh.Vertices)
            place[v] = v.Position;

        Mesh finer = mesh.Subdivide(SubdivisionScheme.DooSabin);

        Assert.True(finer.TryGetVertexTrait("place", out VertexTrait<Vector3D>? fine));
        Assert.All(finer.Vertices, v => Assert.True(Vector3D.Distance(v.Position, fine[v]) < 1e-14, $"{v}"));
    }

    [Fact]
    public void Sqrt3_PointsOfABoundaryEdge_AreAtItsThirds()
    {
        Mesh mesh = MeshLab.Generation.Prisms.OpenCylinder(8, 4);
        VertexTrait<double> number = mesh.AddVertexTrait<double>("number", 0, Blend.Linear);
        foreach (Vertex v in mesh.Vertices)
            number[v] = v.Index * v.Index;

        Mesh finer = mesh.Subdivide(SubdivisionScheme.Sqrt3, new() { BeginWithBoundaryTrisection = true });

        Assert.True(finer.TryGetVertexTrait("number", out VertexTrait<double>? fine));
        int seen = 0;
        foreach (HalfEdge h in finer.HalfEdges)
        {
            // Along the border: old vertex, two new ones, old vertex.
            if (!h.IsBoundary || h.Source.Index >= mesh.VertexSlots)
                continue;
            Vertex a = h.Source, p = h.Target, q = h.Next.Target, b = h.Next.Next.Target;
            Assert.True(b.Index < mesh.VertexSlots);
            Assert.Equal((2 * number[mesh.Vertices[a.Index]] + number[mesh.Vertices[b.Index]]) / 3, fine[p], 1e-12);
            Assert.Equal((number[mesh.Vertices[a.Index]] + 2 * number[mesh.Vertices[b.Index]]) / 3, fine[q], 1e-12);
            seen++;
        }
        Assert.Equal(16, seen);
    }

    [Fact]
    public void Sqrt3_EdgeTraits_StayOnTheBoundaryOnly()
    {
        Mesh mesh = MeshLab.Generation.Prisms.OpenCylinder(8, 4);
        EdgeTrait<int> mark = mesh.AddEdgeTrait("mark", -1);
        foreach (Edge e in mesh.Edges)
            mark[e] = e.Index;

        Mesh finer = mesh.Subdivide(SubdivisionScheme.Sqrt3);

        Assert.True(finer.TryGetEdgeTrait("mark", out EdgeTrait<int>? fine));
        foreach (Edge e in finer.Edges)
        {
            int expected = e.IsBoundary ? mesh.FindEdge(mesh.Vertices[e.Vertex0.Index], mesh.Vertices[e.Vertex1.Index]).Index : -1;
            Assert.Equal(expected, fine[e]);
        }
    }

    /// <summary>The limit is the same before and after a step, whatever the places: at inner vertices, at borders of few and many faces.</summary>
    [Theory]
    [InlineData(SubdivisionScheme.Loop)]
    [InlineData(SubdivisionScheme.CatmullClark)]
    public void Limit_OfAnyPlaces_IsThatOfTheNextStep(SubdivisionScheme scheme)
    {
        for (int k = 1; k <= 9; k++)
        {
            // A fan of k triangles at a border, cut finer so that quadrilaterals have corners of their own; then shaken.
            Vector3D[] rim = [.. Enumerable.Range(0, k + 1).Select(i => new Vector3D(Math.Cos(Math.PI * i / 9), Math.Sin(Math.PI * i / 9), 0))];
            Mesh fan = MeshBuilder.FromTriangles([default, .. rim], [.. Enumerable.Range(1, k).SelectMany(i => new[] { 0, i, i + 1 })]);
            Mesh mesh = fan.Subdivide(scheme);
            var random = new Random(k);
            foreach (Vertex v in mesh.Vertices)
                v.Position += 0.1 * new Vector3D(random.NextDouble(), random.NextDouble(), random.NextDouble());

            LimitPoints now = LimitOf(mesh), next = LimitOf(mesh.Subdivide(scheme));

            for (int v = 0; v < mesh.VertexSlots; v++)
            {
                Assert.True(Vector3D.Distance(now.Positions[v], next.Positions[v]) < 1e-12, $"{k}: v{v}");
                Assert.True(Vector3D.Angle(now.Normals[v], next.Normals[v]) < 1e-7, $"{k}: v{v} {now.Normals[v]} {next.Normals[v]}");
            }
        }

        LimitPoints LimitOf(Mesh mesh) => scheme == SubdivisionScheme.Loop ? LimitSurface.OfLoop(mesh) : LimitSurface.OfCatmullClark(mesh);
    }

    [Fact]
    public void Limit_OfACorner_IsItsPlace()
    {
        Mesh mesh = Shapes.Cube(2);
        Creases.SetByAngle(mesh, 1);
        Vertex corner = mesh.Vertices.First(v => v.Position == default);

        Assert.Equal(default, LimitSurface.OfLoop(mesh).Positions[corner.Index]);
        Assert.Equal(default, LimitSurface.OfCatmullClark(mesh).Positions[corner.Index]);
    }
}
