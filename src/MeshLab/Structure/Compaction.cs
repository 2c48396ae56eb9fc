using MeshLab.Numerics;

namespace MeshLab.Structure;

/// <summary>Where every element went: per old index the new one, −1 for the deleted.</summary>
/// <param name="Vertices">Old vertex index → new.</param>
/// <param name="HalfEdges">Old half-edge index → new.</param>
/// <param name="Edges">Old edge index → new.</param>
/// <param name="Faces">Old face index → new.</param>
public sealed record CompactionMaps(int[] Vertices, int[] HalfEdges, int[] Edges, int[] Faces);

/// <summary>Where the elements of an appended mesh begin.</summary>
/// <param name="FirstVertex">Add to the appended mesh's vertex slots.</param>
/// <param name="FirstHalfEdge">Add to its half-edge slots.</param>
/// <param name="FirstEdge">Add to its edge slots.</param>
/// <param name="FirstFace">Add to its face slots.</param>
public sealed record AppendMaps(int FirstVertex, int FirstHalfEdge, int FirstEdge, int FirstFace);

/// <summary>§4.8 Renumbering.</summary>
public sealed partial class Mesh
{
    /// <summary>§4.8 重新编号: removes the slots of deleted elements. The order stays; traits move along. O(V + E + F).</summary>
    /// <returns>Old → new indices.</returns>
    /// <exception cref="InvalidOperationException">The operations are being recorded: undoing across a renumbering is not possible.</exception>
    public CompactionMaps Compact()
    {
        if (Listener is not null)
            throw new InvalidOperationException("Elements cannot be renumbered while operations are recorded.");
        CompactionMaps maps = NumberLiveElements();
        MoveVerticesDown(maps);
        MoveHalfEdgesDown(maps);
        MoveFacesDown(maps);
        (vertexSlots, halfEdgeSlots, faceSlots) = (vertexCount, 2 * edgeCount, faceCount);
        CompactTraits(maps);
        return maps;
    }

    private CompactionMaps NumberLiveElements()
    {
        int[] vertices = GC.AllocateUninitializedArray<int>(vertexSlots), halfEdges = GC.AllocateUninitializedArray<int>(halfEdgeSlots);
        int[] edges = GC.AllocateUninitializedArray<int>(EdgeSlots), faces = GC.AllocateUninitializedArray<int>(faceSlots);
        int live = 0;
        for (int v = 0; v < vertices.Length; v++)
            vertices[v] = outgoing[v] != DeletedVertexMark ? live++ : -1;
        live = 0;
        for (int e = 0; e < edges.Length; e++)
        {
            int to = next[2 * e] >= 0 ? live++ : -1;
            edges[e] = to;
            halfEdges[2 * e] = to < 0 ? -1 : 2 * to;
            halfEdges[2 * e + 1] = to < 0 ? -1 : 2 * to + 1;
        }
        live = 0;
        for (int f = 0; f < faces.Length; f++)
            faces[f] = halfEdgeOf[f] >= 0 ? live++ : -1;
        return new(vertices, halfEdges, edges, faces);
    }

    // Nothing moves to a higher place, so that each column is rewritten where it is.
    private void MoveVerticesDown(CompactionMaps maps)
    {
        int[] map = maps.Vertices, halfEdges = maps.HalfEdges;
        for (int v = 0; v < map.Length; v++)
        {
            int to = map[v];
            if (to < 0)
                continue;
            positions[to] = positions[v];
            outgoing[to] = outgoing[v] < 0 ? outgoing[v] : halfEdges[outgoing[v]];
        }
    }

    private void MoveHalfEdgesDown(CompactionMaps maps)
    {
        int[] map = maps.HalfEdges, vertices = maps.Vertices, faces = maps.Faces;
        int[] n = next, p = previous, t = target, f = face;
        for (int h = 0; h < map.Length; h++)
        {
            int to = map[h];
            if (to < 0)
                continue;
            n[to] = map[n[h]];
            p[to] = map[p[h]];
            t[to] = vertices[t[h]];
            f[to] = f[h] < 0 ? -1 : faces[f[h]];
        }
    }

    private void MoveFacesDown(CompactionMaps maps)
    {
        int[] map = maps.Faces, halfEdges = maps.HalfEdges;
        for (int f = 0; f < map.Length; f++)
        {
            if (map[f] >= 0)
                halfEdgeOf[map[f]] = halfEdges[halfEdgeOf[f]];
        }
    }

    private void CompactTraits(CompactionMaps maps)
    {
        foreach (Trait trait in vertexTraits)
            trait.Compact(maps.Vertices, vertexSlots);
        foreach (Trait trait in halfEdgeTraits)
            trait.Compact(maps.HalfEdges, halfEdgeSlots);
        foreach (Trait trait in edgeTraits)
            trait.Compact(maps.Edges, EdgeSlots);
        foreach (Trait trait in faceTraits)
            trait.Compact(maps.Faces, faceSlots);
    }

