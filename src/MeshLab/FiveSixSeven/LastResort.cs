using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.FiveSixSeven;

/// <summary>A 5-6-7 mesh by topology alone, on every input, for the components that are none yet: valence 3 → 4 by an edge split, every triangle into nine, one flip for every vertex of
/// valence 4, and vertices above 7 split in their own fresh ring.</summary>
/// <remarks>The flips never meet: each vertex of valence 4 gets a face of its own among its four. That is always possible (Hall's theorem: k such
/// vertices have 4k corners, and a face has at most three, so they touch at least 4k/3 faces).</remarks>
internal static class LastResort
{
    public static WorkMesh Run(WorkMesh mesh)
    {
        bool[] isBad = VerticesOfBadComponents(mesh);
        RaiseValenceThree(mesh);
        int[] faceOf = MatchToFaces(mesh);
        WorkMesh fine = Subdivide(mesh, isBad, faceOf, out List<(int From, int To)> flips);
        fine.Trace = mesh.Trace;
        mesh.Trace?.Remake("nineSplit", fine.VertexSlots, fine.EdgeSlots, fine.FaceSlots);
        foreach ((int from, int to) in flips)
            fine.Flip(fine.Find(from, to));
        LowerHighValences(fine);
        fine.GatherQuadrics();
        return fine;
    }

    /// <summary>Per vertex, whether its component has a vertex that is neither 5, 6 nor 7. Vertices that are added later have higher numbers: their components are bad.</summary>
    private static bool[] VerticesOfBadComponents(WorkMesh mesh)
    {
        var isBad = new bool[mesh.VertexSlots];
        var open = new Stack<int>();
        for (int seed = 0; seed < isBad.Length; seed++)
        {
            if (isBad[seed] || !mesh.IsLiveVertex(seed) || !mesh.IsBad(seed))
                continue;
            isBad[seed] = true;
            open.Push(seed);
            while (open.TryPop(out int v))
            {
                int start = mesh.Outgoing[v], h = start;
                do
                {
                    int w = mesh.Target[h];
                    if (!isBad[w])
                    {
                        isBad[w] = true;
                        open.Push(w);
                    }
                    h = mesh.Next[h ^ 1];
                }
                while (h != start);
            }
        }
        return isBad;
    }

    private static void RaiseValenceThree(WorkMesh mesh)
    {
        for (int v = 0; v < mesh.VertexSlots; v++)
        {
            if (!mesh.IsLiveVertex(v) || mesh.OnRim[v] != 0 || mesh.Valence[v] != 3)
                continue;
            int longest = -1, start = mesh.Outgoing[v], x = start;
            do
            {
                int opposite = mesh.Next[x];
                if (longest < 0 || mesh.LengthSquared(opposite >> 1) > mesh.LengthSquared(longest >> 1))
                    longest = opposite;
                x = mesh.Next[x ^ 1];
            }
            while (x != start);
            mesh.Split(longest, (mesh.Positions[mesh.Target[longest]] + mesh.Positions[mesh.Source(longest)]) * 0.5);
        }
    }

    /// <summary>Per face, the vertex of valence 4 that it serves, or −1: shortest augmenting paths.</summary>
    private static int[] MatchToFaces(WorkMesh mesh)
    {
        int[] owner = new int[mesh.FaceSlots], reachedFrom = new int[mesh.FaceSlots], visited = new int[mesh.FaceSlots], faceOf = new int[mesh.VertexSlots];
        Array.Fill(owner, -1);
        Array.Fill(faceOf, -1);
        var open = new Queue<int>();
        int round = 0;
        for (int v = 0; v < mesh.VertexSlots; v++)
        {
            if (!mesh.IsLiveVertex(v) || mesh.OnRim[v] != 0 || mesh.Valence[v] != 4)
                continue;
            round++;
            // Back along the path every vertex takes the face that was reached from it, and gives up the one it had.
            for (int f = FindFree(v); f >= 0;)
            {
                int u = reachedFrom[f];
                owner[f] = u;
                (f, faceOf[u]) = (faceOf[u], f);
            }
        }
        return owner;

        int FindFree(int v)
        {
            open.Clear();
            open.Enqueue(v);
            while (open.TryDequeue(out int u))
            {
                int start = mesh.Outgoing[u], x = start;
                do
                {
                    int f = mesh.Face[x];
                    if (visited[f] != round)
                    {
                        visited[f] = round;
                        reachedFrom[f] = u;
                        if (owner[f] < 0)
                            return f;
                        open.Enqueue(owner[f]);
                    }
                    x = mesh.Next[x ^ 1];
                }
                while (x != start);
            }
            return -1;
        }
    }

