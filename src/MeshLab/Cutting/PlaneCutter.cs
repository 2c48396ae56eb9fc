using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Cutting;

/// <summary>The work of cutting off one side: number the vertices that stay, then the points of the cut, then write the pieces of faces, then the caps.</summary>
internal sealed class PlaneCutter
{
    private const int GridBits = 44;

    private readonly Mesh mesh;
    private readonly CuttingPlane plane;
    private readonly PlaneSide side;
    private readonly PlaneCrossings crossings;
    private readonly int[] pointOnEdge;
    private readonly int[] number;
    private readonly List<int> sourceVertex = [];
    private readonly List<int> cutHalfEdge = [];
    private readonly List<double> parameter = [];
    private readonly List<Vector3D> positions = [];
    private readonly List<int> corners = [];
    private readonly List<int> sourceFace = [];
    private readonly List<int[]> rims = [];
    private readonly Dictionary<int, int> mergedInto = [];

    public PlaneCutter(Mesh mesh, CuttingPlane plane, double[] distance, PlaneSide side)
    {
        this.mesh = mesh;
        this.plane = plane;
        this.side = side;
        crossings = PlaneCrossings.Find(mesh, distance, side == PlaneSide.Above ? 1 : -1, touchingIsInside: false);
        pointOnEdge = new int[mesh.EdgeSlots];
        number = new int[mesh.VertexSlots];
    }

    public PlaneCutResult Cut(bool cap)
    {
        NumberKeptVertices();
        int openChains = crossings.Chains.Count(chain => !chain.IsClosed);
        foreach (PlaneCrossings.Chain chain in crossings.Chains)
            NumberCutPoints(chain, cap);
        WriteFaces(keepFacesInPlane: !cap && side == PlaneSide.Above);
        if (!cap || rims.Count == 0)
            return Finish(0, 0, openChains);

        int faces = sourceFace.Count;
        List<int> outside = [.. corners];
        WriteFlatCaps();
        try
        {
            return Finish(sourceFace.Count - faces, 0, openChains);
        }
        catch (TopologyException)
        {
            // A diagonal of a cap fell on an edge that is there already, or a rim that crosses itself has one twice: fans have no diagonals.
        }
        corners.Clear();
        corners.AddRange(outside);
        sourceFace.RemoveRange(faces, sourceFace.Count - faces);
        WriteFans();
        return Finish(sourceFace.Count - faces, rims.Count, openChains);
    }

    private void NumberKeptVertices()
    {
        bool[] inside = crossings.Inside;
        for (int v = 0; v < number.Length; v++)
        {
            number[v] = -1;
            if (!inside[v])
                continue;
            number[v] = positions.Count;
            AddPoint(mesh.positions[v], v, -1, 0);
        }
    }

    private int AddPoint(Vector3D position, int source, int cut, double t)
    {
        positions.Add(position);
        sourceVertex.Add(source);
        cutHalfEdge.Add(cut);
        parameter.Add(t);
        return positions.Count - 1;
    }

    /// <summary>One point per crossed edge; one in all for edges in a row that end in the same vertex on the plane.</summary>
    private void NumberCutPoints(PlaneCrossings.Chain chain, bool cap)
    {
        int[] edges = chain.Leaving;
        var line = new List<int>(edges.Length);
        int n = edges.Length, begin = 0;
        // A closed chain is read from a place where no such row is broken.
        if (chain.IsClosed)
        {
            while (begin < n && TouchedVertex(edges[begin]) is >= 0 and var v && TouchedVertex(edges[(begin + n - 1) % n]) == v)
                begin++;
        }
        int touchedBefore = -1;
        for (int i = 0; i < n; i++)
        {
            int h = edges[(begin + i) % n], touched = TouchedVertex(h);
            if (touched < 0)
                line.Add(AddPoint(crossings.PointOn(h), -1, h, crossings.ParameterOf(h)));
            else if (touched != touchedBefore)
                line.Add(PointAt(touched, cap));
            pointOnEdge[h >> 1] = line[^1];
            touchedBefore = touched;
        }
        if (chain.IsClosed && cap)
            AddRim(line);
    }

