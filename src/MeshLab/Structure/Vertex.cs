using System.Runtime.CompilerServices;
using MeshLab.Numerics;

namespace MeshLab.Structure;

/// <summary>A vertex (顶点) of a mesh: a handle of mesh and index. <see langword="default"/> is none.</summary>
public readonly struct Vertex : IEquatable<Vertex>, IComparable<Vertex>
{
    internal readonly Mesh mesh;
    internal readonly int index;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal Vertex(Mesh mesh, int index)
    {
        this.mesh = mesh;
        this.index = index;
    }

    /// <summary>The mesh; <see langword="null"/> for none.</summary>
    public Mesh Mesh => mesh;

    /// <summary>The index in the mesh's vertex columns; −1 for none.</summary>
    public int Index => mesh is null ? -1 : index;

    /// <summary>Whether this is no vertex.</summary>
    public bool IsNone => mesh is null;

    /// <summary>Whether the vertex was deleted.</summary>
    public bool IsDeleted => mesh is not null && mesh.outgoing[index] == Mesh.DeletedVertexMark;

    /// <summary>The position (位置), to read and to write.</summary>
    public ref Vector3D Position => ref mesh.positions[index];

    /// <summary>A half-edge that leaves the vertex, a boundary one if there is any; none if isolated.</summary>
    public HalfEdge Outgoing
    {
        get
        {
            int h = mesh.outgoing[index];
            return h < 0 ? default : new(mesh, h);
        }
    }

    /// <summary>Whether the vertex has no edge (孤立点).</summary>
    public bool IsIsolated => mesh.outgoing[index] < 0;

    /// <summary>Whether the vertex lies on a boundary (边界点). An isolated vertex does not.</summary>
    public bool IsBoundary
    {
        get
        {
            int h = mesh.outgoing[index];
            return h >= 0 && mesh.face[h] < 0;
        }
    }

    /// <summary>The number of edges at the vertex (度). O(valence).</summary>
    public int Valence
    {
        get
        {
            int start = mesh.outgoing[index];
            if (start < 0)
                return 0;
            int[] next = mesh.next;
            int count = 0, h = start;
            do
            {
                count++;
                h = next[h ^ 1];
            }
            while (h != start);
            return count;
        }
    }

    /// <summary>The textbook's traits (属性) of the vertex.</summary>
    public VertexTraits Traits => new(this);

    /// <summary>The vertices joined to this one by an edge, counter-clockwise; on the boundary from first to last without a jump. V–V.</summary>
    public Circulation<Vertex, CounterClockwise, TargetView> Neighbors => new(mesh, LiveOutgoing);

    /// <summary>The neighbours clockwise.</summary>
    public Circulation<Vertex, Clockwise, TargetView> NeighborsClockwise => new(mesh, LiveOutgoing);

    /// <summary>The half-edges that leave the vertex, counter-clockwise (h → h.Previous.Twin).</summary>
    public Circulation<HalfEdge, CounterClockwise, SelfView> OutgoingHalfEdges => new(mesh, LiveOutgoing);

    /// <summary>The half-edges that leave the vertex, clockwise (h → h.Twin.Next).</summary>
    public Circulation<HalfEdge, Clockwise, SelfView> OutgoingHalfEdgesClockwise => new(mesh, LiveOutgoing);

    /// <summary>The half-edges that point to the vertex, counter-clockwise.</summary>
    public Circulation<HalfEdge, CounterClockwise, TwinView> IncomingHalfEdges => new(mesh, LiveOutgoing);

    /// <summary>The half-edges that point to the vertex, clockwise.</summary>
    public Circulation<HalfEdge, Clockwise, TwinView> IncomingHalfEdgesClockwise => new(mesh, LiveOutgoing);

    /// <summary>The edges at the vertex, its spokes, counter-clockwise. V–E.</summary>
    public Circulation<Edge, CounterClockwise, EdgeView> Edges => new(mesh, LiveOutgoing);

    /// <summary>The edges at the vertex clockwise.</summary>
    public Circulation<Edge, Clockwise, EdgeView> EdgesClockwise => new(mesh, LiveOutgoing);

    /// <summary>The faces at the vertex, counter-clockwise. V–F.</summary>
    public Circulation<Face, CounterClockwise, FaceView> Faces => new(mesh, LiveOutgoing);

    /// <summary>The faces at the vertex clockwise.</summary>
    public Circulation<Face, Clockwise, FaceView> FacesClockwise => new(mesh, LiveOutgoing);

    /// <summary>Whether an edge joins the two vertices. O(valence).</summary>
    public bool IsNeighborOf(Vertex other) => mesh.FindHalfEdge(index, other.index) >= 0;

    // −1 for an isolated vertex.
    private int LiveOutgoing
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            int h = mesh is null ? Mesh.DeletedVertexMark : mesh.outgoing[index];
            if (h == Mesh.DeletedVertexMark)
                DeadElement.Throw(this);
            return h;
        }
    }

    /// <summary>Throws if the vertex is none or deleted.</summary>
    /// <exception cref="ArgumentException">The vertex is none or deleted.</exception>
    public void ThrowIfDead() => _ = LiveOutgoing;

    /// <inheritdoc/>
    public bool Equals(Vertex other) => ReferenceEquals(mesh, other.mesh) && index == other.index;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is Vertex other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => index;

    /// <summary>By index.</summary>
    public int CompareTo(Vertex other) => Index.CompareTo(other.Index);

    /// <summary>Whether both are the same vertex of the same mesh.</summary>
    public static bool operator ==(Vertex left, Vertex right) => left.Equals(right);

    /// <summary>Whether the two differ.</summary>
    public static bool operator !=(Vertex left, Vertex right) => !left.Equals(right);

    /// <summary>By index.</summary>
    public static bool operator <(Vertex left, Vertex right) => left.CompareTo(right) < 0;

    /// <summary>By index.</summary>
    public static bool operator >(Vertex left, Vertex right) => left.CompareTo(right) > 0;

    /// <summary>By index.</summary>
    public static bool operator <=(Vertex left, Vertex right) => left.CompareTo(right) <= 0;

    /// <summary>By index.</summary>
    public static bool operator >=(Vertex left, Vertex right) => left.CompareTo(right) >= 0;

    /// <summary><c>v12</c>, or <c>none</c>.</summary>
    public override string ToString() => mesh is null ? "none" : ElementName.Vertex(index);
}
