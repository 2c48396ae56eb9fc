using MeshLab.Numerics;

namespace MeshLab.Simplification;

/// <summary>The least-squares system of one sweep: (Σ w b bᵀ ⊗ n nᵀ + μ I) δ = Σ w r b ⊗ n over the vertices' displacements δ, by conjugate gradients
/// with the inverse 3 × 3 blocks of the diagonal.</summary>
internal sealed class FitSystem
{
    private const int MaxIterations = 6;
    private const double Reduction = 1e-4;
    private const double Damping = 0.005;
    private readonly FitSurface surface;
    private readonly UncheckedArray<FaceSums> sums;
    private readonly UncheckedArray<bool> isFixed;
    private readonly UncheckedArray<Symmetric3> inverse;
    private readonly UncheckedArray<double> damping;
    private readonly UncheckedArray<Vector3D> residual;

    public FitSystem(FitSurface surface, UncheckedArray<FaceSums> sums, UncheckedArray<bool> isFixed)
    {
        this.surface = surface;
        this.sums = sums;
        this.isFixed = isFixed;
        inverse = new Symmetric3[surface.VertexCount];
        damping = new double[surface.VertexCount];
        residual = new Vector3D[surface.VertexCount];
        Assemble();
    }

    /// <summary>The displacements.</summary>
    public UncheckedArray<Vector3D> Solve()
    {
        int n = surface.VertexCount;
        UncheckedArray<Vector3D> x = new Vector3D[n], z = new Vector3D[n], direction = new Vector3D[n], image = new Vector3D[n];
        double rz = 0;
        for (int v = 0; v < n; v++)
        {
            direction[v] = z[v] = inverse[v].Times(residual[v]);
            rz += Vector3D.Dot(residual[v], z[v]);
        }
        double first = rz;
        for (int k = 0; k < MaxIterations && rz > Reduction * first && rz > 0; k++)
        {
            double energy = Apply(direction, image);
            if (!(energy > 0))
                break;
            double step = rz / energy, following = 0;
            for (int v = 0; v < n; v++)
            {
                x[v] += direction[v] * step;
                residual[v] -= image[v] * step;
                z[v] = inverse[v].Times(residual[v]);
                following += Vector3D.Dot(residual[v], z[v]);
            }
            double turn = following / rz;
            rz = following;
            for (int v = 0; v < n; v++)
                direction[v] = z[v] + direction[v] * turn;
        }
        return x;
    }

    private void Assemble()
    {
        int n = surface.VertexCount;
        UncheckedArray<Symmetric3> diagonal = new Symmetric3[n];
        UncheckedArray<double> area = new double[n], got = new double[n];
        for (int f = 0; f < surface.FaceCount; f++)
        {
            ref FaceSums s = ref sums[f];
            var (a, b, c) = surface.Corners[f];
            Vector3D normal = surface.Normals[f];
            double share = surface.DoubledArea(f).Length * (1 / 12.0);
            Add(a, s.M00, s.G0);
            Add(b, s.M11, s.G1);
            Add(c, s.M22, s.G2);

            void Add(int v, double mass, double gradient)
            {
                diagonal[v].AddOuter(normal, mass);
                residual[v] += normal * gradient;
                area[v] += share;
                got[v] += mass;
            }
        }
        for (int v = 0; v < n; v++)
        {
            // A vertex with few samples around is held more strongly.
            damping[v] = Damping * area[v] + Math.Max(0, area[v] - got[v]) + 1e-30;
            if (isFixed[v])
                residual[v] = default;
            else
                inverse[v] = diagonal[v].InverseWith(damping[v]);
        }
    }

    /// <summary>The product with the matrix.</summary>
    /// <returns>The scalar product of argument and image.</returns>
    private double Apply(UncheckedArray<Vector3D> x, UncheckedArray<Vector3D> image)
    {
        for (int v = 0; v < x.Length; v++)
            image[v] = x[v] * damping[v];
        for (int f = 0; f < surface.FaceCount; f++)
        {
            ref FaceSums s = ref sums[f];
            var (a, b, c) = surface.Corners[f];
            Vector3D normal = surface.Normals[f];
            double ta = Vector3D.Dot(normal, x[a]), tb = Vector3D.Dot(normal, x[b]), tc = Vector3D.Dot(normal, x[c]);
            image[a] += normal * (s.M00 * ta + s.M01 * tb + s.M02 * tc);
            image[b] += normal * (s.M01 * ta + s.M11 * tb + s.M12 * tc);
            image[c] += normal * (s.M02 * ta + s.M12 * tb + s.M22 * tc);
        }
        double energy = 0;
        for (int v = 0; v < x.Length; v++)
        {
            if (isFixed[v])
                image[v] = default;
            energy += Vector3D.Dot(x[v], image[v]);
        }
        return energy;
    }

    private struct Symmetric3
    {
        private double xx;
        private double xy;
        private double xz;
        private double yy;
        private double yz;
        private double zz;

        public void AddOuter(Vector3D n, double weight)
        {
            xx += weight * n.X * n.X;
            xy += weight * n.X * n.Y;
            xz += weight * n.X * n.Z;
            yy += weight * n.Y * n.Y;
            yz += weight * n.Y * n.Z;
            zz += weight * n.Z * n.Z;
        }

        public readonly Vector3D Times(Vector3D v) =>
            new(xx * v.X + xy * v.Y + xz * v.Z, xy * v.X + yy * v.Y + yz * v.Z, xz * v.X + yz * v.Y + zz * v.Z);

        /// <summary>The inverse after adding a multiple of the identity; zero if there is none.</summary>
        public readonly Symmetric3 InverseWith(double shift)
        {
            double a = xx + shift, b = yy + shift, c = zz + shift;
            double c11 = b * c - yz * yz, c12 = xz * yz - xy * c, c13 = xy * yz - xz * b;
            double determinant = a * c11 + xy * c12 + xz * c13;
            double scale = determinant > 0 ? 1 / determinant : 0;
            return new Symmetric3
            {
                xx = c11 * scale,
                xy = c12 * scale,
                xz = c13 * scale,
                yy = (a * c - xz * xz) * scale,
                yz = (xy * xz - a * yz) * scale,
                zz = (a * b - xy * xy) * scale,
            };
        }
    }
}