    /// <summary>A copy of a vertex on the plane; without caps one for all, which the builder splits where it must.</summary>
    private int PointAt(int vertex, bool separate)
    {
        if (separate)
            return AddPoint(mesh.positions[vertex], vertex, -1, 0);
        if (number[vertex] < 0)
            number[vertex] = AddPoint(mesh.positions[vertex], vertex, -1, 0);
        return number[vertex];
    }

    private int TouchedVertex(int leaving)
    {
        int v = mesh.target[leaving];
        return crossings.Distance[v] == 0 ? v : -1;
    }

    /// <summary>Takes spikes out of a line, there and back along an edge in the plane: their two sides are joined instead.</summary>
    private void AddRim(List<int> line)
    {
        bool changed = true;
        while (changed && line.Count > 2)
        {
            changed = false;
            for (int i = 0; i < line.Count && line.Count > 2; i++)
            {
                int a = line[i], tip = (i + 1) % line.Count, b = line[(i + 2) % line.Count];
                if (sourceVertex[a] < 0 || sourceVertex[a] != sourceVertex[b] || a == b)
                    continue;
                mergedInto[b] = a;
                int after = (i + 2) % line.Count;
                foreach (int place in tip > after ? (ReadOnlySpan<int>)[tip, after] : [after, tip])
                    line.RemoveAt(place);
                changed = true;
            }
        }
        if (line.Count > 2)
            rims.Add([.. line]);
    }

    private int Merged(int point)
    {
        while (mergedInto.TryGetValue(point, out int into))
            point = into;
        return point;
    }

    private void WriteFaces(bool keepFacesInPlane)
    {
        int[] next = mesh.next, target = mesh.target, halfEdgeOf = mesh.halfEdgeOf;
        bool[] inside = crossings.Inside;
        corners.EnsureCapacity(3 * mesh.FaceSlots);
        sourceFace.EnsureCapacity(mesh.FaceSlots);
        Span<int> piece = stackalloc int[6];
        for (int f = 0; f < mesh.FaceSlots; f++)
        {
            int h0 = halfEdgeOf[f];
            if (h0 < 0)
                continue;
            int h1 = next[h0], h2 = next[h1];
            int a = target[h2], b = target[h0], c = target[h1];
            int count = (inside[a] ? 1 : 0) + (inside[b] ? 1 : 0) + (inside[c] ? 1 : 0);
            if (count == 3)
            {
                Write(f, number[a], number[b], number[c]);
                continue;
            }
            if (count == 0)
            {
                if (keepFacesInPlane && crossings.Distance[a] == 0 && crossings.Distance[b] == 0 && crossings.Distance[c] == 0)
                    Write(f, PointAt(a, false), PointAt(b, false), PointAt(c, false));
                continue;
            }
            int n = 0;
            n = Corner(piece, n, a, h0, b);
            n = Corner(piece, n, b, h1, c);
            n = Corner(piece, n, c, h2, a);
            if (n > 1 && piece[n - 1] == piece[0])
                n--;
            WritePiece(f, piece[..n]);
        }
    }

    /// <summary>The corners that a vertex and the edge behind it give to the piece.</summary>
    private int Corner(Span<int> piece, int n, int from, int h, int to)
    {
        if (crossings.Inside[from])
            piece[n++] = number[from];
        if (crossings.Inside[from] != crossings.Inside[to])
        {
            int point = Merged(pointOnEdge[h >> 1]);
            if (n == 0 || piece[n - 1] != point)
                piece[n++] = point;
        }
        return n;
    }

    private void WritePiece(int face, ReadOnlySpan<int> piece)
    {
        if (piece.Length == 3)
        {
            Write(face, piece[0], piece[1], piece[2]);
        }
        else if (Vector3D.DistanceSquared(positions[piece[0]], positions[piece[2]]) <= Vector3D.DistanceSquared(positions[piece[1]], positions[piece[3]]))
        {
            Write(face, piece[0], piece[1], piece[2]);
            Write(face, piece[0], piece[2], piece[3]);
        }
        else
        {
            Write(face, piece[0], piece[1], piece[3]);
            Write(face, piece[1], piece[2], piece[3]);
        }
    }

