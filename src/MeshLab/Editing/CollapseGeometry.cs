using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>§4.6 The geometric test beside <see cref="EdgeCollapse"/>: would a face that stays turn over?</summary>
public static class CollapseGeometry
{
    extension(HalfEdge halfEdge)
    {
        /// <summary>Whether collapsing the edge to a point turns a remaining face, at one of the edge's ends, too far or makes it degenerate.
        /// A face that is degenerate now may stay so. The mesh is not touched. O(valence of both ends).</summary>
        /// <param name="position">Where both ends would go.</param>
        /// <param name="minimumCosine">The least cosine between a face's normals before and after; 0 allows a right angle.</param>
        /// <exception cref="ArgumentException">The half-edge is none or deleted, or the position is not finite.</exception>
        /// <exception cref="ArgumentOutOfRangeException">The cosine is not between −1 and 1.</exception>
        public bool CollapseFlips(Vector3D position, double minimumCosine = 0)
        {
            halfEdge.ThrowIfDead();
            position.ThrowIfNotFinite(nameof(position));
            ArgumentOutOfRangeException.ThrowIfLessThan(minimumCosine, -1);
            ArgumentOutOfRangeException.ThrowIfGreaterThan(minimumCosine, 1);
            return TurnsAround(halfEdge, position, minimumCosine) || TurnsAround(halfEdge.Twin, position, minimumCosine);
        }
    }

    /// <summary>Looks at the corners at the half-edge's source, except those of the faces beside the edge.</summary>
    private static bool TurnsAround(HalfEdge h, Vector3D position, double minimumCosine)
    {
        Vector3D old = h.Source.Position;
        for (HalfEdge spoke = h.Previous.Twin; spoke != h; spoke = spoke.Previous.Twin)
        {
            // The corner between the spoke and the one after it; the last corner is that of the twin's face.
            HalfEdge after = spoke.Previous.Twin;
            if (spoke.IsBoundary || after == h)
                continue;
            Vector3D a = spoke.Target.Position, b = after.Target.Position;
            Vector3D before = Vector3D.Cross(a - old, b - old), then = Vector3D.Cross(a - position, b - position);
            double product = before.Length * then.Length;
            if (before.LengthSquared > 0 && (product == 0 || Vector3D.Dot(before, then) < minimumCosine * product))
                return true;
        }
        return false;
    }
}
