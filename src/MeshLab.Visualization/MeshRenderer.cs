using System.Numerics;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Visualization;

/// <summary>
/// Draws a mesh without a display: a z-buffer on several samples per pixel, light and colour per visible triangle of each pixel, lines and marks over it.
/// The same mesh and options give the same bits, on every number of threads. O(faces + samples).
/// </summary>
public static class MeshRenderer
{
    private const long MostSamples = 50_000_000;
    private const int BandPixels = 16;

    private static readonly Color Ink = new(0.16f, 0.18f, 0.22f);

    /// <summary>Draws the mesh; polygons are cut into triangles for drawing only.</summary>
    /// <param name="mesh">Any mesh, also empty or with deleted elements.</param>
    /// <param name="options">What to draw; a calm default figure if left out.</param>
    /// <exception cref="ArgumentException">An array of the coloring does not fit the mesh, a marked edge does not exist, or a position is not finite.</exception>
    public static Image Render(Mesh mesh, RenderOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        return Render(RenderGeometry.FromMesh(mesh), options ?? new());
    }

    /// <summary>Draws geometry that is already cut into triangles.</summary>
    internal static Image Render(RenderGeometry geometry, RenderOptions options)
    {
        geometry.CheckFor(options);
        int legend = options.Legend ? Math.Min(Legend.Width(options.Coloring), options.Width / 2) : 0;
        int samples = options.Supersampling;
        while (samples > 1 && (long)options.Width * options.Height * samples * samples > MostSamples)
            samples--;

        Camera camera = Frame(geometry, options, legend, samples);
        ProjectedMesh projected = ProjectedMesh.Of(geometry.Positions, camera, options.MaxDegreeOfParallelism);
        Ball[] balls = Balls(options, camera, samples);
        var buffer = new VisibilityBuffer(options.Width * samples, options.Height * samples, BandPixels * samples);
        if (options.Surface)
            buffer.DrawTriangles(geometry.Triangles, projected, options.MaxDegreeOfParallelism);
        buffer.DrawBalls(balls, camera, geometry.TriangleCount);

        var shader = new SurfaceShader(geometry, projected, camera, balls, options, samples);
        double size = geometry.Size;
        float[]? open = options is { AmbientOcclusion: true, Surface: true } && options.Shading != Shading.None && geometry.TriangleCount > 0
            ? AmbientOcclusion.Compute(buffer, samples, camera, (float)(0.10 * size), shader.GeometricNormal, options.MaxDegreeOfParallelism)
            : null;
        LineOverlay lines = Lines(geometry, options, buffer, camera, projected, samples);
        lines.Draw(BandPixels * samples, options.MaxDegreeOfParallelism);
        GroundShadow? shadow = options is { GroundShadow: true, Surface: true, View.Elevation: > 2 } && geometry.TriangleCount > 0
            ? new GroundShadow(geometry, camera, options.View)
            : null;

        var image = new Image(options.Width, options.Height);
        ParallelBlocks.For(options.Height, BandPixels, options.MaxDegreeOfParallelism, (from, to) =>
        {
            for (int y = from; y < to; y++)
                ResolveRow(image, y, samples, buffer, shader, open, lines, shadow, options.Background);
        });
        DrawTexts(image, options, camera, samples, legend);
        return image;
    }

    private static Camera Frame(RenderGeometry geometry, RenderOptions options, int legend, int samples)
    {
        IEnumerable<Vector3D> extra = options.Polylines.SelectMany(line => line.Points).Concat(options.Points.SelectMany(marks => marks.Points));
        Vector3D[] points = [.. geometry.LiveVertices.Select(v => geometry.Positions[v]), .. extra];
        double width = (options.Width - legend) * samples, height = options.Height * (double)samples;
        double margin = Math.Min(width, height) * 0.06;
        return Camera.Frame(options.View, points, width, height, margin);
    }

