using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Structure;

/// <summary>Each rule of <c>docs/validation.md</c> is seen to fail when its column is spoiled.</summary>
[Trait("Section", "1.4")]
public class ValidationTests
{
    private static void Breaks(int rule, Action<Mesh> spoil, string model = "grid")
    {
        Mesh mesh = Models.Create(model);
        Assert.Empty(mesh.Validate());
        spoil(mesh);
        IReadOnlyList<Violation> found = mesh.Validate();
        Assert.Contains(found, v => v.Rule == rule);
        Assert.All(found, v => Assert.StartsWith($"R{v.Rule} {v.Element}: ", v.ToString(), StringComparison.Ordinal));
    }

    [Fact]
    public void R1_OneHalfEdgeOfAnEdgeDeleted() => Breaks(1, m => m.next[5] = -1);

    [Fact]
    public void R2_NextAndPreviousNotInverse() => Breaks(2, m => m.previous[m.next[4]] = m.next[4]);

    [Fact]
    public void R3_NextLeavesTheFace() => Breaks(3, m => m.face[4] = (m.face[4] + 1) % m.FaceSlots);

    [Fact]
    public void R3_FaceNamesAHalfEdgeOfAnother() => Breaks(3, m => m.halfEdgeOf[0] = m.halfEdgeOf[1]);

    [Fact]
    public void R3_FaceInTwoLoops() => Breaks(3, m =>
    {
        // Two separate loops claim face 0.
        int h = m.halfEdgeOf[9], k = h;
        do
        {
            m.face[k] = 0;
            k = m.next[k];
        }
        while (k != h);
    });

    [Fact]
    public void R4_TargetIsNotWhereTheNextBegins() => Breaks(4, m => m.target[8] = (m.target[8] + 5) % m.VertexSlots);

    [Fact]
    public void R5_OutgoingLeavesAnotherVertex() => Breaks(5, m => m.outgoing[3] = m.outgoing[4]);

    [Fact]
    public void R5_UsedVertexClaimsToBeIsolated() => Breaks(5, m => m.outgoing[3] = Mesh.Isolated);

    [Fact]
    public void R6_BoundaryVertexWithAnInnerOutgoing() => Breaks(6, m => m.outgoing[0] = m.next[m.outgoing[0] ^ 1]);

    [Fact]
    public void R7_HalfEdgesNotReached()
    {
        // Two tetrahedra pressed together in a vertex: one vertex names both fans.
        Breaks(7, m =>
        {
            m.Append(Models.Tetrahedron());
            for (int h = 0; h < m.HalfEdgeSlots; h++)
            {
                if (m.target[h] == 4)
                    m.target[h] = 0;
            }
            m.outgoing[4] = Mesh.Isolated;
        }, "tetrahedron");
    }

    [Fact]
    public void R7_TwoHolesMeet() => Breaks(7, m =>
    {
        // Two faces around a vertex that share no edge turn into holes.
        Face[] around = [.. m.Vertices[0].Faces];
        foreach (Face f in (Face[])[around[0], around[2]])
        {
            foreach (HalfEdge h in f.HalfEdges.ToArray())
                m.face[h.Index] = -1;
            m.halfEdgeOf[f.Index] = -1;
        }
    }, "octahedron");

    [Fact]
    public void R8_FaceWithTwoCorners() => Breaks(8, m =>
    {
        // A quad whose corner is bent onto the one across: its vertices are no longer distinct.
        for (int h = 0; h < m.HalfEdgeSlots; h++)
        {
            if (m.target[h] == 2)
                m.target[h] = 0;
        }
        m.outgoing[2] = Mesh.Isolated;
    }, "cube-quads");

    [Fact]
    public void R8_EdgeWithOneEnd() => Breaks(8, m => m.target[8] = m.target[9]);

    [Fact]
    public void R9_NextIsDeleted() => Breaks(9, m =>
    {
        m.next[6] = m.next[7] = -1;
    });

    [Theory]
    [InlineData(-5)]
    [InlineData(int.MaxValue)]
    public void R9_ReferencesOutOfRange(int index)
    {
        Breaks(9, m => m.next[6] = index < 0 ? 1 << 20 : index);
        Breaks(9, m => m.previous[6] = index);
        Breaks(9, m => m.target[6] = index);
        Breaks(9, m => m.face[6] = index);
        Breaks(9, m => m.outgoing[6] = index);
        Breaks(9, m => m.halfEdgeOf[6] = index < 0 ? 1 << 20 : index);
    }

    [Fact]
    public void R9_TargetOrFaceIsDeleted()
    {
        Breaks(9, m => m.outgoing[6] = Mesh.DeletedVertexMark);
        Breaks(9, m => m.halfEdgeOf[6] = -1);
    }

    [Fact]
    public void R10_TwoEdgesJoinTheSameVertices()
    {
        Breaks(10, m =>
        {
            // Bending the last edge of a fan of three onto the first makes a double edge at the hub.
            for (int h = 0; h < m.HalfEdgeSlots; h++)
            {
                if (m.target[h] == 4)
                    m.target[h] = 1;
            }
            m.outgoing[4] = Mesh.Isolated;
        }, "open-fan");
    }

    [Theory]
    [InlineData(double.NaN)]
    [InlineData(double.PositiveInfinity)]
    public void R11_PositionNotFinite(double x) => Breaks(11, m => m.Positions[7] = new(0, x, 0));

    [Fact]
    public void R12_TraitOfAnotherLength() => Breaks(12, m => m.AddEdgeTrait("t", 0.0).Grow(3));

    [Fact]
    public void Validate_DeletedElements_AreNotLookedAt()
    {
        Mesh mesh = Models.Create("isolated-vertices");
        mesh.Positions[4] = new(double.NaN, 0, 0);
        mesh.DeleteVertexSlot(4);
        Assert.Empty(mesh.Validate());
    }
}
