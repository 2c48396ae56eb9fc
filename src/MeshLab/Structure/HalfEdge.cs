using System.Runtime.CompilerServices;

namespace MeshLab.Structure;

/// <summary>A half-edge (半边): one side of an edge, with the face to its left. <see langword="default"/> is none.</summary>
/// <remarks>The navigation properties do not check for deletion (that would double the time of every walk); operations and circulations do.</remarks>
public readonly struct HalfEdge : IEquatable<HalfEdge>, IComparable<HalfEdge>
{
    internal readonly Mesh mesh;
    internal readonly int index;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal HalfEdge(Mesh mesh, int index)
    {
        this.mesh = mesh;
        this.index = index;
    }

    /// <summary>The mesh; <see langword="null"/> for none.</summary>
    public Mesh Mesh => mesh;

    /// <summary>The index in the mesh's half-edge columns; −1 for none.</summary>
    public int Index => mesh is null ? -1 : index;

    /// <summary>Whether this is no half-edge.</summary>
    public bool IsNone => mesh is null;

    /// <summary>Whether the half-edge was deleted.</summary>
    public bool IsDeleted => mesh is not null && mesh.next[index] < 0;

    /// <summary>The next half-edge around the face or, on the boundary, along the loop.</summary>
    public HalfEdge Next => new(mesh, mesh.next[index]);

    /// <summary>The previous half-edge around the face or along the loop.</summary>
    public HalfEdge Previous => new(mesh, mesh.previous[index]);

    /// <summary>The other half-edge of the edge (对边).</summary>
    public HalfEdge Twin => new(mesh, index ^ 1);

    /// <summary>The vertex that the half-edge points to (目的顶点).</summary>
    public Vertex Target => new(mesh, mesh.target[index]);

    /// <summary>The vertex that it leaves.</summary>
    public Vertex Source => new(mesh, mesh.target[index ^ 1]);

    /// <summary>The edge that it is a side of.</summary>
    public Edge Edge => new(mesh, index >> 1);

    /// <summary>The face to its left; none on the boundary.</summary>
    public Face Face
    {
        get
        {
            int f = mesh.face[index];
            return f < 0 ? default : new(mesh, f);
        }
    }

    /// <summary>Whether there is no face to its left (边界半边).</summary>
    public bool IsBoundary => mesh.face[index] < 0;

    /// <summary>The textbook's traits of the half-edge, that is of a face's corner at <see cref="Target"/>.</summary>
    public HalfEdgeTraits Traits => new(this);

    /// <summary>The half-edges of the face or boundary loop, beginning with this one.</summary>
    public Circulation<HalfEdge, AroundFace, SelfView> Loop
    {
        get
        {
            ThrowIfDead();
            return Circulation<HalfEdge, AroundFace, SelfView>.From(mesh, index);
        }
    }

    /// <summary>Throws if the half-edge is none or deleted.</summary>
    /// <exception cref="ArgumentException">The half-edge is none or deleted.</exception>
    public void ThrowIfDead()
    {
        if (mesh is null || mesh.next[index] < 0)
            DeadElement.Throw(this);
    }

    /// <inheritdoc/>
    public bool Equals(HalfEdge other) => ReferenceEquals(mesh, other.mesh) && index == other.index;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is HalfEdge other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => index;

    /// <summary>By index.</summary>
    public int CompareTo(HalfEdge other) => Index.CompareTo(other.Index);

    /// <summary>Whether both are the same half-edge of the same mesh.</summary>
    public static bool operator ==(HalfEdge left, HalfEdge right) => left.Equals(right);

    /// <summary>Whether the two differ.</summary>
    public static bool operator !=(HalfEdge left, HalfEdge right) => !left.Equals(right);

    /// <summary>By index.</summary>
    public static bool operator <(HalfEdge left, HalfEdge right) => left.CompareTo(right) < 0;

    /// <summary>By index.</summary>
    public static bool operator >(HalfEdge left, HalfEdge right) => left.CompareTo(right) > 0;

    /// <summary>By index.</summary>
    public static bool operator <=(HalfEdge left, HalfEdge right) => left.CompareTo(right) <= 0;

    /// <summary>By index.</summary>
    public static bool operator >=(HalfEdge left, HalfEdge right) => left.CompareTo(right) >= 0;

    /// <summary><c>h3</c>, or <c>none</c>.</summary>
    public override string ToString() => mesh is null ? "none" : ElementName.HalfEdge(index);
}