    // A ball's size is meant on the picture, so its size in space depends on its distance.
    private static Ball[] Balls(RenderOptions options, Camera camera, int samples)
    {
        var balls = new List<Ball>();
        foreach (PointMarks marks in options.Points)
        {
            if (marks.Shape != MarkShape.Sphere)
                continue;
            Vector3 light = Oklab.ToLinear(marks.Color);
            foreach (Vector3D p in marks.Points)
            {
                Vector3 center = camera.ToView(p);
                balls.Add(new(center, (float)(marks.Size * 0.5 * samples * -center.Z / camera.Focal), light));
            }
        }
        return [.. balls];
    }

    private static LineOverlay Lines(
        RenderGeometry g, RenderOptions options, VisibilityBuffer buffer, Camera camera, ProjectedMesh projected, int samples)
    {
        var lines = new LineOverlay(buffer, camera, g.Size);
        if (options.Wireframe)
        {
            float fade = (float)Math.Clamp(MedianEdge(g, projected) / samples / 6, 0.12, 1);
            int ink = lines.AddColor(options.WireframeColor with { A = options.WireframeColor.A * fade });
            for (int e = 0; e < g.Edges.Length / 2; e++)
                AddEdge(lines, g, e, (float)options.WireframeWidth * samples, ink, 0);
        }
        foreach (EdgeMarks marks in options.HighlightedEdges)
        {
            int ink = lines.AddColor(marks.Color);
            foreach (int e in marks.Edges)
                AddEdge(lines, g, e, (float)marks.Width * samples, ink, (float)marks.HiddenOpacity);
        }
        foreach (Polyline polyline in options.Polylines)
        {
            int ink = lines.AddColor(polyline.Color), count = polyline.Points.Count;
            for (int i = 0; i < (polyline.Closed ? count : count - 1); i++)
                lines.AddSegment(polyline.Points[i], polyline.Points[(i + 1) % count], (float)polyline.Width * samples, ink, (float)polyline.HiddenOpacity);
        }
        if (options.Vertices)
        {
            int ink = lines.AddColor(options.VertexColor);
            foreach (int v in g.LiveVertices)
                lines.AddDisc(g.Positions[v], (float)options.VertexSize * samples, ink);
        }
        foreach (PointMarks marks in options.Points)
        {
            if (marks.Shape != MarkShape.Disc)
                continue;
            int ink = lines.AddColor(marks.Color);
            foreach (Vector3D p in marks.Points)
                lines.AddDisc(p, (float)marks.Size * samples, ink);
        }
        return lines;
    }

    private static void AddEdge(LineOverlay lines, RenderGeometry g, int edge, float width, int ink, float hidden)
    {
        int a = g.Edges[2 * edge], b = g.Edges[2 * edge + 1];
        if (a >= 0)
            lines.AddSegment(g.Positions[a], g.Positions[b], width, ink, hidden);
    }

    // In samples, of at most a thousand edges spread over all.
    private static double MedianEdge(RenderGeometry g, ProjectedMesh projected)
    {
        int count = g.Edges.Length / 2, stride = Math.Max(1, count / 1000);
        var lengths = new List<double>();
        for (int e = 0; e < count; e += stride)
        {
            int a = g.Edges[2 * e], b = g.Edges[2 * e + 1];
            if (a >= 0)
                lengths.Add(Math.Sqrt(Math.Pow(projected.X[a] - (double)projected.X[b], 2) + Math.Pow(projected.Y[a] - (double)projected.Y[b], 2)));
        }
        lengths.Sort();
        return lengths.Count == 0 ? 0 : lengths[lengths.Count / 2] / ProjectedMesh.Steps;
    }

