using System.Runtime.CompilerServices;

namespace MeshLab.Structure;

/// <summary>An edge (边): two half-edges in opposite directions. <see langword="default"/> is none.</summary>
public readonly struct Edge : IEquatable<Edge>, IComparable<Edge>
{
    internal readonly Mesh mesh;
    internal readonly int index;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal Edge(Mesh mesh, int index)
    {
        this.mesh = mesh;
        this.index = index;
    }

    /// <summary>The mesh; <see langword="null"/> for none.</summary>
    public Mesh Mesh => mesh;

    /// <summary>The index in the mesh's edge columns; −1 for none.</summary>
    public int Index => mesh is null ? -1 : index;

    /// <summary>Whether this is no edge.</summary>
    public bool IsNone => mesh is null;

    /// <summary>Whether the edge was deleted.</summary>
    public bool IsDeleted => mesh is not null && mesh.next[2 * index] < 0;

    /// <summary>The half-edge with the even index.</summary>
    public HalfEdge HalfEdge0 => new(mesh, 2 * index);

    /// <summary>The half-edge with the odd index, the twin of <see cref="HalfEdge0"/>.</summary>
    public HalfEdge HalfEdge1 => new(mesh, 2 * index + 1);

    /// <summary>The vertex that <see cref="HalfEdge0"/> leaves.</summary>
    public Vertex Vertex0 => new(mesh, mesh.target[2 * index + 1]);

    /// <summary>The vertex that <see cref="HalfEdge0"/> points to.</summary>
    public Vertex Vertex1 => new(mesh, mesh.target[2 * index]);

    /// <summary>The face to the left of <see cref="HalfEdge0"/>; none on the boundary.</summary>
    public Face Face0 => HalfEdge0.Face;

    /// <summary>The face to the left of <see cref="HalfEdge1"/>; none on the boundary.</summary>
    public Face Face1 => HalfEdge1.Face;

    /// <summary>Whether the edge has a face on one side only (边界边).</summary>
    public bool IsBoundary => mesh.face[2 * index] < 0 || mesh.face[2 * index + 1] < 0;

    /// <summary>The distance of its ends, in model units.</summary>
    public double Length => (Vertex1.Position - Vertex0.Position).Length;

    /// <summary>The textbook's traits of the edge.</summary>
    public EdgeTraits Traits => new(this);

    /// <summary>The two ends. E–V.</summary>
    public ElementPair<Vertex> Vertices
    {
        get
        {
            ThrowIfDead();
            return new(Vertex0, Vertex1, 2);
        }
    }

    /// <summary>The faces beside the edge: two, or one on the boundary. E–F.</summary>
    public ElementPair<Face> Faces
    {
        get
        {
            ThrowIfDead();
            Face first = Face0, second = Face1;
            if (first.IsNone)
                return new(second, default, second.IsNone ? 0 : 1);
            return new(first, second, second.IsNone ? 1 : 2);
        }
    }

    /// <summary>The other edges at <see cref="Vertex0"/>, counter-clockwise from this one, then those at <see cref="Vertex1"/>. E–E.</summary>
    public EdgeNeighbors Neighbors
    {
        get
        {
            ThrowIfDead();
            return new(mesh, index);
        }
    }

    /// <summary>Throws if the edge is none or deleted.</summary>
    /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
    public void ThrowIfDead()
    {
        if (mesh is null || mesh.next[2 * index] < 0)
            DeadElement.Throw(this);
    }

    /// <inheritdoc/>
    public bool Equals(Edge other) => ReferenceEquals(mesh, other.mesh) && index == other.index;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is Edge other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => index;

    /// <summary>By index.</summary>
    public int CompareTo(Edge other) => Index.CompareTo(other.Index);

    /// <summary>Whether both are the same edge of the same mesh.</summary>
    public static bool operator ==(Edge left, Edge right) => left.Equals(right);

    /// <summary>Whether the two differ.</summary>
    public static bool operator !=(Edge left, Edge right) => !left.Equals(right);

    /// <summary>By index.</summary>
    public static bool operator <(Edge left, Edge right) => left.CompareTo(right) < 0;

    /// <summary>By index.</summary>
    public static bool operator >(Edge left, Edge right) => left.CompareTo(right) > 0;

    /// <summary>By index.</summary>
    public static bool operator <=(Edge left, Edge right) => left.CompareTo(right) <= 0;

    /// <summary>By index.</summary>
    public static bool operator >=(Edge left, Edge right) => left.CompareTo(right) >= 0;

    /// <summary><c>e4</c>, or <c>none</c>.</summary>
    public override string ToString() => mesh is null ? "none" : ElementName.Edge(index);
}
