using System.Numerics;
using MeshLab.Numerics;

namespace MeshLab.Visualization;

/// <summary>
/// The light that leaves the surface towards the viewer: a wide sky, a key light from the upper left, a fill light from the right, a rim light from behind
/// and a soft highlight. The lights stand around the viewer, so a model looks good from every side.
/// </summary>
internal sealed class SurfaceShader
{
    private static readonly Vector3 Key = Vector3.Normalize(new(-0.52f, 0.66f, 0.58f));
    private static readonly Vector3 Fill = Vector3.Normalize(new(0.85f, 0.10f, 0.55f));
    private static readonly Vector3 Rim = Vector3.Normalize(new(0.25f, 0.55f, -0.80f));
    private static readonly Vector3 KeyLight = new(0.68f, 0.67f, 0.65f);
    private static readonly Vector3 FillLight = new(0.15f, 0.16f, 0.18f);
    private static readonly Vector3 RimLight = new(0.12f, 0.125f, 0.135f);
    private static readonly Vector3 SkyLight = new(0.43f, 0.44f, 0.455f);
    private static readonly Vector3 FloorLight = new(0.20f, 0.19f, 0.18f);

    private readonly RenderGeometry geometry;
    private readonly ProjectedMesh projected;
    private readonly SurfaceColors colors;
    private readonly Vector3[] triangleNormals;
    private readonly Vector3[]? cornerNormals;
    private readonly Camera camera;
    private readonly Ball[] balls;
    private readonly Shading shading;
    private readonly Vector3 up, backTint, right, top, back;
    private readonly float gloss;
    private readonly int isolines, samples;

    /// <summary>Prepares normals and colours.</summary>
    public SurfaceShader(RenderGeometry geometry, ProjectedMesh projected, Camera camera, Ball[] balls, RenderOptions options, int samples)
    {
        this.geometry = geometry;
        this.projected = projected;
        this.camera = camera;
        this.balls = balls;
        this.samples = samples;
        shading = options.Shading;
        colors = new(geometry, options.Coloring);
        int threads = options.MaxDegreeOfParallelism;
        triangleNormals = CornerNormals.OfTriangles(geometry, threads);
        cornerNormals = shading == Shading.Smooth ? CornerNormals.Smooth(geometry, triangleNormals, options.CreaseAngleFor(geometry.TriangleCount), threads) : null;
        up = camera.DirectionToView(Camera.WorldUp(options.View));
        (right, top, back) = ((Vector3)camera.Right, (Vector3)camera.Up, (Vector3)camera.Back);
        backTint = Oklab.ToLinear(options.BackFaceColor);
        // A highlight would falsify colours that stand for numbers.
        gloss = options.Coloring.Kind == ColoringKind.Uniform ? 0.16f : 0.05f;
        isolines = colors.HasIsolines ? options.Coloring.Isolines : 0;
    }

    /// <summary>The geometric normal, towards the viewer, of what the buffer holds at a sample.</summary>
    public Vector3 GeometricNormal(int id, float x, float y)
    {
        if (id >= geometry.TriangleCount)
            return BallNormal(balls[id - geometry.TriangleCount], x, y);
        Vector3 n = ToView(triangleNormals[id]), p = projected.View[geometry.Triangles[3 * id]];
        return Vector3.Dot(n, p) > 0 ? -n : n;
    }

    /// <summary>The light of one triangle or ball.</summary>
    /// <param name="id">What the buffer holds.</param>
    /// <param name="x">Column in samples.</param>
    /// <param name="y">Row in samples.</param>
    /// <param name="open">How open the surroundings are, 0 to 1.</param>
    public Vector3 Shade(int id, float x, float y, float open)
    {
        if (id >= geometry.TriangleCount)
        {
            Ball ball = balls[id - geometry.TriangleCount];
            Vector3 normal = BallNormal(ball, x, y);
            return Light(ball.Light, normal, Vector3.Normalize(-(ball.Center + normal * ball.Radius)), open, 0.22f);
        }
        Vector3 weights = Weights(id, x, y, out bool front);
        Vector3 color = colors.At(id, weights);
        if (isolines > 0)
            color = WithIsoline(color, id, weights, x, y);
        if (!front)
            color = Vector3.Lerp(color, backTint, 0.72f);
        if (shading == Shading.None)
            return color;
        Vector3 point = ViewPoint(id, weights), toViewer = Vector3.Normalize(-point);
        return Light(color, Normal(id, weights, front, toViewer), toViewer, open, gloss);
    }

