using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Remeshing;

/// <summary>
/// The triangle mesh while it is remeshed: the columns of <see cref="Mesh"/> with what remeshing asks for again and again beside
/// them (valence, lines), and with slots that are used again, since hundreds of thousands of edges come and go.
/// </summary>
/// <remarks>A private copy. The three operations do not test anything: the steps do.</remarks>
internal sealed class RemeshSurface
{
    private const int End = -1;

    // Free slots are chained through Next, Outgoing and HalfEdgeOf, as ~(following + 1), so that they are negative.
    private int _freeEdge = End, _freeVertex = End, _freeFace = End;
    private int _mark;
    private int[] _marks;

    public int[] Next, Previous, Target, Face, Outgoing, HalfEdgeOf;
    public Vector3D[] Positions;

    /// <summary>Per vertex, the number of edges.</summary>
    public int[] Valence;

    /// <summary>Per vertex, the number of edges on lines (boundaries and features): 0 inside, 2 along a line.</summary>
    public int[] LineCount;

    /// <summary>Per vertex, whether it never moves: ends, crossings and sharp turns of lines.</summary>
    public bool[] IsCorner;

    /// <summary>Per vertex, the face of the input that it lies on.</summary>
    public int[] InputFace;

    /// <summary>Per vertex, the edge length wanted there.</summary>
    public double[] Size;

    /// <summary>Per edge, whether it is on a line.</summary>
    public bool[] OnLine;

    public RemeshSurface(Mesh mesh)
    {
        (VertexSlots, HalfEdgeSlots, FaceSlots) = (mesh.VertexSlots, mesh.HalfEdgeSlots, mesh.FaceSlots);
        int room = mesh.VertexSlots / 2 + 64;
        (Next, Previous) = (Copy(mesh.Next, 6 * room), Copy(mesh.Previous, 6 * room));
        (Target, Face) = (Copy(mesh.Target, 6 * room), Copy(mesh.FaceOf, 6 * room));
        (Outgoing, HalfEdgeOf) = (Copy(mesh.Outgoing, room), Copy(mesh.HalfEdgeOf, 2 * room));
        Positions = Copy(mesh.Positions, room);
        int vertices = Outgoing.Length;
        (Valence, LineCount, InputFace, _marks) = (new int[vertices], new int[vertices], new int[vertices], new int[vertices]);
        (IsCorner, Size, OnLine) = (new bool[vertices], new double[vertices], new bool[Next.Length / 2]);
        for (int h = 0; h < HalfEdgeSlots; h++)
            Valence[Target[h]]++;

        static T[] Copy<T>(ReadOnlySpan<T> column, int room)
        {
            var copy = new T[column.Length + room];
            column.CopyTo(copy);
            return copy;
        }
    }

    public int VertexSlots { get; private set; }

    public int HalfEdgeSlots { get; private set; }

    public int FaceSlots { get; private set; }

    /// <summary>Where every operation is written; null for nowhere.</summary>
    public StepTrace? Trace { get; init; }

    public bool IsFreeEdge(int h) => Next[h] < 0;

    public bool IsLiveVertex(int v) => Outgoing[v] >= 0;

    public bool IsOnBoundary(int v) => Face[Outgoing[v]] < 0;

    public double LengthSquared(int h) => Vector3D.DistanceSquared(Positions[Target[h]], Positions[Target[h ^ 1]]);

    /// <summary>Whether the other diagonal is free for a flip of the edge, which is inside.</summary>
    public bool CanFlip(int h)
    {
        int c = Target[Next[h]], d = Target[Next[h ^ 1]];
        if (c == d)
            return false;
        int start = Outgoing[c], k = start;
        do
        {
            if (Target[k] == d)
                return false;
            k = Next[k ^ 1];
        }
        while (k != start);
        return true;
    }

    /// <summary>Gives the two triangles beside the edge the other diagonal.</summary>
    public void Flip(int h)
    {
        int t = h ^ 1, bc = Next[h], ca = Next[bc], ad = Next[t], db = Next[ad];
        int a = Target[t], b = Target[h], c = Target[bc], d = Target[ad], f = Face[h], g = Face[t];
        Valence[a]--;
        Valence[b]--;
        Valence[c]++;
        Valence[d]++;
        Target[h] = c;
        Target[t] = d;
        LinkTriangle(h, ca, ad, f);
        LinkTriangle(t, db, bc, g);
        if (Outgoing[a] == h)
            Outgoing[a] = ad;
        if (Outgoing[b] == t)
            Outgoing[b] = bc;
        Trace?.Flip(h >> 1, d, c);
    }

