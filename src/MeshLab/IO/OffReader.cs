using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>§14.2 OFF 文件: reads the text form of Geomview's Object File Format.</summary>
/// <remarks>
/// <code>
/// [ST][C][N]OFF               may be missing; the counts may follow on the same line
/// vertices faces [edges]
/// x y z [nx ny nz] [r g b [a]] [s t]     normal after N, colour after C, texture coordinate after ST
/// n  i1 … in  [colour]                   colour: nothing, an index, r g b or r g b a, up to the end of the line
/// # comment
/// </code>
/// Numbers of vertices may be spread over lines in any way. Colours are from 0 to 1, or from 0 to 255 if one of the file is above 1. The edge count is not
/// used. The binary form and points of other dimension than 3 are refused. Linear time.
/// </remarks>
internal static class OffReader
{
    private const int InstancesPerCheck = 1 << 15;

    public static MeshData Read(ReadOnlySpan<byte> file, ReadContext context)
    {
        TextScanner scanner = new(file, file.StartsWith("\uFEFF"u8) ? 3 : 0, file.Length, context);
        Layout layout = ReadHeader(ref scanner);
        int vertexCount = ReadCount(ref scanner, "the number of vertices"), faceCount = ReadCount(ref scanner, "the number of faces");
        SkipEdgeCount(ref scanner);

        Vertices vertices = ReadVertices(ref scanner, layout, vertexCount, file.Length, context);
        Faces faces = ReadFaces(ref scanner, vertexCount, faceCount, file.Length, context);

        scanner.SkipLinesAndComments();
        if (!scanner.AtEnd)
            throw scanner.Error($"the end of the file after {faceCount} faces, the number that it announces");
        return new MeshData
        {
            Positions = vertices.Positions.ToArray(),
            VertexNormals = layout.HasNormals ? vertices.Normals.ToArray() : null,
            VertexColors = layout.HasColors ? vertices.Colors.ToArray() : null,
            VertexTextureCoordinates = layout.HasTextureCoordinates ? vertices.TextureCoordinates.ToArray() : null,
            FaceStart = faces.Start.ToArray(),
            Corners = faces.Corners.ToArray(),
            FaceColors = faces.Colors.ToArray(),
        };
    }

    private readonly record struct Layout(bool HasNormals, bool HasColors, bool HasTextureCoordinates);

    private static Layout ReadHeader(ref TextScanner scanner)
    {
        scanner.SkipLinesAndComments();
        ReadOnlySpan<byte> token = scanner.PeekToken();
        if (token.Length > 0 && token[0] is (>= (byte)'0' and <= (byte)'9') or (byte)'-' or (byte)'+' && token.IndexOf("OFF"u8) < 0)
            return default; // Geomview lets the keyword be missing.

        int keyword = token.IndexOf("OFF"u8);
        ReadOnlySpan<byte> prefix = keyword < 0 ? [] : token[..keyword];
        bool hasTextureCoordinates = TakePrefix(ref prefix, "ST"u8), hasColors = TakePrefix(ref prefix, "C"u8), hasNormals = TakePrefix(ref prefix, "N"u8);
        if (keyword < 0 || !prefix.IsEmpty)
            throw scanner.Error("OFF, COFF, NOFF, STOFF or a combination of them");
        ReadOnlySpan<byte> glued = token[(keyword + 3)..];
        scanner.Position += keyword + 3;
        if (!glued.IsEmpty && glued[0] is not ((>= (byte)'0' and <= (byte)'9') or (byte)'#'))
            throw scanner.Error("a blank after OFF");
        if (!scanner.AtLineEnd() && scanner.PeekToken().SequenceEqual("BINARY"u8))
            throw scanner.Error("the text form of OFF (the binary form is not supported)");
        return new Layout(hasNormals, hasColors, hasTextureCoordinates);
    }

    private static bool TakePrefix(ref ReadOnlySpan<byte> prefix, ReadOnlySpan<byte> letters)
    {
        if (!prefix.StartsWith(letters))
            return false;
        prefix = prefix[letters.Length..];
        return true;
    }

