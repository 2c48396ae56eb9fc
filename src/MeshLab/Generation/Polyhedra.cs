using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Generation;

/// <summary>The five Platonic solids (正多面体) with their true faces, corners on a sphere around the origin.</summary>
public static class Polyhedra
{
    private static readonly double Golden = (1 + Math.Sqrt(5)) / 2;

    /// <summary>4 triangles; edge √(8/3) r, volume 8√3/27 r³.</summary>
    /// <param name="radius">The radius of the sphere through the corners.</param>
    /// <exception cref="ArgumentOutOfRangeException">The radius is not finite and positive.</exception>
    public static Mesh Tetrahedron(double radius = 1) =>
        OnSphere(radius, [new(1, 1, 1), new(1, -1, -1), new(-1, 1, -1), new(-1, -1, 1)], [0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]);

    /// <summary>6 squares; edge 2/√3 r, volume 8√3/9 r³.</summary>
    /// <inheritdoc cref="Tetrahedron"/>
    public static Mesh Cube(double radius = 1) => OnSphere(
        radius,
        [new(-1, -1, -1), new(1, -1, -1), new(1, 1, -1), new(-1, 1, -1), new(-1, -1, 1), new(1, -1, 1), new(1, 1, 1), new(-1, 1, 1)],
        [0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]);

    /// <summary>8 triangles; edge √2 r, volume 4/3 r³.</summary>
    /// <inheritdoc cref="Tetrahedron"/>
    public static Mesh Octahedron(double radius = 1) => OnSphere(
        radius,
        [new(1, 0, 0), new(-1, 0, 0), new(0, 1, 0), new(0, -1, 0), new(0, 0, 1), new(0, 0, -1)],
        [0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]);

    /// <summary>20 triangles; edge r / sin 72°.</summary>
    /// <inheritdoc cref="Tetrahedron"/>
    public static Mesh Icosahedron(double radius = 1)
    {
        double p = Golden;
        return OnSphere(
            radius,
            [
                new(-1, p, 0), new(1, p, 0), new(-1, -p, 0), new(1, -p, 0), new(0, -1, p), new(0, 1, p),
                new(0, -1, -p), new(0, 1, -p), new(p, 0, -1), new(p, 0, 1), new(-p, 0, -1), new(-p, 0, 1),
            ],
            [0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4], [11, 10, 2], [10, 7, 6], [7, 1, 8],
            [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1]);
    }

    /// <summary>12 pentagons; the dual of the icosahedron: corner i lies over its face i.</summary>
    /// <inheritdoc cref="Tetrahedron"/>
    public static Mesh Dodecahedron(double radius = 1)
    {
        Check.Positive(radius);
        Mesh icosahedron = Icosahedron();
        var corners = new Vector3D[20];
        foreach (Face f in icosahedron.Faces)
        {
            foreach (Vertex v in f.Vertices)
                corners[f.Index] += v.Position;
        }
        var faces = new List<int[]>();
        foreach (Vertex v in icosahedron.Vertices)
        {
            var around = new List<int>();
            foreach (Face f in v.Faces)
                around.Add(f.Index);
            faces.Add([.. around]);
        }
        return OnSphere(radius, corners, [.. faces]);
    }

    private static Mesh OnSphere(double radius, Vector3D[] directions, params int[][] faces)
    {
        Check.Positive(radius);
        foreach (ref Vector3D p in directions.AsSpan())
            p = radius * p.Normalized();
        return MeshBuilder.FromPolygons(directions, faces);
    }
}
