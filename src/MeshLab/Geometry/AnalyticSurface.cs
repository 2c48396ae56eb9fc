using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geometry;

/// <summary>A smooth surface whose normals and curvatures are known at every point, and triangle meshes with their vertices on it: the measure for §10.4.5 and §10.7–10.8.</summary>
/// <param name="Name">The surface's name.</param>
/// <param name="Normal">The outward normal at a point, of any length.</param>
/// <param name="Gaussian">K at a point.</param>
/// <param name="Mean">H at a point, positive where the surface is convex.</param>
/// <param name="Mesh">Makes a mesh of about so many vertices per direction (even, at least 4); twice the number halves the edges.</param>
public sealed record AnalyticSurface(
    string Name, Func<Vector3D, Vector3D> Normal, Func<Vector3D, double> Gaussian, Func<Vector3D, double> Mean, Func<int, Mesh> Mesh)
{
    /// <summary>The unit sphere as a subdivided octahedron, the triangles of unequal size.</summary>
    public static AnalyticSurface Sphere { get; } = new("sphere", p => p, _ => 1, _ => 1, n => OnSphere(n, p => p));

    /// <summary>The torus of radii 2 and ½ about the z axis.</summary>
    public static AnalyticSurface Torus { get; } = new(
        "torus",
        p => new(p.X * (1 - (2 / Rho(p))), p.Y * (1 - (2 / Rho(p))), p.Z),
        p => (Rho(p) - 2) / 0.5 / (0.5 * Rho(p)),
        p => (2 + (2 * (Rho(p) - 2))) / (2 * 0.5 * Rho(p)),
        n => Grid(2 * n, n, true, true, (u, v) =>
        {
            double a = 2 * Math.PI * u, b = 2 * Math.PI * v, r = 2 + (0.5 * Math.Cos(b));
            return new(r * Math.Cos(a), r * Math.Sin(a), 0.5 * Math.Sin(b));
        }));

    /// <summary>The ellipsoid with semi-axes 1.5, 1, 0.75.</summary>
    public static AnalyticSurface Ellipsoid { get; } = new(
        "ellipsoid",
        p => new(p.X / 2.25, p.Y, p.Z / 0.5625),
        p => 1 / (2.25 * 0.5625 * W(p) * W(p)),
        p => Math.Abs(p.LengthSquared - 2.25 - 1 - 0.5625) / (2 * 2.25 * 0.5625 * Math.Pow(W(p), 1.5)),
        n => OnSphere(n, p => new(1.5 * p.X, p.Y, 0.75 * p.Z)));

    /// <summary>The catenoid ρ = cosh z for |z| ≤ 1, open, with the axis inside.</summary>
    public static AnalyticSurface Catenoid { get; } = new(
        "catenoid",
        p => new(p.X / Rho(p), p.Y / Rho(p), -Math.Sinh(p.Z)),
        p => -1 / Math.Pow(Math.Cosh(p.Z), 4),
        _ => 0,
        n => Grid(2 * n, n, true, false, (u, v) =>
        {
            double a = 2 * Math.PI * u, z = (2 * v) - 1;
            return new(Math.Cosh(z) * Math.Cos(a), Math.Cosh(z) * Math.Sin(a), z);
        }));

    /// <summary>The cylinder of radius 1 about the z axis for 0 ≤ z ≤ 2, open, with the axis inside.</summary>
    public static AnalyticSurface Cylinder { get; } = new(
        "cylinder",
        p => new(p.X, p.Y, 0),
        _ => 0,
        _ => 0.5,
        n => Grid(2 * n, n, true, false, (u, v) => new(Math.Cos(2 * Math.PI * u), Math.Sin(2 * Math.PI * u), 2 * v)));

    /// <summary>The cone of radius 1 at z = 0 with its apex at z = 2, open: its half 0 ≤ z ≤ 1, since at the apex the curvature has no bound.</summary>
    public static AnalyticSurface Cone { get; } = new(
        "cone",
        p => new(p.X, p.Y, Rho(p) / 2),
        _ => 0,
        p => 1 / (Math.Sqrt(5) * Rho(p)),
        n => Grid(2 * n, n, true, false, (u, v) =>
        {
            double a = 2 * Math.PI * u, r = 1 - (v / 2);
            return new(r * Math.Cos(a), r * Math.Sin(a), v);
        }));

    /// <summary>The hyperbolic paraboloid z = (x² − y²)/2 for |x|, |y| ≤ 1, open, with the normal upward.</summary>
    public static AnalyticSurface HyperbolicParaboloid { get; } = new(
        "hyperbolic paraboloid",
        p => new(-p.X, p.Y, 1),
        p => -1 / ((1 + (p.X * p.X) + (p.Y * p.Y)) * (1 + (p.X * p.X) + (p.Y * p.Y))),
        p => ((p.X * p.X) - (p.Y * p.Y)) / (2 * Math.Pow(1 + (p.X * p.X) + (p.Y * p.Y), 1.5)),
        n => Grid(n, n, false, false, (u, v) =>
        {
            double x = (2 * u) - 1, y = (2 * v) - 1;
            return new(x, y, ((x * x) - (y * y)) / 2);
        }));

    /// <summary>The larger principal curvature at a point, H + √(H² − K).</summary>
    public double MaxCurvature(Vector3D point) => Mean(point) + Math.Sqrt(Math.Max(0, (Mean(point) * Mean(point)) - Gaussian(point)));

    /// <summary>The smaller principal curvature at a point, H − √(H² − K).</summary>
    public double MinCurvature(Vector3D point) => Mean(point) - Math.Sqrt(Math.Max(0, (Mean(point) * Mean(point)) - Gaussian(point)));

    /// <summary>All of them, the doubly curved ones first.</summary>
    public static IReadOnlyList<AnalyticSurface> All { get; } = [Sphere, Torus, Ellipsoid, Catenoid, Cylinder, Cone, HyperbolicParaboloid];

    /// <summary>The name.</summary>
    public override string ToString() => Name;

    private static double Rho(Vector3D p) => Math.Sqrt((p.X * p.X) + (p.Y * p.Y));

    private static double W(Vector3D p) => (p.X * p.X / (2.25 * 2.25)) + (p.Y * p.Y) + (p.Z * p.Z / (0.5625 * 0.5625));

    /// <summary>A grid of n × m cells, sheared a little so that no direction is favoured, each cell cut into two triangles.</summary>
    private static Mesh Grid(int n, int m, bool closedU, bool closedV, Func<double, double, Vector3D> point)
    {
        var builder = new MeshBuilder();
        int columns = closedU ? n : n + 1, rows = closedV ? m : m + 1;
        for (int j = 0; j < rows; j++)
        {
            for (int i = 0; i < columns; i++)
                builder.AddVertex(point((i + (closedU ? 0.5 * j : 0)) / n, (double)j / m));
        }
        // With a shear of half a cell per row, a closed second direction needs an even number of rows and comes back shifted.
        int At(int i, int j) => ((j % rows) * columns) + ((i + (j >= rows && closedU ? rows / 2 : 0)) % columns);
        for (int j = 0; j < m; j++)
        {
            for (int i = 0; i < n; i++)
            {
                builder.AddFace(At(i, j), At(i + 1, j), At(i, j + 1));
                builder.AddFace(At(i + 1, j), At(i + 1, j + 1), At(i, j + 1));
            }
        }
        return builder.Build();
    }

    private static Mesh OnSphere(int n, Func<Vector3D, Vector3D> map)
    {
        var builder = new MeshBuilder();
        var index = new Dictionary<(int, int, int), int>();
        int At(int x, int y, int z)
        {
            if (!index.TryGetValue((x, y, z), out int v))
                index[(x, y, z)] = v = builder.AddVertex(map(new Vector3D(x, y, z).Normalized()));
            return v;
        }
        foreach (int sx in (int[])[1, -1])
        {
            foreach (int sy in (int[])[1, -1])
            {
                foreach (int sz in (int[])[1, -1])
                    AddOctant(sx, sy, sz);
            }
        }
        return builder.Build();

        void AddOctant(int sx, int sy, int sz)
        {
            int P(int i, int j) => At(sx * i, sy * j, sz * (n - i - j));
            for (int i = 0; i < n; i++)
            {
                for (int j = 0; j < n - i; j++)
                {
                    Add(P(i, j), P(i + 1, j), P(i, j + 1));
                    if (i + j < n - 1)
                        Add(P(i + 1, j), P(i + 1, j + 1), P(i, j + 1));
                }
            }

            void Add(int a, int b, int c)
            {
                if (sx * sy * sz > 0)
                    builder.AddFace(a, b, c);
                else
                    builder.AddFace(a, c, b);
            }
        }
    }
}