    private static int ReadCount(ref TextScanner scanner, string expected)
    {
        scanner.SkipLinesAndComments();
        int start = scanner.Position;
        int count = scanner.ReadInteger(expected);
        return count >= 0 ? count : throw scanner.ErrorAt(start, expected);
    }

    /// <summary>The third count may be missing; it may also stand alone on the next line.</summary>
    private static void SkipEdgeCount(ref TextScanner scanner)
    {
        if (!scanner.AtLineEnd())
        {
            scanner.ReadInteger("the number of edges");
            return;
        }

        int before = scanner.Position;
        scanner.SkipLinesAndComments();
        if (!scanner.TryReadDigits(out _) || !scanner.AtLineEnd())
            scanner.Position = before;
    }

    private ref struct Vertices
    {
        public GrowingArray<Vector3D> Positions, Normals;
        public GrowingArray<Vector2D> TextureCoordinates;
        public GrowingArray<Color> Colors;
    }

    private static Vertices ReadVertices(ref TextScanner scanner, Layout layout, int count, int fileLength, ReadContext context)
    {
        // A vertex takes 6 bytes at least, so the claimed count alone never decides how much memory is taken.
        long capacity = Math.Min(count, (fileLength - scanner.Position) / 6 + 1);
        Vertices vertices = new() { Positions = new(capacity) };
        if (layout.HasNormals)
            vertices.Normals = new(capacity);
        if (layout.HasTextureCoordinates)
            vertices.TextureCoordinates = new(capacity);
        if (layout.HasColors)
            vertices.Colors = new(capacity);
        scanner.SkipLinesAndComments();
        int channels = layout.HasColors ? CountChannels(scanner, layout) : 0;

        for (int v = 0; v < count; v++)
        {
            if (v % InstancesPerCheck == 0)
                context.Check(ReadContext.ReadShare * scanner.Position / fileLength);
            double x = ReadCoordinate(ref scanner), y = ReadCoordinate(ref scanner), z = ReadCoordinate(ref scanner);
            vertices.Positions.Add(new Vector3D(x, y, z));
            if (layout.HasNormals)
                vertices.Normals.Add(new Vector3D(ReadReplaceable(ref scanner, context), ReadReplaceable(ref scanner, context), ReadReplaceable(ref scanner, context)));
            if (layout.HasColors)
                vertices.Colors.Add(ReadColor(ref scanner, channels, context));
            if (layout.HasTextureCoordinates)
                vertices.TextureCoordinates.Add(new Vector2D(ReadReplaceable(ref scanner, context), ReadReplaceable(ref scanner, context)));
        }

        if (layout.HasColors)
            Normalize(vertices.Colors.Span);
        return vertices;
    }

    /// <summary>How many channels a colour has, judged by the first vertex's line; Geomview's own files have four.</summary>
    private static int CountChannels(TextScanner scanner, Layout layout)
    {
        int numbers = 0;
        while (!scanner.AtLineEnd() && scanner.PeekToken() is { IsEmpty: false } token)
        {
            numbers++;
            scanner.Position += token.Length;
        }

        return numbers - 3 - (layout.HasNormals ? 3 : 0) - (layout.HasTextureCoordinates ? 2 : 0) == 3 ? 3 : 4;
    }

    private static Color ReadColor(ref TextScanner scanner, int channels, ReadContext context)
    {
        double r = ReadNumber(ref scanner), g = ReadNumber(ref scanner), b = ReadNumber(ref scanner);
        double a = channels == 4 ? ReadNumber(ref scanner) : Opaque;
        return MakeColor(r, g, b, a, context);
    }

    // Opaque whatever the range of the channels: told from a stored alpha by its sign.
    private const double Opaque = -1;

    private static Color MakeColor(double r, double g, double b, double a, ReadContext context)
    {
        if (double.IsFinite(r) && double.IsFinite(g) && double.IsFinite(b) && double.IsFinite(a))
            return new Color((float)r, (float)g, (float)b, (float)a);
        context.ReplacedAttributes++;
        return new Color(float.NaN, float.NaN, float.NaN, (float)Opaque);
    }

