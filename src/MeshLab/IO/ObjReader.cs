using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>§14.1 OBJ 文件: reads Wavefront OBJ.</summary>
/// <remarks>
/// <code>
/// v  x y z [w] [r g b [a]]     vertex; weight w is not used
/// vt u [v [w]]   vn x y z      texture coordinate, normal
/// f  i  |  i/t  |  i//n  |  i/t/n   three times or more; from 1, or back from −1
/// o  g  s  usemtl              name the faces that follow
/// #                            comment; \ at a line's end joins the next line
/// </code>
/// An index may name a vertex that comes later in the file; indices of texture coordinates and normals are left out if the file has none at all. Lines that begin otherwise are counted and left out.
/// A long file is cut at line ends into stretches, one per thread, that are joined afterwards: the result is the same, and so is the error, which is the
/// first one of the file. Linear time.
/// </remarks>
internal static class ObjReader
{
    public static MeshData Read(ReadOnlyMemory<byte> file, ReadContext context)
    {
        int[] cuts = Cut(file.Span, context.Options);
        ObjChunk[] chunks = new ObjChunk[cuts.Length - 1];
        OrderedTasks.Run(chunks.Length, c =>
        {
            chunks[c] = new ObjChunk(context, cuts[c + 1] - cuts[c]);
            chunks[c].Read(file.Span, cuts[c], cuts[c + 1], reports: c == 0);
        });

        MeshData? data = Join(chunks, context);
        if (data is null)
            ThrowAtBadIndex(file.Span, chunks, context);
        RefuseForeignText(file.Span, chunks, context);
        return data!;
    }

    /// <summary>The borders of the stretches: line starts near equal shares of the bytes.</summary>
    private static int[] Cut(ReadOnlySpan<byte> text, MeshReadOptions options)
    {
        int start = text.StartsWith("\uFEFF"u8) ? 3 : 0;
        int threads = options.MaxChunks > 0 ? options.MaxChunks : Parallelism.Threads;
        int count = (int)Math.Clamp((long)text.Length / options.MinChunkBytes, 1, threads);
        List<int> cuts = [start];
        for (int c = 1; c < count; c++)
        {
            int cut = NextLineStart(text, Math.Max((int)((long)text.Length * c / count), cuts[^1]));
            if (cut > cuts[^1] && cut < text.Length)
                cuts.Add(cut);
        }

        cuts.Add(text.Length);
        return [.. cuts];
    }

    private static int NextLineStart(ReadOnlySpan<byte> text, int position)
    {
        while (true)
        {
            int length = text[position..].IndexOfAny((byte)'\n', (byte)'\r');
            if (length < 0)
                return text.Length;
            position += length;
            bool isCrLf = text[position] == '\r' && position + 1 < text.Length && text[position + 1] == '\n';
            bool isContinued = position > 0 && (text[position - 1] == '\\' || (text[position - 1] == '\r' && position > 1 && text[position - 2] == '\\'));
            position += isCrLf ? 2 : 1;
            if (!isContinued)
                return position;
        }
    }

    /// <summary>The stretches as one; null if an index names nothing.</summary>
    private static MeshData? Join(ObjChunk[] chunks, ReadContext context)
    {
        int vertices = 0, faces = 0, cornerCount = 0, textureCoordinates = 0, normals = 0;
        bool hasColors = false, hasTextureIndices = false, hasNormalIndices = false;
        foreach (ObjChunk chunk in chunks)
        {
            foreach (int corner in chunk.RelativeCorners)
                chunk.Corners[corner] += vertices;
            foreach (int corner in chunk.RelativeTextureIndices)
                chunk.TextureIndices[corner] += textureCoordinates;
            foreach (int corner in chunk.RelativeNormalIndices)
                chunk.NormalIndices[corner] += normals;
            vertices += chunk.Positions.Count;
            faces += chunk.FaceEnds.Count;
            cornerCount += chunk.Corners.Count;
            textureCoordinates += chunk.TexturePool.Count;
            normals += chunk.NormalPool.Count;
            hasColors |= chunk.Colors.IsAllocated;
            hasTextureIndices |= chunk.TextureIndices.IsAllocated;
            hasNormalIndices |= chunk.NormalIndices.IsAllocated;
        }

        Vector3D[] positions = GC.AllocateUninitializedArray<Vector3D>(vertices);
        int[] corners = GC.AllocateUninitializedArray<int>(cornerCount), faceStart = GC.AllocateUninitializedArray<int>(faces + 1);
        faceStart[0] = 0;
        OrderedTasks.Run(chunks.Length, c => CopyGeometry(chunks, c, positions, corners, faceStart));
        if (!AreInRange(corners, vertices))
            return null;

        MeshData data = new() { Positions = positions, Corners = corners, FaceStart = faceStart, FaceLabels = JoinLabels(chunks, faces) };
        if (hasColors)
            data.VertexColors = JoinPadded(chunks, vertices, static c => c.Positions.Count, static c => c.Colors.Span, Color.White);
        if (textureCoordinates == 0 && hasTextureIndices)
        {
            context.CountIgnored("texture coordinate index without vt", chunks.Sum(c => CountPresent(c.TextureIndices)));
        }
        else if (textureCoordinates > 0)
        {
            int[] indices = JoinPadded(chunks, cornerCount, static c => c.Corners.Count, static c => c.TextureIndices.Span, ObjChunk.Missing);
            Vector2D[] pool = JoinPadded(chunks, textureCoordinates, static c => c.TexturePool.Count, static c => c.TexturePool.Span, default);
            if (!AreInRangeOrMissing(indices, textureCoordinates))
                return null;
            (data.VertexTextureCoordinates, data.CornerTextureCoordinates) = CornerAttributes.Distribute<Vector2D>(pool, indices, corners, vertices);
        }

        if (normals == 0 && hasNormalIndices)
        {
            context.CountIgnored("normal index without vn", chunks.Sum(c => CountPresent(c.NormalIndices)));
        }
        else if (normals > 0)
        {
            int[] indices = JoinPadded(chunks, cornerCount, static c => c.Corners.Count, static c => c.NormalIndices.Span, ObjChunk.Missing);
            Vector3D[] pool = JoinPadded(chunks, normals, static c => c.NormalPool.Count, static c => c.NormalPool.Span, default);
            if (!AreInRangeOrMissing(indices, normals))
                return null;
            (data.VertexNormals, data.CornerNormals) = CornerAttributes.Distribute<Vector3D>(pool, indices, corners, vertices);
        }

        Report(chunks, context);
        return data;
    }

