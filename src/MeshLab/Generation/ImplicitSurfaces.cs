using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Generation;

/// <summary>Zero surfaces of functions (隐式曲面) by marching tetrahedra.</summary>
/// <remarks>
/// Every cube of a lattice is cut into the six tetrahedra around one diagonal (Kuhn), the same way in all cubes, so that neighbours agree on
/// their common faces. A tetrahedron with corners on both sides gives one or two triangles. Their corners sit on lattice edges and each is made
/// once, so the result is a closed 2-manifold whatever the function: marching cubes with the table of Lorensen and Cline 1987 is not.
/// Doi and Koide 1991. O(lattice points).
/// </remarks>
public static class ImplicitSurfaces
{
    private const int MostPoints = 60_000_000;

    /// <summary>The even permutations that bring the corners inside (by bit mask) to the front; for three inside, the one outside.</summary>
    private static readonly byte[][] InsideFirst =
    [
        [], [0, 1, 2, 3], [1, 0, 3, 2], [0, 1, 2, 3], [2, 3, 0, 1], [0, 2, 3, 1], [1, 2, 0, 3], [3, 2, 1, 0],
        [3, 2, 1, 0], [0, 3, 1, 2], [1, 3, 2, 0], [2, 3, 0, 1], [2, 3, 0, 1], [1, 0, 3, 2], [0, 1, 2, 3], [],
    ];

    /// <summary>The six tetrahedra of a cube as corner masks (x = 1, y = 2, z = 4), positively oriented.</summary>
    private static readonly byte[][] Tetrahedra =
    [
        [0, 1, 3, 7], [0, 5, 1, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 4, 5, 7], [0, 6, 4, 7],
    ];

    /// <summary>The surface where a function is 0; it is negative inside.</summary>
    /// <param name="field">The function; it must be positive on the faces of the box, and finite.</param>
    /// <param name="box">Where to look.</param>
    /// <param name="cell">The edge of the lattice's cubes. Parts smaller than that may be missed.</param>
    /// <param name="smoothing">Rounds of moving each vertex to the middle of its neighbours and back onto the surface: evens the triangles out.</param>
    /// <exception cref="ArgumentException">The box is empty, the cell is not positive or would need more than 60 million points, the function is not finite, or the surface leaves the box.</exception>
    public static Mesh March(Func<Vector3D, double> field, BoundingBox box, double cell, int smoothing = 0)
    {
        ArgumentNullException.ThrowIfNull(field);
        Check.Positive(cell);
        ArgumentOutOfRangeException.ThrowIfNegative(smoothing);
        if (box.IsEmpty || !box.Min.IsFinite || !box.Max.IsFinite)
            throw new ArgumentException("The box is empty or not finite.", nameof(box));
        var lattice = Lattice.Over(box, cell);
        double[] values = Sample(field, lattice);
        Mesh mesh = Extract(lattice, values);
        for (int round = 0; round < smoothing; round++)
            Even(mesh, field, cell);
        return mesh;
    }

    private static double[] Sample(Func<Vector3D, double> field, Lattice lattice)
    {
        var values = new double[lattice.Count];
        for (int k = 0, p = 0; k < lattice.Z; k++)
        {
            for (int j = 0; j < lattice.Y; j++)
            {
                for (int i = 0; i < lattice.X; i++, p++)
                {
                    double value = values[p] = field(lattice.Place(i, j, k));
                    if (!double.IsFinite(value))
                        throw new ArgumentException($"The function is {value} at {lattice.Place(i, j, k)}.", nameof(field));
                    if (value < 0 && (i == 0 || j == 0 || k == 0 || i == lattice.X - 1 || j == lattice.Y - 1 || k == lattice.Z - 1))
                        throw new ArgumentException($"The surface leaves the box near {lattice.Place(i, j, k)}.", nameof(field));
                }
            }
        }
        return values;
    }

