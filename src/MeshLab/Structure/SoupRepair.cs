using MeshLab.Numerics;

namespace MeshLab.Structure;

/// <summary>Makes an oriented 2-manifold of polygons that are not, by leaving faces out or by giving them vertices of their own.</summary>
internal static class SoupRepair
{
    /// <summary>Leaves out, in index order, every face that is no polygon or uses a directed edge again; then, at vertices where fans of faces
    /// only touch, all fans but the one with the lowest face.</summary>
    /// <param name="soup">The polygons.</param>
    /// <param name="connect">Makes a mesh of polygons, or null of such that are no manifold.</param>
    /// <param name="report">What was left out.</param>
    public static Mesh Skip(PolygonSoup soup, Func<PolygonSoup, Mesh?> connect, out BuildReport report)
    {
        var repairs = new SortedDictionary<int, Repair>();
        bool[] keep = KeepWithoutConflicts(soup, repairs);
        while (true)
        {
            (PolygonSoup kept, int[] sourceFaces) = Select(soup, keep);
            if (connect(kept) is { } mesh)
            {
                report = new BuildReport([.. repairs.Values], sourceFaces, null, 0);
                return mesh;
            }
            if (!SkipTouchingFans(kept, sourceFaces, keep, repairs))
                throw SoupDiagnosis.Explain(kept);
        }
    }

    /// <summary>Cuts the surface along every edge that is not shared by exactly two faces in opposite directions, and gives every fan of faces at a
    /// vertex a copy of it (Guéziec, Taubin, Lazarus, Horn 1998, "cutting"). The fan with the lowest corner keeps the vertex.</summary>
    public static (PolygonSoup Soup, BuildReport Report) Split(PolygonSoup soup)
    {
        var repairs = new List<Repair>();
        var keep = new bool[soup.FaceCount];
        for (int f = 0; f < soup.FaceCount; f++)
        {
            string? defect = DefectOf(soup, f);
            keep[f] = defect is null;
            if (defect is not null)
                repairs.Add(new(RepairKind.SkippedFace, ElementName.Face(f), defect));
        }
        (PolygonSoup kept, int[] sourceFaces) = Select(soup, keep);

        int[] fan = SoupDiagnosis.FansOfCorners(kept, out _);
        var positions = new List<Vector3D>(kept.Positions);
        var sourceVertices = new List<int>(kept.VertexCount);
        for (int v = 0; v < kept.VertexCount; v++)
            sourceVertices.Add(v);
        var vertexOfFan = new Dictionary<int, int>();
        var taken = new bool[kept.VertexCount];
        var corners = new int[kept.Corners.Length];
        for (int c = 0; c < corners.Length; c++)
        {
            int v = kept.Corners[c];
            if (!vertexOfFan.TryGetValue(fan[c], out int own))
            {
                own = v;
                if (taken[v])
                {
                    own = positions.Count;
                    positions.Add(kept.Positions[v]);
                    sourceVertices.Add(v);
                    repairs.Add(new(RepairKind.SplitVertex, ElementName.Vertex(v), $"its faces do not make one fan; a further fan got the copy v{own}"));
                }
                taken[v] = true;
                vertexOfFan[fan[c]] = own;
            }
            corners[c] = own;
        }
        bool sameFaces = sourceFaces.Length == soup.FaceCount;
        return (new PolygonSoup([.. positions], kept.FaceStart, corners),
            new BuildReport(repairs, sameFaces ? null : sourceFaces, [.. sourceVertices], 0));
    }

    private static bool[] KeepWithoutConflicts(PolygonSoup soup, SortedDictionary<int, Repair> repairs)
    {
        var keep = new bool[soup.FaceCount];
        var directed = new EdgeTable(soup.Corners.Length);
        // Per directed edge the kept face that runs along it, plus one.
        var owner = new int[soup.Corners.Length];
        Span<int> few = stackalloc int[16];
        for (int f = 0; f < soup.FaceCount; f++)
        {
            ReadOnlySpan<int> face = soup.Face(f);
            string? conflict = DefectOf(soup, f);
            Span<int> edges = face.Length <= few.Length ? few[..face.Length] : new int[face.Length];
            for (int i = 0; i < face.Length && conflict is null; i++)
            {
                int from = face[i], to = face[i + 1 == face.Length ? 0 : i + 1];
                edges[i] = directed.NumberOf(from, to);
                if (owner[edges[i]] > 0)
                    conflict = $"f{owner[edges[i]] - 1} runs from v{from} to v{to} already";
            }
            keep[f] = conflict is null;
            if (conflict is not null)
            {
                repairs[f] = new(RepairKind.SkippedFace, ElementName.Face(f), conflict);
                continue;
            }
            foreach (int edge in edges)
                owner[edge] = f + 1;
        }
        return keep;
    }

    private static string? DefectOf(PolygonSoup soup, int f)
    {
        ReadOnlySpan<int> face = soup.Face(f);
        int repeated = SoupDiagnosis.RepeatedVertex(face);
        if (repeated >= 0)
            return $"v{face[repeated]} appears twice";
        return face.Length < 3 ? $"it has {face.Length} vertices" : null;
    }

    private static bool SkipTouchingFans(PolygonSoup kept, int[] source, bool[] keep, SortedDictionary<int, Repair> repairs)
    {
        int[] fan = SoupDiagnosis.FansOfCorners(kept, out int[] fansAtVertex);
        var firstFan = new int[kept.VertexCount];
        Array.Fill(firstFan, -1);
        bool skipped = false;
        for (int f = 0; f < kept.FaceCount; f++)
        {
            for (int c = kept.FaceStart[f]; c < kept.FaceStart[f + 1]; c++)
            {
                int v = kept.Corners[c];
                if (fansAtVertex[v] < 2)
                    continue;
                if (firstFan[v] < 0)
                    firstFan[v] = fan[c];
                if (fan[c] == firstFan[v] || !keep[source[f]])
                    continue;
                keep[source[f]] = false;
                skipped = true;
                repairs[source[f]] = new(RepairKind.SkippedFace, ElementName.Face(source[f]), $"it touches an earlier fan of faces in v{v} only");
            }
        }
        return skipped;
    }

    private static (PolygonSoup Soup, int[] SourceFaces) Select(PolygonSoup soup, bool[] keep)
    {
        int faces = 0, length = 0;
        for (int f = 0; f < soup.FaceCount; f++)
        {
            faces += keep[f] ? 1 : 0;
            length += keep[f] ? soup.Face(f).Length : 0;
        }
        int[] start = new int[faces + 1], corners = new int[length], source = new int[faces];
        int kept = 0;
        for (int f = 0; f < soup.FaceCount; f++)
        {
            if (!keep[f])
                continue;
            ReadOnlySpan<int> face = soup.Face(f);
            face.CopyTo(corners.AsSpan(start[kept]));
            source[kept] = f;
            start[kept + 1] = start[kept] + face.Length;
            kept++;
        }
        return (new PolygonSoup(soup.Positions, start, corners), source);
    }
}
