using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>§14.2 OFF 文件: writes the text form of OFF that <see cref="OffReader"/> reads back bit for bit. It holds no corner attributes and no labels.</summary>
internal static class OffWriter
{
    public static void Write(MeshData data, BlockWriter writer)
    {
        writer.Write(b =>
        {
            if (data.VertexTextureCoordinates is not null)
                b.Append("ST"u8);
            if (data.VertexColors is not null)
                b.Append("C"u8);
            if (data.VertexNormals is not null)
                b.Append("N"u8);
            b.Append("OFF\n"u8);
            b.AppendInteger(data.VertexCount);
            b.AppendBlankAnd(data.FaceCount);
            b.Append(" 0\n"u8);
        });
        WriteVertices(data, writer);
        WriteFaces(data, writer);
    }

    private static void WriteVertices(MeshData data, BlockWriter writer)
    {
        Vector3D[] positions = data.Positions;
        writer.WriteRows(positions.Length, 0.6, (from, to, b) =>
        {
            for (int v = from; v < to; v++)
            {
                b.AppendNumber(positions[v].X);
                b.AppendBlankAnd(positions[v].Y);
                b.AppendBlankAnd(positions[v].Z);
                if (data.VertexNormals is { } normals)
                {
                    b.AppendBlankAnd(normals[v].X);
                    b.AppendBlankAnd(normals[v].Y);
                    b.AppendBlankAnd(normals[v].Z);
                }

                if (data.VertexColors is { } colors)
                    AppendColor(b, colors[v], hasAlpha: true);
                if (data.VertexTextureCoordinates is { } texture)
                {
                    b.AppendBlankAnd(texture[v].X);
                    b.AppendBlankAnd(texture[v].Y);
                }

                b.Append((byte)'\n');
            }
        });
    }

    private static void WriteFaces(MeshData data, BlockWriter writer)
    {
        int[] start = data.FaceStart, corners = data.Corners;
        bool hasAlpha = data.FaceColors is not null && Array.Exists(data.FaceColors, c => c.A != 1);
        writer.WriteRows(data.FaceCount, 0.4, (from, to, b) =>
        {
            for (int f = from; f < to; f++)
            {
                b.AppendInteger(start[f + 1] - start[f]);
                for (int c = start[f]; c < start[f + 1]; c++)
                    b.AppendBlankAnd(corners[c]);
                if (data.FaceColors is { } colors)
                    AppendColor(b, colors[f], hasAlpha);
                b.Append((byte)'\n');
            }
        });
    }

    /// <summary>Channels from 0 to 1: one above 1 would make a reader take all of the file for 0 to 255.</summary>
    private static void AppendColor(ByteBuffer b, Color color, bool hasAlpha)
    {
        b.AppendBlankAnd(Math.Clamp(color.R, 0, 1));
        b.AppendBlankAnd(Math.Clamp(color.G, 0, 1));
        b.AppendBlankAnd(Math.Clamp(color.B, 0, 1));
        if (hasAlpha)
            b.AppendBlankAnd(Math.Clamp(color.A, 0, 1));
    }
}
