using MeshLab.Structure;

namespace MeshLab.Neighborhoods;

/// <summary>§5.2 What surrounds an edge (边的邻域). Sets in index order, in time proportional to the answer.</summary>
/// <remarks>
/// <code>
///        ●───●───●          touching faces: those with a corner at either end
///       / \ / \ / \         loop: their edges that touch neither end, and the vertices of those;
///      ●───a───b───●              inside the mesh val(a) + val(b) − 4 edges
///       \ / \ / \ /
///        ●───●───●
/// </code>
/// </remarks>
public static class EdgeNeighborhood
{
    extension(Edge edge)
    {
        /// <summary>§5.2.1 The vertices around the edge: joined to either end, the ends left out.</summary>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        public Vertex[] LoopVertices => edge.AsGroup().RingVertices;

        /// <summary>§5.2.2 The edges of the loop around the edge.</summary>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        public Edge[] LoopEdges
        {
            get
            {
                var found = new List<int>();
                foreach (Face f in edge.TouchingFaces)
                {
                    foreach (HalfEdge h in f.HalfEdges)
                    {
                        if (!IsEnd(edge, h.Source) && !IsEnd(edge, h.Target))
                            found.Add(h.Edge.index);
                    }
                }
                return SortedElements.Edges(edge.mesh, found);
            }
        }

        /// <summary>§5.2.3 The faces with a corner at either end.</summary>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        public Face[] TouchingFaces
        {
            get
            {
                edge.ThrowIfDead();
                var found = new List<int>();
                foreach (Face f in edge.Vertex0.Faces)
                    found.Add(f.index);
                foreach (Face f in edge.Vertex1.Faces)
                    found.Add(f.index);
                return SortedElements.Faces(edge.mesh, found);
            }
        }

        /// <summary>The vertices at exactly <paramref name="k"/> edges from the nearer end; for 0 the two ends.</summary>
        /// <param name="k">How many edges away, at least 0.</param>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        /// <exception cref="ArgumentOutOfRangeException"><paramref name="k"/> is negative.</exception>
        public Vertex[] Ring(int k) => edge.AsGroup().Ring(k);

        /// <summary>The group of this edge alone.</summary>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        public ElementGroup AsGroup()
        {
            edge.ThrowIfDead();
            return ElementGroup.Of(edge.mesh, [edge]);
        }
    }

    private static bool IsEnd(Edge edge, Vertex v) => v == edge.Vertex0 || v == edge.Vertex1;
}
