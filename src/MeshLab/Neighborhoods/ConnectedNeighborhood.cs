using MeshLab.Structure;

namespace MeshLab.Neighborhoods;

/// <summary>The connected component (连通分量) that an element lies in. Sets in index order, in time proportional to the component.</summary>
public static class ConnectedNeighborhood
{
    extension(Vertex vertex)
    {
        /// <summary>All vertices that paths of edges join to this one, itself included.</summary>
        /// <exception cref="ArgumentException">The vertex is none or deleted.</exception>
        public Vertex[] Component
        {
            get
            {
                vertex.ThrowIfDead();
                return SortedElements.Vertices(vertex.mesh, BreadthFirst.Reachable(vertex.mesh, [vertex.index]));
            }
        }
    }

    extension(Edge edge)
    {
        /// <summary>All edges of the component.</summary>
        /// <exception cref="ArgumentException">The edge is none or deleted.</exception>
        public Edge[] Component
        {
            get
            {
                edge.ThrowIfDead();
                var found = new List<int>();
                foreach (int v in BreadthFirst.Reachable(edge.mesh, [edge.Vertex0.index]))
                {
                    foreach (HalfEdge h in new Vertex(edge.mesh, v).OutgoingHalfEdges)
                    {
                        // Both ends come by; the even half-edge leaves only one of them.
                        if ((h.index & 1) == 0)
                            found.Add(h.index >> 1);
                    }
                }
                return SortedElements.Edges(edge.mesh, found);
            }
        }
    }

    extension(Face face)
    {
        /// <summary>All faces of the component.</summary>
        /// <exception cref="ArgumentException">The face is none or deleted.</exception>
        public Face[] Component
        {
            get
            {
                face.ThrowIfDead();
                var found = new List<int>();
                foreach (int v in BreadthFirst.Reachable(face.mesh, [face.HalfEdge.Target.index]))
                {
                    foreach (HalfEdge h in new Vertex(face.mesh, v).OutgoingHalfEdges)
                    {
                        // A face comes by at each corner; its first half-edge leaves only one.
                        if (!h.IsBoundary && face.mesh.halfEdgeOf[h.Face.index] == h.index)
                            found.Add(h.Face.index);
                    }
                }
                return SortedElements.Faces(face.mesh, found);
            }
        }
    }
}
