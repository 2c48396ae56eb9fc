using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Structure;

[Trait("Section", "4.8")]
public class HistoryTests
{
    [Fact]
    public void StateHash_AnyChange_ChangesIt()
    {
        Mesh mesh = Models.Create("grid");
        ulong hash = mesh.StateHash();
        Assert.Equal(hash, Models.Create("grid").StateHash());
        HashSet<ulong> seen = [hash];

        mesh.Vertices[3].Position += new Vector3D(0, 0, double.Epsilon);
        Assert.True(seen.Add(mesh.StateHash()));
        mesh.AddVertexTrait("t", 1);
        Assert.True(seen.Add(mesh.StateHash()));
        mesh.AddVertex(default);
        Assert.True(seen.Add(mesh.StateHash()));
        mesh.Edges.First(e => e.CanFlip(out _)).Flip();
        Assert.True(seen.Add(mesh.StateHash()));
    }

    [Fact]
    public void UndoRedo_StepByStep_PassThroughTheSameStates()
    {
        Mesh mesh = Models.Create("sphere");
        mesh.AddVertexTrait("t", 0.25, Blend.Linear);
        using OperationHistory history = mesh.StartRecording();
        List<ulong> states = [mesh.StateHash()];
        void Done() => states.Add(mesh.StateHash());
        mesh.Edges[7].Split();
        Done();
        mesh.Faces[7].Split();
        Done();
        mesh.Edges.First(e => e.CanFlip(out _)).Flip();
        Done();
        mesh.HalfEdges.First(h => h.CanCollapse(out _)).Collapse();
        Done();
        mesh.Faces[2].Delete();
        Done();
        mesh.MoveVertex(mesh.Vertices[50], default);
        Done();
        mesh.AddVertex(Vector3D.UnitX);
        Done();

        Assert.Equal(7, history.Count);
        Assert.Equal(OperationKind.EdgeSplit, history.Records[0].Kind);
        Assert.Equal(7, history.Records[0].Element);
        Assert.Contains((ElementKind.Face, 2), history.Records[4].Removed);
        for (int i = 6; i >= 0; i--)
        {
            Assert.True(history.Undo());
            Assert.Equal(states[i], mesh.StateHash());
            Assert.Empty(mesh.Validate());
        }
        Assert.False(history.Undo());
        for (int i = 1; i <= 7; i++)
        {
            Assert.True(history.Redo());
            Assert.Equal(states[i], mesh.StateHash());
        }
        Assert.False(history.Redo());
        history.UndoTo(3);
        Assert.Equal(states[3], mesh.StateHash());
        Assert.Equal(4, history.UndoneCount);
        Assert.Throws<ArgumentOutOfRangeException>(() => history.UndoTo(4));
        mesh.AddVertex(default);
        Assert.Equal(0, history.UndoneCount);
    }

    [Fact]
    public void StartRecording_Nested_TellsTheOuterOne()
    {
        Mesh mesh = Models.Create("cube");
        using OperationHistory outer = mesh.StartRecording();
        using (OperationHistory inner = mesh.StartRecording())
        {
            mesh.Edges[0].Split();
            Assert.Equal(1, inner.Count);
        }
        mesh.Edges[1].Split();
        Assert.Equal(2, outer.Count);
        outer.Dispose();
        Assert.Null(mesh.Listener);
    }

    [Fact]
    public void Operations_WithoutAListener_AllocateNothing()
    {
        Mesh mesh = Models.Create("sphere");
        mesh.Reserve(1000, 3000, 2000);
        Work(mesh);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Work(mesh);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);

        static void Work(Mesh mesh)
        {
            foreach (Edge e in mesh.Edges)
                e.TryFlip(out _);
            Vertex m = mesh.Vertices[30].Outgoing.Face.Split();
            m.Outgoing.TryCollapse(out _);
            Vertex n = mesh.Vertices[30].Outgoing.Edge.Split();
            n.Outgoing.TryCollapse(out _);
            Vertex v = mesh.Vertices[30];
            v.TrySplit(v.Outgoing.Target, v.Outgoing.Twin.Next.Twin.Next.Target, out _, out _);
        }
    }

    [Fact]
    public void Memory_OfALargeClosedMesh_IsAtMost68BytesPerFace()
    {
        // 200,000 faces: the columns dominate whatever else the runtime does meanwhile.
        const int Around = 400, Across = 250;
        var positions = new Vector3D[Around * Across];
        var corners = new int[6 * Around * Across];
        for (int i = 0, c = 0; i < Around; i++)
        {
            for (int j = 0; j < Across; j++, c += 6)
            {
                int a = (i * Across) + j, b = ((i + 1) % Around * Across) + j;
                int d = (i * Across) + ((j + 1) % Across), e = ((i + 1) % Around * Across) + ((j + 1) % Across);
                positions[a] = new(i, j, i * j);
                (corners[c], corners[c + 1], corners[c + 2], corners[c + 3], corners[c + 4], corners[c + 5]) = (a, b, e, a, e, d);
            }
        }
        Mesh mesh = MeshBuilder.FromTriangles(positions, corners);

        // A copy allocates the columns and nothing else of size; this counter is the thread's own, whatever other tests do meanwhile.
        long before = GC.GetAllocatedBytesForCurrentThread();
        Mesh copy = mesh.Clone();
        double best = (GC.GetAllocatedBytesForCurrentThread() - before) / (double)copy.Faces.Count;

        Assert.InRange(best, 60, 68);
    }
}
