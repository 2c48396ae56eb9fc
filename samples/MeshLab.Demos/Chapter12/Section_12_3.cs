using MeshLab.Demos.Hosting;
using MeshLab.Morse;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter12;

/// <summary>§12.3 莫斯定理: the sum of the indices is χ, whatever the direction.</summary>
[Demo("12.3", "莫斯定理", "Morse's theorem")]
public static class Section_12_3
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        var rows = new List<IReadOnlyList<object>>();
        foreach (Vector3D direction in (Vector3D[])[new(1, 0, 0), new(0, 1, 0), new(0, 0, 1), new(1, 1, 1), new(1, -2, 3)])
        {
            CriticalPoints critical = CriticalPoints.Of(mesh.DirectionFunction(direction));
            rows.Add([direction.ToString(), critical.Minima.Count, critical.SaddleCount, critical.Maxima.Count, critical.IndexSum, critical.EulerCharacteristic]);
        }
        output.Table("the height in a direction", ["direction", "minima", "saddles", "maxima", "sum of indices", "χ"], rows);
    }
}
