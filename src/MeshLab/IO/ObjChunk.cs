using System.Runtime.CompilerServices;
using System.Text;
using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>One stretch of an OBJ file, read without knowing what stands before it.</summary>
/// <remarks>
/// Two things reach over the border of a stretch: a negative index counts back from the vertices so far, and a group goes on until the next one.
/// Therefore the corners with negative indices are remembered and shifted when the stretches are joined, and the changes of groups are kept as events.
/// </remarks>
internal sealed class ObjChunk
{
    /// <summary>Stands for "this corner names no texture coordinate (or normal)".</summary>
    public const int Missing = int.MinValue;

    private const int BytesPerCheck = 1 << 20;

    private readonly ReadContext context;
    private readonly Dictionary<string, int> ignored = new(StringComparer.Ordinal);
    private GrowingArray<Vector3D> positions;
    private GrowingArray<int> corners;
    private GrowingArray<int> faceEnds;
    private GrowingArray<Color> colors;
    private GrowingArray<Vector2D> texturePool;
    private GrowingArray<Vector3D> normalPool;
    private GrowingArray<int> textureIndices;
    private GrowingArray<int> normalIndices;

    public ObjChunk(ReadContext context, long bytes)
    {
        this.context = context;
        // About 30 bytes a vertex and 20 a face of three corners, two faces a vertex.
        positions = new(bytes / 66);
        corners = new(bytes / 11);
        faceEnds = new(bytes / 33);
    }

    public ref GrowingArray<Vector3D> Positions => ref positions;

    public ref GrowingArray<int> Corners => ref corners;

    public ref GrowingArray<int> FaceEnds => ref faceEnds;

    /// <summary>Not allocated if no vertex has a colour; shorter than the vertices if the last ones have none.</summary>
    public ref GrowingArray<Color> Colors => ref colors;

    public ref GrowingArray<Vector2D> TexturePool => ref texturePool;

    public ref GrowingArray<Vector3D> NormalPool => ref normalPool;

    /// <summary>Not allocated if no corner has one; shorter than the corners if the last ones have none.</summary>
    public ref GrowingArray<int> TextureIndices => ref textureIndices;

    /// <inheritdoc cref="TextureIndices"/>
    public ref GrowingArray<int> NormalIndices => ref normalIndices;

    /// <summary>The corners whose index counts back, and so is short of the vertices of the stretches before.</summary>
    public List<int> RelativeCorners { get; } = [];

    public List<int> RelativeTextureIndices { get; } = [];

    public List<int> RelativeNormalIndices { get; } = [];

    public List<(int Face, string Kind, string Name)> Events { get; } = [];

    public List<string> MaterialLibraries { get; } = [];

    public IReadOnlyDictionary<string, int> Ignored => ignored;

    public long IgnoredLines { get; private set; }

    public long IgnoredWeights { get; private set; }

    public long ReplacedAttributes { get; private set; }

    /// <summary>How many lines said something that the reader knows.</summary>
    public long KnownLines { get; private set; }

    /// <summary>The first line that said nothing known.</summary>
    public int FirstIgnoredPosition { get; private set; } = -1;

    /// <summary>The numbers of vertices, texture coordinates and normals of the whole file if they are known: then every index is checked where it stands.</summary>
    public (int Vertices, int? TextureCoordinates, int? Normals)? Limits { get; init; }

    /// <summary>Reads the lines from one byte to another.</summary>
    public void Read(ReadOnlySpan<byte> text, int from, int to, bool reports)
    {
        TextScanner scanner = new(text, from, to, context);
        int nextCheck = from;
        while (!scanner.AtEnd)
        {
            if (scanner.Position >= nextCheck)
            {
                nextCheck = (int)Math.Min((long)scanner.Position + BytesPerCheck, int.MaxValue);
                context.ThrowIfCancelled();
                if (reports)
                    context.Check(ReadContext.ReadShare * (scanner.Position - from) / (to - from));
            }

            ReadLine(ref scanner);
            scanner.NextLine();
        }
    }

    private void ReadLine(ref TextScanner scanner)
    {
        if (scanner.AtLineEnd())
            return;
        byte first = scanner.Current, second = scanner.Following;
        if (first == 'v' && second <= ' ')
        {
            scanner.Position++;
            ReadVertex(ref scanner);
        }
        else if (first == 'f' && second <= ' ')
        {
            scanner.Position++;
            ReadFace(ref scanner);
        }
        else
        {
            ReadOther(ref scanner);
        }
    }

