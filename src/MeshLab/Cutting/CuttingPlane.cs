using MeshLab.Numerics;

namespace MeshLab.Cutting;

/// <summary>A plane n · x = d (切割平面). Above it is where the normal points.</summary>
public readonly record struct CuttingPlane
{
    /// <summary>Takes the plane n · x = d.</summary>
    /// <param name="normal">Finite and not zero; of any length.</param>
    /// <param name="offset">Finite.</param>
    /// <exception cref="ArgumentException">The normal is zero, or a number is not finite.</exception>
    public CuttingPlane(Vector3D normal, double offset)
    {
        double length = normal.Length;
        if (!normal.IsFinite || !(length > 0) || !double.IsFinite(length))
            throw new ArgumentException($"The normal {normal} of a plane must be finite and not zero.", nameof(normal));
        if (!double.IsFinite(offset / length))
            throw new ArgumentException($"The offset {offset} of a plane must be finite.", nameof(offset));
        Normal = normal / length;
        Offset = offset / length;
    }

    /// <summary>The normal, of length 1.</summary>
    public Vector3D Normal { get; }

    /// <summary>The distance of the plane from the origin, along the normal.</summary>
    public double Offset { get; }

    /// <summary>The plane through a point.</summary>
    /// <exception cref="ArgumentException">The normal is zero, or a number is not finite.</exception>
    public static CuttingPlane Through(Vector3D point, Vector3D normal) => new(normal, Vector3D.Dot(normal, point));

    /// <summary>The signed distance of a point, positive above.</summary>
    public double Distance(Vector3D point) => Vector3D.Dot(Normal, point) - Offset;

    /// <summary>Two directions of the plane; with the normal they are a right-handed frame of unit vectors.</summary>
    internal (Vector3D X, Vector3D Y) Axes()
    {
        Vector3D x = Vector3D.Cross(Math.Abs(Normal.X) < 0.6 ? Vector3D.UnitX : Vector3D.UnitY, Normal).Normalized();
        return (x, Vector3D.Cross(Normal, x));
    }

    /// <summary>Throws for a plane that no constructor made.</summary>
    internal void ThrowIfNone(string parameter)
    {
        if (Normal == default)
            throw new ArgumentException("The plane has no normal.", parameter);
    }
}
