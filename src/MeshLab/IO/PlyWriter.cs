using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>§14.3 PLY 文件: writes PLY that <see cref="PlyReader"/> reads back bit for bit: coordinates as doubles, all attributes, labels with their names in comments.</summary>
internal sealed class PlyWriter
{
    private readonly MeshData data;
    private readonly MeshEncoding encoding;
    private readonly ColorLayout? vertexColors, faceColors;
    private readonly bool hasLongLists;
    private readonly FaceLabelSet[] labels;

    private PlyWriter(MeshData data, MeshEncoding encoding)
    {
        this.data = data;
        this.encoding = encoding;
        vertexColors = ColorLayout.Of(data.VertexColors);
        faceColors = ColorLayout.Of(data.FaceColors);
        labels = [.. data.FaceLabels];
        for (int f = 0; f < data.FaceCount; f++)
            hasLongLists |= 3 * (data.FaceStart[f + 1] - data.FaceStart[f]) > byte.MaxValue;
    }

    private bool IsText => encoding == MeshEncoding.Text;

    private bool IsBig => encoding == MeshEncoding.BinaryBigEndian;

    public static void Write(MeshData data, BlockWriter writer, MeshEncoding encoding)
    {
        PlyWriter ply = new(data, encoding);
        writer.Write(ply.AppendHeader);
        writer.WriteRows(data.VertexCount, 0.5, ply.AppendVertices);
        writer.WriteRows(data.FaceCount, 0.5, ply.AppendFaces);
    }

    /// <summary>Colours are bytes if that loses nothing, else floats; alpha only if one is not 1.</summary>
    private sealed record ColorLayout(bool AreBytes, bool HasAlpha)
    {
        public static ColorLayout? Of(Color[]? colors) => colors is null
            ? null
            : new(Array.TrueForAll(colors, c => IsByte(c.R) && IsByte(c.G) && IsByte(c.B) && IsByte(c.A)), Array.Exists(colors, c => c.A != 1));

        private static bool IsByte(float channel) => channel is >= 0 and <= 1 && MathF.Round(channel * 255) / 255 == channel;
    }

    private void AppendHeader(ByteBuffer b)
    {
        string format = encoding switch
        {
            MeshEncoding.Text => "ascii",
            MeshEncoding.BinaryBigEndian => "binary_big_endian",
            _ => "binary_little_endian",
        };
        b.Append($"ply\nformat {format} 1.0\ncomment written by MeshLab\n");
        foreach (FaceLabelSet set in labels)
        {
            for (int i = 0; i < set.Names.Count; i++)
            {
                b.Append($"comment {PlyHeader.LabelComment} {KindOf(set)} {i} ");
                b.AppendName(set.Names[i]);
                b.Append((byte)'\n');
            }
        }

        b.Append($"element vertex {data.VertexCount}\nproperty double x\nproperty double y\nproperty double z\n");
        if (data.VertexNormals is not null)
            b.Append("property double nx\nproperty double ny\nproperty double nz\n");
        if (data.VertexTextureCoordinates is not null)
            b.Append("property double s\nproperty double t\n");
        AppendColorProperties(b, vertexColors);
        string length = hasLongLists ? "int" : "uchar";
        b.Append($"element face {data.FaceCount}\nproperty list {length} int vertex_indices\n");
        if (data.CornerTextureCoordinates is not null)
            b.Append($"property list {length} double texcoord\n");
        if (data.CornerNormals is not null)
            b.Append($"property list {length} double normal\n");
        AppendColorProperties(b, faceColors);
        foreach (FaceLabelSet set in labels)
            b.Append($"property int {PlyFaceTable.LabelPrefix}{KindOf(set)}\n");
        b.Append("end_header\n");
    }

    private static string KindOf(FaceLabelSet set) => string.Join('_', set.Kind.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries));

    private static void AppendColorProperties(ByteBuffer b, ColorLayout? layout)
    {
        if (layout is null)
            return;
        string type = layout.AreBytes ? "uchar" : "float";
        b.Append($"property {type} red\nproperty {type} green\nproperty {type} blue\n");
        if (layout.HasAlpha)
            b.Append($"property {type} alpha\n");
    }

    private void AppendVertices(int from, int to, ByteBuffer b)
    {
        for (int v = from; v < to; v++)
        {
            Append(b, data.Positions[v]);
            if (data.VertexNormals is not null)
                Append(b, data.VertexNormals[v]);
            if (data.VertexTextureCoordinates is not null)
                Append(b, data.VertexTextureCoordinates[v]);
            if (vertexColors is not null)
                Append(b, data.VertexColors![v], vertexColors);
            EndRow(b);
        }
    }

    private void AppendFaces(int from, int to, ByteBuffer b)
    {
        for (int f = from; f < to; f++)
        {
            int first = data.FaceStart[f], end = data.FaceStart[f + 1];
            AppendLength(b, end - first);
            for (int c = first; c < end; c++)
                Append(b, data.Corners[c]);
            if (data.CornerTextureCoordinates is not null)
            {
                AppendLength(b, 2 * (end - first));
                for (int c = first; c < end; c++)
                    Append(b, data.CornerTextureCoordinates[c]);
            }

            if (data.CornerNormals is not null)
            {
                AppendLength(b, 3 * (end - first));
                for (int c = first; c < end; c++)
                    Append(b, data.CornerNormals[c]);
            }

            if (faceColors is not null)
                Append(b, data.FaceColors![f], faceColors);
            foreach (FaceLabelSet set in labels)
                Append(b, set.Labels[f]);
            EndRow(b);
        }
    }

    private void Append(ByteBuffer b, double number)
    {
        if (!IsText)
            b.AppendBinary(number, IsBig);
        else if (b.IsAtLineStart)
            b.AppendNumber(number);
        else
            b.AppendBlankAnd(number);
    }

    private void Append(ByteBuffer b, int number)
    {
        if (IsText && b.IsAtLineStart)
            b.AppendInteger(number);
        else if (IsText)
            b.AppendBlankAnd(number);
        else
            b.AppendBinary(number, IsBig);
    }

    private void AppendLength(ByteBuffer b, int length)
    {
        if (IsText || hasLongLists)
            Append(b, length);
        else
            b.Append((byte)length);
    }

    private void Append(ByteBuffer b, Vector3D vector)
    {
        Append(b, vector.X);
        Append(b, vector.Y);
        Append(b, vector.Z);
    }

    private void Append(ByteBuffer b, Vector2D vector)
    {
        Append(b, vector.X);
        Append(b, vector.Y);
    }

    private void Append(ByteBuffer b, Color color, ColorLayout layout)
    {
        AppendChannel(b, color.R, layout);
        AppendChannel(b, color.G, layout);
        AppendChannel(b, color.B, layout);
        if (layout.HasAlpha)
            AppendChannel(b, color.A, layout);
    }

    private void AppendChannel(ByteBuffer b, float channel, ColorLayout layout)
    {
        if (layout.AreBytes && IsText)
            b.AppendBlankAnd((int)MathF.Round(channel * 255));
        else if (layout.AreBytes)
            b.Append((byte)MathF.Round(channel * 255));
        else if (IsText)
            b.AppendBlankAnd(channel);
        else
            b.AppendBinary(channel, IsBig);
    }

    private void EndRow(ByteBuffer b)
    {
        if (IsText)
            b.Append((byte)'\n');
    }
}
