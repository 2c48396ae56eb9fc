using System.IO.Compression;
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

    /// <summary>A public model: triangles (polygons are fanned), without unused vertices.</summary>
    public static Mesh Public(string name)
    {
        string path = ReferenceData.ModelPath(name);
        using Stream raw = File.OpenRead(path);
        using Stream stream = path.EndsWith(".gz", StringComparison.Ordinal) ? new GZipStream(raw, CompressionMode.Decompress) : raw;
        using var reader = new StreamReader(stream);
        (List<Vector3D> positions, List<int> corners) = path.Contains(".off", StringComparison.Ordinal) ? ReadOff(reader) : ReadObj(reader);
        var number = new int[positions.Count];
        foreach (int v in corners)
            number[v] = 1;
        var used = new List<Vector3D>();
        for (int v = 0; v < number.Length; v++)
        {
            if (number[v] == 0)
                continue;
            number[v] = used.Count;
            used.Add(positions[v]);
        }
        return MeshBuilder.FromTriangles([.. used], [.. corners.Select(v => number[v])]);
    }

    private static (List<Vector3D>, List<int>) ReadObj(StreamReader reader)
    {
        var positions = new List<Vector3D>();
        var corners = new List<int>();
        while (reader.ReadLine() is { } line)
        {
            string[] words = line.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
            if (words is ["v", ..])
                positions.Add(Point(words, 1));
            else if (words is ["f", ..])
                Fan(corners, [.. words.Skip(1).Select(w => Integer(w.Split('/')[0]) - 1)]);
        }
        return (positions, corners);
    }

    private static (List<Vector3D>, List<int>) ReadOff(StreamReader reader)
    {
        var positions = new List<Vector3D>();
        var corners = new List<int>();
        string[] words = [.. reader.ReadToEnd().Split('\n').Select(l => l.Split('#')[0])
            .SelectMany(l => l.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries)).Where(w => w is not ("OFF" or "COFF"))];
        int vertices = Integer(words[0]), faces = Integer(words[1]), at = 3;
        for (int v = 0; v < vertices; v++, at += 3)
            positions.Add(Point(words, at));
        for (int f = 0; f < faces; f++)
        {
            int degree = Integer(words[at]);
            Fan(corners, [.. words.Skip(at + 1).Take(degree).Select(Integer)]);
            at += degree + 1;
        }
        return (positions, corners);
    }

    private static Vector3D Point(string[] words, int at) => new(Number(words[at]), Number(words[at + 1]), Number(words[at + 2]));

    private static double Number(string word) => double.Parse(word, System.Globalization.CultureInfo.InvariantCulture);

    private static int Integer(string word) => int.Parse(word, System.Globalization.CultureInfo.InvariantCulture);

    private static void Fan(List<int> corners, int[] face)
    {
        for (int i = 2; i < face.Length; i++)
            corners.AddRange([face[0], face[i - 1], face[i]]);
    }
}
