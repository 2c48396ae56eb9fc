using System.Runtime.InteropServices;
using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>§14.1 OBJ 文件: writes Wavefront OBJ that <see cref="ObjReader"/> reads back bit for bit.</summary>
internal static class ObjWriter
{
    private static readonly (string Kind, string Keyword, string Off)[] Statements =
    [
        (FaceLabelSet.Object, "o", ""), (FaceLabelSet.Group, "g", ""), (FaceLabelSet.Material, "usemtl", ""), (FaceLabelSet.Smoothing, "s", "off"),
    ];

    public static void Write(MeshData data, BlockWriter writer, MeshWriteOptions options)
    {
        // One line of comment, so that a mesh without elements is not an empty file.
        writer.Write(b =>
        {
            b.Append("# MeshLab OBJ, vertices and faces:"u8);
            b.AppendBlankAnd(data.VertexCount);
            b.AppendBlankAnd(data.FaceCount);
            b.Append((byte)'\n');
            foreach (string library in options.MaterialLibraries)
            {
                b.Append("mtllib "u8);
                b.AppendName(library);
                b.Append((byte)'\n');
            }
        });

        WriteVertices(data, writer);
        int[] texture = WriteTextureCoordinates(data, writer);
        int[] normals = WriteNormals(data, writer);
        WriteFaces(data, texture, normals, writer);
    }

    private static void WriteVertices(MeshData data, BlockWriter writer)
    {
        Vector3D[] positions = data.Positions;
        Color[]? colors = data.VertexColors;
        bool hasAlpha = colors is not null && Array.Exists(colors, c => c.A != 1);
        writer.WriteRows(positions.Length, 0.5, (from, to, b) =>
        {
            for (int v = from; v < to; v++)
            {
                b.Append((byte)'v');
                b.AppendBlankAnd(positions[v].X);
                b.AppendBlankAnd(positions[v].Y);
                b.AppendBlankAnd(positions[v].Z);
                if (colors is not null)
                    AppendColor(b, colors[v], hasAlpha);
                b.Append((byte)'\n');
            }
        });
    }

    private static void AppendColor(ByteBuffer b, Color color, bool hasAlpha)
    {
        b.AppendBlankAnd(color.R);
        b.AppendBlankAnd(color.G);
        b.AppendBlankAnd(color.B);
        if (hasAlpha)
            b.AppendBlankAnd(color.A);
    }

    /// <summary>Writes the vt lines and returns the index of each corner; empty if there are none.</summary>
    private static int[] WriteTextureCoordinates(MeshData data, BlockWriter writer)
    {
        (Vector2D[] pool, int[] indices) = Pool(data.CornerTextureCoordinates, data.VertexTextureCoordinates, data.Corners);
        writer.WriteRows(pool.Length, 0.1, (from, to, b) =>
        {
            for (int i = from; i < to; i++)
            {
                b.Append("vt"u8);
                b.AppendBlankAnd(pool[i].X);
                b.AppendBlankAnd(pool[i].Y);
                b.Append((byte)'\n');
            }
        });
        return indices;
    }

    private static int[] WriteNormals(MeshData data, BlockWriter writer)
    {
        (Vector3D[] pool, int[] indices) = Pool(data.CornerNormals, data.VertexNormals, data.Corners);
        writer.WriteRows(pool.Length, 0.1, (from, to, b) =>
        {
            for (int i = from; i < to; i++)
            {
                b.Append("vn"u8);
                b.AppendBlankAnd(pool[i].X);
                b.AppendBlankAnd(pool[i].Y);
                b.AppendBlankAnd(pool[i].Z);
                b.Append((byte)'\n');
            }
        });
        return indices;
    }

    /// <summary>The different values and the corners' indices into them: per corner if the corners have values of their own, else per vertex.</summary>
    private static (T[] Pool, int[] Indices) Pool<T>(T[]? perCorner, T[]? perVertex, int[] corners)
        where T : unmanaged
    {
        if (perCorner is null)
            return perVertex is null ? ([], []) : (perVertex, corners);

        List<T> pool = [];
        Dictionary<Bits, int> known = [];
        int[] indices = new int[perCorner.Length];
        for (int c = 0; c < perCorner.Length; c++)
        {
            ref int index = ref CollectionsMarshal.GetValueRefOrAddDefault(known, Bits.Of(perCorner[c]), out bool isKnown);
            if (!isKnown)
            {
                index = pool.Count;
                pool.Add(perCorner[c]);
            }

            indices[c] = index;
        }

        return ([.. pool], indices);
    }

    /// <summary>The bits of two or three doubles, so that 0 and −0 stay two values.</summary>
    private readonly record struct Bits(long X, long Y, long Z)
    {
        public static Bits Of<T>(T value)
            where T : unmanaged
        {
            ReadOnlySpan<long> bits = MemoryMarshal.Cast<T, long>(new ReadOnlySpan<T>(in value));
            return new Bits(bits[0], bits[1], bits.Length > 2 ? bits[2] : 0);
        }
    }

    private static void WriteFaces(MeshData data, int[] texture, int[] normals, BlockWriter writer)
    {
        (FaceLabelSet Set, string Keyword, string Off)[] labels =
            [.. Statements.SelectMany(s => data.FaceLabels.Where(set => set.Kind == s.Kind).Select(set => (set, s.Keyword, s.Off)))];
        int[] start = data.FaceStart, corners = data.Corners;
        if (labels.Length + texture.Length + normals.Length == 0)
        {
            writer.WriteRows(data.FaceCount, 0.3, (from, to, b) => FormatPlainFaces(start, corners, from, to, b));
            return;
        }

        writer.WriteRows(data.FaceCount, 0.3, (from, to, b) =>
        {
            for (int f = from; f < to; f++)
            {
                foreach ((FaceLabelSet set, string keyword, string off) in labels)
                    AppendLabelChange(b, set, keyword, off, f);
                b.Append((byte)'f');
                for (int c = start[f]; c < start[f + 1]; c++)
                {
                    b.AppendBlankAnd(corners[c] + 1);
                    if (texture.Length + normals.Length > 0)
                        AppendAttributes(b, texture, normals, c);
                }

                b.Append((byte)'\n');
            }
        });
    }

    private static void FormatPlainFaces(ReadOnlySpan<int> start, ReadOnlySpan<int> corners, int from, int to, ByteBuffer b)
    {
        for (int f = from; f < to; f++)
        {
            b.Append((byte)'f');
            foreach (int corner in corners[start[f]..start[f + 1]])
                b.AppendBlankAnd(corner + 1);
            b.Append((byte)'\n');
        }
    }

    private static void AppendAttributes(ByteBuffer b, int[] texture, int[] normals, int corner)
    {
        b.Append((byte)'/');
        if (texture.Length > 0)
            b.AppendInteger(texture[corner] + 1);
        if (normals.Length == 0)
            return;
        b.Append((byte)'/');
        b.AppendInteger(normals[corner] + 1);
    }

    private static void AppendLabelChange(ByteBuffer b, FaceLabelSet set, string keyword, string off, int face)
    {
        string before = face == 0 ? "" : NameOf(set, face - 1), name = NameOf(set, face);
        if (name == before)
            return;
        b.Append(keyword);
        if (name.Length > 0 || off.Length > 0)
            b.Append((byte)' ');
        b.AppendName(name.Length > 0 ? name : off);
        b.Append((byte)'\n');
    }

    private static string NameOf(FaceLabelSet set, int face) => set.Labels[face] < 0 ? "" : set.Names[set.Labels[face]];
}
