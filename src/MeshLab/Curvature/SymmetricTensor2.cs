using MeshLab.Numerics;

namespace MeshLab.Curvature;

/// <summary>A symmetric tensor in a tangent plane, ((E, F), (F, G)).</summary>
internal readonly record struct SymmetricTensor2(double E, double F, double G)
{
    /// <summary>Bending in the direction (x, y).</summary>
    public double Along(double x, double y) => E * x * x + 2 * F * x * y + G * y * y;

    /// <summary>Stores eigenvalues and eigenvectors; <paramref name="x"/> and <paramref name="y"/> are the unit axes of the plane in space.</summary>
    public void Store(PrincipalCurvatures result, int vertex, Vector3D x, Vector3D y)
    {
        double mean = (E + G) / 2, half = (E - G) / 2, root = Math.Sqrt(half * half + F * F);
        double angle = Math.Atan2(F, half) / 2, cos = Math.Cos(angle), sin = Math.Sin(angle);
        result.Max[vertex] = mean + root;
        result.Min[vertex] = mean - root;
        result.MaxDirection[vertex] = x * cos + y * sin;
        result.MinDirection[vertex] = y * cos - x * sin;
    }
}

/// <summary>Two unit vectors that span the plane perpendicular to a unit normal; with it a right-handed frame.</summary>
internal readonly struct TangentFrame
{
    public TangentFrame(Vector3D normal)
    {
        // Duff et al. 2017: continuous but for one direction, and without a square root.
        double sign = normal.Z < 0 ? -1 : 1, a = -1 / (sign + normal.Z), b = normal.X * normal.Y * a;
        X = new(1 + sign * normal.X * normal.X * a, sign * b, -sign * normal.X);
        Y = new(b, sign + normal.Y * normal.Y * a, -normal.Y);
    }

    public Vector3D X { get; }

    public Vector3D Y { get; }
}
