using System.Globalization;
using System.Text;
using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>Writes binary glTF 2.0 (Khronos 2021) for viewers: one mesh of triangles with positions, vertex normals, colours and texture coordinates, in single precision.</summary>
/// <remarks>
/// <code>
/// "glTF" 2 length | length "JSON" {…} | length "BIN\0" indices, then one table per attribute
/// </code>
/// Vertex normals that the mesh does not have are those of its faces, weighted by area. Values that differ between the corners of a vertex are not written.
/// </remarks>
internal static class GlbWriter
{
    private const int JsonChunk = 0x4E4F534A, BinaryChunk = 0x004E4942;
    private const int FloatType = 5126, UIntType = 5125;

    public static void Write(MeshData data, BlockWriter writer)
    {
        FloatRange.Check(data.Positions);
        (int[] corners, _) = FaceTriangles.Of(data);
        Vector3D[] normals = data.VertexNormals ?? AreaWeightedNormals(data, corners);
        byte[] json = Json(data, corners.Length);
        int binaryLength = BinaryLength(data, corners.Length);

        writer.Write(b =>
        {
            b.Append("glTF"u8);
            b.AppendBinary(2, isBig: false);
            b.AppendBinary(checked(12 + 8 + json.Length + (binaryLength > 0 ? 8 + binaryLength : 0)), isBig: false);
            b.AppendBinary(json.Length, isBig: false);
            b.AppendBinary(JsonChunk, isBig: false);
            b.Append(json);
            if (binaryLength == 0)
                return;
            b.AppendBinary(binaryLength, isBig: false);
            b.AppendBinary(BinaryChunk, isBig: false);
        });
        if (binaryLength == 0)
            return;
        writer.WriteRows(corners.Length, 0.4, (from, to, b) =>
        {
            for (int c = from; c < to; c++)
                b.AppendBinary(corners[c], isBig: false);
        });
        writer.WriteRows(data.VertexCount, 0.3, (from, to, b) => AppendVectors(b, data.Positions, from, to));
        writer.WriteRows(data.VertexCount, 0.3, (from, to, b) =>
        {
            for (int v = from; v < to; v++)
            {
                // Every normal must have length 1; a vertex without area gets any.
                Vector3D normal = normals[v].Normalized();
                Append(b, normal == default ? Vector3D.UnitZ : normal);
            }
        });
        if (data.VertexColors is { } colors)
            writer.WriteRows(data.VertexCount, 0, (from, to, b) => AppendColors(b, colors, from, to));
        if (data.VertexTextureCoordinates is { } texture)
            writer.WriteRows(data.VertexCount, 0, (from, to, b) => AppendTexture(b, texture, from, to));
    }

    private static int BinaryLength(MeshData data, int corners) => corners == 0
        ? 0
        : checked(4 * corners + 24 * data.VertexCount + (data.VertexColors is null ? 0 : 16 * data.VertexCount) + (data.VertexTextureCoordinates is null ? 0 : 8 * data.VertexCount));

    private static Vector3D[] AreaWeightedNormals(MeshData data, int[] corners)
    {
        Vector3D[] normals = new Vector3D[data.VertexCount];
        for (int c = 0; c < corners.Length; c += 3)
        {
            Vector3D p = data.Positions[corners[c]];
            Vector3D normal = Vector3D.Cross(data.Positions[corners[c + 1]] - p, data.Positions[corners[c + 2]] - p);
            for (int k = 0; k < 3; k++)
                normals[corners[c + k]] += normal;
        }

        return normals;
    }

    private static void AppendVectors(ByteBuffer b, Vector3D[] vectors, int from, int to)
    {
        for (int v = from; v < to; v++)
            Append(b, vectors[v]);
    }

    private static void Append(ByteBuffer b, Vector3D vector)
    {
        b.AppendBinary((float)vector.X, isBig: false);
        b.AppendBinary((float)vector.Y, isBig: false);
        b.AppendBinary((float)vector.Z, isBig: false);
    }

