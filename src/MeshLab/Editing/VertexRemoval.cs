using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>§4.4 删除顶点 (delete vertex): deletes a vertex with its faces and leaves its link (环) as the boundary; also groups of vertices.</summary>
/// <remarks>
/// <code>
///        b ── a               b ── a
///       / \ / \              /      \
///      c ─ v ─ f     ⟶      c  hole  f
///       \ / \ /              \      /
///        d ── e               d ── e
/// </code>
/// The group forms delete the one-ring of vertices, the one-ring of edges (every face at one of their ends), and the two-ring of a vertex
/// (every face at the vertex or at one of its neighbours). Refusals and options as for <see cref="FaceRemoval"/>; the vertices named are
/// deleted in any case. Cost: O(sum of valences).
/// </remarks>
public static class VertexRemoval
{
    extension(Vertex vertex)
    {
        /// <summary>Whether <c>Delete</c> would succeed; the mesh is not touched.</summary>
        /// <param name="why">The reason if not.</param>
        /// <exception cref="ArgumentException">The vertex is none or deleted.</exception>
        public bool CanDelete(out RemovalRefusal why)
        {
            vertex.ThrowIfDead();
            return (why = Examine(vertex.Mesh, [vertex], RemovalOptions.Default, out _)) == RemovalRefusal.None;
        }

        /// <summary>Deletes the vertex and its faces, or leaves the mesh exactly as it was and says why.</summary>
        /// <param name="why">The reason if it was not deleted.</param>
        /// <param name="options">How; <see cref="RemovalOptions.Default"/> if not given.</param>
        /// <exception cref="ArgumentException">The vertex is none or deleted.</exception>
        public bool TryDelete(out RemovalRefusal why, RemovalOptions? options = null)
        {
            vertex.ThrowIfDead();
            return TryDeleteAll(vertex.Mesh, [vertex], options, out why, vertex.Index);
        }

        /// <summary>Deletes the vertex and its faces.</summary>
        /// <param name="options">How; <see cref="RemovalOptions.Default"/> if not given.</param>
        /// <exception cref="ArgumentException">The vertex is none or deleted.</exception>
        /// <exception cref="TopologyException">It cannot be deleted; the message names the vertex and the reason.</exception>
        public void Delete(RemovalOptions? options = null)
        {
            if (!vertex.TryDelete(out RemovalRefusal why, options))
                throw new TopologyException($"{vertex} cannot be deleted: {why}.", vertex.ToString());
        }

        /// <summary>§4.4 Deletes the vertex, its neighbours, and every face at one of them.</summary>
        /// <param name="options">How; <see cref="RemovalOptions.Default"/> if not given.</param>
        /// <exception cref="ArgumentException">The vertex is none or deleted.</exception>
        /// <exception cref="TopologyException">They cannot be deleted; the mesh is as before.</exception>
        public void DeleteTwoRing(RemovalOptions? options = null)
        {
            vertex.ThrowIfDead();
            vertex.Mesh.DeleteVertices([vertex, .. vertex.Neighbors], options);
        }
    }

    extension(Mesh mesh)
    {
        /// <summary>§4.4 Deletes vertices and every face at one of them, or leaves the mesh exactly as it was and says why.</summary>
        /// <param name="vertices">Live vertices of this mesh; repetitions do no harm.</param>
        /// <param name="why">The reason if they were not deleted.</param>
        /// <param name="options">How; <see cref="RemovalOptions.Default"/> if not given.</param>
        /// <exception cref="ArgumentException">A vertex is none, deleted, or of another mesh.</exception>
        public bool TryDeleteVertices(IEnumerable<Vertex> vertices, out RemovalRefusal why, RemovalOptions? options = null)
        {
            ArgumentNullException.ThrowIfNull(vertices);
            var group = new List<Vertex>();
            foreach (Vertex v in vertices.Distinct())
            {
                mesh.CheckOwn(v, nameof(vertices));
                group.Add(v);
            }
            return TryDeleteAll(mesh, group, options, out why, -1);
        }

