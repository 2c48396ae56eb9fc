using System.Buffers.Binary;
using System.IO.Compression;
using System.Numerics;
using MeshLab.Numerics;

namespace MeshLab.Visualization;

/// <summary>
/// The geometry for the turnable model: vertices of 16 bytes (place and number as four 16-bit fractions, octahedral normal, colour), split where
/// normals or colours of a vertex differ, then triangles, edges, lines, marks; all packed by gzip.
/// </summary>
internal sealed class ViewerGeometry
{
    private readonly RenderGeometry geometry;
    private readonly RenderOptions options;

    /// <summary>Packs the geometry.</summary>
    public ViewerGeometry(RenderGeometry geometry, RenderOptions options)
    {
        this.geometry = geometry;
        this.options = options;
        Box = BoundingBox.Empty;
        foreach (int v in geometry.LiveVertices)
            Box = Box.Including(geometry.Positions[v]);
        if (Box.IsEmpty)
            Box = new(Vector3D.Zero, Vector3D.Zero);
        Packed = Pack();
    }

    /// <summary>The box that the 16-bit fractions refer to.</summary>
    public BoundingBox Box { get; }

    /// <summary>The columns, packed.</summary>
    public byte[] Packed { get; }

    /// <summary>How many vertices, after splitting.</summary>
    public int VertexCount { get; private set; }

    /// <summary>How many edges.</summary>
    public int EdgeCount { get; private set; }

    /// <summary>How many segments of polylines and marked edges.</summary>
    public int LineCount { get; private set; }

    /// <summary>How many marks at points.</summary>
    public int MarkCount { get; private set; }

    private byte[] Pack()
    {
        using var vertices = new MemoryStream();
        int[] triangles = SplitVertices(vertices, out int[] firstOf);
        using var packed = new MemoryStream();
        using (var gzip = new GZipStream(packed, CompressionLevel.Optimal, leaveOpen: true))
        {
            vertices.WriteTo(gzip);
            Write(gzip, triangles);
            Write(gzip, Edges(firstOf));
            Write(gzip, Lines());
            Write(gzip, Marks());
        }
        return packed.ToArray();
    }

    // A vertex is written once per different (normal, colour, number) among its corners.
    private int[] SplitVertices(MemoryStream vertices, out int[] firstOf)
    {
        RenderGeometry g = geometry;
        Coloring coloring = options.Coloring;
        int threads = options.MaxDegreeOfParallelism;
        Vector3[] normals = CornerNormals.Smooth(g, CornerNormals.OfTriangles(g, threads), options.CreaseAngleFor(geometry.TriangleCount), threads);
        var triangles = new int[g.Triangles.Length];
        firstOf = new int[g.Positions.Length];
        Array.Fill(firstOf, -1);
        var next = new List<int>();
        var keys = new List<(uint Normal, uint Color, ushort Value)>();
        for (int c = 0; c < triangles.Length; c++)
        {
            int v = g.Triangles[c], f = g.FaceOfTriangle[c / 3];
            var (color, value) = Paint(coloring, v, f);
            var key = (Octahedral(normals[c]), color, value);
            int at = firstOf[v];
            while (at >= 0 && keys[at] != key)
                at = next[at];
            if (at < 0)
            {
                at = keys.Count;
                keys.Add(key);
                next.Add(firstOf[v]);
                firstOf[v] = at;
                WriteVertex(vertices, g.Positions[v], key);
            }
            triangles[c] = at;
        }
        foreach (int v in g.LiveVertices)
        {
            if (firstOf[v] >= 0)
                continue;
            firstOf[v] = keys.Count;
            keys.Add(default);
            next.Add(-1);
            WriteVertex(vertices, g.Positions[v], default);
        }
        VertexCount = keys.Count;
        return triangles;
    }

    // Alpha 0 says: the number counts, through the colour map.
    private static (uint Color, ushort Value) Paint(Coloring coloring, int vertex, int face)
    {
        switch (coloring.Kind)
        {
            case ColoringKind.VertexScalars or ColoringKind.FaceScalars:
                double t = coloring.Normalize(coloring.Values![coloring.Kind == ColoringKind.VertexScalars ? vertex : face]);
                return double.IsNaN(t) ? (Bytes(ColorMap.NotANumber), (ushort)0) : (0u, (ushort)Math.Round(t * 65535));
            case ColoringKind.VertexLabels or ColoringKind.FaceLabels:
                return (Bytes(coloring.LabelColor(coloring.Labels![coloring.Kind == ColoringKind.VertexLabels ? vertex : face])), 0);
            case ColoringKind.VertexColors or ColoringKind.FaceColors:
                return (Bytes(coloring.Colors![coloring.Kind == ColoringKind.VertexColors ? vertex : face]), 0);
            default:
                return (Bytes(coloring.Color), 0);
        }
    }

