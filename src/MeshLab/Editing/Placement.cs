using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>§4.8 包围盒, 缩放, 平移 (placement): where a mesh lies and how large it is.</summary>
/// <remarks>Reading a file never changes positions; these are the explicit calls. Each is undone as one operation. O(V).</remarks>
public static class Placement
{
    extension(Mesh mesh)
    {
        /// <summary>The eight corners of the bounding box: corner i has the larger x, y, z where bit 0, 1, 2 of i is set.</summary>
        /// <exception cref="InvalidOperationException">The mesh has no vertices.</exception>
        public Vector3D[] BoxCorners()
        {
            BoundingBox box = BoxOf(mesh);
            var corners = new Vector3D[8];
            for (int i = 0; i < 8; i++)
            {
                corners[i] = new(
                    (i & 1) == 0 ? box.Min.X : box.Max.X,
                    (i & 2) == 0 ? box.Min.Y : box.Max.Y,
                    (i & 4) == 0 ? box.Min.Z : box.Max.Z);
            }
            return corners;
        }

        /// <summary>Scales about the origin so that the longest side of the bounding box is <paramref name="size"/>.</summary>
        /// <param name="size">Positive, in model units.</param>
        /// <returns>The factor.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The size is not positive and finite.</exception>
        /// <exception cref="InvalidOperationException">The mesh has no vertices, or all are in one point.</exception>
        public double ScaleToSize(double size)
        {
            if (!double.IsFinite(size) || size <= 0)
                throw new ArgumentOutOfRangeException(nameof(size), size, "The size is positive and finite.");
            double factor = size / LongestSide(BoxOf(mesh));
            Transform(mesh, p => p * factor);
            return factor;
        }

        /// <summary>Moves the mesh so that the centre of its bounding box is the origin.</summary>
        /// <returns>The shift.</returns>
        /// <exception cref="InvalidOperationException">The mesh has no vertices.</exception>
        public Vector3D MoveCenterToOrigin()
        {
            Vector3D shift = -BoxOf(mesh).Center;
            Transform(mesh, p => p + shift);
            return shift;
        }

        /// <summary>Moves the centre of the bounding box to the origin and scales its longest side to <paramref name="size"/>.</summary>
        /// <param name="size">Positive, in model units.</param>
        /// <exception cref="ArgumentOutOfRangeException">The size is not positive and finite.</exception>
        /// <exception cref="InvalidOperationException">The mesh has no vertices, or all are in one point.</exception>
        public void Normalize(double size = 1)
        {
            if (!double.IsFinite(size) || size <= 0)
                throw new ArgumentOutOfRangeException(nameof(size), size, "The size is positive and finite.");
            BoundingBox box = BoxOf(mesh);
            Vector3D center = box.Center;
            double factor = size / LongestSide(box);
            Transform(mesh, p => (p - center) * factor);
        }
    }

    private static BoundingBox BoxOf(Mesh mesh)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        return mesh.Vertices.Count > 0 ? mesh.BoundingBox : throw new InvalidOperationException("The mesh has no vertices, so it has no bounding box.");
    }

    private static double LongestSide(BoundingBox box)
    {
        Vector3D sides = box.Max - box.Min;
        double longest = Math.Max(sides.X, Math.Max(sides.Y, sides.Z));
        return longest > 0 ? longest : throw new InvalidOperationException("All vertices lie in one point, so no scale gives the size.");
    }

    private static void Transform(Mesh mesh, Func<Vector3D, Vector3D> move)
    {
        using OperationScope operation = mesh.BeginOperation(OperationKind.Group);
        foreach (Vertex v in mesh.Vertices)
            mesh.SetPosition(v, move(v.Position));
        operation.Complete();
    }
}