    /// <summary>v x y z, v x y z w, v x y z r g b, v x y z r g b a, or v x y z w r g b a.</summary>
    private void ReadVertex(ref TextScanner scanner)
    {
        double x = scanner.ReadFinite("a finite coordinate");
        double y = scanner.ReadFinite("a finite coordinate");
        double z = scanner.ReadFinite("a finite coordinate");
        positions.Add(new Vector3D(x, y, z));
        if (!scanner.AtLineEnd())
            ReadWeightAndColor(ref scanner);
    }

    private void ReadWeightAndColor(ref TextScanner scanner)
    {
        Span<double> rest = stackalloc double[5];
        int count = 0;
        while (!scanner.AtLineEnd())
        {
            if (count == rest.Length)
                throw scanner.Error("the end of the line after 8 numbers");
            rest[count++] = scanner.ReadAttribute("a number or the end of the line");
        }

        if (count == 2)
            throw scanner.Error("a sixth number: 3 coordinates, and a weight, a colour or both");
        if (count is 1 or 5)
        {
            if (rest[0] != 1)
                IgnoredWeights++;
            rest = rest[1..];
            count--;
        }

        if (count == 0)
            return;
        if (!colors.IsAllocated)
            colors = new(positions.Count + 1);
        colors.PadTo(positions.Count - 1, Color.White);
        Span<double> channels = rest[..count];
        bool isFinite = true;
        foreach (double channel in channels)
            isFinite &= double.IsFinite(channel);
        if (!isFinite)
            ReplacedAttributes++;
        colors.Add(isFinite ? new((float)rest[0], (float)rest[1], (float)rest[2], count == 4 ? (float)rest[3] : 1) : Color.White);
    }

    /// <summary>f with three or more corners v, v/t, v//n or v/t/n.</summary>
    private void ReadFace(ref TextScanner scanner)
    {
        int first = corners.Count;
        while (!scanner.AtLineEnd())
        {
            int index = ReadIndex(ref scanner, positions.Count, Limits?.Vertices, "a vertex index", out bool isRelative);
            if (isRelative)
                RelativeCorners.Add(corners.Count);
            corners.Add(index);
            if (scanner.Current == '/')
                ReadCornerAttributes(ref scanner);
            if (scanner.Current > ' ' && scanner.Current != '\\')
                throw scanner.Error("a blank or the end of the line");
        }

        if (corners.Count - first < 3)
            throw scanner.Error("three or more corners of a face");
        faceEnds.Add(corners.Count);
    }

    private void ReadCornerAttributes(ref TextScanner scanner)
    {
        scanner.Position++;
        if (scanner.Current is not ((byte)'/' or <= (byte)' '))
        {
            int index = ReadIndex(ref scanner, texturePool.Count, Limits?.TextureCoordinates, "a texture coordinate's index", out bool isRelative);
            AddIndex(ref textureIndices, index, isRelative ? RelativeTextureIndices : null);
        }

        if (scanner.Current != '/')
            return;
        scanner.Position++;
        if (scanner.Current > ' ')
        {
            int index = ReadIndex(ref scanner, normalPool.Count, Limits?.Normals, "a normal's index", out bool isRelative);
            AddIndex(ref normalIndices, index, isRelative ? RelativeNormalIndices : null);
        }
    }

    private void AddIndex(ref GrowingArray<int> indices, int index, List<int>? relative)
    {
        int corner = corners.Count - 1;
        if (!indices.IsAllocated)
            indices = new(corners.Count + 1);
        indices.PadTo(corner, Missing);
        relative?.Add(corner);
        indices.Add(index);
    }

    /// <summary>Reads an index from 1 or back from −1, and returns it from 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int ReadIndex(ref TextScanner scanner, int count, int? limit, string expected, out bool isRelative)
    {
        int start = scanner.Position;
        if (!scanner.TryReadDigits(out int index) || index == 0)
            throw scanner.ErrorAt(start, expected);
        isRelative = index < 0;
        index = isRelative ? count + index : index - 1;
        if (limit is int known && (index < 0 || index >= known))
            throw scanner.ErrorAt(start, $"{expected} of at most {(isRelative ? count : known)}");
        return index;
    }