    /// <summary>Puts a vertex on the edge and cuts the triangles beside it in two. The part at the source of h keeps the edge's index.</summary>
    public int Split(int h, Vector3D position)
    {
        int t = h ^ 1, a = Target[t], b = Target[h], f = Face[h], g = Face[t], bc = Next[h], db = Previous[t];
        int m = NewVertex(position), n = NewEdge(), back = n ^ 1;
        OnLine[n >> 1] = OnLine[h >> 1];
        LineCount[m] = OnLine[h >> 1] ? 2 : 0;
        Valence[m] = 2;
        InputFace[m] = InputFace[a];
        Size[m] = (Size[a] + Size[b]) * 0.5;

        Target[h] = m;
        Target[n] = b;
        Target[back] = m;
        if (Outgoing[b] == t)
            Outgoing[b] = back;
        Outgoing[m] = n;
        if (f >= 0)
        {
            CutTriangle(h, n, bc, f, m);
        }
        else
        {
            Face[n] = -1;
            Link(h, n);
            Link(n, bc);
        }
        if (g >= 0)
        {
            // The same from the other side, where the part at b comes first.
            int ad = Next[t], d = Target[ad], inner = NewEdge(), outer = inner ^ 1, cut = NewFace();
            Target[inner] = m;
            Target[outer] = d;
            LinkTriangle(t, ad, inner, g);
            LinkTriangle(back, outer, db, cut);
            Valence[d]++;
            Valence[m]++;
        }
        else
        {
            Face[back] = -1;
            Link(db, back);
            Link(back, t);
            Outgoing[m] = t;
        }
        Trace?.Split(h >> 1, m, position);
        return m;
    }

    // h: a → m, n: m → b, then b → c → a: the triangle becomes a, m, c and m, b, c.
    private void CutTriangle(int h, int n, int bc, int f, int m)
    {
        int ca = Next[bc], c = Target[bc], inner = NewEdge(), outer = inner ^ 1, cut = NewFace();
        Target[inner] = c;
        Target[outer] = m;
        LinkTriangle(h, inner, ca, f);
        LinkTriangle(n, bc, outer, cut);
        Valence[c]++;
        Valence[m]++;
    }

    /// <summary>Whether the edge can be contracted without changing the topology (link condition), and without leaving a vertex of two edges.</summary>
    public bool CanCollapse(int h)
    {
        int t = h ^ 1, u = Target[t], v = Target[h];
        int triangles = (Face[h] >= 0 ? 1 : 0) + (Face[t] >= 0 ? 1 : 0);
        if (triangles == 2 && IsOnBoundary(u) && IsOnBoundary(v))
            return false;
        if (CommonNeighbors(u, v) != triangles)
            return false;
        // A tetrahedron, or part of one.
        if (triangles == 2 && Valence[u] <= 3 && Valence[v] <= 3)
            return false;
        return (Face[h] < 0 || ApexSurvives(Target[Next[h]])) && (Face[t] < 0 || ApexSurvives(Target[Next[t]]));
    }

    private bool ApexSurvives(int v) => Valence[v] > (IsOnBoundary(v) ? 2 : 3);

    private int CommonNeighbors(int u, int v)
    {
        _mark++;
        int start = Outgoing[u], k = start, common = 0;
        do
        {
            _marks[Target[k]] = _mark;
            k = Next[k ^ 1];
        }
        while (k != start);
        start = k = Outgoing[v];
        do
        {
            common += _marks[Target[k]] == _mark ? 1 : 0;
            k = Next[k ^ 1];
        }
        while (k != start);
        return common;
    }

    /// <summary>Contracts the edge: its source goes, its target stays, at the position.</summary>
    public void Collapse(int h, Vector3D position)
    {
        int t = h ^ 1, u = Target[t], v = Target[h];
        int hNext = Next[h], hPrevious = Previous[h], tNext = Next[t], tPrevious = Previous[t], f = Face[h], g = Face[t];
        LineCount[v] += LineCount[u] - (OnLine[h >> 1] ? 2 : 0);
        Valence[v] += Valence[u] - 2;
        int start = Outgoing[u], k = start;
        do
        {
            Target[k ^ 1] = v;
            k = Next[k ^ 1];
        }
        while (k != start);

        Link(hPrevious, hNext);
        Link(tPrevious, tNext);
        if (f >= 0)
            HalfEdgeOf[f] = hNext;
        if (g >= 0)
            HalfEdgeOf[g] = tNext;
        if (start != h && Face[start] < 0)
            Outgoing[v] = start;
        else if (Outgoing[v] == t)
            Outgoing[v] = hNext;
        FreeEdge(h);
        FreeVertex(u);
        if (f >= 0)
            CloseTwoGon(hNext);
        if (g >= 0)
            CloseTwoGon(tNext);
        if (f < 0 || g < 0)
            PointToBoundary(v);
        Positions[v] = position;
        Trace?.Collapse(h >> 1, v, u, position);
    }

