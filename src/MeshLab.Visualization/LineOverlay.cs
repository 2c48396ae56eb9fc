using System.Numerics;
using MeshLab.Numerics;

namespace MeshLab.Visualization;

/// <summary>
/// Lines and discs over the surface: per sample a colour number and a coverage. A line's depth is tested on its middle, so that it keeps its full
/// width along an outline, and once more at the sample, more tolerantly, so that it does not stand over what is in front.
/// </summary>
internal sealed class LineOverlay
{
    private readonly VisibilityBuffer surface;
    private readonly Camera camera;
    private readonly float tolerance;
    private readonly List<Stroke> strokes = [];
    private readonly List<Color> colors = [];
    private uint[]? cells;

    /// <summary>An overlay without lines.</summary>
    /// <param name="surface">The drawn surface.</param>
    /// <param name="camera">The camera.</param>
    /// <param name="modelSize">The diagonal of the model's box.</param>
    public LineOverlay(VisibilityBuffer surface, Camera camera, double modelSize)
    {
        this.surface = surface;
        this.camera = camera;
        tolerance = (float)(0.001 * modelSize);
    }

    private readonly record struct Stroke(Vector2 A, Vector2 B, float NearA, float NearB, float Radius, int Color, float Hidden);

    /// <summary>Registers a colour for the strokes that follow.</summary>
    public int AddColor(Color color)
    {
        colors.Add(color);
        return colors.Count - 1;
    }

    /// <summary>Adds a segment; width in samples.</summary>
    public void AddSegment(Vector3D a, Vector3D b, float width, int color, float hidden)
    {
        var (ax, ay, az) = camera.Project(a);
        var (bx, by, bz) = camera.Project(b);
        AddStroke(new((float)ax, (float)ay), new((float)bx, (float)by), (float)(1 / az), (float)(1 / bz), width, color, hidden);
    }

    /// <summary>Adds a disc at a point; diameter in samples.</summary>
    public void AddDisc(Vector3D point, float diameter, int color) => AddSegment(point, point, diameter, color, 0);

    /// <summary>Draws everything added, in the order added.</summary>
    public void Draw(int bandRows, int maxThreads)
    {
        if (strokes.Count == 0)
            return;
        cells = new uint[surface.Width * surface.Height];
        int bands = (surface.Height + bandRows - 1) / bandRows;
        int[] start = Bin(bands, bandRows, out int[] binned);
        Parallel.For(0, bands, new ParallelOptions { MaxDegreeOfParallelism = maxThreads }, band =>
        {
            foreach (int i in binned.AsSpan(start[band]..start[band + 1]))
                DrawStroke(strokes[i], band * bandRows, Math.Min((band + 1) * bandRows, surface.Height));
        });
    }

    /// <summary>Lays the lines over the light of a pixel.</summary>
    /// <param name="x">The pixel's column.</param>
    /// <param name="y">The pixel's row.</param>
    /// <param name="samples">Samples per pixel and axis.</param>
    /// <param name="light">The light so far, premultiplied by the opacity.</param>
    public Vector4 Over(int x, int y, int samples, Vector4 light)
    {
        if (cells is null)
            return light;
        Vector4 ink = default;
        for (int row = y * samples; row < (y + 1) * samples; row++)
        {
            for (int i = row * surface.Width + x * samples, end = i + samples; i < end; i++)
            {
                uint cell = cells[i];
                if ((cell & 255) == 0)
                    continue;
                Color color = colors[(int)(cell >> 8)];
                float a = (cell & 255) / 255f * color.A;
                ink += new Vector4(Oklab.ToLinear(color) * a, a);
            }
        }
        if (ink.W == 0)
            return light;
        ink /= samples * samples;
        return ink + light * (1 - ink.W);
    }

    private void AddStroke(Vector2 a, Vector2 b, float nearA, float nearB, float width, int color, float hidden)
    {
        // Far outside lines (strong zoom) would only cost time.
        float r = width / 2 + 1;
        if (Math.Max(a.X, b.X) < -r || Math.Max(a.Y, b.Y) < -r || Math.Min(a.X, b.X) > surface.Width + r || Math.Min(a.Y, b.Y) > surface.Height + r)
            return;
        strokes.Add(new(a, b, nearA, nearB, width / 2, color, hidden));
    }

