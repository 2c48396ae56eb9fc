namespace MeshLab.Structure;

/// <summary>A broken rule of the structure.</summary>
/// <param name="Rule">The number of the rule: 1 for R1 … 12 for R12 (<c>docs/validation.md</c>).</param>
/// <param name="Element">The element to blame, as <c>v12</c>, <c>h3</c>, <c>e4</c>, <c>f5</c>, or a trait's name.</param>
/// <param name="Message">What is wrong.</param>
public sealed record Violation(int Rule, string Element, string Message)
{
    /// <inheritdoc/>
    public override string ToString() => $"R{Rule} {Element}: {Message}";
}

/// <summary>The rules of the structure, one by one.</summary>
public sealed partial class Mesh
{
    /// <summary>Lists every violated rule, R1 to R12; empty for a sound mesh. O(V + E + F) for meshes of bounded valence.</summary>
    public IReadOnlyList<Violation> Validate()
    {
        var found = new List<Violation>();
        CheckReferences(found);
        // The rest walks along the references, which may lead anywhere if they are broken.
        if (found.Count == 0)
        {
            CheckHalfEdges(found);
            if (found.Count == 0)
            {
                CheckVertices(found);
                CheckFaces(found);
            }
        }
        CheckPositions(found);
        CheckTraits(found);
        return found;
    }

    /// <summary>R9: live elements refer to live elements only. R1 (twin of twin) holds by the numbering of half-edges in pairs, if both live.</summary>
    private void CheckReferences(List<Violation> found)
    {
        if ((halfEdgeSlots & 1) != 0)
            found.Add(new(1, ElementName.HalfEdge(halfEdgeSlots - 1), "the last half-edge has no twin"));
        for (int h = 0; h + 1 < halfEdgeSlots; h += 2)
        {
            if (next[h] < 0 != next[h + 1] < 0)
                found.Add(new(1, ElementName.HalfEdge(h), "one of the two half-edges is deleted, its twin is not"));
        }
        for (int h = 0; h < halfEdgeSlots; h++)
        {
            if (next[h] < 0)
                continue;
            string name = ElementName.HalfEdge(h);
            if (!LiveHalfEdge(next[h]))
                found.Add(new(9, name, $"next is {ElementName.HalfEdge(next[h])}, which is not live"));
            if (!LiveHalfEdge(previous[h]))
                found.Add(new(9, name, $"previous is {ElementName.HalfEdge(previous[h])}, which is not live"));
            if ((uint)target[h] >= (uint)vertexSlots || outgoing[target[h]] == DeletedVertexMark)
                found.Add(new(9, name, $"target is {ElementName.Vertex(target[h])}, which is not live"));
            if (face[h] < -1 || face[h] >= faceSlots || (face[h] >= 0 && halfEdgeOf[face[h]] < 0))
                found.Add(new(9, name, $"face is {ElementName.Face(face[h])}, which is not live"));
        }
        for (int v = 0; v < vertexSlots; v++)
        {
            if (outgoing[v] < DeletedVertexMark || (outgoing[v] >= 0 && !LiveHalfEdge(outgoing[v])))
                found.Add(new(9, ElementName.Vertex(v), $"outgoing is {ElementName.HalfEdge(outgoing[v])}, which is not live"));
        }
        for (int f = 0; f < faceSlots; f++)
        {
            if (halfEdgeOf[f] >= 0 && !LiveHalfEdge(halfEdgeOf[f]))
                found.Add(new(9, ElementName.Face(f), $"half-edge is {ElementName.HalfEdge(halfEdgeOf[f])}, which is not live"));
        }
    }

    private bool LiveHalfEdge(int h) => (uint)h < (uint)halfEdgeSlots && next[h] >= 0;

    /// <summary>R2: next and previous are inverse. R3: next stays in the face. R4: next begins where the half-edge ends.</summary>
    private void CheckHalfEdges(List<Violation> found)
    {
        for (int h = 0; h < halfEdgeSlots; h++)
        {
            int n = next[h];
            if (n < 0)
                continue;
            if (previous[n] != h)
                found.Add(new(2, ElementName.HalfEdge(h), $"next is {ElementName.HalfEdge(n)}, whose previous is {ElementName.HalfEdge(previous[n])}"));
            if (face[n] != face[h])
                found.Add(new(3, ElementName.HalfEdge(h), $"next is {ElementName.HalfEdge(n)}, which lies in another face"));
            if (target[h] != target[n ^ 1])
                found.Add(new(4, ElementName.HalfEdge(h), $"ends at {ElementName.Vertex(target[h])}, but next begins at {ElementName.Vertex(target[n ^ 1])}"));
            if (target[h] == target[h ^ 1])
                found.Add(new(8, ElementName.Edge(h >> 1), $"both ends are {ElementName.Vertex(target[h])}"));
        }
    }

