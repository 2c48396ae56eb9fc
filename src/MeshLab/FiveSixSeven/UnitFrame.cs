using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.FiveSixSeven;

/// <summary>Coordinates in which the bounding box has its centre at the origin and a diagonal of length 1.</summary>
internal readonly record struct UnitFrame(Vector3D Center, double Diagonal)
{
    public static UnitFrame Of(Mesh mesh)
    {
        BoundingBox box = mesh.BoundingBox;
        return new(box.Center, box.Diagonal > 0 ? box.Diagonal : 1);
    }

    public Mesh ToUnit(Mesh mesh)
    {
        Mesh unit = mesh.Clone();
        foreach (ref Vector3D p in unit.Positions)
            p = (p - Center) / Diagonal;
        return unit;
    }

    /// <summary>The result in the input's coordinates; vertices that did not move get their old coordinates back to the last bit.</summary>
    public Mesh FromUnit(WorkMesh work, Mesh input)
    {
        (Vector3D[] positions, int[] corners, int[] slots) = work.Export();
        for (int i = 0; i < positions.Length; i++)
        {
            Vector3D p = positions[i];
            bool stayed = slots[i] < input.VertexSlots && (input.Positions[slots[i]] - Center) / Diagonal == p;
            positions[i] = stayed ? input.Positions[slots[i]] : p * Diagonal + Center;
        }
        return MeshBuilder.FromTriangles(positions, corners);
    }
}