    private int[] Bin(int bands, int bandRows, out int[] binned)
    {
        var start = new int[bands + 1];
        foreach (Stroke s in strokes)
        {
            var (first, last) = Bands(s, bands, bandRows);
            for (int band = first; band <= last; band++)
                start[band + 1]++;
        }
        for (int band = 0; band < bands; band++)
            start[band + 1] += start[band];
        binned = new int[start[bands]];
        int[] next = start[..^1];
        for (int i = 0; i < strokes.Count; i++)
        {
            var (first, last) = Bands(strokes[i], bands, bandRows);
            for (int band = first; band <= last; band++)
                binned[next[band]++] = i;
        }
        return start;
    }

    private static (int First, int Last) Bands(Stroke s, int bands, int bandRows)
    {
        float reach = s.Radius + 1;
        float top = Math.Min(s.A.Y, s.B.Y) - reach, bottom = Math.Max(s.A.Y, s.B.Y) + reach;
        return ((int)(Math.Max(top, 0) / bandRows), (int)Math.Min(bottom / bandRows, bands - 1));
    }

    private void DrawStroke(Stroke s, int top, int bottom)
    {
        float reach = s.Radius + 0.5f;
        Vector2 d = s.B - s.A;
        float lengthSquared = d.LengthSquared(), inverse = lengthSquared > 0 ? 1 / lengthSquared : 0;
        int y0 = Math.Max((int)MathF.Floor(Math.Min(s.A.Y, s.B.Y) - reach), top), y1 = Math.Min((int)MathF.Ceiling(Math.Max(s.A.Y, s.B.Y) + reach), bottom - 1);
        float left = Math.Min(s.A.X, s.B.X) - reach, right = Math.Max(s.A.X, s.B.X) + reach;
        for (int y = y0; y <= y1; y++)
        {
            float from = left, to = right;
            if (Math.Abs(d.Y) > 1e-3f)
            {
                // The part of the row inside the endless strip around the line.
                float middle = s.A.X + d.X * (y + 0.5f - s.A.Y) / d.Y, half = reach * MathF.Sqrt(lengthSquared) / Math.Abs(d.Y) + 1;
                from = Math.Max(from, middle - half);
                to = Math.Min(to, middle + half);
            }
            int x0 = Math.Max((int)MathF.Floor(from), 0), x1 = (int)Math.Min(MathF.Ceiling(to), surface.Width - 1);
            for (int x = x0; x <= x1; x++)
            {
                var p = new Vector2(x + 0.5f, y + 0.5f);
                float t = Math.Clamp(Vector2.Dot(p - s.A, d) * inverse, 0, 1);
                Vector2 middle = s.A + d * t;
                float coverage = Math.Min(reach - Vector2.Distance(p, middle), 1);
                if (coverage <= 0)
                    continue;
                if (!IsVisible(s.NearA + (s.NearB - s.NearA) * t, middle, x, y, s.Radius))
                    coverage *= s.Hidden;
                uint alpha = (uint)(coverage * 255 + 0.5f);
                ref uint cell = ref cells![y * surface.Width + x];
                if (alpha > 0 && alpha >= (cell & 255))
                    cell = (uint)s.Color << 8 | alpha;
            }
        }
    }

    private bool IsVisible(float near, Vector2 middle, int x, int y, float radius)
    {
        float sample = 1 / ((float)camera.Focal * near);
        int mx = Math.Clamp((int)middle.X, 0, surface.Width - 1), my = Math.Clamp((int)middle.Y, 0, surface.Height - 1);
        return InFront(my * surface.Width + mx, tolerance + 4 * sample) && InFront(y * surface.Width + x, 2 * tolerance + (2 + 3 * radius) * sample);

        bool InFront(int i, float slack) => near * (1 + slack * surface.Nearness[i]) >= surface.Nearness[i];
    }
}