    /// <summary>R5: outgoing starts at its vertex. R6: it is a boundary one where there is a boundary. R7: all half-edges are reached from it.
    /// R10: no two half-edges lead to the same neighbour.</summary>
    private void CheckVertices(List<Violation> found)
    {
        var incident = new int[vertexSlots];
        for (int h = 0; h < halfEdgeSlots; h++)
        {
            if (next[h] >= 0)
                incident[target[h]]++;
        }
        var lastSource = new int[vertexSlots];
        Array.Fill(lastSource, -1);
        for (int v = 0; v < vertexSlots; v++)
        {
            int start = outgoing[v];
            if (start < 0)
            {
                if (incident[v] > 0)
                    found.Add(new(5, ElementName.Vertex(v), "has edges but no outgoing half-edge"));
                continue;
            }
            if (target[start ^ 1] != v)
            {
                found.Add(new(5, ElementName.Vertex(v), $"outgoing {ElementName.HalfEdge(start)} leaves {ElementName.Vertex(target[start ^ 1])}"));
                continue;
            }
            CheckRing(found, v, start, incident[v], lastSource);
        }
    }

    private void CheckRing(List<Violation> found, int v, int start, int incident, int[] lastSource)
    {
        int reached = 0, boundaries = 0, h = start;
        do
        {
            reached++;
            if (face[h] < 0)
                boundaries++;
            if (lastSource[target[h]] == v)
                found.Add(new(10, ElementName.HalfEdge(h), $"{ElementName.Vertex(v)} and {ElementName.Vertex(target[h])} are joined by more than one edge"));
            lastSource[target[h]] = v;
            h = next[h ^ 1];
        }
        while (h != start && reached <= incident);
        if (reached != incident || h != start)
            found.Add(new(7, ElementName.Vertex(v), $"{incident} half-edges leave it, {reached} are reached from its outgoing one"));
        else if (boundaries > 1)
            found.Add(new(7, ElementName.Vertex(v), $"{boundaries} holes meet in it"));
        else if (boundaries == 1 && face[start] >= 0)
            found.Add(new(6, ElementName.Vertex(v), $"lies on a boundary, but its outgoing {ElementName.HalfEdge(start)} does not"));
    }

    /// <summary>R3 and R8: a face's half-edges are one loop with three or more distinct vertices.</summary>
    private void CheckFaces(List<Violation> found)
    {
        var owned = new int[faceSlots];
        for (int h = 0; h < halfEdgeSlots; h++)
        {
            if (next[h] >= 0 && face[h] >= 0)
                owned[face[h]]++;
        }
        var lastFace = new int[vertexSlots];
        Array.Fill(lastFace, -1);
        for (int f = 0; f < faceSlots; f++)
        {
            if (halfEdgeOf[f] < 0)
                continue;
            if (face[halfEdgeOf[f]] != f)
            {
                found.Add(new(3, ElementName.Face(f), $"its half-edge {ElementName.HalfEdge(halfEdgeOf[f])} lies in another face"));
                continue;
            }
            int degree = 0, h = halfEdgeOf[f];
            do
            {
                if (lastFace[target[h]] == f)
                    found.Add(new(8, ElementName.Face(f), $"{ElementName.Vertex(target[h])} appears twice"));
                lastFace[target[h]] = f;
                degree++;
                h = next[h];
            }
            while (h != halfEdgeOf[f]);
            if (degree < 3)
                found.Add(new(8, ElementName.Face(f), $"has {degree} vertices"));
            if (degree != owned[f])
                found.Add(new(3, ElementName.Face(f), $"{owned[f]} half-edges name it, its loop has {degree}"));
        }
    }

    /// <summary>R11: positions are finite.</summary>
    private void CheckPositions(List<Violation> found)
    {
        for (int v = 0; v < vertexSlots; v++)
        {
            if (outgoing[v] != DeletedVertexMark && !positions[v].IsFinite)
                found.Add(new(11, ElementName.Vertex(v), $"its position is {positions[v]}"));
        }
    }

    /// <summary>R12: every trait has a value per slot.</summary>
    private void CheckTraits(List<Violation> found)
    {
        foreach (Trait trait in AllTraits)
        {
            if (trait.Count != SlotsOf(trait.Kind))
                found.Add(new(12, trait.Name, $"has {trait.Count} values for {SlotsOf(trait.Kind)} slots"));
        }
    }
}