    private static uint Bytes(Color c) => Image.ToByte(c.R) | (uint)Image.ToByte(c.G) << 8 | (uint)Image.ToByte(c.B) << 16 | 0xFF000000;

    // The unit sphere folded onto a square (Meyer et al., 2010), 16 bits per side.
    private static uint Octahedral(Vector3 n)
    {
        float sum = Math.Abs(n.X) + Math.Abs(n.Y) + Math.Abs(n.Z);
        if (!(sum > 0))
            return 0;
        float x = n.X / sum, y = n.Y / sum;
        if (n.Z < 0)
            (x, y) = ((1 - Math.Abs(y)) * (x >= 0 ? 1 : -1), (1 - Math.Abs(x)) * (y >= 0 ? 1 : -1));
        return (ushort)(short)MathF.Round(x * 32767) | (uint)(ushort)(short)MathF.Round(y * 32767) << 16;
    }

    private void WriteVertex(MemoryStream vertices, Vector3D position, (uint Normal, uint Color, ushort Value) key)
    {
        Span<byte> bytes = stackalloc byte[16];
        Vector3D low = Box.Min, size = Box.Size;
        for (int axis = 0; axis < 3; axis++)
        {
            double fraction = size[axis] > 0 ? (position[axis] - low[axis]) / size[axis] : 0;
            BinaryPrimitives.WriteUInt16LittleEndian(bytes[(2 * axis)..], (ushort)Math.Round(Math.Clamp(fraction, 0, 1) * 65535));
        }
        BinaryPrimitives.WriteUInt16LittleEndian(bytes[6..], key.Value);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes[8..], key.Normal);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes[12..], key.Color);
        vertices.Write(bytes);
    }

    private int[] Edges(int[] firstOf)
    {
        var edges = new List<int>(geometry.Edges.Length);
        for (int e = 0; e < geometry.Edges.Length; e += 2)
        {
            if (geometry.Edges[e] < 0)
                continue;
            edges.Add(firstOf[geometry.Edges[e]]);
            edges.Add(firstOf[geometry.Edges[e + 1]]);
        }
        EdgeCount = edges.Count / 2;
        return [.. edges];
    }

    private float[] Lines()
    {
        var lines = new List<float>();
        foreach (EdgeMarks marks in options.HighlightedEdges)
        {
            foreach (int e in marks.Edges)
            {
                if (geometry.Edges[2 * e] >= 0)
                    Add(geometry.Positions[geometry.Edges[2 * e]], geometry.Positions[geometry.Edges[2 * e + 1]], marks.Color, marks.Width);
            }
        }
        foreach (Polyline polyline in options.Polylines)
        {
            int count = polyline.Points.Count;
            for (int i = 0; i < (polyline.Closed ? count : count - 1); i++)
                Add(polyline.Points[i], polyline.Points[(i + 1) % count], polyline.Color, polyline.Width);
        }
        LineCount = lines.Count / 11;
        return [.. lines];

        void Add(Vector3D a, Vector3D b, Color color, double width) => lines.AddRange(
            [(float)a.X, (float)a.Y, (float)a.Z, (float)b.X, (float)b.Y, (float)b.Z, color.R, color.G, color.B, color.A, (float)width]);
    }

    private float[] Marks()
    {
        var marks = new List<float>();
        if (options.Vertices)
        {
            foreach (int v in geometry.LiveVertices)
                Add(geometry.Positions[v], options.VertexColor, options.VertexSize, MarkShape.Disc);
        }
        foreach (PointMarks group in options.Points)
        {
            foreach (Vector3D p in group.Points)
                Add(p, group.Color, group.Size, group.Shape);
        }
        MarkCount = marks.Count / 8;
        return [.. marks];

        void Add(Vector3D p, Color color, double size, MarkShape shape) => marks.AddRange(
            [(float)p.X, (float)p.Y, (float)p.Z, color.R, color.G, color.B, (float)size, shape == MarkShape.Sphere ? 1 : 0]);
    }

    private static void Write(Stream stream, int[] values)
    {
        var bytes = new byte[4 * values.Length];
        for (int i = 0; i < values.Length; i++)
            BinaryPrimitives.WriteInt32LittleEndian(bytes.AsSpan(4 * i), values[i]);
        stream.Write(bytes);
    }

    private static void Write(Stream stream, float[] values) => Write(stream, Array.ConvertAll(values, BitConverter.SingleToInt32Bits));
}