    private void ReadOther(ref TextScanner scanner)
    {
        int start = scanner.Position;
        ReadOnlySpan<byte> keyword = scanner.PeekToken();
        if (keyword.IsEmpty)
            throw scanner.Error("text");
        scanner.Position += keyword.Length;
        KnownLines++;
        if (keyword.SequenceEqual("vt"u8))
            ReadTextureCoordinate(ref scanner);
        else if (keyword.SequenceEqual("vn"u8))
            ReadNormal(ref scanner);
        else if (keyword.SequenceEqual("o"u8))
            AddEvent(ref scanner, FaceLabelSet.Object);
        else if (keyword.SequenceEqual("g"u8))
            AddEvent(ref scanner, FaceLabelSet.Group);
        else if (keyword.SequenceEqual("s"u8))
            AddEvent(ref scanner, FaceLabelSet.Smoothing);
        else if (keyword.SequenceEqual("usemtl"u8))
            AddEvent(ref scanner, FaceLabelSet.Material);
        else if (keyword.SequenceEqual("mtllib"u8))
            MaterialLibraries.Add(Encoding.UTF8.GetString(scanner.ReadRestOfLine()));
        else
            Ignore(ref scanner, keyword, start);
    }

    private void ReadTextureCoordinate(ref TextScanner scanner)
    {
        double u = ReadReplaceable(ref scanner, "a texture coordinate");
        double v = scanner.AtLineEnd() ? 0 : ReadReplaceable(ref scanner, "a texture coordinate or the end of the line");
        if (!scanner.AtLineEnd())
            scanner.ReadAttribute("a third texture coordinate or the end of the line");
        if (!scanner.AtLineEnd())
            throw scanner.Error("the end of the line");
        if (!texturePool.IsAllocated)
            texturePool = new(16);
        texturePool.Add(new Vector2D(u, v));
    }

    private void ReadNormal(ref TextScanner scanner)
    {
        double x = ReadReplaceable(ref scanner, "a normal's coordinate");
        double y = ReadReplaceable(ref scanner, "a normal's coordinate");
        double z = ReadReplaceable(ref scanner, "a normal's coordinate");
        if (!scanner.AtLineEnd())
            throw scanner.Error("the end of the line");
        if (!normalPool.IsAllocated)
            normalPool = new(16);
        normalPool.Add(new Vector3D(x, y, z));
    }

    private double ReadReplaceable(ref TextScanner scanner, string expected)
    {
        double value = scanner.ReadAttribute(expected);
        if (double.IsFinite(value))
            return value;
        ReplacedAttributes++;
        return 0;
    }

    /// <summary>From the next face on, another object, group, material or smoothing group; an empty name ends the last one.</summary>
    private void AddEvent(ref TextScanner scanner, string kind)
    {
        ReadOnlySpan<byte> name = scanner.ReadRestOfLine();
        bool isOff = kind == FaceLabelSet.Smoothing && (name.SequenceEqual("off"u8) || name.SequenceEqual("0"u8));
        Events.Add((faceEnds.Count, kind, isOff ? "" : Encoding.UTF8.GetString(name)));
    }

    private void Ignore(ref TextScanner scanner, ReadOnlySpan<byte> keyword, int start)
    {
        KnownLines--;
        // Text in a strange keyword is somebody's extension; control characters are not text at all.
        foreach (byte c in scanner.ReadRestOfLine())
        {
            if (c is < (byte)' ' and not (byte)'\t' and not (byte)'\f' and not (byte)'\v')
                throw scanner.ErrorAt(start, "a line of text");
        }

        if (keyword[0] is (byte)'v' or (byte)'f' && keyword.Length > 1 && keyword[1] is (>= (byte)'0' and <= (byte)'9') or (byte)'-' or (byte)'+')
            throw scanner.ErrorAt(start, $"a blank after {(char)keyword[0]}");
        if (FirstIgnoredPosition < 0)
            FirstIgnoredPosition = start;
        IgnoredLines++;
        string name = Encoding.UTF8.GetString(keyword.Length > 32 ? keyword[..32] : keyword);
        if (ignored.Count < 64 || ignored.ContainsKey(name))
            ignored[name] = ignored.GetValueOrDefault(name) + 1;
    }
}