    private static int CountPresent(GrowingArray<int> indices) => indices.IsAllocated ? indices.Count - indices.Span.Count(ObjChunk.Missing) : 0;

    private static void CopyGeometry(ObjChunk[] chunks, int c, Vector3D[] positions, int[] corners, int[] faceStart)
    {
        int vertex = 0, corner = 0, face = 0;
        foreach (ObjChunk earlier in chunks.AsSpan(0, c))
        {
            vertex += earlier.Positions.Count;
            corner += earlier.Corners.Count;
            face += earlier.FaceEnds.Count;
        }

        chunks[c].Positions.Span.CopyTo(positions.AsSpan(vertex));
        chunks[c].Corners.Span.CopyTo(corners.AsSpan(corner));
        Span<int> ends = chunks[c].FaceEnds.Span, starts = faceStart.AsSpan(face + 1, ends.Length);
        for (int f = 0; f < ends.Length; f++)
            starts[f] = ends[f] + corner;
    }

    private delegate ReadOnlySpan<T> ColumnOf<T>(ObjChunk chunk);

    /// <summary>The columns of all stretches one after the other, each padded to its length.</summary>
    private static T[] JoinPadded<T>(ObjChunk[] chunks, int total, Func<ObjChunk, int> lengthOf, ColumnOf<T> columnOf, T padding)
    {
        T[] joined = new T[total];
        int at = 0;
        foreach (ObjChunk chunk in chunks)
        {
            int length = lengthOf(chunk);
            ReadOnlySpan<T> column = columnOf(chunk);
            column.CopyTo(joined.AsSpan(at));
            joined.AsSpan(at + column.Length, length - column.Length).Fill(padding);
            at += length;
        }

        return joined;
    }

    private static FaceLabelSet[] JoinLabels(ObjChunk[] chunks, int faces)
    {
        FaceLabelCollector labels = new(faces);
        int firstFace = 0;
        foreach (ObjChunk chunk in chunks)
        {
            foreach ((int face, string kind, string name) in chunk.Events)
                labels.Change(kind, firstFace + face, name);
            firstFace += chunk.FaceEnds.Count;
        }

        return labels.ToSets();
    }

    private static bool AreInRange(ReadOnlySpan<int> indices, int count)
    {
        // One comparison of the largest, as unsigned numbers: the loop has no branch.
        uint largest = 0;
        foreach (int index in indices)
            largest = Math.Max(largest, (uint)index);
        return indices.IsEmpty || largest < (uint)count;
    }

    private static bool AreInRangeOrMissing(ReadOnlySpan<int> indices, int count)
    {
        foreach (int index in indices)
        {
            if ((uint)index >= (uint)count && index != ObjChunk.Missing)
                return false;
        }

        return true;
    }

    private static void Report(ObjChunk[] chunks, ReadContext context)
    {
        foreach (ObjChunk chunk in chunks)
        {
            context.MaterialLibraries.AddRange(chunk.MaterialLibraries);
            context.IgnoredLines += chunk.IgnoredLines;
            context.IgnoredWeights += chunk.IgnoredWeights;
            context.ReplacedAttributes += chunk.ReplacedAttributes;
            foreach ((string keyword, int count) in chunk.Ignored)
                context.CountIgnored(keyword, count);
        }
    }

    /// <summary>Reads once more in one piece, now with the counts of the whole file, up to the index that is out of range.</summary>
    private static void ThrowAtBadIndex(ReadOnlySpan<byte> text, ObjChunk[] chunks, ReadContext context)
    {
        ObjChunk whole = new(context, text.Length)
        {
            Limits = (chunks.Sum(c => c.Positions.Count), LimitOf(chunks.Sum(c => c.TexturePool.Count)), LimitOf(chunks.Sum(c => c.NormalPool.Count))),
        };
        whole.Read(text, text.StartsWith("\uFEFF"u8) ? 3 : 0, text.Length, reports: false);
        throw new System.Diagnostics.UnreachableException("An index out of range was not found again.");
    }

    private static int? LimitOf(int count) => count == 0 ? null : count;

    /// <summary>A file in which no line at all says something of OBJ is something else under a wrong name.</summary>
    private static void RefuseForeignText(ReadOnlySpan<byte> text, ObjChunk[] chunks, ReadContext context)
    {
        bool knowsSomething = chunks.Any(c => c.KnownLines > 0 || c.Positions.Count > 0 || c.FaceEnds.Count > 0);
        int ignored = chunks.Select(c => c.FirstIgnoredPosition).FirstOrDefault(p => p >= 0, -1);
        if (!knowsSomething && ignored >= 0)
            throw context.TextError(text, ignored, "a statement of OBJ (v, vt, vn, f, o, g, s, usemtl, mtllib)");
    }
}