    private static void ResolveRow(
        Image image, int y, int samples, VisibilityBuffer buffer, SurfaceShader shader, float[]? open, LineOverlay lines, GroundShadow? shadow, Color? background)
    {
        Span<int> ids = stackalloc int[samples * samples];
        Span<Vector3> sums = stackalloc Vector3[samples * samples];
        Span<byte> row = image.Bytes.Slice(4 * y * image.Width, 4 * image.Width);
        for (int x = 0; x < image.Width; x++)
        {
            int kinds = Gather(buffer, x, y, samples, ids, sums);
            float around = open is null ? 1 : open[y * image.Width + x];
            Vector4 light = default;
            for (int k = 0; k < kinds; k++)
            {
                // Shading once per triangle, in the middle of its samples, is as smooth as shading every sample.
                float n = sums[k].Z;
                Vector3 shade = shader.Shade(ids[k], sums[k].X / n, sums[k].Y / n, around);
                light += new Vector4(Vector3.Clamp(shade, default, Vector3.One), 1) * n;
            }
            light /= samples * samples;
            if (light.W < 1)
                light += Background(x, y, samples, image, shadow, background) * (1 - light.W);
            Store(row.Slice(4 * x, 4), lines.Over(x, y, samples, light));
        }
    }

    // The different triangles in a pixel: their sums of sample positions, and in z how many samples they have.
    private static int Gather(VisibilityBuffer buffer, int x, int y, int samples, Span<int> ids, Span<Vector3> sums)
    {
        int kinds = 0;
        for (int sy = y * samples; sy < (y + 1) * samples; sy++)
        {
            for (int sx = x * samples; sx < (x + 1) * samples; sx++)
            {
                int id = buffer.Id[sy * buffer.Width + sx];
                if (id < 0)
                    continue;
                int k = 0;
                while (k < kinds && ids[k] != id)
                    k++;
                if (k == kinds)
                {
                    ids[k] = id;
                    sums[k] = default;
                    kinds++;
                }
                sums[k] += new Vector3(sx + 0.5f, sy + 0.5f, 1);
            }
        }
        return kinds;
    }

    private static Vector4 Background(int x, int y, int samples, Image image, GroundShadow? shadow, Color? chosen)
    {
        float dark = shadow?.At((x + 0.5) * samples, (y + 0.5) * samples) ?? 0;
        if (chosen is { } color)
        {
            float alpha = color.A + (1 - color.A) * dark;
            return new(Oklab.ToLinear(color) * (color.A * (1 - dark)), alpha);
        }
        float dx = (x + 0.5f) / image.Width - 0.5f, dy = (y + 0.5f) / image.Height - 0.42f;
        float edge = Math.Min(1, 2.0f * (dx * dx + dy * dy));
        Vector3 light = Vector3.Lerp(Vector3.One, new(0.86f, 0.885f, 0.92f), edge);
        return new(light * Vector3.Lerp(Vector3.One, new(0.02f, 0.03f, 0.05f), dark), 1);
    }

    private static void Store(Span<byte> pixel, Vector4 light)
    {
        Vector3 color = light.W > 0 ? light.AsVector3() / light.W : default;
        pixel[0] = Image.ToByte(Oklab.ToStored(color.X));
        pixel[1] = Image.ToByte(Oklab.ToStored(color.Y));
        pixel[2] = Image.ToByte(Oklab.ToStored(color.Z));
        pixel[3] = Image.ToByte(light.W);
    }

    private static void DrawTexts(Image image, RenderOptions options, Camera camera, int samples, int legend)
    {
        foreach (TextLabel label in options.Labels)
        {
            var (x, y, _) = camera.Project(label.Position);
            // A light rim keeps the text readable over lines.
            ImageDrawing.DrawText(image, label.Text, x / samples + 5, y / samples - 5, label.Size, Color.White with { A = 0.8f }, TextAlign.Left, (float)label.Size * 0.3f);
            image.DrawText(label.Text, x / samples + 5, y / samples - 5, label.Size, label.Color);
        }
        if (options.Title.Length > 0)
            image.DrawText(options.Title, 18, 30, 18, Ink);
        if (legend > 0)
            Legend.Draw(image, options.Coloring, image.Width - legend);
    }
}
