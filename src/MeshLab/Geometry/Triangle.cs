using MeshLab.Numerics;

namespace MeshLab.Geometry;

/// <summary>The formulas of one triangle in space (§10.1, §10.3, §10.6), counter-clockwise seen from outside.</summary>
/// <param name="A">The first corner.</param>
/// <param name="B">The second corner.</param>
/// <param name="C">The third corner.</param>
public readonly record struct Triangle(Vector3D A, Vector3D B, Vector3D C)
{
    /// <summary>The normal, as long as twice the area (面积向量): (B − A) × (C − A).</summary>
    public Vector3D DoubleAreaVector => Vector3D.Cross(B - A, C - A);

    /// <summary>§10.1 面积: half the length of the cross product.</summary>
    public double Area => 0.5 * DoubleAreaVector.Length;

    /// <summary>§10.1 海伦公式 (Heron's formula) from the three lengths, in the order of terms that survives needles.</summary>
    /// <remarks>Kahan 1983: a ≥ b ≥ c, ¼√((a+(b+c))(c−(a−b))(c+(a−b))(a+(b−c))). The plain √(s(s−a)(s−b)(s−c)) loses all digits there.</remarks>
    public double HeronArea
    {
        get
        {
            double a = (C - B).Length, b = (A - C).Length, c = (B - A).Length;
            if (a < b)
                (a, b) = (b, a);
            if (b < c)
                (b, c) = (c, b);
            if (a < b)
                (a, b) = (b, a);
            double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
            // Rounding of the lengths can break the triangle inequality of a flat triangle.
            return product > 0 ? 0.25 * Math.Sqrt(product) : 0;
        }
    }

    /// <summary>§10.3 The unit normal (法向); the null vector if the area is zero.</summary>
    public Vector3D Normal => DoubleAreaVector.Normalized();

    /// <summary>The barycentre (重心): the mean of the corners.</summary>
    public Vector3D Barycenter => A + ((B - A) + (C - A)) / 3;

    /// <summary>The centre of the circle through the corners (外心); not finite if the area is zero.</summary>
    public Vector3D Circumcenter
    {
        get
        {
            Vector3D u = B - A, v = C - A, n = Vector3D.Cross(u, v);
            return A + (v.LengthSquared * Vector3D.Cross(n, u) + u.LengthSquared * Vector3D.Cross(v, n)) / (2 * n.LengthSquared);
        }
    }

    /// <summary>The radius of the circle through the corners, abc / 4A; infinite if the area is zero.</summary>
    public double Circumradius => (B - A).Length * (C - B).Length * (A - C).Length / (2 * DoubleAreaVector.Length);

    /// <summary>The radius of the circle inside, 2A / (a + b + c).</summary>
    public double Inradius
    {
        get
        {
            double perimeter = (B - A).Length + (C - B).Length + (A - C).Length;
            return perimeter > 0 ? DoubleAreaVector.Length / perimeter : 0;
        }
    }

    /// <summary>The angle at <see cref="A"/> in [0, π] (§10.6), by atan2, exact also for needles.</summary>
    public double AngleA => Vector3D.Angle(B - A, C - A);

    /// <summary>The angle at <see cref="B"/>.</summary>
    public double AngleB => Vector3D.Angle(C - B, A - B);

    /// <summary>The angle at <see cref="C"/>.</summary>
    public double AngleC => Vector3D.Angle(A - C, B - C);

    /// <summary>The smallest of the three angles, in radians: π/3 is best.</summary>
    public double MinAngle => Math.Min(AngleA, Math.Min(AngleB, AngleC));

    /// <summary>The largest of the three angles, in radians.</summary>
    public double MaxAngle => Math.Max(AngleA, Math.Max(AngleB, AngleC));

    /// <summary>The quality 4√3·A / (a² + b² + c²): 1 for an equilateral triangle, 0 for zero area (Bank, Smith 1997).</summary>
    public double Quality
    {
        get
        {
            double squares = (B - A).LengthSquared + (C - B).LengthSquared + (A - C).LengthSquared;
            return squares > 0 ? 2 * Math.Sqrt(3) * DoubleAreaVector.Length / squares : 0;
        }
    }

    /// <summary>Twice the inradius over the circumradius, 2r / R: 1 for an equilateral triangle, 0 for zero area.</summary>
    public double RadiusRatio
    {
        get
        {
            double radius = Circumradius;
            return double.IsFinite(radius) && radius > 0 ? 2 * Inradius / radius : 0;
        }
    }

    /// <summary>Longest side over the altitude on it: 2/√3 for an equilateral triangle, infinite for zero area.</summary>
    public double AspectRatio
    {
        get
        {
            double longest = Math.Max((B - A).LengthSquared, Math.Max((C - B).LengthSquared, (A - C).LengthSquared));
            return longest / DoubleAreaVector.Length;
        }
    }
}
