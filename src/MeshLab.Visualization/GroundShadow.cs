using System.Numerics;
using MeshLab.Numerics;

namespace MeshLab.Visualization;

/// <summary>
/// The soft shadow under a model that stands on the ground, lit from a wide sky: the model's shape seen from below, in layers by height,
/// the higher the more blurred and the fainter.
/// </summary>
internal sealed class GroundShadow
{
    private const int Size = 160;
    private static readonly (float Height, float Blur, float Strength)[] Layers = [(0.03f, 0.015f, 0.26f), (0.12f, 0.04f, 0.17f), (0.35f, 0.10f, 0.13f), (2f, 0.18f, 0.10f)];

    private readonly float[] shade = new float[Size * Size];
    private readonly Camera camera;
    private readonly Vector3D up, sideA, sideB, center;
    private readonly double ground, halfWidth;

    /// <summary>The shadow of the triangles.</summary>
    public GroundShadow(RenderGeometry g, Camera camera, View view)
    {
        this.camera = camera;
        up = Camera.WorldUp(view);
        (sideA, sideB) = view.Up == UpAxis.Z ? (Vector3D.UnitX, Vector3D.UnitY) : (Vector3D.UnitZ, Vector3D.UnitX);
        BoundingBox box = BoundingBox.Empty;
        foreach (int v in g.Triangles)
            box = box.Including(g.Positions[v]);
        center = box.Center;
        ground = Vector3D.Dot(box.Min, up) - 0.002 * box.Diagonal;
        halfWidth = Math.Max(box.Diagonal * 0.5, 1e-300) * 1.6;

        float[] lowest = LowestHeights(g, box.Diagonal);
        foreach (var (height, blur, strength) in Layers)
            AddLayer(lowest, height, blur, strength);
    }

    /// <summary>How much of the light the ground seen at a sample of the picture lacks, 0 to 1.</summary>
    public float At(double x, double y)
    {
        Vector3D ray = camera.Right * ((x - camera.CenterX) / camera.Focal) + camera.Up * ((camera.CenterY - y) / camera.Focal) - camera.Back;
        double down = Vector3D.Dot(ray, up), above = Vector3D.Dot(camera.Position, up) - ground;
        if (down >= -1e-9 || above <= 0)
            return 0;
        Vector3D hit = camera.Position + ray * (above / -down) - center;
        double u = (Vector3D.Dot(hit, sideA) / halfWidth + 1) * 0.5 * Size - 0.5, v = (Vector3D.Dot(hit, sideB) / halfWidth + 1) * 0.5 * Size - 0.5;
        if (!(u >= 0 && v >= 0 && u < Size - 1 && v < Size - 1))
            return 0;
        int i = (int)u, j = (int)v;
        float s = (float)(u - i), t = (float)(v - j);
        float lower = shade[j * Size + i] * (1 - s) + shade[j * Size + i + 1] * s, upper = shade[(j + 1) * Size + i] * (1 - s) + shade[(j + 1) * Size + i + 1] * s;
        return lower * (1 - t) + upper * t;
    }

    // Per cell the lowest height above the ground, in units of the model's diagonal.
    private float[] LowestHeights(RenderGeometry g, double diagonal)
    {
        var lowest = new float[Size * Size];
        Array.Fill(lowest, float.PositiveInfinity);
        var points = new Vector3[g.Positions.Length];
        for (int v = 0; v < points.Length; v++)
        {
            Vector3D p = g.Positions[v] - center;
            points[v] = new(
                (float)((Vector3D.Dot(p, sideA) / halfWidth + 1) * 0.5 * Size),
                (float)((Vector3D.Dot(p, sideB) / halfWidth + 1) * 0.5 * Size),
                (float)((Vector3D.Dot(g.Positions[v], up) - ground) / diagonal));
        }
        for (int t = 0; t < g.TriangleCount; t++)
            DrawTriangle(lowest, points[g.Triangles[3 * t]], points[g.Triangles[3 * t + 1]], points[g.Triangles[3 * t + 2]]);
        return lowest;
    }

    private static void DrawTriangle(float[] lowest, Vector3 a, Vector3 b, Vector3 c)
    {
        int x0 = Math.Max((int)Math.Min(a.X, Math.Min(b.X, c.X)), 0), x1 = Math.Min((int)Math.Max(a.X, Math.Max(b.X, c.X)), Size - 1);
        int y0 = Math.Max((int)Math.Min(a.Y, Math.Min(b.Y, c.Y)), 0), y1 = Math.Min((int)Math.Max(a.Y, Math.Max(b.Y, c.Y)), Size - 1);
        float area = (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X), least = Math.Min(a.Z, Math.Min(b.Z, c.Z));
        for (int y = y0; y <= y1; y++)
        {
            for (int x = x0; x <= x1; x++)
            {
                float px = x + 0.5f, py = y + 0.5f, height = least;
                if ((x1 - x0 > 1 || y1 - y0 > 1) && area != 0)
                {
                    float u = ((b.X - px) * (c.Y - py) - (b.Y - py) * (c.X - px)) / area, v = ((c.X - px) * (a.Y - py) - (c.Y - py) * (a.X - px)) / area;
                    if (u < 0 || v < 0 || u + v > 1)
                        continue;
                    height = u * a.Z + v * b.Z + (1 - u - v) * c.Z;
                }
                ref float cell = ref lowest[y * Size + x];
                cell = Math.Min(cell, height);
            }
        }
    }

    private void AddLayer(float[] lowest, float height, float blur, float strength)
    {
        float[] mask = new float[Size * Size], other = new float[Size * Size];
        for (int i = 0; i < mask.Length; i++)
            mask[i] = lowest[i] < height ? 1 : 0;
        // Half widths of the box filter in cells; three passes are nearly a Gaussian.
        int radius = Math.Max(1, (int)(blur * Size / 3.2f));
        for (int pass = 0; pass < 3; pass++)
        {
            BlurRows(mask, other, radius);
            BlurRows(other, mask, radius);
        }
        for (int i = 0; i < mask.Length; i++)
            shade[i] = 1 - (1 - shade[i]) * (1 - strength * mask[i]);
    }

    // Blurs along rows and writes transposed, so that two calls blur both ways.
    private static void BlurRows(float[] from, float[] to, int radius)
    {
        float scale = 1f / (2 * radius + 1);
        for (int y = 0; y < Size; y++)
        {
            for (int x = 0; x < Size; x++)
            {
                float sum = 0;
                for (int k = Math.Max(x - radius, 0); k <= Math.Min(x + radius, Size - 1); k++)
                    sum += from[y * Size + k];
                to[x * Size + y] = sum * scale;
            }
        }
    }
}