    private static Mesh Extract(Lattice lattice, double[] values)
    {
        // Lattice edges by lower end and direction (mask − 1).
        var vertexOn = new Dictionary<int, int>();
        var positions = new List<Vector3D>();
        var corners = new List<int>();
        Span<int> point = stackalloc int[8];
        for (int k = 0; k + 1 < lattice.Z; k++)
        {
            for (int j = 0; j + 1 < lattice.Y; j++)
            {
                for (int i = 0; i + 1 < lattice.X; i++)
                {
                    int inside = 0;
                    for (int mask = 0; mask < 8; mask++)
                    {
                        point[mask] = lattice.Index(i + (mask & 1), j + (mask >> 1 & 1), k + (mask >> 2));
                        if (values[point[mask]] < 0)
                            inside++;
                    }
                    if (inside is 0 or 8)
                        continue;
                    foreach (byte[] tetrahedron in Tetrahedra)
                        AddTriangles(tetrahedron, point);
                }
            }
        }
        return MeshBuilder.FromSoup(PolygonSoup.FromTriangles(positions.ToArray(), corners.ToArray()), NonManifoldPolicy.Throw, out _);

        void AddTriangles(byte[] tetrahedron, ReadOnlySpan<int> point)
        {
            int mask = 0;
            for (int c = 0; c < 4; c++)
            {
                if (values[point[tetrahedron[c]]] < 0)
                    mask |= 1 << c;
            }
            byte[] order = InsideFirst[mask];
            if (order.Length == 0)
                return;
            int a = tetrahedron[order[0]], b = tetrahedron[order[1]], c2 = tetrahedron[order[2]], d = tetrahedron[order[3]];
            switch (int.PopCount(mask))
            {
                case 1:
                    corners.AddRange([On(a, b, point), On(a, c2, point), On(a, d, point)]);
                    break;
                case 3:
                    corners.AddRange([On(a, b, point), On(a, d, point), On(a, c2, point)]);
                    break;
                default:
                    int ac = On(a, c2, point), ad = On(a, d, point), bd = On(b, d, point), bc = On(b, c2, point);
                    corners.AddRange([ac, ad, bd, ac, bd, bc]);
                    break;
            }
        }

        int On(int from, int to, ReadOnlySpan<int> point)
        {
            // Along the diagonal's order the lower end is the one with fewer bits.
            if (from > to)
                (from, to) = (to, from);
            int key = point[from] * 7 + (to - from - 1);
            if (!vertexOn.TryGetValue(key, out int vertex))
            {
                vertexOn[key] = vertex = positions.Count;
                double s = values[point[from]], t = values[point[to]];
                // Kept away from the ends, where vertices of several edges would fall together.
                positions.Add(Vector3D.Lerp(lattice.Place(point[from]), lattice.Place(point[to]), Math.Clamp(s / (s - t), 0.02, 0.98)));
            }
            return vertex;
        }
    }

    private static void Even(Mesh mesh, Func<Vector3D, double> field, double cell)
    {
        var moved = new Vector3D[mesh.VertexSlots];
        foreach (Vertex v in mesh.Vertices)
        {
            Vector3D sum = default;
            int count = 0;
            foreach (Vertex w in v.Neighbors)
            {
                sum += w.Position;
                count++;
            }
            moved[v.Index] = Project(Vector3D.Lerp(v.Position, sum / count, 0.7), field, cell);
        }
        moved.CopyTo(mesh.Positions);
    }

    /// <summary>Two Newton steps along the gradient, by central differences; none longer than a quarter of a cell.</summary>
    private static Vector3D Project(Vector3D p, Func<Vector3D, double> field, double cell)
    {
        double step = 1e-4 * cell;
        for (int round = 0; round < 2; round++)
        {
            Vector3D gradient = Gradient(field, p, step);
            double squared = gradient.LengthSquared;
            if (!(squared > 0))
                break;
            Vector3D move = field(p) / squared * gradient;
            double length = move.Length;
            p -= length > cell / 4 ? cell / 4 / length * move : move;
        }
        return p;
    }

    internal static Vector3D Gradient(Func<Vector3D, double> field, Vector3D p, double step)
    {
        Vector3D x = new(step, 0, 0), y = new(0, step, 0), z = new(0, 0, step);
        return new Vector3D(field(p + x) - field(p - x), field(p + y) - field(p - y), field(p + z) - field(p - z)) / (2 * step);
    }

    private readonly record struct Lattice(Vector3D Origin, double Cell, int X, int Y, int Z)
    {
        public int Count => X * Y * Z;

        public static Lattice Over(BoundingBox box, double cell)
        {
            Vector3D size = box.Size;
            double x = Math.Ceiling(size.X / cell) + 1, y = Math.Ceiling(size.Y / cell) + 1, z = Math.Ceiling(size.Z / cell) + 1;
            if (x * y * z > MostPoints)
                throw new ArgumentOutOfRangeException(nameof(cell), cell, $"The lattice would have {x} × {y} × {z} points; {MostPoints} are allowed.");
            Vector3D extent = new((x - 1) * cell, (y - 1) * cell, (z - 1) * cell);
            return new(box.Center - extent / 2, cell, (int)x, (int)y, (int)z);
        }

        public int Index(int i, int j, int k) => (k * Y + j) * X + i;

        public Vector3D Place(int i, int j, int k) => Origin + Cell * new Vector3D(i, j, k);

        public Vector3D Place(int index) => Place(index % X, index / X % Y, index / (X * Y));
    }
}
