using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>§14.3 STL 文件: writes stereolithography files. Polygons are cut into triangles; text keeps exact doubles, binary rounds to floats.</summary>
internal static class StlWriter
{
    private const int HeaderBytes = 80;

    public static void Write(MeshData data, BlockWriter writer, MeshEncoding encoding)
    {
        (int[] corners, int[] faces) = FaceTriangles.Of(data);
        if (encoding == MeshEncoding.Text)
            WriteText(data, corners, faces, writer);
        else
            WriteBinary(data, corners, faces.Length, writer);
    }

    private static void WriteBinary(MeshData data, int[] corners, int count, BlockWriter writer)
    {
        Vector3D[] positions = data.Positions;
        FloatRange.Check(positions);
        writer.Write(b =>
        {
            b.Append("binary STL written by MeshLab"u8);
            while (b.Length < HeaderBytes)
                b.Append((byte)' ');
            b.AppendBinary(count, isBig: false);
        });
        writer.WriteRows(count, 1, (from, to, b) =>
        {
            for (int t = from; t < to; t++)
            {
                Vector3D p = positions[corners[3 * t]], q = positions[corners[3 * t + 1]], r = positions[corners[3 * t + 2]];
                AppendBinary(b, Vector3D.Cross(q - p, r - p).Normalized());
                AppendBinary(b, p);
                AppendBinary(b, q);
                AppendBinary(b, r);
                b.Append([0, 0]);
            }
        });
    }

    private static void AppendBinary(ByteBuffer b, Vector3D v)
    {
        b.AppendBinary((float)v.X, isBig: false);
        b.AppendBinary((float)v.Y, isBig: false);
        b.AppendBinary((float)v.Z, isBig: false);
    }

    /// <summary>One solid for each stretch of faces with the same object name.</summary>
    private static void WriteText(MeshData data, int[] corners, int[] faces, BlockWriter writer)
    {
        Vector3D[] positions = data.Positions;
        FaceLabelSet? objects = data.FaceLabels.FirstOrDefault(set => set.Kind == FaceLabelSet.Object);
        string NameOf(int triangle) => objects is null || objects.Labels[faces[triangle]] < 0 ? "" : objects.Names[objects.Labels[faces[triangle]]];

        writer.Write(b => AppendSolid(b, "solid"u8, faces.Length == 0 ? "" : NameOf(0)));
        writer.WriteRows(faces.Length, 1, (from, to, b) =>
        {
            for (int t = from; t < to; t++)
            {
                if (t > 0 && NameOf(t) != NameOf(t - 1))
                {
                    AppendSolid(b, "endsolid"u8, NameOf(t - 1));
                    AppendSolid(b, "solid"u8, NameOf(t));
                }

                AppendFacet(b, positions[corners[3 * t]], positions[corners[3 * t + 1]], positions[corners[3 * t + 2]]);
            }
        });
        writer.Write(b => AppendSolid(b, "endsolid"u8, faces.Length == 0 ? "" : NameOf(faces.Length - 1)));
    }

    private static void AppendSolid(ByteBuffer b, ReadOnlySpan<byte> keyword, string name)
    {
        b.Append(keyword);
        if (name.Length > 0)
            b.Append((byte)' ');
        b.AppendName(name);
        b.Append((byte)'\n');
    }

    private static void AppendFacet(ByteBuffer b, Vector3D p, Vector3D q, Vector3D r)
    {
        b.Append("  facet normal"u8);
        AppendText(b, Vector3D.Cross(q - p, r - p).Normalized());
        b.Append("    outer loop\n"u8);
        foreach (Vector3D corner in (ReadOnlySpan<Vector3D>)[p, q, r])
        {
            b.Append("      vertex"u8);
            AppendText(b, corner);
        }

        b.Append("    endloop\n  endfacet\n"u8);
    }

    private static void AppendText(ByteBuffer b, Vector3D v)
    {
        b.AppendBlankAnd(v.X);
        b.AppendBlankAnd(v.Y);
        b.AppendBlankAnd(v.Z);
        b.Append((byte)'\n');
    }
}

/// <summary>Formats of single precision cannot hold every double.</summary>
internal static class FloatRange
{
    /// <summary>Checks that every coordinate stays finite as a float.</summary>
    /// <exception cref="ArgumentException">A coordinate would become infinite.</exception>
    public static void Check(Vector3D[] positions)
    {
        for (int v = 0; v < positions.Length; v++)
        {
            Vector3D p = positions[v];
            if (Math.Max(Math.Abs(p.X), Math.Max(Math.Abs(p.Y), Math.Abs(p.Z))) > float.MaxValue)
                throw new ArgumentException($"The position {p} of v{v} is too large for the format's single precision; scale the mesh first.", nameof(positions));
        }
    }
}
