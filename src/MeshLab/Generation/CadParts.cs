using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Generation;

/// <summary>Machine parts (机械零件): sharp edges, flat faces, round holes, and the long thin triangles that CAD programs write.</summary>
public static class CadParts
{
    /// <summary>A flange: a plate with rounded corners and four bolt holes, a boss on it, and a bore through both. Closed, genus 5.</summary>
    /// <param name="segments">Sides of every circle, a multiple of 4 from 8 to 512.</param>
    /// <exception cref="ArgumentOutOfRangeException">The count is out of range or not a multiple of 4.</exception>
    public static Mesh Flange(int segments = 32)
    {
        Check.Count(segments, 8, 512);
        if (segments % 4 != 0)
            throw new ArgumentOutOfRangeException(nameof(segments), segments, "A multiple of 4 is needed.");
        const double half = 1, corner = 0.3, bolt = 0.12, boltAt = 0.7, bossRadius = 0.5, boreRadius = 0.32, plate = 0.3, top = 0.8;
        Vector2D[] outline = RoundedSquare(half, corner, segments);
        Vector2D[] boss = Circle(default, bossRadius, segments), bore = Circle(default, boreRadius, segments);
        Vector2D[][] bolts =
        [
            Circle(new(boltAt, boltAt), bolt, segments), Circle(new(-boltAt, boltAt), bolt, segments),
            Circle(new(-boltAt, -boltAt), bolt, segments), Circle(new(boltAt, -boltAt), bolt, segments),
        ];

        var builder = new MeshBuilder();
        int boreBottom = AddLoop(builder, bore, 0), boreTop = AddLoop(builder, bore, top);
        int bossBottom = AddLoop(builder, boss, plate), bossTop = AddLoop(builder, boss, top);
        int bottom = AddLoops(0), upper = AddLoops(plate);

        AddPlane(builder, outline, [.. bolts, bore], [bottom, .. LoopsAfter(bottom), boreBottom], up: false);
        AddPlane(builder, outline, [.. bolts, boss], [upper, .. LoopsAfter(upper), bossBottom], up: true);
        // The boss's rim is the outline of its top.
        AddPlane(builder, [.. boss.Reverse()], [bore], [bossTop, boreTop], up: true, outlineReversed: true);
        Extrusions.AddWall(builder, bottom, upper, outline.Length);
        for (int k = 0; k < bolts.Length; k++)
            Extrusions.AddWall(builder, LoopsAfter(bottom)[k], LoopsAfter(upper)[k], segments);
        Extrusions.AddWall(builder, boreBottom, boreTop, segments);
        // The boss is listed clockwise, as a hole of the plate; its wall faces the other way.
        for (int i = 0; i < segments; i++)
        {
            int j = (i + 1) % segments;
            builder.AddFace(bossBottom + j, bossBottom + i, bossTop + i);
            builder.AddFace(bossBottom + j, bossTop + i, bossTop + j);
        }
        return builder.Build();

        int AddLoops(double z)
        {
            int first = AddLoop(builder, outline, z);
            foreach (Vector2D[] loop in bolts)
                AddLoop(builder, loop, z);
            return first;
        }

        int[] LoopsAfter(int first)
        {
            int next = first + outline.Length;
            return [next, next + segments, next + 2 * segments, next + 3 * segments];
        }
    }

    /// <summary>An L-shaped bracket extruded across, without holes: 12 corners, flat faces, right angles. Closed, genus 0.</summary>
    public static Mesh Bracket() =>
        Extrusions.Extrude([new(0, 0), new(1, 0), new(1, 0.2), new(0.2, 0.2), new(0.2, 1), new(0, 1)], 0.6);

    private static void AddPlane(MeshBuilder builder, Vector2D[] outline, Vector2D[][] holes, int[] first, bool up, bool outlineReversed = false)
    {
        (Vector2D[] points, int[] start) = Extrusions.Join(outline, holes);
        List<int> triangles = EarClipping.Triangulate(points, start, nameof(outline));
        for (int c = 0; c < triangles.Count; c += 3)
        {
            int a = Vertex(triangles[c]), b = Vertex(triangles[c + 1]), d = Vertex(triangles[c + 2]);
            if (up)
                builder.AddFace(a, b, d);
            else
                builder.AddFace(a, d, b);
        }

        int Vertex(int point)
        {
            int loop = 0;
            while (point >= start[loop + 1])
                loop++;
            int at = point - start[loop];
            return first[loop] + (loop == 0 && outlineReversed ? outline.Length - 1 - at : at);
        }
    }

    private static int AddLoop(MeshBuilder builder, Vector2D[] loop, double z)
    {
        int first = builder.VertexCount;
        foreach (Vector2D p in loop)
            builder.AddVertex(new(p.X, p.Y, z));
        return first;
    }

    /// <summary>A circle, clockwise as a hole wants it.</summary>
    private static Vector2D[] Circle(Vector2D center, double radius, int segments)
    {
        var circle = new Vector2D[segments];
        for (int i = 0; i < segments; i++)
            circle[i] = center + radius * UnitCircle.At(-i, segments);
        return circle;
    }

    private static Vector2D[] RoundedSquare(double half, double corner, int segments)
    {
        var outline = new List<Vector2D>();
        int perCorner = segments / 4;
        for (int quarter = 0; quarter < 4; quarter++)
        {
            Vector2D diagonal = UnitCircle.At(2 * quarter + 1, 8);
            Vector2D center = (half - corner) * new Vector2D(Math.Sign(diagonal.X), Math.Sign(diagonal.Y));
            for (int i = 0; i <= perCorner; i++)
                outline.Add(center + corner * UnitCircle.At(quarter * perCorner + i, segments));
        }
        return [.. outline];
    }
}
