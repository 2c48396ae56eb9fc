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
    private readonly UncheckedArray<bool> isFixed;

    /// <summary>Per vertex the inverse of the diagonal block; while assembling, the block itself.</summary>
    private readonly UncheckedArray<Symmetric3> inverse;
    private readonly UncheckedArray<double> damping;
    private readonly UncheckedArray<Vector3D> residual;
    private readonly UncheckedArray<Vector3D> solution;
    private readonly UncheckedArray<Vector3D> direction;
    private readonly UncheckedArray<Vector3D> image;
    private UncheckedArray<FaceSums> sums;

    /// <summary>Room for the systems of all sweeps.</summary>
    public FitSystem(FitSurface surface, UncheckedArray<bool> isFixed)
    {
        this.surface = surface;
        this.isFixed = isFixed;
        int n = surface.VertexCount;
        inverse = new Symmetric3[n];
        damping = new double[n];
        residual = new Vector3D[n];
        solution = new Vector3D[n];
        direction = new Vector3D[n];
        image = new Vector3D[n];
    }

    /// <summary>The displacements for what the samples add up to; valid until the next call.</summary>
    public UncheckedArray<Vector3D> Solve(UncheckedArray<FaceSums> faceSums)
    {
        sums = faceSums;
        Assemble();
        int n = surface.VertexCount;
        double rz = 0;
        for (int v = 0; v < n; v++)
        {
            solution[v] = default;
            direction[v] = inverse[v].Times(residual[v]);
            rz += Vector3D.Dot(residual[v], direction[v]);
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
                solution[v] += direction[v] * step;
                residual[v] -= image[v] * step;
                // The image has served; its room takes the preconditioned residual.
                image[v] = inverse[v].Times(residual[v]);
                following += Vector3D.Dot(residual[v], image[v]);
            }
            double turn = following / rz;
            rz = following;
            for (int v = 0; v < n; v++)
                direction[v] = image[v] + direction[v] * turn;
        }
        return solution;
    }

    private void Assemble()
    {
        int n = surface.VertexCount;
        Array.Clear(inverse.Items);
        Array.Clear(residual.Items);
        Array.Clear(damping.Items);
        UncheckedArray<double> got = new double[n];
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
                inverse[v].AddOuter(normal, mass);
                residual[v] += normal * gradient;
                damping[v] += share;
                got[v] += mass;
            }
        }
        for (int v = 0; v < n; v++)
        {
            // A vertex with few samples around is held more strongly.
            double area = damping[v];
            damping[v] = Damping * area + Math.Max(0, area - got[v]) + 1e-30;
            if (isFixed[v])
            {
                // Directions go through the inverse, so nothing moves the vertex.
                (residual[v], inverse[v]) = (default, default);
            }
            else
            {
                inverse[v] = inverse[v].InverseWith(damping[v]);
            }
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
            energy += Vector3D.Dot(x[v], image[v]);
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
