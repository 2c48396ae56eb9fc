using MeshLab.Structure;

namespace MeshLab.Neighborhoods;

/// <summary>§5.4–5.5 A group of vertices, edges or faces (点组, 边组, 面组) and what surrounds it. Made by <c>mesh.Group(…)</c>.</summary>
/// <remarks>
/// A group is first turned into its vertex set S: the vertices themselves, the ends of the edges, the corners of the faces. A face group's inside is its
/// faces; the inside of a vertex or edge group is the faces with all corners in S. A group may lie in several patches; all of them are answered for.
/// Results are sets in index order (loops apart), in time proportional to the group and the answer. The group is a snapshot: editing
/// the mesh makes it stale.
/// </remarks>
public sealed class ElementGroup
{
    private readonly HashSet<int> vertices;
    private readonly HashSet<int> faces;

    private ElementGroup(Mesh mesh, ElementKind kind, HashSet<int> vertices, HashSet<int>? faces)
    {
        Mesh = mesh;
        Kind = kind;
        this.vertices = vertices;
        this.faces = faces ?? FacesInside();
    }

    /// <summary>The mesh.</summary>
    public Mesh Mesh { get; }

    /// <summary>Whether the group is one of vertices, edges or faces.</summary>
    public ElementKind Kind { get; }

    /// <summary>The vertex set S.</summary>
    public Vertex[] Vertices => SortedElements.Vertices(Mesh, [.. vertices]);

    /// <summary>The faces inside the group.</summary>
    public Face[] Faces => SortedElements.Faces(Mesh, [.. faces]);

    /// <summary>§5.4.1 The vertices outside S that an edge joins to S (环点).</summary>
    public Vertex[] RingVertices => Ring(1);

    /// <summary>§5.4.2 The faces with a corner in S that are not inside the group (环面).</summary>
    public Face[] RingFaces => SortedElements.Faces(Mesh, RingFaceIndices());

    /// <summary>§5.4.3 The half-edges of the ring faces with both ends outside S (环半边).</summary>
    public HalfEdge[] RingHalfEdges
    {
        get
        {
            var found = new List<int>();
            foreach (int f in SortedElements.Distinct(RingFaceIndices()))
            {
                foreach (HalfEdge h in new Face(Mesh, f).HalfEdges)
                {
                    if (!vertices.Contains(h.Source.index) && !vertices.Contains(h.Target.index))
                        found.Add(h.index);
                }
            }
            return SortedElements.HalfEdges(Mesh, found);
        }
    }

    /// <summary>§5.4.3 The edges of the ring faces with both ends outside S (环边).</summary>
    public Edge[] RingEdges => SortedElements.Edges(Mesh, [.. RingHalfEdges.Select(h => h.Edge.index)]);

    /// <summary>§5.5 The half-edges along the group's rim (边界半边). Of a face group: those with their face inside and their twin's not.
    /// Of a vertex or edge group: those with both ends in S and their face not inside.</summary>
    public HalfEdge[] RimHalfEdges
    {
        get
        {
            var found = new List<int>();
            foreach (int v in vertices)
            {
                foreach (HalfEdge h in new Vertex(Mesh, v).OutgoingHalfEdges)
                {
                    if (IsRim(h.index))
                        found.Add(h.index);
                }
            }
            return SortedElements.HalfEdges(Mesh, found);
        }
    }

    /// <summary>§5.5 The rim as closed loops, each beginning at its lowest half-edge and ordered by it: the inside of a face group is to the left,
    /// that of a vertex or edge group to the right.</summary>
    public HalfEdge[][] RimLoops
    {
        get
        {
            var loops = new List<HalfEdge[]>();
            var walked = new HashSet<int>();
            foreach (HalfEdge start in RimHalfEdges)
            {
                if (walked.Contains(start.index))
                    continue;
                var loop = new List<HalfEdge>();
                int h = start.index;
                while (walked.Add(h))
                {
                    loop.Add(new(Mesh, h));
                    h = NextOnRim(h);
                }
                loops.Add([.. loop]);
            }
            return [.. loops];
        }
    }

    /// <summary>§5.5 The faces inside the group with an edge on its rim (边界面).</summary>
    public Face[] RimFaces => SidesOfRim(inside: true);

    /// <summary>The faces outside the group with an edge on its rim (外边界面).</summary>
    public Face[] OuterRimFaces => SidesOfRim(inside: false);

    /// <summary>The vertices at exactly <paramref name="k"/> edges from the group; for 0 the set S.</summary>
    /// <param name="k">How many edges away, at least 0.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="k"/> is negative.</exception>
    public Vertex[] Ring(int k) => BreadthFirst.Ring(Mesh, vertices, k);