    private Vector3 Normal(int t, Vector3 weights, bool front, Vector3 toViewer)
    {
        Vector3 n = cornerNormals is null
            ? triangleNormals[t]
            : cornerNormals[3 * t] * weights.X + cornerNormals[3 * t + 1] * weights.Y + cornerNormals[3 * t + 2] * weights.Z;
        n = ToView(n);
        float length = n.Length();
        if (length < 1e-6f)
            return toViewer;
        n /= front ? length : -length;
        // A smoothed normal may turn away at an outline; there it is bent back until it is just seen.
        float facing = Vector3.Dot(n, toViewer);
        return facing >= 0.02f ? n : Vector3.Normalize(n + toViewer * (0.02f - facing));
    }

    private Vector3 Light(Vector3 color, Vector3 n, Vector3 toViewer, float open, float shine)
    {
        float sky = 0.5f + 0.5f * Vector3.Dot(n, up), key = Vector3.Dot(n, Key), fill = Vector3.Dot(n, Fill), rim = Vector3.Dot(n, Rim);
        // The key light reaches a little around the edge: a softer terminator.
        key = Math.Max(0, (key + 0.18f) / 1.18f);
        float direct = 0.45f + 0.55f * open;
        Vector3 diffuse = Vector3.Lerp(FloorLight, SkyLight, sky) * open
            + (KeyLight * key + FillLight * Math.Max(0, fill) + RimLight * Math.Max(0, rim)) * direct;
        Vector3 half = Vector3.Normalize(Key + toViewer);
        float highlight = MathF.Pow(Math.Max(0, Vector3.Dot(n, half)), 42) * shine;
        float grazing = 1 - Math.Max(0, Vector3.Dot(n, toViewer));
        float sheen = grazing * grazing * grazing * grazing * 0.10f * sky;
        return color * diffuse + new Vector3((highlight + sheen) * direct);
    }

    // Barycentric coordinates on the picture, then corrected by the distances.
    private Vector3 Weights(int t, float x, float y, out bool front)
    {
        int a = geometry.Triangles[3 * t], b = geometry.Triangles[3 * t + 1], c = geometry.Triangles[3 * t + 2];
        const double step = 1.0 / ProjectedMesh.Steps;
        double ax = projected.X[a] * step - x, ay = projected.Y[a] * step - y, bx = projected.X[b] * step - x, by = projected.Y[b] * step - y;
        double cx = projected.X[c] * step - x, cy = projected.Y[c] * step - y;
        double wa = bx * cy - by * cx, wb = cx * ay - cy * ax, wc = ax * by - ay * bx;
        // Rows run downward: from outside the corners run clockwise on the picture's coordinates.
        front = wa + wb + wc < 0;
        wa *= projected.Nearness[a];
        wb *= projected.Nearness[b];
        wc *= projected.Nearness[c];
        double sum = wa + wb + wc;
        return sum == 0 ? new(1 / 3f) : new((float)(wa / sum), (float)(wb / sum), (float)(wc / sum));
    }

    private Vector3 WithIsoline(Vector3 color, int t, Vector3 weights, float x, float y)
    {
        float value = colors.ScalarAt(t, weights) * isolines;
        float dx = colors.ScalarAt(t, Weights(t, x + samples, y, out _)) * isolines - value;
        float dy = colors.ScalarAt(t, Weights(t, x, y + samples, out _)) * isolines - value;
        float slope = MathF.Sqrt(dx * dx + dy * dy);
        if (!(slope > 1e-6f))
            return color;
        float distance = Math.Abs(value - MathF.Round(value)) / slope;
        float coverage = Math.Clamp(1.1f - distance, 0, 1) * Math.Clamp(1.4f - 2 * slope, 0, 1);
        return color * (1 - 0.7f * coverage);
    }

    private Vector3 ViewPoint(int t, Vector3 weights) =>
        projected.View[geometry.Triangles[3 * t]] * weights.X
        + projected.View[geometry.Triangles[3 * t + 1]] * weights.Y
        + projected.View[geometry.Triangles[3 * t + 2]] * weights.Z;

    private Vector3 BallNormal(Ball ball, float x, float y)
    {
        Vector3 ray = new((x - (float)camera.CenterX) / (float)camera.Focal, ((float)camera.CenterY - y) / (float)camera.Focal, -1), c = ball.Center;
        float dd = ray.LengthSquared(), dc = Vector3.Dot(ray, c), root = dc * dc - dd * (c.LengthSquared() - ball.Radius * ball.Radius);
        return Vector3.Normalize(ray * ((dc - MathF.Sqrt(Math.Max(root, 0))) / dd) - c);
    }

    private Vector3 ToView(Vector3 n) => new(Vector3.Dot(n, right), Vector3.Dot(n, top), Vector3.Dot(n, back));
}
