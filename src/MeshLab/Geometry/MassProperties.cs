using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geometry;

/// <summary>A symmetric 3 × 3 tensor of inertia (惯性张量).</summary>
/// <param name="XX">∫ y² + z².</param>
/// <param name="YY">∫ z² + x².</param>
/// <param name="ZZ">∫ x² + y².</param>
/// <param name="XY">−∫ xy.</param>
/// <param name="YZ">−∫ yz.</param>
/// <param name="ZX">−∫ zx.</param>
public readonly record struct InertiaTensor(double XX, double YY, double ZZ, double XY, double YZ, double ZX)
{
    /// <summary>XX + YY + ZZ, which does not change under rotation.</summary>
    public double Trace => XX + YY + ZZ;
}

/// <summary>Surface and solid as masses of density 1.</summary>
/// <param name="Area">The area.</param>
/// <param name="Volume">§10.2 体积: the signed volume, positive if the normals point outward. Of an open mesh: of the cone over it from the origin.</param>
/// <param name="SurfaceCentroid">The centroid of the surface (形心), weighted by area; NaN if the area is zero.</param>
/// <param name="VolumeCentroid">The centroid of the solid (or of that cone); NaN if the volume is zero.</param>
/// <param name="Inertia">The inertia of the solid about its centroid.</param>
/// <param name="ZeroAreaFaces">How many faces have zero area.</param>
public sealed record MassProperties(
    double Area, double Volume, Vector3D SurfaceCentroid, Vector3D VolumeCentroid, InertiaTensor Inertia, int ZeroAreaFaces);

/// <summary>§10.2 体积 (signed volume), centroids and inertia by summing tetrahedra over the faces.</summary>
/// <remarks>
/// V = Σ det(a, b, c) / 6 over the triangles, which for a closed mesh does not depend on the origin; its sums are taken about the centre of the
/// bounding box, so that a shape far from the origin keeps its digits. Polygons are summed as fans of their first vertex: exact if they are flat.
/// Moments: ∫ xᵢxⱼ over a tetrahedron (0, a, b, c) = det/120 · (sᵢsⱼ + aᵢaⱼ + bᵢbⱼ + cᵢcⱼ), s = a + b + c (Lien, Kajiya 1984). O(H), in parallel.
/// </remarks>
public static class Volumes
{
    extension(Mesh mesh)
    {
        /// <summary>§10.2 体积: the signed volume in cubic model units; of an open mesh, of the cone over it from the origin.</summary>
        public double Volume => mesh.ComputeMassProperties().Volume;

        /// <summary>Area, volume, centroids and inertia in one pass.</summary>
        public MassProperties ComputeMassProperties()
        {
            ArgumentNullException.ThrowIfNull(mesh);
            Vector3D origin = mesh.Vertices.Count == 0 || !mesh.IsClosed ? default : mesh.BoundingBox.Center;
            var blocks = new Moments[(mesh.FaceSlots + Parallelism.BlockSize - 1) / Parallelism.BlockSize];
            Parallelism.ForBlocks(mesh.FaceSlots, (from, to) => blocks[from / Parallelism.BlockSize] = Moments.OfFaces(mesh, origin, from, to));
            var total = new Moments();
            foreach (Moments block in blocks)
                total.Add(block);
            return total.ToProperties(origin);
        }
    }

    /// <summary>Sums over faces about an origin. Volume terms are six times too large, second moments twenty times more.</summary>
    private struct Moments
    {
        private double area;
        private Vector3D areaMoment;
        private double volume;
        private Vector3D first;
        private Vector3D squares;
        private Vector3D products;
        private int zeroAreaFaces;

        public static Moments OfFaces(Mesh mesh, Vector3D origin, int from, int to)
        {
            int[] next = mesh.next, target = mesh.target, halfEdgeOf = mesh.halfEdgeOf;
            Vector3D[] positions = mesh.positions;
            var sums = new Moments();
            for (int f = from; f < to; f++)
            {
                int start = halfEdgeOf[f];
                if (start < 0)
                    continue;
                Vector3D vector = Areas.DoubleArea(next, target, positions, start), normal = vector.Normalized();
                if (normal == default)
                    sums.zeroAreaFaces++;
                Vector3D a = positions[target[start ^ 1]] - origin, b = positions[target[start]] - origin;
                for (int h = next[start]; next[h] != start; h = next[h])
                {
                    Vector3D c = positions[target[h]] - origin;
                    sums.AddTriangle(a, b, c, normal);
                    b = c;
                }
            }
            return sums;
        }

        /// <summary>Adds one triangle of a face; in a fan of a polygon that is not convex, some count negative by the face's normal.</summary>
        private void AddTriangle(Vector3D a, Vector3D b, Vector3D c, Vector3D normal)
        {
            Vector3D sum = a + b + c, cross = Vector3D.Cross(b - a, c - a);
            double doubleArea = Vector3D.Dot(cross, normal), det = Vector3D.Dot(a, cross);
            area += doubleArea;
            areaMoment += doubleArea * sum;
            volume += det;
            first += det * sum;
            squares += det * new Vector3D(
                sum.X * sum.X + a.X * a.X + b.X * b.X + c.X * c.X,
                sum.Y * sum.Y + a.Y * a.Y + b.Y * b.Y + c.Y * c.Y,
                sum.Z * sum.Z + a.Z * a.Z + b.Z * b.Z + c.Z * c.Z);
            products += det * new Vector3D(
                sum.X * sum.Y + a.X * a.Y + b.X * b.Y + c.X * c.Y,
                sum.Y * sum.Z + a.Y * a.Z + b.Y * b.Z + c.Y * c.Z,
                sum.Z * sum.X + a.Z * a.X + b.Z * b.X + c.Z * c.X);
        }

        public void Add(Moments other)
        {
            area += other.area;
            areaMoment += other.areaMoment;
            volume += other.volume;
            first += other.first;
            squares += other.squares;
            products += other.products;
            zeroAreaFaces += other.zeroAreaFaces;
        }

        public readonly MassProperties ToProperties(Vector3D origin)
        {
            double v = volume / 6;
            Vector3D center = first / (4 * volume);
            Vector3D s = squares / 120 - v * new Vector3D(center.X * center.X, center.Y * center.Y, center.Z * center.Z);
            Vector3D p = products / 120 - v * new Vector3D(center.X * center.Y, center.Y * center.Z, center.Z * center.X);
            return new(
                area / 2,
                v,
                origin + areaMoment / (3 * area),
                origin + center,
                new(s.Y + s.Z, s.Z + s.X, s.X + s.Y, -p.X, -p.Y, -p.Z),
                zeroAreaFaces);
        }
    }
}