        /// <summary>§4.4 Deletes vertices and every face at one of them.</summary>
        /// <param name="vertices">Live vertices of this mesh; repetitions do no harm.</param>
        /// <param name="options">How; <see cref="RemovalOptions.Default"/> if not given.</param>
        /// <exception cref="ArgumentException">A vertex is none, deleted, or of another mesh.</exception>
        /// <exception cref="TopologyException">They cannot be deleted; the mesh is as before.</exception>
        public void DeleteVertices(IEnumerable<Vertex> vertices, RemovalOptions? options = null)
        {
            if (!mesh.TryDeleteVertices(vertices, out RemovalRefusal why, options))
                throw new TopologyException($"The vertices cannot be deleted: {why}.");
        }

        /// <summary>§4.4 Deletes the ends of edges and every face at one of them.</summary>
        /// <param name="edges">Live edges of this mesh.</param>
        /// <param name="options">How; <see cref="RemovalOptions.Default"/> if not given.</param>
        /// <exception cref="ArgumentException">An edge is none, deleted, or of another mesh.</exception>
        /// <exception cref="TopologyException">They cannot be deleted; the mesh is as before.</exception>
        public void DeleteRingsOfEdges(IEnumerable<Edge> edges, RemovalOptions? options = null)
        {
            ArgumentNullException.ThrowIfNull(edges);
            var ends = new List<Vertex>();
            foreach (Edge e in edges)
            {
                mesh.CheckOwn(e, nameof(edges));
                ends.AddRange([e.Vertex0, e.Vertex1]);
            }
            mesh.DeleteVertices(ends, options);
        }

        /// <summary>§4.2 Deletes faces, all or none.</summary>
        /// <param name="faces">Live faces of this mesh; repetitions do no harm.</param>
        /// <param name="options">How; <see cref="RemovalOptions.Default"/> if not given.</param>
        /// <exception cref="ArgumentException">A face is none, deleted, or of another mesh.</exception>
        /// <exception cref="TopologyException">They cannot be deleted; the mesh is as before.</exception>
        public void DeleteFaces(IEnumerable<Face> faces, RemovalOptions? options = null)
        {
            ArgumentNullException.ThrowIfNull(faces);
            options ??= RemovalOptions.Default;
            var group = new List<int>();
            foreach (Face f in faces.Distinct())
            {
                mesh.CheckOwn(f, nameof(faces));
                group.Add(f.Index);
            }
            if (!options.SplitPinched && RegionRemoval.Examine(mesh, group) != RemovalRefusal.None)
                throw new TopologyException($"The faces cannot be deleted: {RemovalRefusal.Pinch}.");
            using OperationScope operation = mesh.BeginOperation(OperationKind.DeleteFace);
            RegionRemoval.Remove(mesh, group, options);
            operation.Complete();
        }
    }

    private static RemovalRefusal Examine(Mesh mesh, IReadOnlyCollection<Vertex> vertices, RemovalOptions options, out List<int> faces)
    {
        faces = [];
        var seen = new HashSet<int>();
        foreach (Vertex v in vertices)
        {
            foreach (Face f in v.Faces)
            {
                if (seen.Add(f.Index))
                    faces.Add(f.Index);
            }
        }
        return options.SplitPinched ? RemovalRefusal.None : RegionRemoval.Examine(mesh, faces);
    }

    private static bool TryDeleteAll(Mesh mesh, IReadOnlyCollection<Vertex> vertices, RemovalOptions? options, out RemovalRefusal why, int element)
    {
        options ??= RemovalOptions.Default;
        why = Examine(mesh, vertices, options, out List<int> faces);
        if (why != RemovalRefusal.None)
            return false;
        using OperationScope operation = mesh.BeginOperation(OperationKind.DeleteVertex, element);
        RegionRemoval.Remove(mesh, faces, options);
        foreach (Vertex v in vertices)
        {
            if (!v.IsDeleted)
                mesh.DeleteVertexSlot(v.Index);
        }
        operation.Complete();
        return true;
    }
}
