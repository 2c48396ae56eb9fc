using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Generation;

/// <summary>Solids between two copies of a plane figure (拉伸, sweep along a straight line).</summary>
public static class Extrusions
{
    /// <summary>Extrudes an outline with holes from z = −height/2 to height/2: closed, genus = number of holes, volume = area · height.</summary>
    /// <remarks>The lower points come first, loop after loop, then the upper ones. Caps are cut by clipping ears. O(n²) for n points.</remarks>
    /// <param name="outline">A simple polygon, counter-clockwise.</param>
    /// <param name="height">The distance of the caps.</param>
    /// <param name="holes">Simple polygons inside, clockwise, apart from each other.</param>
    /// <exception cref="ArgumentException">A loop has fewer than three points, turns the wrong way, crosses another or itself, or the height is not positive.</exception>
    public static Mesh Extrude(Vector2D[] outline, double height = 1, params Vector2D[][] holes)
    {
        ArgumentNullException.ThrowIfNull(outline);
        ArgumentNullException.ThrowIfNull(holes);
        Check.Positive(height);
        (Vector2D[] points, int[] loopStart) = Join(outline, holes);
        List<int> cap = EarClipping.Triangulate(points, loopStart, nameof(outline));

        int n = points.Length;
        var builder = new MeshBuilder();
        foreach (double z in (ReadOnlySpan<double>)[-height / 2, height / 2])
        {
            foreach (Vector2D p in points)
                builder.AddVertex(new(p.X, p.Y, z));
        }
        for (int c = 0; c < cap.Count; c += 3)
            builder.AddFace(cap[c], cap[c + 2], cap[c + 1]);
        for (int c = 0; c < cap.Count; c += 3)
            builder.AddFace(n + cap[c], n + cap[c + 1], n + cap[c + 2]);
        for (int loop = 0; loop + 1 < loopStart.Length; loop++)
            AddWall(builder, loopStart[loop], n + loopStart[loop], loopStart[loop + 1] - loopStart[loop]);
        return builder.Build();
    }

    internal static (Vector2D[] Points, int[] LoopStart) Join(Vector2D[] outline, Vector2D[][] holes)
    {
        var points = new List<Vector2D>(outline);
        var start = new List<int> { 0, outline.Length };
        foreach (Vector2D[] hole in holes)
        {
            points.AddRange(hole ?? throw new ArgumentException("A hole is null.", nameof(holes)));
            start.Add(points.Count);
        }
        Vector2D[] joined = [.. points];
        Check.Finite(joined, nameof(outline));
        return (joined, [.. start]);
    }

    /// <summary>Two triangles per side between a lower and an upper loop of vertices; the outside is to the right of the loop.</summary>
    internal static void AddWall(MeshBuilder builder, int lower, int upper, int count)
    {
        for (int i = 0; i < count; i++)
        {
            int j = (i + 1) % count;
            builder.AddFace(lower + i, lower + j, upper + j);
            builder.AddFace(lower + i, upper + j, upper + i);
        }
    }
}
