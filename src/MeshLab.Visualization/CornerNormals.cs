using System.Numerics;
using MeshLab.Numerics;

namespace MeshLab.Visualization;

/// <summary>
/// The normals for the light, one per triangle corner. Smooth: the mean over the triangles around the vertex whose normals
/// differ from this triangle's by at most the crease angle, weighted by their angle at the vertex (Thürmer and Wüthrich, 1998).
/// </summary>
internal static class CornerNormals
{
    private const int MostPairs = 400;

    /// <summary>Unit normals of all triangles; zero for one without area.</summary>
    public static Vector3[] OfTriangles(RenderGeometry g, int maxThreads)
    {
        var normals = new Vector3[g.TriangleCount];
        ParallelBlocks.For(normals.Length, 16384, maxThreads, (from, to) =>
        {
            Vector3D[] p = g.Positions;
            for (int t = from; t < to; t++)
            {
                Vector3D a = p[g.Triangles[3 * t]];
                normals[t] = (Vector3)Vector3D.Cross(p[g.Triangles[3 * t + 1]] - a, p[g.Triangles[3 * t + 2]] - a).Normalized();
            }
        });
        return normals;
    }

    /// <summary>Three unit normals per triangle.</summary>
    public static Vector3[] Smooth(RenderGeometry g, Vector3[] triangleNormals, double creaseDegrees, int maxThreads)
    {
        int[] start = CornersAround(g, out int[] corners);
        float[] angle = CornerAngles(g, maxThreads);
        float limit = creaseDegrees >= 180 ? -2 : (float)Math.Cos(creaseDegrees * Math.PI / 180) - 1e-5f;
        var result = new Vector3[g.Triangles.Length];
        ParallelBlocks.For(g.Positions.Length, 8192, maxThreads, (from, to) =>
        {
            for (int v = from; v < to; v++)
            {
                ReadOnlySpan<int> around = corners.AsSpan(start[v]..start[v + 1]);
                // Every pair of triangles around a vertex of a huge fan would be too many: there the mean of all stands for the pairs.
                Vector3 all = around.Length > MostPairs ? Sum(around, triangleNormals, angle, default, -2) : default;
                foreach (int corner in around)
                {
                    Vector3 own = triangleNormals[corner / 3];
                    Vector3 sum = around.Length <= MostPairs ? Sum(around, triangleNormals, angle, own, limit)
                        : Vector3.Dot(own, all) >= limit * all.Length() ? all : own;
                    float length = sum.Length();
                    result[corner] = length > 1e-6f ? sum / length : own;
                }
            }
        });
        return result;
    }

    private static Vector3 Sum(ReadOnlySpan<int> around, Vector3[] normals, float[] angle, Vector3 own, float limit)
    {
        Vector3 sum = default;
        foreach (int other in around)
        {
            Vector3 n = normals[other / 3];
            if (Vector3.Dot(own, n) >= limit)
                sum += n * angle[other];
        }
        return sum;
    }

    private static int[] CornersAround(RenderGeometry g, out int[] corners)
    {
        var start = new int[g.Positions.Length + 1];
        foreach (int v in g.Triangles)
            start[v + 1]++;
        for (int v = 0; v < g.Positions.Length; v++)
            start[v + 1] += start[v];
        corners = new int[g.Triangles.Length];
        int[] next = start[..^1];
        for (int c = 0; c < g.Triangles.Length; c++)
            corners[next[g.Triangles[c]]++] = c;
        return start;
    }

    private static float[] CornerAngles(RenderGeometry g, int maxThreads)
    {
        var angles = new float[g.Triangles.Length];
        ParallelBlocks.For(g.TriangleCount, 16384, maxThreads, (from, to) =>
        {
            for (int t = from; t < to; t++)
            {
                Vector3D a = g.Positions[g.Triangles[3 * t]], b = g.Positions[g.Triangles[3 * t + 1]], c = g.Positions[g.Triangles[3 * t + 2]];
                Vector3 ab = (Vector3)(b - a).Normalized(), bc = (Vector3)(c - b).Normalized(), ca = (Vector3)(a - c).Normalized();
                angles[3 * t] = Angle(-Vector3.Dot(ab, ca));
                angles[3 * t + 1] = Angle(-Vector3.Dot(ab, bc));
                angles[3 * t + 2] = Angle(-Vector3.Dot(bc, ca));
            }
        });
        return angles;

        static float Angle(float cosine) => MathF.Acos(Math.Clamp(cosine, -1, 1));
    }
}
