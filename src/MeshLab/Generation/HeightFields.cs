using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Generation;

/// <summary>Graphs of functions z = f(x, y) over a centred grid (高度场), among them a fractal terrain and a sheet with holes.</summary>
public static class HeightFields
{
    /// <summary>The graph of a function. O(mn).</summary>
    /// <param name="m">Vertices along x, at least 2.</param>
    /// <param name="n">Vertices along y, at least 2.</param>
    /// <param name="height">The function of x and y.</param>
    /// <param name="width">The extent along x.</param>
    /// <param name="depth">The extent along y.</param>
    /// <param name="faces">Triangles or quadrilaterals.</param>
    /// <exception cref="ArgumentException">A count is below 2, a length is not finite and positive, or a value of the function is not finite.</exception>
    public static Mesh Create(
        int m, int n, Func<double, double, double> height, double width = 1, double depth = 1, PatchFaces faces = PatchFaces.Triangles)
    {
        ArgumentNullException.ThrowIfNull(height);
        Check.Count(m, 2);
        Check.Count(n, 2);
        Check.Positive(width);
        Check.Positive(depth);
        Check.Elements(m, n, nameof(m));
        return new Patch(m - 1, n - 1, Faces: faces).Build((i, j) =>
        {
            double x = Centered(i, m) * width, y = Centered(j, n) * depth;
            return new Vector3D(x, y, height(x, y));
        });
    }

    /// <summary>A landscape: five octaves of noise over the unit square.</summary>
    /// <param name="n">Vertices per side, at least 2.</param>
    /// <param name="roughness">The height of the mountains.</param>
    /// <param name="seed">Another seed, another landscape.</param>
    /// <exception cref="ArgumentOutOfRangeException">The count is below 2, or the roughness is negative.</exception>
    public static Mesh Terrain(int n = 96, double roughness = 0.3, int seed = 1)
    {
        Check.NotNegative(roughness);
        var noise = new ValueNoise(seed);
        return Create(n, n, (x, y) => roughness * noise.Fractal(new Vector3D(3 * x, 3 * y, 0.5), 5));
    }

    /// <summary>The saddle z = (x² − y²)/a (双曲抛物面): Gaussian curvature −4/a² and mean curvature 0 at the origin.</summary>
    /// <param name="n">Vertices per side, at least 2.</param>
    /// <param name="a">The larger, the flatter.</param>
    /// <param name="width">The extent along x and y.</param>
    /// <exception cref="ArgumentOutOfRangeException">The count is below 2, or a length is not finite and positive.</exception>
    public static Mesh HyperbolicParaboloid(int n = 33, double a = 1, double width = 1)
    {
        Check.Positive(a);
        return Create(n, n, (x, y) => (x * x - y * y) / a, width, width);
    }

    /// <summary>A wavy square sheet with round holes (带孔曲面): one outer boundary loop and one per hole.</summary>
    /// <remarks>The sheet is a board of holes × holes fields; rings of cells lead from the rim of each field to the circle in its middle.</remarks>
    /// <param name="holes">Holes per side, from 1 to 16: the sheet has the square of it.</param>
    /// <param name="resolution">Cells per side of a field, from 2 to 512.</param>
    /// <param name="amplitude">The height of the waves.</param>
    /// <exception cref="ArgumentOutOfRangeException">A count is out of range, or the amplitude is negative.</exception>
    public static Mesh PerforatedSheet(int holes = 3, int resolution = 16, double amplitude = 0.08)
    {
        Check.Count(holes, 1, 16);
        Check.Count(resolution, 2, 512);
        Check.NotNegative(amplitude);
        int perRow = holes * resolution + 1, around = 4 * resolution, rings = Math.Max(1, resolution / 2);
        var builder = new MeshBuilder();
        var rim = new Dictionary<(int, int), int>();
        for (int field = 0; field < holes * holes; field++)
            AddField(field % holes, field / holes);
        return builder.Build();

        void AddField(int x, int y)
        {
            var center = new Vector2D((x + 0.5) / holes - 0.5, (y + 0.5) / holes - 0.5);
            var ring = new int[around];
            for (int k = 0; k < around; k++)
                ring[k] = RimVertex(AlongRim(x, y, k));
            for (int r = 1; r <= rings; r++)
            {
                var inner = new int[around];
                for (int k = 0; k < around; k++)
                {
                    Vector2D edge = Place(AlongRim(x, y, k)), circle = center + 0.25 / holes / (edge - center).Length * (edge - center);
                    inner[k] = builder.AddVertex(Raised(Vector2D.Lerp(edge, circle, (double)r / rings)));
                }
                for (int k = 0; k < around; k++)
                {
                    int next = (k + 1) % around;
                    builder.AddFace(ring[k], ring[next], inner[next]);
                    builder.AddFace(ring[k], inner[next], inner[k]);
                }
                ring = inner;
            }
        }

        // Counter-clockwise around the field, from its lower left corner.
        (int I, int J) AlongRim(int x, int y, int k)
        {
            int side = k / resolution, along = k % resolution;
            (int i, int j) = side switch
            {
                0 => (along, 0),
                1 => (resolution, along),
                2 => (resolution - along, resolution),
                _ => (0, resolution - along),
            };
            return (x * resolution + i, y * resolution + j);
        }

        int RimVertex((int I, int J) point)
        {
            if (!rim.TryGetValue(point, out int vertex))
                rim[point] = vertex = builder.AddVertex(Raised(Place(point)));
            return vertex;
        }

        Vector2D Place((int I, int J) point) => new(Centered(point.I, perRow), Centered(point.J, perRow));

        Vector3D Raised(Vector2D p) => new(p.X, p.Y, amplitude * Math.Sin(2 * Math.PI * p.X) * Math.Cos(2 * Math.PI * p.Y));
    }

    /// <summary>i/(n − 1) − 1/2, so that i and n − 1 − i give exact negatives.</summary>
    internal static double Centered(int i, int n) => (2.0 * i - (n - 1)) / (2.0 * (n - 1));
}
