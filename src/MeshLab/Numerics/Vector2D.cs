using System.Globalization;

namespace MeshLab.Numerics;

/// <summary>A point of the plane or a texture coordinate (纹理坐标).</summary>
/// <param name="X">The first coordinate, u of a texture.</param>
/// <param name="Y">The second coordinate, v of a texture.</param>
public readonly record struct Vector2D(double X, double Y)
{
    /// <summary>Sum.</summary>
    public static Vector2D operator +(Vector2D left, Vector2D right) => new(left.X + right.X, left.Y + right.Y);

    /// <summary>Difference.</summary>
    public static Vector2D operator -(Vector2D left, Vector2D right) => new(left.X - right.X, left.Y - right.Y);

    /// <summary>The vector scaled.</summary>
    public static Vector2D operator *(Vector2D left, double right) => new(left.X * right, left.Y * right);

    /// <summary>The vector scaled.</summary>
    public static Vector2D operator *(double left, Vector2D right) => right * left;

    /// <summary>The Euclidean length.</summary>
    public double Length => Math.Sqrt(X * X + Y * Y);

    /// <summary>The scalar product.</summary>
    public static double Dot(Vector2D a, Vector2D b) => a.X * b.X + a.Y * b.Y;

    /// <summary>The z of the vector product: twice the signed area of the triangle (0, a, b).</summary>
    public static double Cross(Vector2D a, Vector2D b) => a.X * b.Y - a.Y * b.X;

    /// <summary>The point at parameter <paramref name="t"/> from <paramref name="a"/> (0) to <paramref name="b"/> (1).</summary>
    public static Vector2D Lerp(Vector2D a, Vector2D b, double t) => a * (1 - t) + b * t;

    /// <inheritdoc/>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"({X}, {Y})");
}
