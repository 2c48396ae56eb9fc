using System.Numerics;
using MeshLab.Numerics;

namespace MeshLab.Visualization;

/// <summary>The vertices as the camera sees them.</summary>
internal sealed class ProjectedMesh
{
    /// <summary>Steps per sample: coordinates on the picture are whole numbers of these, so that inside and outside are decided exactly.</summary>
    public const int Steps = 256;

    private const double LargestCoordinate = 1 << 28;

    /// <summary>Columns, in steps.</summary>
    public required int[] X { get; init; }

    /// <summary>Rows, in steps.</summary>
    public required int[] Y { get; init; }

    /// <summary>One over the distance: linear on the picture, larger is nearer.</summary>
    public required float[] Nearness { get; init; }

    /// <summary>Positions in the axes right, up, towards the viewer, the camera at the origin.</summary>
    public required Vector3[] View { get; init; }

    /// <summary>Projects all vertices.</summary>
    public static ProjectedMesh Of(Vector3D[] positions, Camera camera, int maxThreads)
    {
        var result = new ProjectedMesh
        {
            X = new int[positions.Length],
            Y = new int[positions.Length],
            Nearness = new float[positions.Length],
            View = new Vector3[positions.Length],
        };
        ParallelBlocks.For(positions.Length, 16384, maxThreads, (from, to) =>
        {
            for (int v = from; v < to; v++)
            {
                Vector3D d = positions[v] - camera.Position;
                double x = Vector3D.Dot(d, camera.Right), y = Vector3D.Dot(d, camera.Up), z = -Vector3D.Dot(d, camera.Back);
                double nearness = 1 / z;
                result.X[v] = Step(camera.CenterX + camera.Focal * x * nearness);
                result.Y[v] = Step(camera.CenterY - camera.Focal * y * nearness);
                result.Nearness[v] = (float)nearness;
                result.View[v] = new((float)x, (float)y, (float)-z);
            }
        });
        return result;
    }

    private static int Step(double coordinate) => (int)Math.Clamp(Math.Round(coordinate * Steps), -LargestCoordinate, LargestCoordinate);
}
