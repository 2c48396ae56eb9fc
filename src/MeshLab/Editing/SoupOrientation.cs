using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>What was done to orient a polygon soup.</summary>
/// <param name="Soup">The oriented polygons; positions and order of faces as before.</param>
/// <param name="Reversed">The faces that were turned around.</param>
/// <param name="Components">The number of components of faces joined across edges.</param>
/// <param name="NonOrientable">Per component without a consistent orientation, a face in which the contradiction shows; these components are left as they were.</param>
public sealed record SoupOrientationResult(PolygonSoup Soup, IReadOnlyList<int> Reversed, int Components, IReadOnlyList<int> NonOrientable);

/// <summary>§4.8 统一方向 (consistent orientation): turns the faces of a polygon soup so that neighbours agree.</summary>
/// <remarks>Faces are neighbours across an edge that has exactly two faces. The smallest face of a component leads; a closed component is then turned
/// outward if its volume is negative. Expected O(n).</remarks>
public static class SoupOrientation
{
    extension(PolygonSoup soup)
    {
        /// <summary>Gives every component one orientation where there is one.</summary>
        /// <param name="outward">Whether closed components are turned so that their volume is positive.</param>
        /// <returns>A new soup and what was done; the soup itself is not changed.</returns>
        public SoupOrientationResult WithConsistentOrientation(bool outward = true)
        {
            ArgumentNullException.ThrowIfNull(soup);
            (int[] across, bool[] isClosedFace) = MatchEdges(soup);
            var turned = new bool[soup.FaceCount];
            var component = new int[soup.FaceCount];
            Array.Fill(component, -1);
            var nonOrientable = new List<int>();
            int components = 0;
            for (int seed = 0; seed < soup.FaceCount; seed++)
            {
                if (component[seed] >= 0)
                    continue;
                List<int> members = Spread(soup, across, seed, components++, component, turned, out int contradiction);
                if (contradiction >= 0)
                {
                    nonOrientable.Add(contradiction);
                    foreach (int f in members)
                        turned[f] = false;
                }
                else if (outward && members.TrueForAll(f => isClosedFace[f]) && Volume(soup, members, turned) < 0)
                {
                    foreach (int f in members)
                        turned[f] = !turned[f];
                }
            }
            List<int> reversed = [.. Enumerable.Range(0, soup.FaceCount).Where(f => turned[f])];
            return new(Turn(soup, turned), reversed, components, nonOrientable);
        }
    }

    /// <summary>Per corner, the corner of the one other face along the same edge, or −1; and per face, whether every edge has one.</summary>
    private static (int[] Across, bool[] IsClosedFace) MatchEdges(PolygonSoup soup)
    {
        var users = new Dictionary<(int, int), (int First, int Second, int Count)>();
        var across = new int[soup.Corners.Length];
        Array.Fill(across, -1);
        for (int f = 0; f < soup.FaceCount; f++)
        {
            for (int c = soup.FaceStart[f]; c < soup.FaceStart[f + 1]; c++)
            {
                (int, int) key = Key(soup, f, c);
                users[key] = users.TryGetValue(key, out (int First, int Second, int Count) u) ? (u.First, c, u.Count + 1) : (c, -1, 1);
            }
        }
        foreach ((int first, int second, int count) in users.Values)
        {
            if (count == 2)
                (across[first], across[second]) = (second, first);
        }
        var closed = new bool[soup.FaceCount];
        for (int f = 0; f < closed.Length; f++)
            closed[f] = soup.Face(f).Length > 0 && !across.AsSpan(soup.FaceStart[f], soup.FaceStart[f + 1] - soup.FaceStart[f]).Contains(-1);
        return (across, closed);
    }

    private static (int From, int To) Ends(PolygonSoup soup, int f, int corner)
    {
        int after = corner + 1 < soup.FaceStart[f + 1] ? corner + 1 : soup.FaceStart[f];
        return (soup.Corners[corner], soup.Corners[after]);
    }

    private static (int, int) Key(PolygonSoup soup, int f, int corner)
    {
        (int from, int to) = Ends(soup, f, corner);
        return (Math.Min(from, to), Math.Max(from, to));
    }

    private static List<int> Spread(PolygonSoup soup, int[] across, int seed, int number, int[] component, bool[] turned, out int contradiction)
    {
        contradiction = -1;
        component[seed] = number;
        List<int> members = [seed];
        for (int i = 0; i < members.Count; i++)
        {
            int f = members[i];
            for (int c = soup.FaceStart[f]; c < soup.FaceStart[f + 1]; c++)
            {
                if (across[c] < 0)
                    continue;
                int g = FaceOf(soup, across[c]);
                // Neighbours agree if they use their edge in opposite directions.
                bool sameWay = Ends(soup, f, c) == Ends(soup, g, across[c]);
                bool wanted = turned[f] ^ sameWay;
                if (component[g] < 0)
                {
                    (component[g], turned[g]) = (number, wanted);
                    members.Add(g);
                }
                else if (turned[g] != wanted && contradiction < 0)
                {
                    contradiction = g;
                }
            }
        }
        return members;
    }

    private static int FaceOf(PolygonSoup soup, int corner)
    {
        int f = Array.BinarySearch(soup.FaceStart, corner);
        if (f < 0)
            return ~f - 1;
        // Empty faces begin where the next one does.
        while (soup.FaceStart[f + 1] == corner)
            f++;
        return f;
    }

    private static double Volume(PolygonSoup soup, List<int> faces, bool[] turned)
    {
        Vector3D origin = soup.Positions[soup.Corners[soup.FaceStart[faces[0]]]];
        double volume = 0;
        foreach (int f in faces)
        {
            ReadOnlySpan<int> corners = soup.Face(f);
            for (int i = 2; i < corners.Length; i++)
            {
                double part = Vector3D.Determinant(
                    soup.Positions[corners[0]] - origin, soup.Positions[corners[i - 1]] - origin, soup.Positions[corners[i]] - origin);
                volume += turned[f] ? -part : part;
            }
        }
        return volume;
    }

    /// <summary>A turned face keeps its first vertex.</summary>
    private static PolygonSoup Turn(PolygonSoup soup, bool[] turned)
    {
        int[] corners = [.. soup.Corners];
        for (int f = 0; f < turned.Length; f++)
        {
            if (turned[f])
                corners.AsSpan(soup.FaceStart[f] + 1, soup.FaceStart[f + 1] - soup.FaceStart[f] - 1).Reverse();
        }
        return new([.. soup.Positions], [.. soup.FaceStart], corners);
    }
}
