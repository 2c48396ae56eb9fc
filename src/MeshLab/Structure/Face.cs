using System.Runtime.CompilerServices;

namespace MeshLab.Structure;

/// <summary>A face (面): a polygon of three or more vertices, counter-clockwise seen from outside. <see langword="default"/> is none.</summary>
public readonly struct Face : IEquatable<Face>, IComparable<Face>
{
    internal readonly Mesh mesh;
    internal readonly int index;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal Face(Mesh mesh, int index)
    {
        this.mesh = mesh;
        this.index = index;
    }

    /// <summary>The mesh; <see langword="null"/> for none.</summary>
    public Mesh Mesh => mesh;

    /// <summary>The index in the mesh's face columns; −1 for none.</summary>
    public int Index => mesh is null ? -1 : index;

    /// <summary>Whether this is no face.</summary>
    public bool IsNone => mesh is null;

    /// <summary>Whether the face was deleted.</summary>
    public bool IsDeleted => mesh is not null && mesh.halfEdgeOf[index] < 0;

    /// <summary>The face's first half-edge: from its first to its second vertex.</summary>
    public HalfEdge HalfEdge => new(mesh, mesh.halfEdgeOf[index]);

    /// <summary>The number of vertices of the face (边数). O(degree).</summary>
    public int Degree
    {
        get
        {
            int start = mesh.halfEdgeOf[index], h = start, count = 0;
            do
            {
                count++;
                h = mesh.next[h];
            }
            while (h != start);
            return count;
        }
    }

    /// <summary>Whether the face has three vertices.</summary>
    public bool IsTriangle
    {
        get
        {
            int[] next = mesh.next;
            int start = mesh.halfEdgeOf[index];
            return next[next[next[start]]] == start;
        }
    }

    /// <summary>Whether an edge of the face lies on the boundary. O(degree).</summary>
    public bool IsBoundary
    {
        get
        {
            int start = mesh.halfEdgeOf[index], h = start;
            do
            {
                if (mesh.face[h ^ 1] < 0)
                    return true;
                h = mesh.next[h];
            }
            while (h != start);
            return false;
        }
    }

    /// <summary>The textbook's traits of the face.</summary>
    public FaceTraits Traits => new(this);

    /// <summary>The vertices of the face, counter-clockwise from its first. F–V.</summary>
    public Circulation<Vertex, AroundFace, SourceView> Vertices => new(mesh, LiveHalfEdge);

    /// <summary>The half-edges of the face, counter-clockwise from the first.</summary>
    public Circulation<HalfEdge, AroundFace, SelfView> HalfEdges => new(mesh, LiveHalfEdge);

    /// <summary>The edges of the face, counter-clockwise. F–E.</summary>
    public Circulation<Edge, AroundFace, EdgeView> Edges => new(mesh, LiveHalfEdge);

    /// <summary>The faces across its edges, counter-clockwise; a face that shares two edges appears twice. F–F.</summary>
    public Circulation<Face, AroundFace, AcrossView> Neighbors => new(mesh, LiveHalfEdge);

    /// <summary>The vertices clockwise from the first.</summary>
    public Circulation<Vertex, AroundFaceClockwise, TargetView> VerticesClockwise => new(mesh, LiveHalfEdge);

    /// <summary>The half-edges clockwise, beginning with the previous of the first.</summary>
    public Circulation<HalfEdge, AroundFaceClockwise, SelfView> HalfEdgesClockwise => new(mesh, LiveHalfEdge);

    private int LiveHalfEdge
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            int h = mesh is null ? -1 : mesh.halfEdgeOf[index];
            if (h < 0)
                DeadElement.Throw(this);
            return h;
        }
    }

    /// <summary>Throws if the face is none or deleted.</summary>
    /// <exception cref="ArgumentException">The face is none or deleted.</exception>
    public void ThrowIfDead() => _ = LiveHalfEdge;

    /// <inheritdoc/>
    public bool Equals(Face other) => ReferenceEquals(mesh, other.mesh) && index == other.index;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is Face other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => index;

    /// <summary>By index.</summary>
    public int CompareTo(Face other) => Index.CompareTo(other.Index);

    /// <summary>Whether both are the same face of the same mesh.</summary>
    public static bool operator ==(Face left, Face right) => left.Equals(right);

    /// <summary>Whether the two differ.</summary>
    public static bool operator !=(Face left, Face right) => !left.Equals(right);

    /// <summary>By index.</summary>
    public static bool operator <(Face left, Face right) => left.CompareTo(right) < 0;

    /// <summary>By index.</summary>
    public static bool operator >(Face left, Face right) => left.CompareTo(right) > 0;

    /// <summary>By index.</summary>
    public static bool operator <=(Face left, Face right) => left.CompareTo(right) <= 0;

    /// <summary>By index.</summary>
    public static bool operator >=(Face left, Face right) => left.CompareTo(right) >= 0;

    /// <summary><c>f5</c>, or <c>none</c>.</summary>
    public override string ToString() => mesh is null ? "none" : ElementName.Face(index);
}
