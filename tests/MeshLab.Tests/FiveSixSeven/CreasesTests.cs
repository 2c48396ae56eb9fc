using MeshLab.FiveSixSeven;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.FiveSixSeven;

[Trait("Section", "9.6")]
public class CreasesTests
{
    private const double Angle = 40 * Math.PI / 180;

    private static int CountOf(WorkMesh work, int kind) => work.Kind.Take(work.VertexSlots).Count(k => k == kind);

    [Fact]
    public void Mark_Cube_MarksTwelveEdgesAndEightCorners()
    {
        WorkMesh work = WorkMesh.From(Models.Create("cube"));
        List<(int A, int B)> segments = Creases.Mark(work, Angle, 10);
        Assert.Equal((12, 12), (segments.Count, work.Crease.Sum()));
        Assert.Equal(8, CountOf(work, VertexKind.Corner));
        Assert.All(segments, s => Assert.Equal(1, work.Crease[work.Find(s.A, s.B) >> 1]));
    }

    [Fact]
    public void Mark_Angle_IsTheTurnOfTheNormals()
    {
        // Along the rim of a prism with 8 sides the sides meet at 45°, the ends at 90°.
        Mesh prism = Models.Triangulated(Models.Prism(8));
        WorkMesh above = WorkMesh.From(prism), below = WorkMesh.From(prism);
        Assert.Equal(16, Creases.Mark(above, 46 * Math.PI / 180, 0).Count);
        Assert.Equal(24, Creases.Mark(below, 44 * Math.PI / 180, 0).Count);
        // The rims turn by 45° at each vertex: less than at a corner.
        Assert.Equal((0, 16), (CountOf(above, VertexKind.Corner), CountOf(above, VertexKind.OnCrease)));
        // Three lines meet at each.
        Assert.Equal(16, CountOf(below, VertexKind.Corner));
    }

    [Theory]
    [InlineData(5, 60, 5)] // the rim turns by 72° at its vertices: corners
    [InlineData(8, 46, 0)]
    public void Mark_LineThatTurns_HasACornerBeyondAcosSixTenths(int sides, double angle, int corners)
    {
        WorkMesh work = WorkMesh.From(Models.Fan(sides));
        Creases.Mark(work, angle * Math.PI / 180, 0);
        Assert.Equal(corners, CountOf(work, VertexKind.Corner));
        Assert.Equal(sides - corners, CountOf(work, VertexKind.OnCrease));
        Assert.Equal(1, CountOf(work, VertexKind.Smooth));
    }

    [Theory]
    [InlineData(3, 3, 0)]
    [InlineData(3, 2, 3)]
    [InlineData(0, 3, 0)]
    public void Mark_TreeOfFewSharpEdges_IsNoise(int sharp, int noise, int expected)
    {
        // A flat grid with a ridge of a few edges: a row of vertices lifted would make closed lines, so the dihedral angles are made by a fold that fades out.
        Mesh mesh = Models.Triangulated(Models.QuadGrid(10, 10));
        WorkMesh work = WorkMesh.From(mesh);
        int before = Creases.Mark(work, Angle, noise).Count;
        Assert.Equal(40, before);
        if (sharp == 0)
            return;
        int[] ridge = [.. RidgeOf(mesh, sharp)];
        WorkMesh folded = WorkMesh.From(mesh);
        Assert.Equal(expected, Creases.Mark(folded, Angle, noise).Count - before);
        Assert.All(ridge, e => Assert.Equal(expected > 0 ? 1 : 0, folded.Crease[e]));
    }

    /// <summary>Folds an accordion pleat along so many edges of the middle line, flat again at both ends; the edges of the ridge.</summary>
    private static List<int> RidgeOf(Mesh mesh, int edges)
    {
        // Two rows beside the line go down, so that only the line itself is sharp.
        foreach (Vertex v in mesh.Vertices)
        {
            int i = (int)Math.Round(v.Position.X * 10), j = (int)Math.Round(v.Position.Y * 10);
            if (i >= 3 && i <= 3 + edges)
                v.Position += new Vector3D(0, 0, j == 5 ? 0.055 : 0);
        }
        return [.. mesh.Edges.Where(e => Angle < Dihedral(e)).Select(e => e.Index)];
    }

    private static double Dihedral(Edge e) => e.IsBoundary ? 0 : Vector3D.Angle(NormalOf(e.Face0), NormalOf(e.Face1));

    private static Vector3D NormalOf(Face f)
    {
        HalfEdge h = f.HalfEdge;
        return Vector3D.Cross(h.Target.Position - h.Source.Position, h.Next.Target.Position - h.Source.Position);
    }

    [Fact]
    public void IsCrumpled_FoldedFaces_CountsThem()
    {
        Assert.False(Creases.IsCrumpled(WorkMesh.From(Models.Create("cube"))));
        Mesh mesh = Models.Triangulated(Models.QuadGrid(10, 10));
        Assert.False(Creases.IsCrumpled(WorkMesh.From(mesh)));
        // Every second inner vertex thrown beyond its ring folds the faces around it.
        foreach (Vertex v in mesh.Vertices.Where(v => !v.IsBoundary && v.Index % 2 == 0))
            v.Position += new Vector3D(0.25, 0, 0);
        WorkMesh work = WorkMesh.From(mesh);
        Assert.True(Creases.IsCrumpled(work));
        // Then only the boundary is kept.
        Assert.Equal(40, Creases.Mark(work, Angle, 0).Count);
    }
}
