namespace MeshLab.HoleFilling;

/// <summary>§6.1 (a) 扇形补洞 and (b) 重心扇形: the fan from a vertex of the loop, and the fan around its centre.</summary>
internal static class FanTriangulation
{
    /// <summary>The fan from the first vertex of which no chord is taken; <see langword="null"/> if there is none.</summary>
    public static List<int>? FromVertex(HoleLoop loop)
    {
        int n = loop.Count;
        for (int first = 0; first < n; first++)
        {
            bool free = true;
            for (int k = 2; k < n - 1 && free; k++)
                free = !loop.IsTaken(first, (first + k) % n);
            if (!free)
                continue;
            var triangles = new List<int>(3 * (n - 2));
            for (int k = 1; k < n - 1; k++)
                triangles.AddRange([first, (first + k) % n, (first + k + 1) % n]);
            return triangles;
        }
        return null;
    }

    /// <summary>The fan around one new vertex, which has the number n.</summary>
    public static List<int> AroundCenter(HoleLoop loop)
    {
        int n = loop.Count;
        var triangles = new List<int>(3 * n);
        for (int i = 0; i < n; i++)
            triangles.AddRange([i, (i + 1) % n, n]);
        return triangles;
    }
}