    /// <summary>§9.4: two vertices per edge, one per face; old valences stay, new vertices have six.</summary>
    private static WorkMesh Subdivide(WorkMesh mesh, bool[] isBad, int[] served, out List<(int From, int To)> flips)
    {
        var number = new int[mesh.VertexSlots];
        var nearSource = new int[2 * mesh.EdgeSlots];
        var positions = new List<Vector3D>();
        var kinds = new List<int>();
        for (int v = 0; v < mesh.VertexSlots; v++)
        {
            if (mesh.IsLiveVertex(v))
                number[v] = Add(mesh.Positions[v], mesh.Kind[v]);
        }
        for (int h = 0; h < nearSource.Length; h++)
        {
            if (mesh.IsLiveEdge(h >> 1) && IsBad(mesh.Target[h]))
            {
                Vector3D p = Vector3D.Lerp(mesh.Positions[mesh.Source(h)], mesh.Positions[mesh.Target[h]], 1 / 3.0);
                nearSource[h] = Add(p, mesh.Crease[h >> 1] != 0 ? VertexKind.OnCrease : VertexKind.Smooth);
            }
        }
        var corners = new List<int>(27 * mesh.LiveFaces);
        flips = [];
        for (int f = 0; f < mesh.FaceSlots; f++)
        {
            if (!mesh.IsLiveFace(f))
                continue;
            int h = mesh.HalfEdgeOf[f];
            if (!IsBad(mesh.Target[h]))
            {
                corners.AddRange([number[mesh.Source(h)], number[mesh.Target[h]], number[mesh.Apex(h)]]);
                continue;
            }
            int center = Add((mesh.Positions[mesh.Source(h)] + mesh.Positions[mesh.Target[h]] + mesh.Positions[mesh.Apex(h)]) / 3, VertexKind.Smooth);
            for (int k = 0; k < 3; k++, h = mesh.Next[h])
            {
                int atNext = nearSource[h], atPrevious = nearSource[mesh.Previous[h] ^ 1];
                corners.AddRange([number[mesh.Source(h)], atNext, atPrevious]);
                corners.AddRange([atNext, center, atPrevious]);
                corners.AddRange([atNext, nearSource[h ^ 1], center]);
                if (served[f] == mesh.Source(h))
                    flips.Add((atNext, atPrevious));
            }
        }
        WorkMesh fine = WorkMesh.From(MeshBuilder.FromTriangles([.. positions], [.. corners]));
        for (int v = 0; v < fine.VertexSlots; v++)
            fine.Kind[v] = kinds[v];
        MarkCreases(mesh, fine, IsBad, number, nearSource);
        return fine;

        bool IsBad(int v) => v >= isBad.Length || isBad[v];

        int Add(Vector3D p, int kind)
        {
            positions.Add(p);
            kinds.Add(kind);
            return positions.Count - 1;
        }
    }

    private static void MarkCreases(WorkMesh mesh, WorkMesh fine, Func<int, bool> isBad, int[] number, int[] nearSource)
    {
        for (int e = 0; e < mesh.EdgeSlots; e++)
        {
            if (!mesh.IsLiveEdge(e) || mesh.Crease[e] == 0)
                continue;
            int h = 2 * e;
            ReadOnlySpan<int> path = !isBad(mesh.Target[h]) ? [number[mesh.Source(h)], number[mesh.Target[h]]]
                : [number[mesh.Source(h)], nearSource[h], nearSource[h + 1], number[mesh.Target[h]]];
            for (int i = 0; i + 1 < path.Length; i++)
                fine.Crease[fine.Find(path[i], path[i + 1]) >> 1] = 1;
        }
    }

    /// <summary>Splits off six consecutive neighbours at a time: an edge split on the third spoke, then three flips. The new vertex has valence 7, the old one
    /// loses three edges; the two limiting neighbours, fresh ones of valence 6, get 7.</summary>
    private static void LowerHighValences(WorkMesh mesh)
    {
        int vertices = mesh.VertexSlots;
        Span<int> spokes = stackalloc int[6];
        for (int v = 0; v < vertices; v++)
        {
            if (mesh.OnRim[v] != 0)
                continue;
            int first = mesh.Outgoing[v];
            while (mesh.Valence[v] > 7)
            {
                int x = first;
                for (int k = 0; k < 6; k++, x = mesh.Next[x ^ 1])
                    spokes[k] = x;
                // The next group begins one spoke before this one, so that its ends are fresh again.
                int before = mesh.Previous[first] ^ 1;
                Vector3D p = Vector3D.Lerp(mesh.Positions[v], mesh.Positions[mesh.Target[spokes[2]]], 0.4);
                mesh.Split(spokes[2], p);
                foreach (int q in (ReadOnlySpan<int>)[spokes[1], spokes[3], spokes[4]])
                {
                    mesh.Crease[q >> 1] = 0;
                    mesh.Flip(q);
                }
                first = before;
            }
        }
    }
}
