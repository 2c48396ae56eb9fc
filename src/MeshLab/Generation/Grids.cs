using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Generation;

/// <summary>§2.5 平面网格 (planar grids).</summary>
public static class Grids
{
    /// <summary>m × n vertices in z = 0, (m − 1)(n − 1) · 2 triangles facing up. O(mn).</summary>
    /// <remarks>The centre of the grid is the origin, to the last bit: opposite vertices are negatives of each other. (The textbook's program shifts the grid by half a cell.)</remarks>
    /// <param name="m">Vertices along x, at least 2.</param>
    /// <param name="n">Vertices along y, at least 2.</param>
    /// <param name="width">The extent along x.</param>
    /// <param name="height">The extent along y.</param>
    /// <param name="faces">Triangles or quadrilaterals.</param>
    /// <exception cref="ArgumentOutOfRangeException">A count is below 2, or a length is not finite and positive.</exception>
    public static Mesh Grid(int m, int n, double width = 1, double height = 1, PatchFaces faces = PatchFaces.Triangles) =>
        HeightFields.Create(m, n, static (_, _) => 0, width, height, faces);
}
