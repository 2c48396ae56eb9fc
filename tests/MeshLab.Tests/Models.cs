using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests;

/// <summary>Small meshes of every sort, by name, for theories: <c>[MemberData(nameof(Models.All), MemberType = typeof(Models))]</c>.</summary>
/// <remarks>A theory is given the name and calls <see cref="Create"/>, which makes a fresh mesh each time.</remarks>
public static class Models
{
    private static readonly SortedDictionary<string, (Func<Mesh> Create, Sort Sort)> Recipes = new(StringComparer.Ordinal)
    {
        ["annulus"] = (() => Annulus(12), Sort.Triangles),
        ["bipyramid-1200"] = (() => Bipyramid(1200), Sort.Triangles | Sort.Closed),
        ["bumpy-sphere"] = (() => BumpySphere(10, 14), Sort.Triangles | Sort.Closed),
        ["components"] = (Components, Sort.Triangles),
        ["cube"] = (() => Triangulated(Voxels(1, 1, 1)), Sort.Triangles | Sort.Closed),
        ["cube-quads"] = (() => Voxels(1, 1, 1), Sort.Closed),
        ["empty"] = (() => new Mesh(), Sort.Triangles | Sort.Closed | Sort.Flat),
        ["fan-1200"] = (() => Fan(1200), Sort.Triangles),
        ["far-away"] = (() => Moved(Sphere(8, 10), 1, new(1e6, -1e6, 1e6)), Sort.Triangles | Sort.Closed),
        ["genus-2"] = (() => Triangulated(GenusTwo()), Sort.Triangles | Sort.Closed),
        ["genus-2-quads"] = (GenusTwo, Sort.Closed),
        ["grid"] = (() => Triangulated(QuadGrid(7, 6)), Sort.Triangles),
        ["grid-quads"] = (() => QuadGrid(6, 5), Sort.None),
        ["holes"] = (GridWithHoles, Sort.Triangles),
        ["isolated-vertices"] = (TetrahedronAndPoints, Sort.Triangles | Sort.Closed),
        ["mixed-polygons"] = (MixedPolygons, Sort.None),
        ["open-fan"] = (() => MeshBuilder.FromTriangles([new(0, 0, 0), new(2, 0, 0), new(2, 2, 0), new(0, 2, 1), new(-2, 1, 0)], [0, 1, 2, 0, 2, 3, 0, 3, 4]), Sort.Triangles),
        ["one-triangle"] = (() => MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 0, 0), new(0, 1, 0)], [0, 1, 2]), Sort.Triangles),
        ["octahedron"] = (() => Bipyramid(4), Sort.Triangles | Sort.Closed),
        ["prism-6"] = (() => Prism(6), Sort.Closed),
        ["slivers"] = (() => Scaled(Triangulated(QuadGrid(9, 5)), new(1, 1e-5, 1)), Sort.Triangles),
        ["sphere"] = (() => Sphere(8, 10), Sort.Triangles | Sort.Closed),
        ["tetrahedron"] = (Tetrahedron, Sort.Triangles | Sort.Closed),
        ["tiny"] = (() => Moved(Sphere(8, 10), 1e-6, default), Sort.Triangles | Sort.Closed),
        ["torus"] = (() => Torus(12, 8), Sort.Triangles | Sort.Closed),
    };

    [Flags]
    private enum Sort
    {
        None = 0,
        Triangles = 1,
        Closed = 2,
        Flat = 4,
    }

    /// <summary>The names of all models.</summary>
    public static IReadOnlyList<string> Names { get; } = [.. Recipes.Keys];

    /// <summary>All models.</summary>
    public static TheoryData<string> All => Select(_ => true);

    /// <summary>All models whose faces are triangles, the empty one too.</summary>
    public static TheoryData<string> TriangleMeshes => Select(sort => sort.HasFlag(Sort.Triangles));

    /// <summary>Models with faces of more than three vertices.</summary>
    public static TheoryData<string> PolygonMeshes => Select(sort => !sort.HasFlag(Sort.Triangles));

    /// <summary>Models without boundary; not the empty one.</summary>
    public static TheoryData<string> ClosedMeshes => Select(sort => sort.HasFlag(Sort.Closed) && !sort.HasFlag(Sort.Flat));

    /// <summary>Triangle meshes without boundary; not the empty one.</summary>
    public static TheoryData<string> ClosedTriangleMeshes =>
        Select(sort => sort.HasFlag(Sort.Closed | Sort.Triangles) && !sort.HasFlag(Sort.Flat));

    /// <summary>Models with a boundary.</summary>
    public static TheoryData<string> BoundaryMeshes => Select(sort => !sort.HasFlag(Sort.Closed));

    /// <summary>Makes a model anew.</summary>
    public static Mesh Create(string name) => Recipes[name].Create();

    /// <summary>The regular tetrahedron on four corners of a cube, counter-clockwise from outside.</summary>
    public static Mesh Tetrahedron() => MeshBuilder.FromTriangles(
        [new(1, 1, 1), new(1, -1, -1), new(-1, 1, -1), new(-1, -1, 1)],
        [0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2]);

    /// <summary>Quads in the plane z = 0 over [0, 1]², <paramref name="columns"/> × <paramref name="rows"/> of them.</summary>
    public static Mesh QuadGrid(int columns, int rows)
    {
        var builder = new MeshBuilder();
        for (int j = 0; j <= rows; j++)
        {
            for (int i = 0; i <= columns; i++)
                builder.AddVertex(new((double)i / columns, (double)j / rows, 0));
        }
        int w = columns + 1;
        for (int j = 0; j < rows; j++)
        {
            for (int i = 0; i < columns; i++)
                builder.AddFace((j * w) + i, (j * w) + i + 1, ((j + 1) * w) + i + 1, ((j + 1) * w) + i);
        }
        return builder.Build();
    }

    /// <summary>A triangle fan around vertex 0 with <paramref name="n"/> triangles, closed around it.</summary>
    public static Mesh Fan(int n)
    {
        var builder = new MeshBuilder();
        builder.AddVertex(default);
        for (int i = 0; i < n; i++)
            builder.AddVertex(OnCircle(i, n, 0));
        for (int i = 0; i < n; i++)
            builder.AddFace(0, 1 + i, 1 + ((i + 1) % n));
        return builder.Build();
    }

    /// <summary>Two cones over a ring of <paramref name="n"/> vertices; vertices n and n + 1 are the apexes.</summary>
    public static Mesh Bipyramid(int n)
    {
        var builder = new MeshBuilder();
        for (int i = 0; i < n; i++)
            builder.AddVertex(OnCircle(i, n, 0));
        int top = builder.AddVertex(new(0, 0, 1)), bottom = builder.AddVertex(new(0, 0, -1));
        for (int i = 0; i < n; i++)
        {
            builder.AddFace(i, (i + 1) % n, top);
            builder.AddFace((i + 1) % n, i, bottom);
        }
        return builder.Build();
    }

    /// <summary>A ring of quads between two polygons with <paramref name="n"/> corners.</summary>
    public static Mesh Prism(int n)
    {
        var builder = new MeshBuilder();
        for (int i = 0; i < 2 * n; i++)
            builder.AddVertex(OnCircle(i % n, n, i < n ? -0.5 : 0.5));
        for (int i = 0; i < n; i++)
            builder.AddFace(i, (i + 1) % n, n + ((i + 1) % n), n + i);
        builder.AddFace([.. Enumerable.Range(0, n).Reverse()]);
        builder.AddFace([.. Enumerable.Range(n, n)]);
        return builder.Build();
    }

    /// <summary>A torus of 2 · <paramref name="around"/> · <paramref name="across"/> triangles, radii 1 and 0.4.</summary>
    public static Mesh Torus(int around, int across)
    {
        var builder = new MeshBuilder();
        for (int i = 0; i < around; i++)
        {
            for (int j = 0; j < across; j++)
            {
                double u = 2 * Math.PI * i / around, v = 2 * Math.PI * j / across, r = 1 + (0.4 * Math.Cos(v));
                builder.AddVertex(new(r * Math.Cos(u), r * Math.Sin(u), 0.4 * Math.Sin(v)));
            }
        }
        int At(int i, int j) => (i % around * across) + (j % across);
        for (int i = 0; i < around; i++)
        {
            for (int j = 0; j < across; j++)
            {
                builder.AddFace(At(i, j), At(i + 1, j), At(i + 1, j + 1));
                builder.AddFace(At(i, j), At(i + 1, j + 1), At(i, j + 1));
            }
        }
        return builder.Build();
    }

    /// <summary>A unit sphere with <paramref name="rings"/> rings of latitude between two poles.</summary>
    public static Mesh Sphere(int rings, int around) => BumpySphere(rings, around, 0);

    /// <summary>A sphere whose radius varies; every vertex different.</summary>
    public static Mesh BumpySphere(int rings, int around, double bump = 0.2)
    {
        var random = new Random(7);
        var builder = new MeshBuilder();
        for (int i = 0; i < rings; i++)
        {
            for (int j = 0; j < around; j++)
            {
                double theta = Math.PI * (i + 1) / (rings + 1), phi = 2 * Math.PI * j / around, r = 1 + (bump * (random.NextDouble() - 0.5));
                builder.AddVertex(new(r * Math.Sin(theta) * Math.Cos(phi), r * Math.Sin(theta) * Math.Sin(phi), r * Math.Cos(theta)));
            }
        }
        int north = builder.AddVertex(new(0, 0, 1)), south = builder.AddVertex(new(0, 0, -1));
        int At(int i, int j) => (i * around) + (j % around);
        for (int j = 0; j < around; j++)
        {
            builder.AddFace(north, At(0, j), At(0, j + 1));
            builder.AddFace(south, At(rings - 1, j + 1), At(rings - 1, j));
            for (int i = 0; i + 1 < rings; i++)
            {
                builder.AddFace(At(i, j), At(i + 1, j), At(i + 1, j + 1));
                builder.AddFace(At(i, j), At(i + 1, j + 1), At(i, j + 1));
            }
        }
        return builder.Build();
    }

    /// <summary>The surface of a block of unit cubes in quads, without the cubes that a predicate takes out. No two cubes may touch along an edge only.</summary>
    public static Mesh Voxels(int nx, int ny, int nz, Func<int, int, int, bool>? isOut = null)
    {
        var builder = new MeshBuilder();
        var number = new Dictionary<(int, int, int), int>();
        bool Full(int x, int y, int z) => x >= 0 && y >= 0 && z >= 0 && x < nx && y < ny && z < nz && isOut?.Invoke(x, y, z) != true;
        int Corner((int X, int Y, int Z) p)
        {
            if (!number.TryGetValue(p, out int v))
                number.Add(p, v = builder.AddVertex(new(p.X, p.Y, p.Z)));
            return v;
        }
        void Quad((int, int, int) a, (int, int, int) b, (int, int, int) c, (int, int, int) d) =>
            builder.AddFace(Corner(a), Corner(b), Corner(c), Corner(d));

        for (int z = 0; z < nz; z++)
        {
            for (int y = 0; y < ny; y++)
            {
                for (int x = 0; x < nx; x++)
                {
                    if (!Full(x, y, z))
                        continue;
                    int x1 = x + 1, y1 = y + 1, z1 = z + 1;
                    if (!Full(x, y, z - 1))
                        Quad((x, y, z), (x, y1, z), (x1, y1, z), (x1, y, z));
                    if (!Full(x, y, z1))
                        Quad((x, y, z1), (x1, y, z1), (x1, y1, z1), (x, y1, z1));
                    if (!Full(x, y - 1, z))
                        Quad((x, y, z), (x1, y, z), (x1, y, z1), (x, y, z1));
                    if (!Full(x, y1, z))
                        Quad((x, y1, z), (x, y1, z1), (x1, y1, z1), (x1, y1, z));
                    if (!Full(x - 1, y, z))
                        Quad((x, y, z), (x, y, z1), (x, y1, z1), (x, y1, z));
                    if (!Full(x1, y, z))
                        Quad((x1, y, z), (x1, y1, z), (x1, y1, z1), (x1, y, z1));
                }
            }
        }
        return builder.Build();
    }

    /// <summary>The same surface with every polygon cut into a fan from its first vertex.</summary>
    public static Mesh Triangulated(Mesh mesh)
    {
        var corners = new List<int>();
        foreach (Face f in mesh.Faces)
        {
            HalfEdge h = f.HalfEdge;
            for (HalfEdge k = h.Next; k.Next != h; k = k.Next)
                corners.AddRange([h.Source.Index, k.Source.Index, k.Target.Index]);
        }
        return MeshBuilder.FromTriangles(mesh.Positions, [.. corners]);
    }

    private static Mesh GenusTwo() => Voxels(5, 3, 1, (x, y, _) => y == 1 && x is 1 or 3);

    private static Mesh Annulus(int n)
    {
        var builder = new MeshBuilder();
        for (int i = 0; i < 2 * n; i++)
            builder.AddVertex(OnCircle(i % n, n, 0) * (i < n ? 1 : 0.5));
        for (int i = 0; i < n; i++)
        {
            int j = (i + 1) % n;
            builder.AddFace(i, j, n + j);
            builder.AddFace(i, n + j, n + i);
        }
        return builder.Build();
    }

    private static Mesh GridWithHoles()
    {
        Mesh full = Triangulated(QuadGrid(9, 6));
        var corners = new List<int>();
        foreach (Face f in full.Faces)
        {
            // Two quads and one triangle are left out.
            if (f.Index is not (30 or 31 or 40 or 41 or 75))
                corners.AddRange(f.Vertices.Select(v => v.Index));
        }
        return MeshBuilder.FromTriangles(full.Positions, [.. corners]);
    }

    private static Mesh Components()
    {
        Mesh mesh = Torus(6, 5);
        mesh.Append(Moved(Tetrahedron(), 0.2, new(3, 0, 0)));
        mesh.Append(Moved(Triangulated(QuadGrid(3, 2)), 1, new(5, 0, 0)));
        return mesh;
    }

    private static Mesh TetrahedronAndPoints()
    {
        Mesh mesh = Tetrahedron();
        mesh.AddVertex(new(5, 0, 0));
        mesh.AddVertex(new(0, 5, 0));
        return mesh;
    }

    // A quad, a pentagon, a quad and two triangles around vertex 9:
    //
    //   7 ─── 6 ─── 5
    //   │     │   / │
    //   8 ─── 9 ─── 4
    //   │      \    │
    //   0 ─ 1 ─ 2 ─ 3
    private static Mesh MixedPolygons() => MeshBuilder.FromPolygons(
        [new(0, 0, 0), new(1, 0, 0), new(2, 0, 0), new(3, 0, 0), new(3, 1, 0.1), new(3, 2, 0), new(1.5, 2, 0.2), new(0, 2, 0), new(0, 1, 0), new(1.5, 1, 0.3)],
        [8, 9, 6, 7],
        [0, 1, 2, 9, 8],
        [2, 3, 4, 9],
        [4, 5, 9],
        [5, 6, 9]);

    internal static Mesh Moved(Mesh mesh, double scale, Vector3D offset)
    {
        foreach (ref Vector3D p in mesh.Positions)
            p = (p * scale) + offset;
        return mesh;
    }

    private static Mesh Scaled(Mesh mesh, Vector3D scale)
    {
        foreach (ref Vector3D p in mesh.Positions)
            p = new(p.X * scale.X, p.Y * scale.Y, p.Z * scale.Z);
        return mesh;
    }

    private static Vector3D OnCircle(int i, int n, double z) => new(Math.Cos(2 * Math.PI * i / n), Math.Sin(2 * Math.PI * i / n), z);

    private static TheoryData<string> Select(Func<Sort, bool> wanted) => new(Recipes.Where(r => wanted(r.Value.Sort)).Select(r => r.Key));
}
