using System.Numerics;

namespace MeshLab.Visualization;

/// <summary>
/// How open each pixel's surroundings are, from the z-buffer alone: points around it on the picture that rise above its tangent plane take light away
/// (after McGuire et al., "The Alchemy screen-space ambient obscurance algorithm", 2011). A fixed pattern of 4 × 4 pixels, smoothed away afterwards.
/// </summary>
internal static class AmbientOcclusion
{
    private const int Taps = 20;

    /// <summary>Per pixel from 0 (closed in) to 1 (open).</summary>
    /// <param name="buffer">The z-buffer.</param>
    /// <param name="samples">Samples per pixel and axis.</param>
    /// <param name="camera">The camera.</param>
    /// <param name="radius">How far surroundings count, in units of the model.</param>
    /// <param name="normalOf">The geometric normal (in view space, to the viewer) of a buffer id at a sample.</param>
    /// <param name="maxThreads">How many threads may work.</param>
    public static float[] Compute(
        VisibilityBuffer buffer, int samples, Camera camera, float radius, Func<int, float, float, Vector3> normalOf, int maxThreads)
    {
        int width = buffer.Width / samples, height = buffer.Height / samples;
        var points = new Vector3[width * height];
        var open = new float[width * height];
        Array.Fill(open, 1);
        ParallelBlocks.For(height, 16, maxThreads, (from, to) => Unproject(buffer, samples, camera, points, width, from, to));
        ParallelBlocks.For(height, 16, maxThreads, (from, to) =>
        {
            for (int y = from; y < to; y++)
            {
                for (int x = 0; x < width; x++)
                {
                    Vector3 p = points[y * width + x];
                    if (p.Z == 0)
                        continue;
                    float sx = x * samples + samples / 2 + 0.5f, sy = y * samples + samples / 2 + 0.5f;
                    int id = buffer.Id[(int)sy * buffer.Width + (int)sx];
                    float reach = radius * (float)camera.Focal / -p.Z / samples;
                    open[y * width + x] = Openness(points, width, height, x, y, p, normalOf(id, sx, sy), radius, reach);
                }
            }
        });
        return Smooth(open, points, width, height, radius, maxThreads);
    }

    private static void Unproject(VisibilityBuffer buffer, int samples, Camera camera, Vector3[] points, int width, int from, int to)
    {
        for (int y = from; y < to; y++)
        {
            for (int x = 0; x < width; x++)
            {
                int sx = x * samples + samples / 2, sy = y * samples + samples / 2;
                float near = buffer.Nearness[sy * buffer.Width + sx];
                if (near <= 0)
                    continue;
                float z = 1 / near, scale = z / (float)camera.Focal;
                points[y * width + x] = new((sx + 0.5f - (float)camera.CenterX) * scale, ((float)camera.CenterY - sy - 0.5f) * scale, -z);
            }
        }
    }

    private static float Openness(Vector3[] points, int width, int height, int x, int y, Vector3 p, Vector3 normal, float radius, float reach)
    {
        const float goldenAngle = 2.3999632f;
        float turn = ((x & 3) * 4 + (y & 3) * 7 % 16) * (2 * MathF.PI / 16), sum = 0;
        for (int i = 0; i < Taps; i++)
        {
            float r = reach * (i + 0.5f) / Taps;
            var (sin, cos) = MathF.SinCos(turn + i * goldenAngle);
            int qx = x + (int)MathF.Round(r * cos), qy = y + (int)MathF.Round(r * sin);
            if ((uint)qx >= (uint)width || (uint)qy >= (uint)height || (qx == x && qy == y))
                continue;
            Vector3 q = points[qy * width + qx];
            if (q.Z == 0)
                continue;
            Vector3 v = q - p;
            float squared = v.LengthSquared(), fade = 1 - squared / (radius * radius);
            if (fade <= 0 || squared == 0)
                continue;
            sum += Math.Max(0, Vector3.Dot(v, normal) / MathF.Sqrt(squared) - 0.12f) * fade;
        }
        return Math.Clamp(1 - 2.0f * sum / Taps, 0, 1);
    }

    // The mean over 5 × 5 pixels of about the same depth (the pattern has a period of 4).
    private static float[] Smooth(float[] open, Vector3[] points, int width, int height, float radius, int maxThreads)
    {
        var result = new float[open.Length];
        ParallelBlocks.For(height, 16, maxThreads, (from, to) =>
        {
            for (int y = from; y < to; y++)
            {
                for (int x = 0; x < width; x++)
                {
                    float z = points[y * width + x].Z, sum = 0, weight = 0;
                    for (int qy = Math.Max(y - 2, 0); qy <= Math.Min(y + 2, height - 1); qy++)
                    {
                        for (int qx = Math.Max(x - 2, 0); qx <= Math.Min(x + 2, width - 1); qx++)
                        {
                            float other = points[qy * width + qx].Z;
                            if (other == 0 || Math.Abs(other - z) > 0.25f * radius)
                                continue;
                            float w = (Math.Abs(qx - x) == 2 ? 0.5f : 1) * (Math.Abs(qy - y) == 2 ? 0.5f : 1);
                            sum += w * open[qy * width + qx];
                            weight += w;
                        }
                    }
                    result[y * width + x] = weight > 0 ? sum / weight : 1;
                }
            }
        });
        return result;
    }
}
