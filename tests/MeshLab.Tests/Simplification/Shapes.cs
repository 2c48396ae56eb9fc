using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Tests.Simplification;

/// <summary>Small meshes with known answers.</summary>
internal static class Shapes
{
    /// <summary>A flat or curved sheet of n × n squares, each two triangles: one boundary loop.</summary>
    public static Mesh Sheet(int n, Func<double, double, double>? height = null)
    {
        var builder = new MeshBuilder();
        for (int j = 0; j <= n; j++)
        {
            for (int i = 0; i <= n; i++)
            {
                double x = i / (double)n, y = j / (double)n;
                builder.AddVertex(new(x, y, height?.Invoke(x, y) ?? 0));
            }
        }
        for (int j = 0; j < n; j++)
        {
            for (int i = 0; i < n; i++)
            {
                int a = j * (n + 1) + i, b = a + 1, c = a + n + 2, d = a + n + 1;
                builder.AddFace(a, b, c);
                builder.AddFace(a, c, d);
            }
        }
        return builder.Build();
    }

    /// <summary>A torus of n × m squares, each two triangles: closed, genus 1.</summary>
    public static Mesh Torus(int n, int m)
    {
        var builder = new MeshBuilder();
        for (int j = 0; j < m; j++)
        {
            for (int i = 0; i < n; i++)
            {
                double a = 2 * Math.PI * i / n, b = 2 * Math.PI * j / m, r = 1 + 0.4 * Math.Cos(b);
                builder.AddVertex(new(r * Math.Cos(a), r * Math.Sin(a), 0.4 * Math.Sin(b)));
            }
        }
        for (int j = 0; j < m; j++)
        {
            for (int i = 0; i < n; i++)
            {
                int a = j * n + i, b = j * n + (i + 1) % n, c = (j + 1) % m * n + (i + 1) % n, d = (j + 1) % m * n + i;
                builder.AddFace(a, b, c);
                builder.AddFace(a, c, d);
            }
        }
        return builder.Build();
    }

    /// <summary>An axis-parallel cube, each side n × n squares: eight corners, twelve straight edges.</summary>
    public static Mesh Cube(int n)
    {
        var builder = new MeshBuilder();
        var index = new Dictionary<(int, int, int), int>();
        int At(int x, int y, int z)
        {
            if (!index.TryGetValue((x, y, z), out int v))
                index[(x, y, z)] = v = builder.AddVertex(new(x / (double)n, y / (double)n, z / (double)n));
            return v;
        }
        for (int axis = 0; axis < 3; axis++)
        {
            for (int side = 0; side <= 1; side++)
            {
                int P(int i, int j) => (axis, side) switch
                {
                    (0, _) => At(side * n, i, j),
                    (1, _) => At(j, side * n, i),
                    _ => At(i, j, side * n),
                };
                for (int i = 0; i < n; i++)
                {
                    for (int j = 0; j < n; j++)
                    {
                        int a = P(i, j), b = P(i + 1, j), c = P(i + 1, j + 1), d = P(i, j + 1);
                        if (side == 0)
                            (b, d) = (d, b);
                        builder.AddFace(a, b, c);
                        builder.AddFace(a, c, d);
                    }
                }
            }
        }
        return builder.Build();
    }

    public static Mesh Tetrahedron() => MeshBuilder.FromTriangles(
        [new(0, 0, 0), new(1, 0, 0), new(0, 1, 0), new(0, 0, 1)], [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);

    /// <summary>A copy with other positions.</summary>
    public static Mesh Moved(Mesh mesh, Func<Vector3D, Vector3D> move)
    {
        Mesh copy = mesh.Clone();
        foreach (Vertex v in copy.Vertices)
            v.Position = move(v.Position);
        return copy;
    }

    /// <summary>Vertices minus edges plus faces.</summary>
    public static int EulerCharacteristic(Mesh mesh) => mesh.Vertices.Count - mesh.Edges.Count + mesh.Faces.Count;

    public static int BoundaryLoops(Mesh mesh)
    {
        var seen = new HashSet<int>();
        int loops = 0;
        foreach (HalfEdge h in mesh.HalfEdges)
        {
            if (!h.IsBoundary || !seen.Add(h.Index))
                continue;
            loops++;
            for (HalfEdge k = h.Next; k != h; k = k.Next)
                seen.Add(k.Index);
        }
        return loops;
    }

    public static int Components(Mesh mesh)
    {
        var seen = new HashSet<int>();
        var open = new Stack<Vertex>();
        int components = 0;
        foreach (Vertex v in mesh.Vertices)
        {
            if (v.IsIsolated || !seen.Add(v.Index))
                continue;
            components++;
            open.Push(v);
            while (open.TryPop(out Vertex w))
            {
                foreach (Vertex n in w.Neighbors)
                {
                    if (seen.Add(n.Index))
                        open.Push(n);
                }
            }
        }
        return components;
    }
}
