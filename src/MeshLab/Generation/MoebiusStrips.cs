using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Generation;

/// <summary>The Möbius strip (莫比乌斯带): a surface that no half-edge mesh can hold, because it has one side only.</summary>
public static class MoebiusStrips
{
    /// <summary>The strip as polygons: χ = 0, one boundary loop, not orientable, so that the builder refuses it.</summary>
    /// <remarks>((1 + t cos θ/2) cos θ, (1 + t cos θ/2) sin θ, t sin θ/2) for θ in [0, 2π], |t| ≤ width/2; the last column meets the first upside down.</remarks>
    /// <param name="segments">Cells around, at least 3.</param>
    /// <param name="rows">Cells across, at least 1.</param>
    /// <param name="width">The width, below 2.</param>
    /// <exception cref="ArgumentOutOfRangeException">A count is too small, or the width is not between 0 and 2.</exception>
    public static PolygonSoup Strip(int segments = 64, int rows = 4, double width = 0.6)
    {
        Check.Count(segments, 3);
        Check.Count(rows, 1);
        Check.Positive(width);
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(width, 2);
        Check.Elements(segments, rows + 1L, nameof(segments));
        int perColumn = rows + 1;
        var positions = new Vector3D[segments * perColumn];
        for (int i = 0; i < segments; i++)
        {
            Vector2D turn = UnitCircle.At(i, segments), half = UnitCircle.At(i, 2L * segments);
            for (int j = 0; j <= rows; j++)
            {
                double t = width * HeightFields.Centered(j, perColumn), r = 1 + t * half.X;
                positions[i * perColumn + j] = new(r * turn.X, r * turn.Y, t * half.Y);
            }
        }
        var corners = new List<int>(6 * segments * rows);
        for (int i = 0; i < segments; i++)
        {
            for (int j = 0; j < rows; j++)
            {
                int a = At(i, j), b = At(i + 1, j), c = At(i + 1, j + 1), d = At(i, j + 1);
                corners.AddRange([a, b, c, a, c, d]);
            }
        }
        return PolygonSoup.FromTriangles(positions, [.. corners]);

        int At(int i, int j) => i < segments ? i * perColumn + j : rows - j;
    }
}
