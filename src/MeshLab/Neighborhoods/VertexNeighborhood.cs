using MeshLab.Structure;

namespace MeshLab.Neighborhoods;

/// <summary>§5.1 What surrounds a vertex (点的邻域). Sets in index order; the circulators of <see cref="Vertex"/> give the same elements in turning order.</summary>
/// <remarks>
/// <code>
///        q───p          spokes (辐边):  v–p, v–q, …        edges at the vertex
///       / \ / \         link (一层邻域边):  p–q, …          edges opposite the vertex in its faces
///      ●───v───●        ring (一层邻域点):  p, q, …         the other ends of the spokes
///       \ / \ /
///        ●───●
/// </code>
/// The textbook's "edges of the first ring" is the link; both are named here. All take time proportional to the answer (and its sorting).
/// </remarks>
public static class VertexNeighborhood
{
    extension(Vertex vertex)
    {
        /// <summary>§5.1.1 The vertices joined to this one by an edge (邻接点).</summary>
        /// <exception cref="ArgumentException">The vertex is none or deleted.</exception>
        public Vertex[] RingVertices
        {
            get
            {
                var found = new List<int>();
                foreach (Vertex v in vertex.Neighbors)
                    found.Add(v.index);
                return SortedElements.Vertices(vertex.mesh, found);
            }
        }

        /// <summary>§5.1.2 The edges at the vertex (辐边).</summary>
        /// <exception cref="ArgumentException">The vertex is none or deleted.</exception>
        public Edge[] SpokeEdges
        {
            get
            {
                var found = new List<int>();
                foreach (Edge e in vertex.Edges)
                    found.Add(e.index);
                return SortedElements.Edges(vertex.mesh, found);
            }
        }

        /// <summary>§5.1.2 The edges of the faces around the vertex that do not touch it (一层邻域边).</summary>
        /// <exception cref="ArgumentException">The vertex is none or deleted.</exception>
        public Edge[] LinkEdges
        {
            get
            {
                var found = new List<int>();
                foreach (Face f in vertex.Faces)
                {
                    foreach (HalfEdge h in f.HalfEdges)
                    {
                        if (h.Source != vertex && h.Target != vertex)
                            found.Add(h.Edge.index);
                    }
                }
                return SortedElements.Edges(vertex.mesh, found);
            }
        }

        /// <summary>§5.1.3 The faces at the vertex (邻接面).</summary>
        /// <exception cref="ArgumentException">The vertex is none or deleted.</exception>
        public Face[] IncidentFaces
        {
            get
            {
                var found = new List<int>();
                foreach (Face f in vertex.Faces)
                    found.Add(f.index);
                return SortedElements.Faces(vertex.mesh, found);
            }
        }

        /// <summary>The k-ring (k 层邻域): the vertices at exactly <paramref name="k"/> edges from this one; for 0 the vertex itself.</summary>
        /// <param name="k">How many edges away, at least 0.</param>
        /// <exception cref="ArgumentException">The vertex is none or deleted.</exception>
        /// <exception cref="ArgumentOutOfRangeException"><paramref name="k"/> is negative.</exception>
        public Vertex[] Ring(int k)
        {
            vertex.ThrowIfDead();
            return BreadthFirst.Ring(vertex.mesh, [vertex.index], k);
        }

        /// <summary>The vertices at most <paramref name="k"/> edges from this one, itself included.</summary>
        /// <param name="k">How many edges away, at least 0.</param>
        /// <exception cref="ArgumentException">The vertex is none or deleted.</exception>
        /// <exception cref="ArgumentOutOfRangeException"><paramref name="k"/> is negative.</exception>
        public Vertex[] Disk(int k)
        {
            vertex.ThrowIfDead();
            return BreadthFirst.Disk(vertex.mesh, [vertex.index], k);
        }

        /// <summary>The group of this vertex alone.</summary>
        /// <exception cref="ArgumentException">The vertex is none or deleted.</exception>
        public ElementGroup AsGroup()
        {
            vertex.ThrowIfDead();
            return ElementGroup.Of(vertex.mesh, [vertex]);
        }
    }
}