    /// <summary>glTF's colours are linear, the library's are sRGB.</summary>
    private static void AppendColors(ByteBuffer b, Color[] colors, int from, int to)
    {
        for (int v = from; v < to; v++)
        {
            b.AppendBinary(ToLinear(colors[v].R), isBig: false);
            b.AppendBinary(ToLinear(colors[v].G), isBig: false);
            b.AppendBinary(ToLinear(colors[v].B), isBig: false);
            b.AppendBinary(Math.Clamp(colors[v].A, 0, 1), isBig: false);
        }
    }

    private static float ToLinear(float channel)
    {
        float c = Math.Clamp(channel, 0, 1);
        return c <= 0.04045f ? c / 12.92f : MathF.Pow((c + 0.055f) / 1.055f, 2.4f);
    }

    /// <summary>glTF's v runs downwards.</summary>
    private static void AppendTexture(ByteBuffer b, Vector2D[] texture, int from, int to)
    {
        for (int v = from; v < to; v++)
        {
            b.AppendBinary((float)texture[v].X, isBig: false);
            b.AppendBinary((float)(1 - texture[v].Y), isBig: false);
        }
    }

    private static byte[] Json(MeshData data, int corners)
    {
        StringBuilder json = new("{\"asset\":{\"version\":\"2.0\",\"generator\":\"MeshLab\"}");
        if (corners > 0)
            AppendScene(json, data, corners);
        json.Append('}');
        // Chunks are multiples of four bytes; JSON is padded with blanks.
        while (Encoding.UTF8.GetByteCount(json.ToString()) % 4 != 0)
            json.Append(' ');
        return Encoding.UTF8.GetBytes(json.ToString());
    }

    private static void AppendScene(StringBuilder json, MeshData data, int corners)
    {
        List<(string Name, string Type, int Size)> attributes = [("POSITION", "VEC3", 12), ("NORMAL", "VEC3", 12)];
        if (data.VertexColors is not null)
            attributes.Add(("COLOR_0", "VEC4", 16));
        if (data.VertexTextureCoordinates is not null)
            attributes.Add(("TEXCOORD_0", "VEC2", 8));

        json.Append(",\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":{");
        json.AppendJoin(',', attributes.Select((a, i) => $"\"{a.Name}\":{i + 1}"));
        json.Append("},\"indices\":0,\"material\":0}]}],\"materials\":[{\"doubleSided\":true,\"pbrMetallicRoughness\":{\"metallicFactor\":0,\"roughnessFactor\":0.8}}]");

        json.Append(CultureInfo.InvariantCulture, $",\"accessors\":[{{\"bufferView\":0,\"componentType\":{UIntType},\"count\":{corners},\"type\":\"SCALAR\"}}");
        for (int i = 0; i < attributes.Count; i++)
        {
            json.Append(CultureInfo.InvariantCulture, $",{{\"bufferView\":{i + 1},\"componentType\":{FloatType},\"count\":{data.VertexCount},\"type\":\"{attributes[i].Type}\"");
            if (i == 0)
                AppendBounds(json, BoundingBox.Of(data.Positions));
            json.Append('}');
        }

        json.Append(CultureInfo.InvariantCulture, $"],\"bufferViews\":[{{\"buffer\":0,\"byteOffset\":0,\"byteLength\":{4 * corners},\"target\":34963}}");
        int offset = 4 * corners;
        foreach ((_, _, int size) in attributes)
        {
            int length = size * data.VertexCount;
            json.Append(CultureInfo.InvariantCulture, $",{{\"buffer\":0,\"byteOffset\":{offset},\"byteLength\":{length},\"target\":34962}}");
            offset += length;
        }

        json.Append(CultureInfo.InvariantCulture, $"],\"buffers\":[{{\"byteLength\":{offset}}}]");
    }

    private static void AppendBounds(StringBuilder json, BoundingBox box) => json.Append(
        CultureInfo.InvariantCulture,
        $",\"min\":[{(float)box.Min.X},{(float)box.Min.Y},{(float)box.Min.Z}],\"max\":[{(float)box.Max.X},{(float)box.Max.Y},{(float)box.Max.Z}]");
}
