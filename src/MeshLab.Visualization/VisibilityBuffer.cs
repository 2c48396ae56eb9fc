using System.Numerics;

namespace MeshLab.Visualization;

/// <summary>
/// The z-buffer: for each sample which triangle (or ball) is nearest, and how near. Bands of rows are filled independently, each in the order of the
/// triangles, so the result does not depend on threads. Equal distance: the smaller index wins.
/// </summary>
internal sealed class VisibilityBuffer
{
    private const int Steps = ProjectedMesh.Steps;

    private readonly int bandRows;

    /// <summary>An empty buffer.</summary>
    public VisibilityBuffer(int width, int height, int bandRows)
    {
        Width = width;
        Height = height;
        this.bandRows = bandRows;
        Nearness = new float[width * height];
        Id = new int[width * height];
        Array.Fill(Id, -1);
    }

    /// <summary>Samples per row.</summary>
    public int Width { get; }

    /// <summary>Rows of samples.</summary>
    public int Height { get; }

    /// <summary>One over the distance of the nearest surface; 0 where there is none.</summary>
    public float[] Nearness { get; }

    /// <summary>Triangle index, triangle count + ball index, or −1.</summary>
    public int[] Id { get; }

    /// <summary>Draws all triangles.</summary>
    public void DrawTriangles(int[] triangles, ProjectedMesh mesh, int maxThreads)
    {
        int[] start = Bin(triangles, mesh, out int[] binned);
        Parallel.For(0, start.Length - 1, new ParallelOptions { MaxDegreeOfParallelism = maxThreads }, band =>
        {
            int top = band * bandRows, bottom = Math.Min(top + bandRows, Height);
            foreach (int t in binned.AsSpan(start[band]..start[band + 1]))
                DrawTriangle(mesh, t, triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2], top, bottom);
        });
    }

    /// <summary>Draws lit balls given in view space (see <see cref="ProjectedMesh.View"/>).</summary>
    public void DrawBalls(ReadOnlySpan<Ball> balls, Camera camera, int firstId)
    {
        for (int i = 0; i < balls.Length; i++)
            DrawBall(balls[i], camera, firstId + i);
    }

    // Counting sort of the triangles into the bands they touch; within a band in index order.
    private int[] Bin(int[] triangles, ProjectedMesh mesh, out int[] binned)
    {
        int bands = (Height + bandRows - 1) / bandRows, count = triangles.Length / 3;
        var start = new int[bands + 1];
        for (int t = 0; t < count; t++)
        {
            if (!Bands(triangles, mesh, t, bands, out int first, out int last))
                continue;
            for (int band = first; band <= last; band++)
                start[band + 1]++;
        }
        for (int band = 0; band < bands; band++)
            start[band + 1] += start[band];
        binned = new int[start[bands]];
        int[] next = start[..^1];
        for (int t = 0; t < count; t++)
        {
            if (!Bands(triangles, mesh, t, bands, out int first, out int last))
                continue;
            for (int band = first; band <= last; band++)
                binned[next[band]++] = t;
        }
        return start;
    }

    private bool Bands(int[] triangles, ProjectedMesh mesh, int t, int bands, out int first, out int last)
    {
        int a = mesh.Y[triangles[3 * t]], b = mesh.Y[triangles[3 * t + 1]], c = mesh.Y[triangles[3 * t + 2]];
        int top = FirstSample(Math.Min(a, Math.Min(b, c))), bottom = LastSample(Math.Max(a, Math.Max(b, c)));
        first = Math.Max(top, 0) / bandRows;
        last = Math.Min(Math.Min(bottom, Height - 1) / bandRows, bands - 1);
        return top <= bottom && bottom >= 0 && top < Height;
    }

    // Edge functions over whole numbers, sample centres at half a sample, the top-left rule for shared edges.
    private void DrawTriangle(ProjectedMesh mesh, int id, int a, int b, int c, int top, int bottom)
    {
        int ax = mesh.X[a], ay = mesh.Y[a], bx = mesh.X[b], by = mesh.Y[b], cx = mesh.X[c], cy = mesh.Y[c];
        long area = (long)(bx - ax) * (cy - ay) - (long)(by - ay) * (cx - ax);
        if (area == 0)
            return;
        if (area < 0)
        {
            (b, c) = (c, b);
            (bx, by, cx, cy) = (cx, cy, bx, by);
            area = -area;
        }
        int x0 = Math.Max(FirstSample(Math.Min(ax, Math.Min(bx, cx))), 0), x1 = Math.Min(LastSample(Math.Max(ax, Math.Max(bx, cx))), Width - 1);
        int y0 = Math.Max(FirstSample(Math.Min(ay, Math.Min(by, cy))), top), y1 = Math.Min(LastSample(Math.Max(ay, Math.Max(by, cy))), bottom - 1);
        if (x0 > x1 || y0 > y1)
            return;

        int px = x0 * Steps + Steps / 2, py = y0 * Steps + Steps / 2;
        long eab = Edge(ax, ay, bx, by, px, py), ebc = Edge(bx, by, cx, cy, px, py), eca = Edge(cx, cy, ax, ay, px, py);
        long abX = -(long)(by - ay) * Steps, bcX = -(long)(cy - by) * Steps, caX = -(long)(ay - cy) * Steps;
        long abY = (long)(bx - ax) * Steps, bcY = (long)(cx - bx) * Steps, caY = (long)(ax - cx) * Steps;

        // The distance is a plane over the picture; the bounds keep slivers from reaching beyond their corners.
        float na = mesh.Nearness[a], nb = mesh.Nearness[b], nc = mesh.Nearness[c];
        float least = Math.Min(na, Math.Min(nb, nc)), most = Math.Max(na, Math.Max(nb, nc));
        double scale = 1.0 / area;
        double gradientX = (abX * (double)nc + bcX * (double)na + caX * (double)nb) * scale;

        for (int y = y0; y <= y1; y++)
        {
            long e0 = eab, e1 = ebc, e2 = eca;
            double n = (e0 * (double)nc + e1 * (double)na + e2 * (double)nb) * scale;
            e0 += Bias(ax, ay, bx, by);
            e1 += Bias(bx, by, cx, cy);
            e2 += Bias(cx, cy, ax, ay);
            int row = y * Width;
            for (int x = x0; x <= x1; x++)
            {
                if ((e0 | e1 | e2) >= 0)
                {
                    float near = Math.Clamp((float)(n + gradientX * (x - x0)), least, most);
                    if (near > Nearness[row + x])
                    {
                        Nearness[row + x] = near;
                        Id[row + x] = id;
                    }
                }
                e0 += abX;
                e1 += bcX;
                e2 += caX;
            }
            eab += abY;
            ebc += bcY;
            eca += caY;
        }
    }

    // The nearer root of |t·d − c|² = r², d the ray through the sample with depth 1.
    private void DrawBall(Ball ball, Camera camera, int id)
    {
        Vector3 c = ball.Center;
        double distance = -c.Z, r = ball.Radius;
        if (distance <= 1.01 * r)
            return;
        double reach = 1.1 * camera.Focal * r / (distance - r) + 1;
        double x = camera.CenterX + camera.Focal * c.X / distance, y = camera.CenterY - camera.Focal * c.Y / distance;
        int x0 = (int)Math.Max(x - reach, 0), x1 = (int)Math.Min(x + reach, Width - 1);
        int y0 = (int)Math.Max(y - reach, 0), y1 = (int)Math.Min(y + reach, Height - 1);
        for (int row = y0; row <= y1; row++)
        {
            for (int column = x0; column <= x1; column++)
            {
                double dx = (column + 0.5 - camera.CenterX) / camera.Focal, dy = (camera.CenterY - row - 0.5) / camera.Focal;
                double dd = dx * dx + dy * dy + 1, dc = dx * c.X + dy * c.Y - c.Z;
                double root = dc * dc - dd * ((double)c.X * c.X + (double)c.Y * c.Y + (double)c.Z * c.Z - r * r);
                if (root < 0)
                    continue;
                float near = (float)(dd / (dc - Math.Sqrt(root)));
                int i = row * Width + column;
                if (near > Nearness[i])
                {
                    Nearness[i] = near;
                    Id[i] = id;
                }
            }
        }
    }

    private static int FirstSample(int step) => (step + Steps / 2 - 1) >> 8;

    private static int LastSample(int step) => (step - Steps / 2) >> 8;

    private static long Edge(int ax, int ay, int bx, int by, int px, int py) => (long)(bx - ax) * (py - ay) - (long)(by - ay) * (px - ax);

    private static int Bias(int ax, int ay, int bx, int by) => by < ay || (by == ay && bx > ax) ? 0 : -1;
}

/// <summary>A ball in view space.</summary>
/// <param name="Center">In the axes right, up, towards the viewer.</param>
/// <param name="Radius">Its radius.</param>
/// <param name="Light">Its colour as linear light.</param>
internal readonly record struct Ball(System.Numerics.Vector3 Center, float Radius, System.Numerics.Vector3 Light);
