using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Generation;

/// <summary>A small beast from a field of melted bones (元球): closed, one component, genus 1, because its tail grows back into its back.</summary>
/// <remarks>
/// The field is −ln Σ exp(−k dᵢ)/k over the distances dᵢ to limbs (chains of tapered capsules along smooth curves),
/// less a fractal skin; its zero surface is marched and evened out.
/// The noise of a scanner (扫描噪声) moves every vertex along its normal by a normally distributed length.
/// </remarks>
public static class Creatures
{
    private const double Sharpness = 26;

    /// <summary>A limb this far away adds less than 10⁻⁶ to the field.</summary>
    private const double Reach = 0.55;

    private static readonly Limb[] Skeleton = BuildSkeleton();

    /// <summary>The beast, facing +x, standing on z = 0.</summary>
    /// <param name="resolution">Cells of the marched lattice per unit; its body is about one unit high. 19 gives about 26,000 faces.</param>
    /// <param name="skin">The height of the skin's bumps.</param>
    /// <param name="noise">The standard deviation of the scanner's noise, in lattice cells.</param>
    /// <param name="seed">For skin and noise.</param>
    /// <exception cref="ArgumentOutOfRangeException">The resolution is not between 16 and 200, or an amplitude is negative or above 0.3.</exception>
    public static Mesh Beast(int resolution = 19, double skin = 0.012, double noise = 0.03, int seed = 1)
    {
        Check.Count(resolution, 16, 200);
        Check.NotNegative(skin);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(skin, 0.3);
        Check.NotNegative(noise);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(noise, 0.3);
        var bumps = new ValueNoise(seed);
        double cell = 1.0 / resolution;
        BoundingBox box = Bounds(0.15 + skin * 2);
        Mesh mesh = ImplicitSurfaces.March(Field, box, cell, smoothing: 6);
        AddNoise(mesh, Field, noise * cell, cell, new Random(seed));
        return mesh;

        double Field(Vector3D p)
        {
            double sum = 0;
            foreach (Limb limb in Skeleton)
            {
                if (!limb.IsBeyond(p, Reach))
                    sum += Math.Exp(-Sharpness * limb.Distance(p));
            }
            if (sum == 0)
                return Reach;
            double body = -Math.Log(sum) / Sharpness;
            // Far away the skin does not matter, and it costs most.
            return Math.Abs(body) > 0.2 ? body : body + skin * bumps.Fractal(8 * p, 2);
        }
    }

