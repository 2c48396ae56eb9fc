using MeshLab.Structure;

namespace MeshLab.Neighborhoods;

/// <summary>§5.3 What surrounds a face (面的邻域). Sets in index order, in time proportional to the answer.</summary>
public static class FaceNeighborhood
{
    extension(Face face)
    {
        /// <summary>§5.3.1 The other faces that share a vertex with this one (共点面).</summary>
        /// <exception cref="ArgumentException">The face is none or deleted.</exception>
        public Face[] FacesSharingVertex => face.AsGroup().RingFaces;

        /// <summary>§5.3.2 The other faces that share an edge with this one (共边面).</summary>
        /// <exception cref="ArgumentException">The face is none or deleted.</exception>
        public Face[] FacesSharingEdge
        {
            get
            {
                var found = new List<int>();
                foreach (Face f in face.Neighbors)
                {
                    if (f != face)
                        found.Add(f.index);
                }
                return SortedElements.Faces(face.mesh, found);
            }
        }

        /// <summary>§5.3.3 The vertices joined to a corner of the face, its corners left out.</summary>
        /// <exception cref="ArgumentException">The face is none or deleted.</exception>
        public Vertex[] RingVertices => face.AsGroup().RingVertices;

        /// <summary>§5.3.4 The edges of the faces around that touch no corner of this one.</summary>
        /// <exception cref="ArgumentException">The face is none or deleted.</exception>
        public Edge[] RingEdges => face.AsGroup().RingEdges;

        /// <summary>The vertices at exactly <paramref name="k"/> edges from the nearest corner; for 0 the corners.</summary>
        /// <param name="k">How many edges away, at least 0.</param>
        /// <exception cref="ArgumentException">The face is none or deleted.</exception>
        /// <exception cref="ArgumentOutOfRangeException"><paramref name="k"/> is negative.</exception>
        public Vertex[] Ring(int k) => face.AsGroup().Ring(k);

        /// <summary>The group of this face alone.</summary>
        /// <exception cref="ArgumentException">The face is none or deleted.</exception>
        public ElementGroup AsGroup()
        {
            face.ThrowIfDead();
            return ElementGroup.Of(face.mesh, [face]);
        }
    }
}