    /// <summary>The vertices at most <paramref name="k"/> edges from the group.</summary>
    /// <param name="k">How many edges away, at least 0.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="k"/> is negative.</exception>
    public Vertex[] Disk(int k) => BreadthFirst.Disk(Mesh, vertices, k);

    /// <summary>A group of vertices.</summary>
    /// <exception cref="ArgumentException">A vertex is none, deleted, or of another mesh; it is named.</exception>
    internal static ElementGroup Of(Mesh mesh, IEnumerable<Vertex> group)
    {
        var set = new HashSet<int>();
        foreach (Vertex v in group)
        {
            mesh.CheckOwn(v, nameof(group));
            set.Add(v.index);
        }
        return new(mesh, ElementKind.Vertex, set, null);
    }

    /// <summary>A group of edges.</summary>
    /// <exception cref="ArgumentException">An edge is none, deleted, or of another mesh; it is named.</exception>
    internal static ElementGroup Of(Mesh mesh, IEnumerable<Edge> group)
    {
        var set = new HashSet<int>();
        foreach (Edge e in group)
        {
            mesh.CheckOwn(e, nameof(group));
            set.Add(e.Vertex0.index);
            set.Add(e.Vertex1.index);
        }
        return new(mesh, ElementKind.Edge, set, null);
    }

    /// <summary>A group of faces.</summary>
    /// <exception cref="ArgumentException">A face is none, deleted, or of another mesh; it is named.</exception>
    internal static ElementGroup Of(Mesh mesh, IEnumerable<Face> group)
    {
        HashSet<int> vertexSet = [], faceSet = [];
        foreach (Face f in group)
        {
            mesh.CheckOwn(f, nameof(group));
            faceSet.Add(f.index);
            foreach (Vertex v in f.Vertices)
                vertexSet.Add(v.index);
        }
        return new(mesh, ElementKind.Face, vertexSet, faceSet);
    }

    private HashSet<int> FacesInside()
    {
        var inside = new HashSet<int>();
        foreach (int v in vertices)
        {
            foreach (Face f in new Vertex(Mesh, v).Faces)
            {
                if (!inside.Contains(f.index) && AllCornersInside(f))
                    inside.Add(f.index);
            }
        }
        return inside;
    }

    private bool AllCornersInside(Face f)
    {
        foreach (Vertex v in f.Vertices)
        {
            if (!vertices.Contains(v.index))
                return false;
        }
        return true;
    }

    private List<int> RingFaceIndices()
    {
        var found = new List<int>();
        foreach (int v in vertices)
        {
            foreach (Face f in new Vertex(Mesh, v).Faces)
            {
                if (!faces.Contains(f.index))
                    found.Add(f.index);
            }
        }
        return found;
    }

    private bool IsRim(int h)
    {
        bool left = faces.Contains(Mesh.face[h]);
        return Kind == ElementKind.Face
            ? left && !faces.Contains(Mesh.face[h ^ 1])
            : !left && vertices.Contains(Mesh.target[h]) && vertices.Contains(Mesh.target[h ^ 1]);
    }

    /// <summary>Turns about the target, staying on the left side of the half-edge, until the rim goes on.</summary>
    private int NextOnRim(int h)
    {
        h = Mesh.next[h];
        while (!IsRim(h))
            h = Mesh.next[h ^ 1];
        return h;
    }

    private Face[] SidesOfRim(bool inside)
    {
        var found = new List<int>();
        foreach (HalfEdge h in RimHalfEdges)
        {
            foreach (int f in (ReadOnlySpan<int>)[Mesh.face[h.index], Mesh.face[h.index ^ 1]])
            {
                if (f >= 0 && faces.Contains(f) == inside)
                    found.Add(f);
            }
        }
        return SortedElements.Faces(Mesh, found);
    }
}

/// <summary>Making groups.</summary>
public static class ElementGroups
{
    extension(Mesh mesh)
    {
        /// <summary>A group of vertices (点组).</summary>
        /// <exception cref="ArgumentException">A vertex is none, deleted, or of another mesh; it is named.</exception>
        public ElementGroup Group(IEnumerable<Vertex> vertices)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            ArgumentNullException.ThrowIfNull(vertices);
            return ElementGroup.Of(mesh, vertices);
        }

        /// <summary>A group of edges (边组).</summary>
        /// <exception cref="ArgumentException">An edge is none, deleted, or of another mesh; it is named.</exception>
        public ElementGroup Group(IEnumerable<Edge> edges)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            ArgumentNullException.ThrowIfNull(edges);
            return ElementGroup.Of(mesh, edges);
        }

        /// <summary>A group of faces (面组).</summary>
        /// <exception cref="ArgumentException">A face is none, deleted, or of another mesh; it is named.</exception>
        public ElementGroup Group(IEnumerable<Face> faces)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            ArgumentNullException.ThrowIfNull(faces);
            return ElementGroup.Of(mesh, faces);
        }
    }
}
