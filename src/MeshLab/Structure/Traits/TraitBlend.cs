using MeshLab.Numerics;

namespace MeshLab.Structure;

/// <summary>How a trait's value is made from those of two elements when an operation makes one from two.</summary>
/// <typeparam name="T">The type of the values.</typeparam>
/// <param name="first">The value of the first element.</param>
/// <param name="second">The value of the second element.</param>
/// <param name="t">Where between them: 0 is the first, 1 the second.</param>
public delegate T TraitBlend<T>(T first, T second, double t);

/// <summary>The usual rules.</summary>
/// <remarks>
/// At t = 0 and t = 1 the linear rules give that element's value bit for bit. NaN means "no value" and is catching: a blend in which one of both has a share is NaN.
/// No position and no connectivity depends on it.
/// </remarks>
public static class Blend
{
    /// <summary>The value of the nearer element; the first on a tie.</summary>
    public static T Nearest<T>(T first, T second, double t) => t <= 0.5 ? first : second;

    /// <summary>Linear, for numbers.</summary>
    public static double Linear(double first, double second, double t) =>
        t == 0 ? first : t == 1 ? second : first + (second - first) * t;

    /// <summary>Linear, for vectors.</summary>
    public static Vector3D Linear(Vector3D first, Vector3D second, double t) =>
        t == 0 ? first : t == 1 ? second : Vector3D.Lerp(first, second, t);

    /// <summary>Linear, for texture coordinates.</summary>
    public static Vector2D Linear(Vector2D first, Vector2D second, double t) =>
        t == 0 ? first : t == 1 ? second : Vector2D.Lerp(first, second, t);

    /// <summary>Linear, for colours.</summary>
    public static Color Linear(Color first, Color second, double t) =>
        t == 0 ? first : t == 1 ? second : Color.Lerp(first, second, t);

    /// <summary>Linear and scaled to length 1, for directions.</summary>
    public static Vector3D Direction(Vector3D first, Vector3D second, double t) => Linear(first, second, t).Normalized();

    /// <summary>The larger, for flags and labels: what is set on either stays set.</summary>
    public static int Largest(int first, int second, double t) => Math.Max(first, second);
}
