using MeshLab.Morse;
using MeshLab.Numerics;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter12;

/// <summary>Spheres for critical points: blue minima, yellow saddles, red maxima.</summary>
internal static class CriticalMarks
{
    private static readonly Color Blue = new(0.15f, 0.30f, 0.85f), Yellow = new(0.95f, 0.78f, 0.10f), Red = new(0.85f, 0.12f, 0.12f);

    public static IReadOnlyList<PointMarks> Of(IEnumerable<CriticalPoint> points, double size = 12)
    {
        CriticalPoint[] all = [.. points];
        return [Marks(all, CriticalKind.Minimum, Blue, size), Marks(all, CriticalKind.Saddle, Yellow, size), Marks(all, CriticalKind.Maximum, Red, size)];
    }

    private static PointMarks Marks(CriticalPoint[] points, CriticalKind kind, Color color, double size) =>
        new([.. points.Where(p => p.Kind == kind).Select(p => p.Vertex.Position)], color, size);
}
