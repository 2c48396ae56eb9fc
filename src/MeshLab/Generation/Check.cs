using System.Runtime.CompilerServices;
using MeshLab.Numerics;

namespace MeshLab.Generation;

/// <summary>Checks of the generators' arguments.</summary>
internal static class Check
{
    /// <summary>Throws unless the number is finite and positive.</summary>
    public static void Positive(double value, [CallerArgumentExpression(nameof(value))] string? name = null)
    {
        if (!(value > 0) || !double.IsFinite(value))
            throw new ArgumentOutOfRangeException(name, value, "A finite number above 0 is needed.");
    }

    /// <summary>Throws unless the number is finite.</summary>
    public static void Finite(double value, [CallerArgumentExpression(nameof(value))] string? name = null)
    {
        if (!double.IsFinite(value))
            throw new ArgumentOutOfRangeException(name, value, "A finite number is needed.");
    }

    /// <summary>Throws unless the number is finite and at least 0.</summary>
    public static void NotNegative(double value, [CallerArgumentExpression(nameof(value))] string? name = null)
    {
        if (!(value >= 0) || !double.IsFinite(value))
            throw new ArgumentOutOfRangeException(name, value, "A finite number of at least 0 is needed.");
    }

    /// <summary>Throws unless the count lies between two bounds.</summary>
    public static void Count(int value, int least, int most = MostSegments, [CallerArgumentExpression(nameof(value))] string? name = null)
    {
        if (value < least || value > most)
            throw new ArgumentOutOfRangeException(name, value, $"A count from {least} to {most} is needed.");
    }

    /// <summary>Throws unless the product of two counts fits the indices of a mesh.</summary>
    public static void Elements(long first, long second, string name)
    {
        if (first * second > MostVertices)
            throw new ArgumentOutOfRangeException(name, first * second, $"That is more than {MostVertices} vertices.");
    }

    /// <summary>Throws unless every point is finite.</summary>
    public static void Finite(ReadOnlySpan<Vector3D> points, string name)
    {
        foreach (Vector3D point in points)
        {
            if (!point.IsFinite)
                throw new ArgumentException($"The point {point} is not finite.", name);
        }
    }

    /// <summary>Throws unless every point is finite.</summary>
    public static void Finite(ReadOnlySpan<Vector2D> points, string name)
    {
        foreach (Vector2D point in points)
        {
            if (!double.IsFinite(point.X) || !double.IsFinite(point.Y))
                throw new ArgumentException($"The point {point} is not finite.", name);
        }
    }

    public const int MostSegments = 10_000_000;

    private const int MostVertices = 100_000_000;
}
