using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geometry;

/// <summary>Coordinates in which a bounding box has its centre at the origin and a diagonal of length 1, to work in where neither place nor size of a model may matter.</summary>
/// <remarks>Places are rounded to 2⁻³⁶. The last bits of a model's coordinates depend on its units; choices between things that are equal but for them would too.</remarks>
internal readonly struct UnitFrame
{
    /// <summary>Numbers from 2¹⁶ to 2¹⁷ are multiples of 2⁻³⁶.</summary>
    private const double RoundingShift = 3 << 15;

    private readonly Vector3D lowest;
    private readonly Vector3D half;

    private UnitFrame(BoundingBox box)
    {
        lowest = box.Min;
        half = box.Size / 2;
        Scale = DiagonalOf(box);
    }

    private static double DiagonalOf(BoundingBox box)
    {
        if (box.Diagonal is > 1e-150 and < 1e150)
            return box.Diagonal;
        // Squares of the sides do not fit into a number, or vanish.
        double longest = Math.Max(box.Size.X, Math.Max(box.Size.Y, box.Size.Z));
        double diagonal = longest * (box.Size / longest).Length;
        return diagonal > 0 && double.IsFinite(diagonal) && double.IsFinite(1 / diagonal) ? diagonal : 1;
    }

    /// <summary>Model units per unit.</summary>
    public double Scale { get; }

    public static UnitFrame Of(Mesh mesh) => new(mesh.BoundingBox);

    public Vector3D ToUnit(Vector3D position)
    {
        // The lowest corner first: far from the origin this difference is exact, that from the center is not.
        Vector3D p = (position - lowest - half) / Scale;
        return new(Rounded(p.X), Rounded(p.Y), Rounded(p.Z));

        static double Rounded(double x) => x + RoundingShift - RoundingShift;
    }

    public Vector3D FromUnit(Vector3D position) => position * Scale + half + lowest;

    /// <summary>As <see cref="FromUnit(Vector3D)"/>; a place that is still that of a vertex of the input has its bits.</summary>
    public Vector3D FromUnit(Vector3D position, Mesh input, int vertex) =>
        vertex < input.VertexSlots && ToUnit(input.Positions[vertex]) == position ? input.Positions[vertex] : FromUnit(position);

    /// <summary>A copy of the mesh in this frame.</summary>
    public Mesh ToUnit(Mesh mesh)
    {
        Mesh unit = mesh.Clone();
        foreach (ref Vector3D p in unit.Positions)
            p = ToUnit(p);
        return unit;
    }
}