    /// <summary>Gives every element the index that the maps say. Half-edge maps must keep twins together.</summary>
    internal void Renumber(CompactionMaps maps, int vertices, int edges, int faces)
    {
        if (Listener is not null)
            throw new InvalidOperationException("Elements cannot be renumbered while operations are recorded.");

        var newPositions = new Vector3D[vertices];
        var newOutgoing = new int[vertices];
        for (int v = 0; v < vertexSlots; v++)
        {
            int to = maps.Vertices[v];
            if (to < 0)
                continue;
            newPositions[to] = positions[v];
            newOutgoing[to] = outgoing[v] < 0 ? outgoing[v] : maps.HalfEdges[outgoing[v]];
        }

        int[] newNext = new int[2 * edges], newPrevious = new int[2 * edges], newTarget = new int[2 * edges], newFace = new int[2 * edges];
        for (int h = 0; h < halfEdgeSlots; h++)
        {
            int to = maps.HalfEdges[h];
            if (to < 0)
                continue;
            newNext[to] = maps.HalfEdges[next[h]];
            newPrevious[to] = maps.HalfEdges[previous[h]];
            newTarget[to] = maps.Vertices[target[h]];
            newFace[to] = face[h] < 0 ? -1 : maps.Faces[face[h]];
        }

        var newHalfEdgeOf = new int[faces];
        for (int f = 0; f < faceSlots; f++)
        {
            if (maps.Faces[f] >= 0)
                newHalfEdgeOf[maps.Faces[f]] = maps.HalfEdges[halfEdgeOf[f]];
        }

        (positions, outgoing, halfEdgeOf) = (newPositions, newOutgoing, newHalfEdgeOf);
        (next, previous, target, face) = (newNext, newPrevious, newTarget, newFace);
        (vertexSlots, vertexCount) = (vertices, vertices);
        (halfEdgeSlots, edgeCount) = (2 * edges, edges);
        (faceSlots, faceCount) = (faces, faces);

        CompactTraits(maps);
    }

    /// <summary>Adds a copy of another mesh as further components; deleted elements stay deleted. Traits of the same name and type come along,
    /// as do those that only the other mesh has. O(size of both).</summary>
    /// <returns>Where the copy's indices begin.</returns>
    /// <exception cref="InvalidOperationException">The operations are being recorded.</exception>
    public AppendMaps Append(Mesh other)
    {
        ArgumentNullException.ThrowIfNull(other);
        if (Listener is not null)
            throw new InvalidOperationException("A mesh cannot be appended while operations are recorded.");
        if (ReferenceEquals(other, this))
            other = Clone();

        var first = new AppendMaps(vertexSlots, halfEdgeSlots, EdgeSlots, faceSlots);
        int vertices = checked(vertexSlots + other.vertexSlots), halfEdges = checked(halfEdgeSlots + other.halfEdgeSlots);
        int faces = checked(faceSlots + other.faceSlots);
        EnsureVertexCapacity(vertices);
        EnsureHalfEdgeCapacity(halfEdges);
        EnsureFaceCapacity(faces);

        other.Positions.CopyTo(positions.AsSpan(first.FirstVertex));
        Shift(other.Outgoing, outgoing.AsSpan(first.FirstVertex), first.FirstHalfEdge);
        Shift(other.Next, next.AsSpan(first.FirstHalfEdge), first.FirstHalfEdge);
        Shift(other.Previous, previous.AsSpan(first.FirstHalfEdge), first.FirstHalfEdge);
        Shift(other.Target, target.AsSpan(first.FirstHalfEdge), first.FirstVertex);
        Shift(other.FaceOf, face.AsSpan(first.FirstHalfEdge), first.FirstFace);
        Shift(other.HalfEdgeOf, halfEdgeOf.AsSpan(first.FirstFace), first.FirstHalfEdge);

        (vertexSlots, halfEdgeSlots, faceSlots) = (vertices, halfEdges, faces);
        vertexCount += other.vertexCount;
        edgeCount += other.edgeCount;
        faceCount += other.faceCount;
        ResizeTraits();
        AppendTraits(other, first);
        return first;
    }

    private void AppendTraits(Mesh other, AppendMaps first)
    {
        foreach (Trait theirs in other.AllTraits)
        {
            if (other.faceLabels.Exists(labels => ReferenceEquals(labels.Labels, theirs)))
                continue;
            List<Trait> ours = TraitsOf(theirs.Kind);
            Trait? mine = Find(ours, theirs.Name);
            if (mine is null)
            {
                mine = theirs.CloneFor(this);
                mine.Grow(0);
                mine.Grow(SlotsOf(theirs.Kind));
                ours.Add(mine);
            }
            mine.AppendFrom(theirs, theirs.Kind switch
            {
                ElementKind.Vertex => first.FirstVertex,
                ElementKind.HalfEdge => first.FirstHalfEdge,
                ElementKind.Edge => first.FirstEdge,
                _ => first.FirstFace,
            });
        }
        foreach (FaceLabels theirs in other.faceLabels)
        {
            FaceLabels mine = GetOrAddFaceLabels(theirs.Sort);
            for (int f = 0; f < other.faceSlots; f++)
            {
                int label = theirs.Labels[f];
                mine.Labels[first.FirstFace + f] = label < 0 ? label : mine.Number(theirs.Names[label]);
            }
        }
    }

    private static void Shift(ReadOnlySpan<int> from, Span<int> to, int offset)
    {
        for (int i = 0; i < from.Length; i++)
            to[i] = from[i] < 0 ? from[i] : from[i] + offset;
    }
}