    /// <summary>Brings channels of 0 to 255 to 0 to 1, and replaces the marks of <see cref="MakeColor"/>.</summary>
    private static void Normalize(Span<Color> colors)
    {
        float largest = 0;
        foreach (Color c in colors)
        {
            if (!float.IsNaN(c.R))
                largest = Math.Max(Math.Max(largest, c.R), Math.Max(Math.Max(c.G, c.B), c.A));
        }

        float unit = largest > 1 ? 255 : 1;
        foreach (ref Color c in colors)
        {
            c = float.IsNaN(c.R)
                ? Color.White
                : new Color(c.R / unit, c.G / unit, c.B / unit, c.A == (float)Opaque ? 1 : c.A / unit);
        }
    }

    private ref struct Faces
    {
        public GrowingArray<int> Start, Corners;
        public FaceColorCollector Colors;
    }

    /// <summary>Face colours: nothing is stored until the first face that has one.</summary>
    private ref struct FaceColorCollector
    {
        private GrowingArray<Color> colors;
        private bool hasAny;

        public void Add(int face, Color color)
        {
            if (!hasAny)
                colors = new(face + 1);
            hasAny = true;
            PadTo(face);
            colors.Add(color);
        }

        public void PadTo(int faces)
        {
            if (hasAny)
                colors.PadTo(faces, new Color(float.NaN, float.NaN, float.NaN));
        }

        public readonly Color[]? ToArray()
        {
            if (!hasAny)
                return null;
            Normalize(colors.Span);
            return colors.ToArray();
        }
    }

    private static Faces ReadFaces(ref TextScanner scanner, int vertexCount, int faceCount, int fileLength, ReadContext context)
    {
        long remaining = fileLength - scanner.Position;
        Faces faces = new() { Start = new(Math.Min(faceCount, remaining / 8) + 1), Corners = new(Math.Min(3L * faceCount, remaining / 2)) };
        faces.Start.Add(0);
        string expectedIndex = $"a vertex index from 0 to {vertexCount - 1}";
        for (int f = 0; f < faceCount; f++)
        {
            if (f % InstancesPerCheck == 0)
                context.Check(ReadContext.ReadShare * scanner.Position / fileLength);
            scanner.SkipLinesAndComments();
            int start = scanner.Position;
            int degree = scanner.ReadInteger("the number of corners of a face");
            if (degree < 3)
                throw scanner.ErrorAt(start, "a face of three or more corners");
            for (int k = 0; k < degree; k++)
            {
                scanner.SkipLinesAndComments();
                start = scanner.Position;
                int index = scanner.ReadInteger(expectedIndex);
                if ((uint)index >= (uint)vertexCount)
                    throw scanner.ErrorAt(start, expectedIndex);
                faces.Corners.Add(index);
            }

            faces.Start.Add(faces.Corners.Count);
            if (!scanner.AtLineEnd())
                ReadFaceColor(ref scanner, f, ref faces.Colors, context);
        }

        faces.Colors.PadTo(faceCount);
        return faces;
    }

    private static void ReadFaceColor(ref TextScanner scanner, int face, ref FaceColorCollector colors, ReadContext context)
    {
        Span<double> channels = stackalloc double[4];
        int count = 0;
        while (!scanner.AtLineEnd())
        {
            if (count == 4)
                throw scanner.Error("the end of the line after a colour");
            channels[count++] = scanner.ReadAttribute("a colour's number or the end of the line");
        }

        if (count == 1)
            context.CountIgnored("index into a colour map");
        else if (count == 2)
            throw scanner.Error("a third number of a colour");
        else
            colors.Add(face, MakeColor(channels[0], channels[1], channels[2], count == 4 ? channels[3] : Opaque, context));
    }

    private static double ReadCoordinate(ref TextScanner scanner)
    {
        if (scanner.AtLineEnd())
            scanner.SkipLinesAndComments();
        return scanner.ReadFinite("a finite coordinate");
    }

    private static double ReadNumber(ref TextScanner scanner)
    {
        scanner.SkipLinesAndComments();
        return scanner.ReadAttribute("a number");
    }

    private static double ReadReplaceable(ref TextScanner scanner, ReadContext context)
    {
        double value = ReadNumber(ref scanner);
        if (double.IsFinite(value))
            return value;
        context.ReplacedAttributes++;
        return 0;
    }
}
