using System.Collections;

namespace MeshLab.Structure;

/// <summary>The vertices (顶点) of a mesh in index order. Elements added during a walk are not visited; deleted ones are passed over.</summary>
public readonly struct VertexList : IEnumerable<Vertex>
{
    private readonly Mesh mesh;

    internal VertexList(Mesh mesh) => this.mesh = mesh;

    /// <summary>The number of vertices that are not deleted.</summary>
    public int Count => mesh.LiveVertices;

    /// <summary>The handle for an index, of a deleted element too.</summary>
    /// <param name="index">From 0 to the number of slots − 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such slot.</exception>
    public Vertex this[int index] => (uint)index < (uint)mesh.VertexSlots
        ? new(mesh, index)
        : throw new ArgumentOutOfRangeException(nameof(index), index, $"The mesh has {mesh.VertexSlots} slots for vertices.");

    /// <summary>Starts the walk.</summary>
    public Enumerator GetEnumerator() => new(mesh);

    IEnumerator<Vertex> IEnumerable<Vertex>.GetEnumerator()
    {
        foreach (Vertex element in this)
            yield return element;
    }

    IEnumerator IEnumerable.GetEnumerator() => ((IEnumerable<Vertex>)this).GetEnumerator();

    /// <summary>The walk.</summary>
    public struct Enumerator
    {
        private readonly Mesh mesh;
        private readonly int end;
        private int index;

        internal Enumerator(Mesh mesh)
        {
            this.mesh = mesh;
            end = mesh.VertexSlots;
            index = -1;
        }

        /// <summary>The element.</summary>
        public readonly Vertex Current => new(mesh, index);

        /// <summary>Goes to the next element, if there is one.</summary>
        public bool MoveNext()
        {
            do
            {
                if (++index >= end)
                    return false;
            }
            while (mesh.IsDeletedVertex(index));
            return true;
        }
    }
}

/// <summary>The half-edges (半边) of a mesh in index order. Elements added during a walk are not visited; deleted ones are passed over.</summary>
public readonly struct HalfEdgeList : IEnumerable<HalfEdge>
{
    private readonly Mesh mesh;

    internal HalfEdgeList(Mesh mesh) => this.mesh = mesh;

    /// <summary>The number of half-edges that are not deleted.</summary>
    public int Count => mesh.LiveEdges * 2;

    /// <summary>The handle for an index, of a deleted element too.</summary>
    /// <param name="index">From 0 to the number of slots − 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such slot.</exception>
    public HalfEdge this[int index] => (uint)index < (uint)mesh.HalfEdgeSlots
        ? new(mesh, index)
        : throw new ArgumentOutOfRangeException(nameof(index), index, $"The mesh has {mesh.HalfEdgeSlots} slots for half-edges.");

    /// <summary>Starts the walk.</summary>
    public Enumerator GetEnumerator() => new(mesh);

    IEnumerator<HalfEdge> IEnumerable<HalfEdge>.GetEnumerator()
    {
        foreach (HalfEdge element in this)
            yield return element;
    }

    IEnumerator IEnumerable.GetEnumerator() => ((IEnumerable<HalfEdge>)this).GetEnumerator();

    /// <summary>The walk.</summary>
    public struct Enumerator
    {
        private readonly Mesh mesh;
        private readonly int end;
        private int index;

        internal Enumerator(Mesh mesh)
        {
            this.mesh = mesh;
            end = mesh.HalfEdgeSlots;
            index = -1;
        }

        /// <summary>The element.</summary>
        public readonly HalfEdge Current => new(mesh, index);

        /// <summary>Goes to the next element, if there is one.</summary>
        public bool MoveNext()
        {
            do
            {
                if (++index >= end)
                    return false;
            }
            while (mesh.next[index] < 0);
            return true;
        }
    }
}

/// <summary>The edges (边) of a mesh in index order. Elements added during a walk are not visited; deleted ones are passed over.</summary>
public readonly struct EdgeList : IEnumerable<Edge>
{
    private readonly Mesh mesh;

    internal EdgeList(Mesh mesh) => this.mesh = mesh;

    /// <summary>The number of edges that are not deleted.</summary>
    public int Count => mesh.LiveEdges;

    /// <summary>The handle for an index, of a deleted element too.</summary>
    /// <param name="index">From 0 to the number of slots − 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such slot.</exception>
    public Edge this[int index] => (uint)index < (uint)mesh.EdgeSlots
        ? new(mesh, index)
        : throw new ArgumentOutOfRangeException(nameof(index), index, $"The mesh has {mesh.EdgeSlots} slots for edges.");

    /// <summary>Starts the walk.</summary>
    public Enumerator GetEnumerator() => new(mesh);

    IEnumerator<Edge> IEnumerable<Edge>.GetEnumerator()
    {
        foreach (Edge element in this)
            yield return element;
    }

    IEnumerator IEnumerable.GetEnumerator() => ((IEnumerable<Edge>)this).GetEnumerator();

    /// <summary>The walk.</summary>
    public struct Enumerator
    {
        private readonly Mesh mesh;
        private readonly int end;
        private int index;

        internal Enumerator(Mesh mesh)
        {
            this.mesh = mesh;
            end = mesh.EdgeSlots;
            index = -1;
        }

        /// <summary>The element.</summary>
        public readonly Edge Current => new(mesh, index);

        /// <summary>Goes to the next element, if there is one.</summary>
        public bool MoveNext()
        {
            do
            {
                if (++index >= end)
                    return false;
            }
            while (mesh.IsDeletedEdge(index));
            return true;
        }
    }
}

/// <summary>The faces (面) of a mesh in index order. Elements added during a walk are not visited; deleted ones are passed over.</summary>
public readonly struct FaceList : IEnumerable<Face>
{
    private readonly Mesh mesh;

    internal FaceList(Mesh mesh) => this.mesh = mesh;

    /// <summary>The number of faces that are not deleted.</summary>
    public int Count => mesh.LiveFaces;

    /// <summary>The handle for an index, of a deleted element too.</summary>
    /// <param name="index">From 0 to the number of slots − 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such slot.</exception>
    public Face this[int index] => (uint)index < (uint)mesh.FaceSlots
        ? new(mesh, index)
        : throw new ArgumentOutOfRangeException(nameof(index), index, $"The mesh has {mesh.FaceSlots} slots for faces.");

    /// <summary>Starts the walk.</summary>
    public Enumerator GetEnumerator() => new(mesh);

    IEnumerator<Face> IEnumerable<Face>.GetEnumerator()
    {
        foreach (Face element in this)
            yield return element;
    }

    IEnumerator IEnumerable.GetEnumerator() => ((IEnumerable<Face>)this).GetEnumerator();

    /// <summary>The walk.</summary>
    public struct Enumerator
    {
        private readonly Mesh mesh;
        private readonly int end;
        private int index;

        internal Enumerator(Mesh mesh)
        {
            this.mesh = mesh;
            end = mesh.FaceSlots;
            index = -1;
        }

        /// <summary>The element.</summary>
        public readonly Face Current => new(mesh, index);

        /// <summary>Goes to the next element, if there is one.</summary>
        public bool MoveNext()
        {
            do
            {
                if (++index >= end)
                    return false;
            }
            while (mesh.IsDeletedFace(index));
            return true;
        }
    }
}
