using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>§4.7 The geometric test beside <see cref="EdgeFlip"/>: would the flipped triangles fold over?</summary>
public static class FlipGeometry
{
    extension(Edge edge)
    {
        /// <summary>Whether a flip would leave the quadrilateral folded, that is: it is concave there, or its two new triangles are degenerate or
        /// turn too far from one another or from the old ones. The mesh is not touched. O(1).</summary>
        /// <param name="minimumCosine">The least cosine between the normals of the two new triangles; 0 allows a right angle, −1 anything that is not degenerate.</param>
        /// <exception cref="ArgumentException">The edge is none, deleted, or not between two triangles.</exception>
        /// <exception cref="ArgumentOutOfRangeException">The cosine is not between −1 and 1.</exception>
        public bool FlipFolds(double minimumCosine = 0)
        {
            edge.ThrowIfDead();
            ArgumentOutOfRangeException.ThrowIfLessThan(minimumCosine, -1);
            ArgumentOutOfRangeException.ThrowIfGreaterThan(minimumCosine, 1);
            if (edge.IsBoundary || !edge.Face0.IsTriangle || !edge.Face1.IsTriangle)
                throw new ArgumentException($"{edge} does not lie between two triangles.");

            HalfEdge h = edge.HalfEdge0, t = h.Twin;
            Vector3D a = t.Target.Position, b = h.Target.Position, c = h.Next.Target.Position, d = t.Next.Target.Position;
            Vector3D old = Vector3D.Cross(b - a, c - a) + Vector3D.Cross(d - a, b - a);
            Vector3D left = Vector3D.Cross(c - d, a - d), right = Vector3D.Cross(b - d, c - d);
            double product = left.Length * right.Length;
            bool turnsAway = Vector3D.Dot(old, left) <= 0 || Vector3D.Dot(old, right) <= 0;
            return product == 0 || turnsAway || Vector3D.Dot(left, right) < minimumCosine * product;
        }
    }
}