    // A triangle has lost an edge: its two others become one, which is on a line if one of them was.
    private void CloseTwoGon(int gone)
    {
        int kept = Next[gone], outer = gone ^ 1, v = Target[gone], w = Target[kept], f = Face[gone], g = Face[outer];
        bool both = OnLine[gone >> 1] && OnLine[kept >> 1];
        OnLine[kept >> 1] |= OnLine[gone >> 1];
        if (both)
        {
            LineCount[v]--;
            LineCount[w]--;
        }
        Valence[v]--;
        Valence[w]--;
        int after = Next[outer], before = Previous[outer];
        Link(kept, after);
        Link(before, kept);
        Face[kept] = g;
        if (g >= 0)
            HalfEdgeOf[g] = kept;
        if (Outgoing[v] == outer)
            Outgoing[v] = kept;
        if (Outgoing[w] == gone)
            Outgoing[w] = kept ^ 1;
        FreeEdge(gone);
        HalfEdgeOf[f] = ~(_freeFace + 1);
        _freeFace = f;
    }

    private void PointToBoundary(int v)
    {
        int start = Outgoing[v], k = start;
        do
        {
            if (Face[k] < 0)
            {
                Outgoing[v] = k;
                return;
            }
            k = Next[k ^ 1];
        }
        while (k != start);
    }

    /// <summary>The surface as a mesh, without gaps: vertices and faces in slot order.</summary>
    /// <param name="place">Where a place of a vertex is in the mesh, if that has other coordinates.</param>
    public Mesh ToMesh(Func<Vector3D, int, Vector3D>? place = null)
    {
        var number = new int[VertexSlots];
        var positions = new List<Vector3D>(VertexSlots);
        for (int v = 0; v < VertexSlots; v++)
        {
            number[v] = positions.Count;
            if (IsLiveVertex(v))
                positions.Add(place is null ? Positions[v] : place(Positions[v], v));
        }
        var corners = new List<int>(3 * FaceSlots);
        for (int f = 0; f < FaceSlots; f++)
        {
            int h = HalfEdgeOf[f];
            if (h < 0)
                continue;
            corners.Add(number[Target[h ^ 1]]);
            corners.Add(number[Target[h]]);
            corners.Add(number[Target[Next[h]]]);
        }
        return MeshBuilder.FromTriangles(
            System.Runtime.InteropServices.CollectionsMarshal.AsSpan(positions), System.Runtime.InteropServices.CollectionsMarshal.AsSpan(corners));
    }

    private void Link(int before, int after)
    {
        Next[before] = after;
        Previous[after] = before;
    }

    private void LinkTriangle(int a, int b, int c, int f)
    {
        Link(a, b);
        Link(b, c);
        Link(c, a);
        Face[a] = Face[b] = Face[c] = f;
        HalfEdgeOf[f] = a;
    }

    private int NewVertex(Vector3D position)
    {
        int v = _freeVertex;
        if (v >= 0)
        {
            _freeVertex = ~Outgoing[v] - 1;
        }
        else
        {
            v = VertexSlots++;
            if (v == Outgoing.Length)
                GrowVertices(v * 3 / 2 + 64);
        }
        Positions[v] = position;
        IsCorner[v] = false;
        return v;
    }

    private int NewEdge()
    {
        int h = _freeEdge;
        if (h >= 0)
        {
            _freeEdge = ~Next[h] - 1;
        }
        else
        {
            h = HalfEdgeSlots;
            HalfEdgeSlots += 2;
            if (HalfEdgeSlots > Next.Length)
                GrowHalfEdges((HalfEdgeSlots * 3 / 2 + 64) & ~1);
        }
        OnLine[h >> 1] = false;
        return h;
    }

    private int NewFace()
    {
        int f = _freeFace;
        if (f >= 0)
        {
            _freeFace = ~HalfEdgeOf[f] - 1;
            return f;
        }
        if (FaceSlots == HalfEdgeOf.Length)
            Array.Resize(ref HalfEdgeOf, FaceSlots * 3 / 2 + 64);
        return FaceSlots++;
    }

    private void FreeEdge(int h)
    {
        h &= ~1;
        Next[h] = ~(_freeEdge + 1);
        Next[h + 1] = -1;
        _freeEdge = h;
    }

    private void FreeVertex(int v)
    {
        Outgoing[v] = ~(_freeVertex + 1);
        _freeVertex = v;
    }

    private void GrowVertices(int capacity)
    {
        Array.Resize(ref Outgoing, capacity);
        Array.Resize(ref Positions, capacity);
        Array.Resize(ref Valence, capacity);
        Array.Resize(ref LineCount, capacity);
        Array.Resize(ref IsCorner, capacity);
        Array.Resize(ref InputFace, capacity);
        Array.Resize(ref Size, capacity);
        Array.Resize(ref _marks, capacity);
    }

    private void GrowHalfEdges(int capacity)
    {
        Array.Resize(ref Next, capacity);
        Array.Resize(ref Previous, capacity);
        Array.Resize(ref Target, capacity);
        Array.Resize(ref Face, capacity);
        Array.Resize(ref OnLine, capacity / 2);
    }
}
