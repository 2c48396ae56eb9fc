using MeshLab.Numerics;

namespace MeshLab.Structure;

/// <summary>Makes an oriented 2-manifold of polygons that are not, by leaving faces out or by giving them vertices of their own.</summary>
internal static class SoupRepair
{
    /// <summary>Leaves out, in index order, every face that is no polygon or uses a directed edge again; then, at vertices where fans of faces
    /// only touch, all fans but the one with the lowest face.</summary>
    public static (PolygonSoup Soup, BuildReport Report) Skip(PolygonSoup soup)
    {
        var repairs = new SortedDictionary<int, Repair>();
        var keep = new bool[soup.FaceCount];
        var owner = new Dictionary<(int, int), int>();
        for (int f = 0; f < soup.FaceCount; f++)
        {
            string? conflict = DefectOf(soup, f) ?? ConflictOf(soup, f, owner);
            keep[f] = conflict is null;
            if (conflict is not null)
            {
                repairs[f] = new(RepairKind.SkippedFace, ElementName.Face(f), conflict);
                continue;
            }
            ReadOnlySpan<int> face = soup.Face(f);
            for (int i = 0; i < face.Length; i++)
                owner[(face[i], face[(i + 1) % face.Length])] = f;
        }
        while (SkipTouchingFans(soup, keep, repairs))
        {
        }
        (PolygonSoup kept, int[] sourceFaces) = Select(soup, keep);
        return (kept, new BuildReport([.. repairs.Values], sourceFaces, null, 0));
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

    private static string? DefectOf(PolygonSoup soup, int f)
    {
        ReadOnlySpan<int> face = soup.Face(f);
        int repeated = SoupDiagnosis.RepeatedVertex(face);
        if (repeated >= 0)
            return $"v{face[repeated]} appears twice";
        return face.Length < 3 ? $"it has {face.Length} vertices" : null;
    }

    private static string? ConflictOf(PolygonSoup soup, int f, Dictionary<(int, int), int> owner)
    {
        ReadOnlySpan<int> face = soup.Face(f);
        for (int i = 0; i < face.Length; i++)
        {
            int from = face[i], to = face[(i + 1) % face.Length];
            if (owner.TryGetValue((from, to), out int other))
                return $"f{other} runs from v{from} to v{to} already";
        }
        return null;
    }

    private static bool SkipTouchingFans(PolygonSoup soup, bool[] keep, SortedDictionary<int, Repair> repairs)
    {
        (PolygonSoup kept, int[] source) = Select(soup, keep);
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
        var start = new List<int> { 0 };
        var corners = new List<int>();
        var source = new List<int>();
        for (int f = 0; f < soup.FaceCount; f++)
        {
            if (!keep[f])
                continue;
            corners.AddRange(soup.Face(f));
            start.Add(corners.Count);
            source.Add(f);
        }
        return (new PolygonSoup(soup.Positions, [.. start], [.. corners]), [.. source]);
    }
}
