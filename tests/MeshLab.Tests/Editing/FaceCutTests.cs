using MeshLab.Editing;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Editing;

[Trait("Section", "4.8")]
public class FaceCutTests
{
    [Fact]
    public void TryCut_EachIllegalCase_GivesItsReasonAndLeavesTheMeshAlone()
    {
        // The quad 0 1 2 3 lies on a tetrahedron's edges: 0–2 is an edge elsewhere.
        Mesh mesh = MeshBuilder.FromFaces(5, [0, 1, 2, 3], [0, 2, 1], [3, 2, 4]);
        ulong before = mesh.StateHash();
        Face quad = mesh.Faces[0];
        Vertex[] v = [.. mesh.Vertices];

        Assert.False(quad.TryCut(v[0], v[2], out _, out CutRefusal why));
        Assert.Equal(CutRefusal.EdgeExists, why);
        Assert.False(quad.TryCut(v[0], v[1], out _, out why));
        Assert.Equal(CutRefusal.NoDiagonal, why);
        Assert.False(quad.TryCut(v[3], v[3], out _, out why));
        Assert.Equal(CutRefusal.NoDiagonal, why);
        Assert.False(quad.CanCut(v[4], v[1], out why));
        Assert.Equal(CutRefusal.NotACorner, why);
        Assert.Throws<TopologyException>(() => quad.Cut(v[4], v[1]));
        Assert.Equal(before, mesh.StateHash());
    }

    //   3 ─── 2          3 ─── 2
    //   │     │    ⟶     │ 0 / │
    //   │     │          │ / 1 │
    //   0 ─── 1          0 ─── 1
    [Fact]
    public void Cut_Quad_KeepsTheLeftPart()
    {
        Mesh mesh = MeshBuilder.FromFaces(4, [0, 1, 2, 3]);
        FaceTrait<int> name = mesh.AddFaceTrait("name", 6);
        HalfEdge diagonal = mesh.Faces[0].Cut(mesh.Vertices[0], mesh.Vertices[2]);

        Assert.Equal([0, 2, 3], mesh.Faces[0].Vertices.Select(v => v.Index).Order());
        Assert.Equal([0, 1, 2], diagonal.Twin.Face.Vertices.Select(v => v.Index).Order());
        Assert.Equal(6, name[diagonal.Twin.Face]);
        Assert.Empty(mesh.Validate());
    }

    [Fact]
    public void Undo_AfterCuttingEveryPolygon_RestoresEveryBit()
    {
        foreach (string model in (string[])["cube-quads", "prism-6", "grid-quads", "mixed-polygons", "genus-2-quads"])
        {
            Mesh mesh = Models.Create(model);
            ulong before = mesh.StateHash();
            using OperationHistory history = mesh.StartRecording();
            for (int f = 0; f < mesh.FaceSlots; f++)
            {
                Face face = mesh.Faces[f];
                while (!face.IsTriangle && face.TryCut(face.HalfEdge.Source, face.HalfEdge.Next.Target, out _, out _))
                {
                }
            }
            Assert.True(mesh.IsTriangleMesh);
            Assert.Empty(mesh.Validate());
            history.UndoAll();
            Assert.Equal(before, mesh.StateHash());
        }
    }
}
