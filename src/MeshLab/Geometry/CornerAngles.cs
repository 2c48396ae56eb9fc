using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geometry;

/// <summary>§10.6 角度 (corner angles) and §10.7 角亏 (angle defects).</summary>
/// <remarks>
/// The angle of a corner is atan2(|u × w|, u · w): exact also near 0 and π, where arccos loses half the digits. A corner of a polygon whose
/// turn is against the face's normal has an angle over π, so the angles of a flat n-gon add up to (n − 2)π. A side of length zero makes the angle 0.
/// </remarks>
public static class CornerAngles
{
    extension(HalfEdge halfEdge)
    {
        /// <summary>The angle of the face's corner at <see cref="HalfEdge.Target"/>, in radians; NaN on the boundary.</summary>
        /// <exception cref="ArgumentException">The half-edge is none or deleted.</exception>
        public double CornerAngle
        {
            get
            {
                halfEdge.ThrowIfDead();
                return halfEdge.IsBoundary ? double.NaN : AngleAt(halfEdge);
            }
        }
    }

    extension(Vertex vertex)
    {
        /// <summary>The sum of the corner angles at the vertex, in radians; 0 for an isolated vertex. O(valence).</summary>
        /// <exception cref="ArgumentException">The vertex is none or deleted.</exception>
        public double AngleSum
        {
            get
            {
                double sum = 0;
                foreach (HalfEdge h in vertex.IncomingHalfEdges)
                {
                    if (!h.IsBoundary)
                        sum += AngleAt(h);
                }
                return sum;
            }
        }

        /// <summary>§10.7 角亏: 2π less the angles around the vertex, π less on the boundary; NaN if isolated.</summary>
        /// <exception cref="ArgumentException">The vertex is none or deleted.</exception>
        public double AngleDefect
        {
            get
            {
                double sum = vertex.AngleSum;
                if (vertex.IsIsolated)
                    return double.NaN;
                return (vertex.IsBoundary ? Math.PI : 2 * Math.PI) - sum;
            }
        }
    }

    extension(Mesh mesh)
    {
        /// <summary>The corner angles per half-edge slot, each at its half-edge's target, in radians; NaN on the boundary and for deleted ones. O(H), in parallel.</summary>
        public double[] ComputeCornerAngles()
        {
            ArgumentNullException.ThrowIfNull(mesh);
            int[] halfEdgeOf = mesh.halfEdgeOf, next = mesh.next, target = mesh.target;
            Vector3D[] positions = mesh.positions;
            var angles = new double[mesh.HalfEdgeSlots];
            Array.Fill(angles, double.NaN);
            Parallelism.ForBlocks(mesh.FaceSlots, (from, to) =>
            {
                for (int f = from; f < to; f++)
                {
                    int first = halfEdgeOf[f];
                    if (first >= 0)
                        AnglesOfFace(next, target, positions, first, angles);
                }
            });
            return angles;
        }

        /// <summary>§10.7 角亏 per vertex slot: 2π − Σθ, on the boundary π − Σθ; NaN for isolated and deleted vertices. O(V + H), in parallel.</summary>
        /// <remarks>With this rule Σ defects = 2πχ for every mesh of flat faces, closed or not (Gauss–Bonnet, §11).</remarks>
        public double[] ComputeAngleDefects()
        {
            ArgumentNullException.ThrowIfNull(mesh);
            return mesh.IsTriangleMesh ? DefectsOfTriangles(mesh) : DefectsOfPolygons(mesh);
        }
    }

    /// <summary>The angle of the corner at the target of a half-edge that has a face.</summary>
    internal static double AngleAt(HalfEdge h)
    {
        Vector3D v = h.Target.Position, u = h.Next.Target.Position - v, w = h.Source.Position - v, cross = Vector3D.Cross(u, w);
        double angle = Math.Atan2(cross.Length, Vector3D.Dot(u, w));
        return !h.Face.IsTriangle && Vector3D.Dot(cross, h.Face.DoubleAreaVector) < 0 ? 2 * Math.PI - angle : angle;
    }

    private static void AnglesOfFace(int[] next, int[] target, Vector3D[] positions, int first, double[] angles)
    {
        int second = next[first], third = next[second];
        if (next[third] == first)
        {
            Vector3D a = positions[target[first]], b = positions[target[second]], c = positions[target[third]];
            Vector3D ab = b - a, bc = c - b, ca = a - c;
            // Twice the area serves all three corners.
            double cross = Vector3D.Cross(ab, ca).Length;
            angles[first] = Math.Atan2(cross, -Vector3D.Dot(ab, ca));
            angles[second] = Math.Atan2(cross, -Vector3D.Dot(bc, ab));
            angles[third] = Math.Atan2(cross, -Vector3D.Dot(ca, bc));
            return;
        }
        Vector3D normal = Areas.DoubleArea(next, target, positions, first);
        int h = first;
        Vector3D before = positions[target[first ^ 1]];
        do
        {
            int after = next[h];
            Vector3D v = positions[target[h]], u = positions[target[after]] - v, w = before - v, cross = Vector3D.Cross(u, w);
            double angle = Math.Atan2(cross.Length, Vector3D.Dot(u, w));
            angles[h] = Vector3D.Dot(cross, normal) < 0 ? 2 * Math.PI - angle : angle;
            before = v;
            h = after;
        }
        while (h != first);
    }

    private static double[] DefectsOfTriangles(Mesh mesh)
    {
        int[] next = mesh.next, target = mesh.target, outgoing = mesh.outgoing, face = mesh.face;
        Vector3D[] positions = mesh.positions;
        var defects = new double[mesh.VertexSlots];
        Parallelism.ForBlocks(defects.Length, (from, to) =>
        {
            for (int v = from; v < to; v++)
            {
                int h = outgoing[v];
                if (h < 0)
                {
                    defects[v] = double.NaN;
                    continue;
                }
                var sum = new AngleSumByRotation();
                bool isBoundary = CornerSum.Around(next, target, positions, positions[v], h, face[h] < 0, ref sum);
                defects[v] = sum.MissingTo(isBoundary ? 1 : 2);
            }
        });
        return defects;
    }

    private static double[] DefectsOfPolygons(Mesh mesh)
    {
        double[] angles = mesh.ComputeCornerAngles();
        var defects = new double[mesh.VertexSlots];
        Array.Fill(defects, double.NaN);
        foreach (Vertex v in mesh.Vertices)
        {
            if (v.IsIsolated)
                continue;
            double sum = 0;
            foreach (HalfEdge h in v.IncomingHalfEdges)
            {
                if (!h.IsBoundary)
                    sum += angles[h.index];
            }
            defects[v.index] = (v.IsBoundary ? Math.PI : 2 * Math.PI) - sum;
        }
        return defects;
    }
}
