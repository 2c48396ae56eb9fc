using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>§14.3 PLY 文件: reads Stanford's Polygon File Format, text and binary in both byte orders.</summary>
/// <remarks>
/// The header says which tables follow (elements) and their columns (properties). Read are, in whatever order they stand:
/// <code>
/// vertex      x y z   nx ny nz   s t (or u v, texture_u texture_v)   red green blue alpha
/// face        vertex_indices (or vertex_index)   texcoord, normal (lists, per corner)   red green blue alpha   label_KIND
/// tristrips   vertex_indices: strips of triangles, −1 between them
/// </code>
/// Other elements and properties are skipped and counted. Integer colours are from 0 to 255 (short ones to 65535), others as they stand. In text every
/// instance stands on its own line. Linear time.
/// </remarks>
internal static class PlyReader
{
    private const int InstancesPerCheck = 1 << 15;

    public static MeshData Read(ReadOnlySpan<byte> file, ReadContext context)
    {
        PlyHeader header = PlyHeader.Read(file, context);
        PlyCursor cursor = new(file, header, context);
        PlyVertexTable vertices = new();
        PlyFaceTable faces = new(header.Elements.Find(e => e.Name == "vertex")?.Count ?? 0);
        foreach (PlyElement element in header.Elements)
        {
            switch (element.Name)
            {
                case "vertex":
                    vertices.Read(ref cursor, element, context);
                    break;
                case "face":
                    faces.Read(ref cursor, element, header, context);
                    break;
                case "tristrips":
                    faces.ReadStrips(ref cursor, element, context);
                    break;
                default:
                    context.CountIgnored($"element {element.Name}", Math.Max(element.Count, 1));
                    cursor.SkipElement(element);
                    break;
            }
        }

        cursor.Finish();
        MeshData data = new() { Positions = vertices.Positions, FaceStart = faces.FaceStart, Corners = faces.Corners };
        data.VertexNormals = vertices.Normals;
        data.VertexTextureCoordinates = vertices.TextureCoordinates;
        data.VertexColors = vertices.Colors;
        data.CornerNormals = faces.CornerNormals;
        data.CornerTextureCoordinates = faces.CornerTextureCoordinates;
        data.FaceColors = faces.Colors;
        data.FaceLabels = faces.Labels;
        return data;
    }

    /// <summary>Finds the first of the names among the properties that are single numbers; −1 if there is none.</summary>
    public static int FindNumber(PlyElement element, params ReadOnlySpan<string> names)
    {
        foreach (string name in names)
        {
            int index = element.Properties.FindIndex(p => !p.IsList && p.Name == name);
            if (index >= 0)
                return index;
        }

        return -1;
    }

    /// <summary>Counts the properties that nobody reads.</summary>
    public static void CountIgnored(PlyElement element, ReadOnlySpan<int> used, ReadContext context)
    {
        for (int p = 0; p < element.Properties.Count; p++)
        {
            if (!used.Contains(p))
                context.CountIgnored($"property {element.Name}.{element.Properties[p].Name}");
        }
    }

    /// <summary>Tells from time to time how far reading is, and whether it shall go on.</summary>
    public static void CheckSometimes(int instance, ref PlyCursor cursor, ReadContext context)
    {
        if (instance % InstancesPerCheck == 0)
            context.Check(ReadContext.ReadShare * cursor.Fraction);
    }

    /// <summary>What a colour's number is divided by.</summary>
    public static float ColorUnit(PlyType type) => type switch
    {
        PlyType.Float32 or PlyType.Float64 => 1,
        PlyType.Int16 or PlyType.UInt16 => ushort.MaxValue,
        _ => byte.MaxValue,
    };
}
