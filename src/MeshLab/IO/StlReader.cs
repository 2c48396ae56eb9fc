using System.Buffers.Binary;
using System.Text;
using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>§14.3 STL 文件: reads stereolithography files, text and binary.</summary>
/// <remarks>
/// <code>
/// solid NAME                        80 bytes of header
///   facet normal x y z              number of triangles (4 bytes)
///     outer loop                    per triangle: normal, three vertices (12 floats), 2 bytes
///       vertex x y z   (three)
///     endloop
///   endfacet
/// endsolid NAME
/// </code>
/// STL has no shared vertices; they are found again by joining exactly equal coordinates (welding, 焊接), in the order of their first appearance. The normals are not
/// used: the order of the corners says the same. Keywords in any case; several solids become labels of the kind <see cref="FaceLabelSet.Object"/>. A file
/// is binary if its length fits its count, whatever its first word. Linear time.
/// </remarks>
internal static class StlReader
{
    private const int HeaderBytes = 84, FacetBytes = 50;
    private const int FacetsPerCheck = 1 << 15;

    public static MeshData Read(ReadOnlySpan<byte> file, ReadContext context) =>
        IsBinary(file) ? ReadBinary(file, context) : ReadText(file, context);

    private static bool IsBinary(ReadOnlySpan<byte> file)
    {
        if (file.Length >= HeaderBytes && HeaderBytes + (long)FacetBytes * FacetCount(file) == file.Length)
            return true;
        ReadOnlySpan<byte> text = file.TrimStart("\uFEFF \t\r\n"u8);
        bool beginsAsText = text.Length >= 5 && Ascii.EqualsIgnoreCase(text[..5], "solid"u8);
        return file.Length >= HeaderBytes && (!beginsAsText || file.Contains((byte)0));
    }

    private static uint FacetCount(ReadOnlySpan<byte> file) => BinaryPrimitives.ReadUInt32LittleEndian(file[80..]);

    private static MeshData ReadBinary(ReadOnlySpan<byte> file, ReadContext context)
    {
        context.Encoding = MeshEncoding.BinaryLittleEndian;
        long count = FacetCount(file), present = (file.Length - HeaderBytes) / FacetBytes;
        if (count > present)
            throw context.BinaryError(file.Length, "the end of the file", $"facet {present + 1} of {count}");
        // A few bytes behind the facets are somebody's padding; a whole facet's worth means that the count is too small.
        if (count < present)
            throw context.BinaryError(HeaderBytes + count * FacetBytes, $"{file.Length - HeaderBytes - count * FacetBytes} more bytes", $"the end of the file after {count} facets");
        context.TrailingBytes = file.Length - HeaderBytes - count * FacetBytes;

        Vector3D[] corners = new Vector3D[3 * count];
        for (int f = 0; f < count; f++)
        {
            if (f % FacetsPerCheck == 0)
                context.Check(ReadContext.ReadShare * f / count);
            int offset = HeaderBytes + f * FacetBytes + 12;
            for (int k = 0; k < 3; k++, offset += 12)
                corners[3 * f + k] = ReadVertex(file, offset, context);
            if (BinaryPrimitives.ReadUInt16LittleEndian(file[offset..]) != 0)
                context.CountIgnored("attribute bytes of a facet");
        }

        return Assemble(corners, [], context);
    }

    private static Vector3D ReadVertex(ReadOnlySpan<byte> file, int offset, ReadContext context)
    {
        Vector3D vertex = new(
            BinaryPrimitives.ReadSingleLittleEndian(file[offset..]),
            BinaryPrimitives.ReadSingleLittleEndian(file[(offset + 4)..]),
            BinaryPrimitives.ReadSingleLittleEndian(file[(offset + 8)..]));
        return vertex.IsFinite ? vertex : throw context.BinaryError(offset, $"the vertex {vertex}", "finite coordinates");
    }

    private static MeshData ReadText(ReadOnlySpan<byte> file, ReadContext context)
    {
        TextScanner scanner = new(file, file.StartsWith("\uFEFF"u8) ? 3 : 0, file.Length, context);
        GrowingArray<Vector3D> corners = new(file.Length / 64);
        List<(int Face, string Name)> solids = [];
        Expect(ref scanner, "solid"u8, "solid");
        while (true)
        {
            solids.Add((corners.Count / 3, Encoding.UTF8.GetString(scanner.ReadRestOfLine())));
            ReadFacets(ref scanner, ref corners, file.Length, context);
            scanner.ReadRestOfLine();
            scanner.SkipLinesAndComments();
            if (scanner.AtEnd)
                return Assemble(corners.ToArray(), solids, context);
            Expect(ref scanner, "solid"u8, "solid or the end of the file");
        }
    }

    /// <summary>Reads facets up to and with <c>endsolid</c>.</summary>
    private static void ReadFacets(ref TextScanner scanner, ref GrowingArray<Vector3D> corners, int fileLength, ReadContext context)
    {
        while (!TryTake(ref scanner, "endsolid"u8))
        {
            if (corners.Count % (3 * FacetsPerCheck) == 0)
                context.Check(ReadContext.ReadShare * scanner.Position / fileLength);
            Expect(ref scanner, "facet"u8, "facet or endsolid");
            Expect(ref scanner, "normal"u8, "normal");
            for (int k = 0; k < 3; k++)
            {
                scanner.SkipLinesAndComments();
                scanner.ReadAttribute("a normal's coordinate");
            }

            Expect(ref scanner, "outer"u8, "outer loop");
            Expect(ref scanner, "loop"u8, "loop");
            for (int k = 0; k < 3; k++)
            {
                Expect(ref scanner, "vertex"u8, "vertex");
                corners.Add(new Vector3D(ReadCoordinate(ref scanner), ReadCoordinate(ref scanner), ReadCoordinate(ref scanner)));
            }

            Expect(ref scanner, "endloop"u8, "endloop after three vertices");
            Expect(ref scanner, "endfacet"u8, "endfacet");
        }
    }

    private static double ReadCoordinate(ref TextScanner scanner)
    {
        scanner.SkipLinesAndComments();
        return scanner.ReadFinite("a finite coordinate");
    }

    private static void Expect(ref TextScanner scanner, ReadOnlySpan<byte> keyword, string expected)
    {
        if (!TryTake(ref scanner, keyword))
            throw scanner.Error(expected);
    }

    private static bool TryTake(ref TextScanner scanner, ReadOnlySpan<byte> keyword)
    {
        scanner.SkipLinesAndComments();
        ReadOnlySpan<byte> token = scanner.PeekToken();
        if (!Ascii.EqualsIgnoreCase(token, keyword))
            return false;
        scanner.Position += token.Length;
        return true;
    }

    private static MeshData Assemble(Vector3D[] corners, List<(int Face, string Name)> solids, ReadContext context)
    {
        int faces = corners.Length / 3;
        FaceLabelCollector labels = new(faces);
        foreach ((int face, string name) in solids)
            labels.Change(FaceLabelSet.Object, face, name);

        int[] faceStart = new int[faces + 1], indices = new int[corners.Length];
        for (int f = 0; f <= faces; f++)
            faceStart[f] = 3 * f;
        Vector3D[] positions = corners;
        if (context.Options.Weld)
        {
            positions = ExactWeld.Weld(corners, indices);
            context.WeldedVertices = corners.Length - positions.Length;
        }
        else
        {
            for (int c = 0; c < indices.Length; c++)
                indices[c] = c;
        }

        return new MeshData { Positions = positions, FaceStart = faceStart, Corners = indices, FaceLabels = labels.ToSets() };
    }
}