    private static void AddNoise(Mesh mesh, Func<Vector3D, double> field, double deviation, double cell, Random random)
    {
        if (deviation == 0)
            return;
        foreach (ref Vector3D p in mesh.Positions)
        {
            // Box and Muller's transform of two uniform numbers.
            double radius = Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())), angle = 2 * Math.PI * random.NextDouble();
            p += deviation * radius * Math.Cos(angle) * ImplicitSurfaces.Gradient(field, p, 1e-3 * cell).Normalized();
        }
    }

    private static BoundingBox Bounds(double margin)
    {
        BoundingBox box = BoundingBox.Empty;
        foreach (Limb limb in Skeleton)
        {
            foreach (Bone bone in limb.Bones)
            {
                double r = Math.Max(bone.RadiusA, bone.RadiusB) + margin;
                Vector3D reach = new(r, r, r);
                box = box.Including(bone.A - reach).Including(bone.A + reach).Including(bone.B - reach).Including(bone.B + reach);
            }
        }
        return box;
    }

    private static Limb[] BuildSkeleton()
    {
        var limbs = new List<Limb>();
        // Trunk, neck and head.
        Add([(-0.62, 0, 0.78, 0.27), (-0.15, 0, 0.8, 0.29), (0.4, 0, 0.84, 0.31)]);
        Add([(0.42, 0, 0.9, 0.24), (0.72, 0, 1.2, 0.17), (0.88, 0, 1.5, 0.15)]);
        Add([(0.86, 0, 1.56, 0.19), (1.14, 0, 1.5, 0.14), (1.4, 0, 1.43, 0.11)]);
        // The tail turns up and grows into the back again.
        Add(
        [
            (-0.75, 0, 0.8, 0.2), (-1.12, 0, 0.74, 0.13), (-1.4, 0, 0.88, 0.11), (-1.5, 0, 1.18, 0.1),
            (-1.34, 0, 1.46, 0.095), (-1.04, 0, 1.54, 0.09), (-0.76, 0, 1.44, 0.09), (-0.56, 0, 1.2, 0.095), (-0.45, 0, 0.95, 0.12),
        ]);
        for (int k = 0; k < 4; k++)
            Add([(-0.18 + 0.19 * k, 0, 1.06, 0.075), (-0.25 + 0.19 * k, 0, 1.28 - 0.03 * Math.Abs(k - 1.5), 0.03)]);
        foreach (double side in (ReadOnlySpan<double>)[1, -1])
        {
            // Fore leg, hind leg, ear, eye.
            Add([(0.4, 0.2 * side, 0.72, 0.16), (0.46, 0.29 * side, 0.4, 0.11), (0.4, 0.3 * side, 0.13, 0.085)]);
            Add([(0.4, 0.3 * side, 0.11, 0.09), (0.54, 0.31 * side, 0.08, 0.075)]);
            Add([(-0.55, 0.2 * side, 0.74, 0.2), (-0.4, 0.29 * side, 0.42, 0.13), (-0.58, 0.3 * side, 0.14, 0.09)]);
            Add([(-0.58, 0.3 * side, 0.11, 0.09), (-0.44, 0.31 * side, 0.08, 0.075)]);
            Add([(0.82, 0.12 * side, 1.68, 0.08), (0.7, 0.24 * side, 1.86, 0.08), (0.54, 0.34 * side, 1.98, 0.035)]);
            Add([(1.09, 0.14 * side, 1.64, 0.06), (1.1, 0.145 * side, 1.645, 0.06)]);
        }
        return [.. limbs];

        void Add((double X, double Y, double Z, double Radius)[] joints) =>
            limbs.Add(new Limb([.. joints.Select(j => (new Vector3D(j.X, j.Y, j.Z), j.Radius))]));
    }

    /// <summary>Capsules along the Catmull–Rom curve through some joints, within a sphere.</summary>
    private sealed class Limb
    {
        private const int BonesPerJoint = 4;

        private readonly Vector3D center;
        private readonly double radius;

        public Limb((Vector3D Place, double Radius)[] joints)
        {
            var bones = new List<Bone>();
            for (int j = 0; j + 1 < joints.Length; j++)
            {
                // A limb of two joints is straight.
                int steps = joints.Length > 2 ? BonesPerJoint : 1;
                for (int s = 0; s < steps; s++)
                {
                    (Vector3D a, double ra) = Along(joints, j, (double)s / steps);
                    (Vector3D b, double rb) = Along(joints, j, (s + 1.0) / steps);
                    bones.Add(new(a, b, ra, rb));
                }
            }
            Bones = [.. bones];
            BoundingBox box = BoundingBox.Of(Bones.SelectMany(bone => new[] { bone.A, bone.B }).ToArray());
            center = box.Center;
            radius = Bones.Max(bone => Math.Max((bone.A - center).Length + bone.RadiusA, (bone.B - center).Length + bone.RadiusB));
        }

        public Bone[] Bones { get; }

        public bool IsBeyond(Vector3D p, double distance)
        {
            double limit = radius + distance;
            return (p - center).LengthSquared > limit * limit;
        }

        public double Distance(Vector3D p)
        {
            double nearest = double.PositiveInfinity;
            foreach (Bone bone in Bones)
                nearest = Math.Min(nearest, bone.Distance(p));
            return nearest;
        }

        private static (Vector3D Place, double Radius) Along((Vector3D Place, double Radius)[] joints, int j, double t)
        {
            (Vector3D p1, double r1) = joints[j];
            (Vector3D p2, double r2) = joints[j + 1];
            Vector3D before = joints[Math.Max(0, j - 1)].Place, after = joints[Math.Min(joints.Length - 1, j + 2)].Place;
            Vector3D m1 = 0.5 * (p2 - before), m2 = 0.5 * (after - p1);
            double t2 = t * t, t3 = t2 * t;
            return ((2 * t3 - 3 * t2 + 1) * p1 + (t3 - 2 * t2 + t) * m1 + (3 * t2 - 2 * t3) * p2 + (t3 - t2) * m2, r1 + (r2 - r1) * t);
        }
    }

    /// <summary>A capsule whose radius changes from one end to the other.</summary>
    private sealed record Bone(Vector3D A, Vector3D B, double RadiusA, double RadiusB)
    {
        private readonly Vector3D axis = B - A;
        private readonly double inverse = 1 / (B - A).LengthSquared;

        public double Distance(Vector3D p)
        {
            Vector3D arm = p - A;
            double t = Math.Clamp(Vector3D.Dot(arm, axis) * inverse, 0, 1);
            return (arm - t * axis).Length - (RadiusA + t * (RadiusB - RadiusA));
        }
    }
}
