namespace MeshLab.Numerics;

/// <summary>An axis-parallel box (包围盒). The box of no points is empty: <see cref="IsEmpty"/>.</summary>
/// <param name="Min">The corner with the smallest coordinates.</param>
/// <param name="Max">The corner with the largest coordinates.</param>
public readonly record struct BoundingBox(Vector3D Min, Vector3D Max)
{
    /// <summary>The box that holds nothing: joining it with another box gives that box.</summary>
    public static BoundingBox Empty { get; } = new(
        new(double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity),
        new(double.NegativeInfinity, double.NegativeInfinity, double.NegativeInfinity));

    /// <summary>Whether the box holds no point.</summary>
    public bool IsEmpty => !(Min.X <= Max.X && Min.Y <= Max.Y && Min.Z <= Max.Z);

    /// <summary>Max − Min; zero if empty.</summary>
    public Vector3D Size => IsEmpty ? default : Max - Min;

    /// <summary>The middle; the origin if empty.</summary>
    public Vector3D Center => IsEmpty ? default : Min + (Max - Min) * 0.5;

    /// <summary>The length of the diagonal, the usual unit for distances of meshes.</summary>
    public double Diagonal => Size.Length;

    /// <summary>The eight corners (包围盒的角点), bit 0 of the index for x, 1 for y, 2 for z.</summary>
    public Vector3D Corner(int index) => new(
        (index & 1) == 0 ? Min.X : Max.X,
        (index & 2) == 0 ? Min.Y : Max.Y,
        (index & 4) == 0 ? Min.Z : Max.Z);

    /// <summary>The smallest box that holds the points.</summary>
    public static BoundingBox Of(ReadOnlySpan<Vector3D> points)
    {
        BoundingBox box = Empty;
        foreach (Vector3D p in points)
            box = box.Including(p);
        return box;
    }

    /// <summary>The smallest box that holds this one and the point.</summary>
    public BoundingBox Including(Vector3D point) => new(Vector3D.Min(Min, point), Vector3D.Max(Max, point));

    /// <summary>The smallest box that holds both.</summary>
    public BoundingBox Including(BoundingBox other) => new(Vector3D.Min(Min, other.Min), Vector3D.Max(Max, other.Max));

    /// <summary>Whether the point is inside or on the surface.</summary>
    public bool Contains(Vector3D p) =>
        p.X >= Min.X && p.Y >= Min.Y && p.Z >= Min.Z && p.X <= Max.X && p.Y <= Max.Y && p.Z <= Max.Z;
}