    private void Write(int face, int a, int b, int c)
    {
        corners.Add(a);
        corners.Add(b);
        corners.Add(c);
        sourceFace.Add(face);
    }

    /// <summary>Triangulates the inside of the rims.</summary>
    private void WriteFlatCaps()
    {
        (Vector3D x, Vector3D y) = plane.Axes();
        if (side == PlaneSide.Below)
            (x, y) = (y, x);
        // Only rims need flat coordinates; they are numbered apart.
        List<int> used = [];
        var flatLoops = new List<int[]>(rims.Count);
        foreach (int[] rim in rims)
        {
            flatLoops.Add([.. Enumerable.Range(used.Count, rim.Length)]);
            used.AddRange(rim);
        }
        var flat = new Vector2D[used.Count];
        Vector3D origin = plane.Normal * plane.Offset;
        for (int i = 0; i < flat.Length; i++)
        {
            Vector3D p = positions[used[i]] - origin;
            flat[i] = new(Vector3D.Dot(p, x), Vector3D.Dot(p, y));
        }
        SnapToGrid(flat);
        var triangles = new List<int>();
        PlanarTriangulation.Triangulate(flat, flatLoops, triangles);
        // The cap looks away from the part: the rim of a piece is the cap's rim backwards.
        for (int i = 0; i < triangles.Count; i += 3)
            Write(-1, used[triangles[i]], used[triangles[i + 2]], used[triangles[i + 1]]);
    }

    /// <summary>Rounds away the last bits: points in which loops touch come from different edges, and become equal.</summary>
    private static void SnapToGrid(Vector2D[] flat)
    {
        double extent = 0;
        foreach (Vector2D p in flat)
            extent = Math.Max(extent, Math.Max(Math.Abs(p.X), Math.Abs(p.Y)));
        double step = extent > 0 ? Math.ScaleB(1, Math.ILogB(extent) - GridBits) : 1;
        for (int i = 0; i < flat.Length; i++)
            flat[i] = new(Math.Round(flat[i].X / step) * step, Math.Round(flat[i].Y / step) * step);
    }

    private void WriteFans()
    {
        foreach (int[] rim in rims)
        {
            Vector3D sum = default;
            foreach (int v in rim)
                sum += positions[v];
            int center = AddPoint(sum / rim.Length, -1, -1, 0);
            for (int i = 0; i < rim.Length; i++)
                Write(-1, center, rim[(i + 1) % rim.Length], rim[i]);
        }
    }

    private PlaneCutResult Finish(int capFaces, int fanned, int openChains)
    {
        int[] kept = UsedPoints(out int[] newNumber);
        var soup = new PolygonSoup(
            Array.ConvertAll(kept, v => positions[v]),
            PolygonSoup.TriangleStarts(corners.Count, nameof(corners)),
            [.. corners.Select(v => newNumber[v])]);
        bool capped = capFaces > 0;
        Mesh part = MeshBuilder.FromSoup(soup, capped ? NonManifoldPolicy.Throw : NonManifoldPolicy.Split, out BuildReport report);
        if (report.SourceVertices is { } copies)
            kept = Array.ConvertAll(copies, v => kept[v]);
        MeshPart result = MeshPart.Of(
            mesh,
            part,
            Array.ConvertAll(kept, v => sourceVertex[v]),
            [.. sourceFace],
            Array.ConvertAll(kept, v => cutHalfEdge[v]),
            Array.ConvertAll(kept, v => parameter[v]));
        return new(result, capFaces, capped ? rims.Count : 0, fanned, openChains);
    }

    /// <summary>The points that faces use: all but those that were joined with another.</summary>
    private int[] UsedPoints(out int[] newNumber)
    {
        var used = new bool[positions.Count];
        foreach (int v in corners)
            used[v] = true;
        newNumber = new int[used.Length];
        var kept = new List<int>(used.Length);
        for (int v = 0; v < used.Length; v++)
        {
            newNumber[v] = kept.Count;
            if (used[v])
                kept.Add(v);
        }
        return [.. kept];
    }
}
