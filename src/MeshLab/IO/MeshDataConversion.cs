using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.IO;

/// <summary>The way between the raw data of files and the half-edge mesh.</summary>
public static class MeshDataConversion
{
    private const int FacesPerBlock = 16384;

    /// <summary>Builds the mesh: vertices and faces keep their order, each face its first corner, and the attributes become traits.</summary>
    /// <remarks>
    /// Attributes go to the textbook's traits: vertex <c>Normal</c>, <c>UV</c>, <c>Color</c>; half-edge <c>Normal</c>, <c>TextureCoordinate</c> at the corner
    /// that the half-edge points to; face <c>Color</c>. Labels go to <see cref="Mesh.FaceLabels"/>. O(size).
    /// </remarks>
    /// <param name="data">The data; they are copied.</param>
    /// <param name="policy">What to do with faces that do not make an oriented 2-manifold.</param>
    /// <param name="report">What the builder did.</param>
    /// <exception cref="TopologyException">The policy is to throw, and the faces are not an oriented 2-manifold; elements have the file's numbers, from 0.</exception>
    /// <exception cref="ArgumentException">An index is out of range, a position is not finite, or an attribute has not one value per element.</exception>
    public static Mesh ToMesh(this MeshData data, NonManifoldPolicy policy, out BuildReport report)
    {
        ArgumentNullException.ThrowIfNull(data);
        CheckLengths(data);
        return Build(data, [.. data.Positions], policy, out report);
    }

    /// <inheritdoc cref="ToMesh(MeshData, NonManifoldPolicy, out BuildReport)"/>
    public static Mesh ToMesh(this MeshData data) => data.ToMesh(NonManifoldPolicy.Throw, out _);

    /// <summary>The live elements of a mesh, renumbered in order, with the attributes that files know. O(size).</summary>
    /// <param name="mesh">The mesh.</param>
    public static MeshData ToMeshData(this Mesh mesh)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        return Gather(mesh, sharePositions: false);
    }

    /// <summary>As <see cref="ToMesh(MeshData, NonManifoldPolicy, out BuildReport)"/>, but the mesh takes over the positions.</summary>
    internal static Mesh Build(MeshData data, Vector3D[] positions, NonManifoldPolicy policy, out BuildReport report)
    {
        Mesh mesh = MeshBuilder.FromSoup(new PolygonSoup(positions, data.FaceStart, data.Corners), policy, out report);
        AddVertexTraits(mesh, data, report.SourceVertices);
        AddCornerTraits(mesh, data, report.SourceFaces);
        AddFaceTraits(mesh, data, report.SourceFaces);
        return mesh;
    }

    /// <summary>As <see cref="ToMeshData"/>; the positions may be the mesh's own array, which saves a copy as long as nothing is changed.</summary>
    internal static MeshData Gather(Mesh mesh, bool sharePositions)
    {
        int[]? vertices = mesh.Vertices.Count == mesh.VertexSlots ? null : LiveVertices(mesh);
        int[]? faces = mesh.Faces.Count == mesh.FaceSlots ? null : LiveFaces(mesh);
        bool canShare = sharePositions && vertices is null && mesh.positions.Length == mesh.VertexSlots;
        (int[] faceStart, int[] corners) = GatherFaces(mesh, vertices, faces);
        MeshData data = new()
        {
            Positions = canShare ? mesh.positions : Pick<Vector3D>(mesh.Positions, vertices),
            FaceStart = faceStart,
            Corners = corners,
        };
        if (mesh.TryGetVertexTrait(TraitNames.Normal, out VertexTrait<Vector3D>? normals))
            data.VertexNormals = Pick<Vector3D>(normals.Values, vertices);
        if (mesh.TryGetVertexTrait(TraitNames.UV, out VertexTrait<Vector2D>? texture))
            data.VertexTextureCoordinates = Pick<Vector2D>(texture.Values, vertices);
        if (mesh.TryGetVertexTrait(TraitNames.Color, out VertexTrait<Color>? colors))
            data.VertexColors = Pick<Color>(colors.Values, vertices);
        if (mesh.TryGetHalfEdgeTrait(TraitNames.Normal, out HalfEdgeTrait<Vector3D>? cornerNormals))
            data.CornerNormals = PickCorners(mesh, cornerNormals, faceStart, faces);
        if (mesh.TryGetHalfEdgeTrait(TraitNames.TextureCoordinate, out HalfEdgeTrait<Vector2D>? cornerTexture))
            data.CornerTextureCoordinates = PickCorners(mesh, cornerTexture, faceStart, faces);
        if (mesh.TryGetFaceTrait(TraitNames.Color, out FaceTrait<Color>? faceColors))
            data.FaceColors = Pick<Color>(faceColors.Values, faces);
        data.FaceLabels = [.. mesh.FaceLabels.Select(l => new FaceLabelSet(l.Sort, [.. l.Names], Pick<int>(l.Labels.Values, faces)))];
        return data;
    }

    private static void AddVertexTraits(Mesh mesh, MeshData data, int[]? source)
    {
        if (data.VertexNormals is { } normals)
            Put(mesh.AddVertexTrait<Vector3D>(TraitNames.Normal, default, Blend.Direction).Values, normals, source);
        if (data.VertexTextureCoordinates is { } texture)
            Put(mesh.AddVertexTrait<Vector2D>(TraitNames.UV, default, Blend.Linear).Values, texture, source);
        if (data.VertexColors is { } colors)
            Put(mesh.AddVertexTrait<Color>(TraitNames.Color, default, Blend.Linear).Values, colors, source);
    }

    private static void AddCornerTraits(Mesh mesh, MeshData data, int[]? source)
    {
        if (data.CornerNormals is { } normals)
            PutCorners(mesh, mesh.AddHalfEdgeTrait<Vector3D>(TraitNames.Normal, default, Blend.Direction), normals, data, source);
        if (data.CornerTextureCoordinates is { } texture)
            PutCorners(mesh, mesh.AddHalfEdgeTrait<Vector2D>(TraitNames.TextureCoordinate, default, Blend.Linear), texture, data, source);
    }

    private static void AddFaceTraits(Mesh mesh, MeshData data, int[]? source)
    {
        if (data.FaceColors is { } colors)
            Put(mesh.AddFaceTrait<Color>(TraitNames.Color, default, Blend.Linear).Values, colors, source);
        foreach (FaceLabelSet set in data.FaceLabels)
        {
            FaceLabels labels = mesh.GetOrAddFaceLabels(set.Kind);
            int[] numbers = [.. set.Names.Select(labels.Number)];
            Span<int> values = labels.Labels.Values;
            for (int f = 0; f < values.Length; f++)
            {
                int label = set.Labels[source is null ? f : source[f]];
                values[f] = label < 0 ? FaceLabels.None : numbers[label];
            }
        }
    }

    private static void Put<T>(Span<T> values, T[] given, int[]? source)
    {
        for (int i = 0; i < values.Length; i++)
            values[i] = given[source is null ? i : source[i]];
    }

    /// <summary>A corner's value stands at the half-edge that points to it: at the previous one of the half-edge that leaves it.</summary>
    private static void PutCorners<T>(Mesh mesh, HalfEdgeTrait<T> trait, T[] given, MeshData data, int[]? source)
    {
        ReadOnlySpan<int> next = mesh.Next, previous = mesh.Previous, first = mesh.HalfEdgeOf;
        Span<T> values = trait.Values;
        for (int f = 0; f < first.Length; f++)
        {
            int sourceFace = source is null ? f : source[f], h = previous[first[f]];
            for (int c = data.FaceStart[sourceFace]; c < data.FaceStart[sourceFace + 1]; c++, h = next[h])
                values[h] = given[c];
        }
    }

    private static T[] PickCorners<T>(Mesh mesh, HalfEdgeTrait<T> trait, int[] faceStart, int[]? faces)
    {
        ReadOnlySpan<int> next = mesh.Next, previous = mesh.Previous, first = mesh.HalfEdgeOf;
        ReadOnlySpan<T> values = trait.Values;
        T[] picked = new T[faceStart[^1]];
        for (int f = 0; f + 1 < faceStart.Length; f++)
        {
            int h = previous[first[faces is null ? f : faces[f]]];
            for (int c = faceStart[f]; c < faceStart[f + 1]; c++, h = next[h])
                picked[c] = values[h];
        }

        return picked;
    }

    private static T[] Pick<T>(ReadOnlySpan<T> values, int[]? live)
    {
        if (live is null)
            return values.ToArray();
        T[] picked = new T[live.Length];
        for (int i = 0; i < live.Length; i++)
            picked[i] = values[live[i]];
        return picked;
    }

    private static (int[] FaceStart, int[] Corners) GatherFaces(Mesh mesh, int[]? vertices, int[]? faces)
    {
        int[] number = vertices is null ? [] : NumberOf(vertices, mesh.VertexSlots);
        int[] faceStart = new int[mesh.Faces.Count + 1];
        Parallelism.ForBlocks(mesh.Faces.Count, FacesPerBlock, (from, to) =>
        {
            ReadOnlySpan<int> next = mesh.Next, first = mesh.HalfEdgeOf;
            for (int f = from; f < to; f++)
            {
                int h0 = first[faces is null ? f : faces[f]], degree = 0, h = h0;
                do
                {
                    degree++;
                    h = next[h];
                }
                while (h != h0);
                faceStart[f + 1] = degree;
            }
        });
        for (int f = 1; f < faceStart.Length; f++)
            faceStart[f] += faceStart[f - 1];

        int[] corners = GC.AllocateUninitializedArray<int>(faceStart[^1]);
        Parallelism.ForBlocks(mesh.Faces.Count, FacesPerBlock, (from, to) =>
        {
            ReadOnlySpan<int> next = mesh.Next, previous = mesh.Previous, target = mesh.Target, first = mesh.HalfEdgeOf;
            for (int f = from; f < to; f++)
            {
                int h = previous[first[faces is null ? f : faces[f]]];
                for (int c = faceStart[f]; c < faceStart[f + 1]; c++, h = next[h])
                    corners[c] = number.Length == 0 ? target[h] : number[target[h]];
            }
        });
        return (faceStart, corners);
    }

    private static int[] LiveVertices(Mesh mesh)
    {
        int[] live = new int[mesh.Vertices.Count];
        for (int v = 0, i = 0; v < mesh.VertexSlots; v++)
        {
            if (!mesh.IsDeletedVertex(v))
                live[i++] = v;
        }

        return live;
    }

    private static int[] LiveFaces(Mesh mesh)
    {
        int[] live = new int[mesh.Faces.Count];
        for (int f = 0, i = 0; f < mesh.FaceSlots; f++)
        {
            if (!mesh.IsDeletedFace(f))
                live[i++] = f;
        }

        return live;
    }

    private static int[] NumberOf(int[] live, int slots)
    {
        int[] number = new int[slots];
        for (int i = 0; i < live.Length; i++)
            number[live[i]] = i;
        return number;
    }

    private static void CheckLengths(MeshData data)
    {
        Check(data.VertexNormals?.Length, data.VertexCount, nameof(data.VertexNormals));
        Check(data.VertexTextureCoordinates?.Length, data.VertexCount, nameof(data.VertexTextureCoordinates));
        Check(data.VertexColors?.Length, data.VertexCount, nameof(data.VertexColors));
        Check(data.CornerNormals?.Length, data.Corners.Length, nameof(data.CornerNormals));
        Check(data.CornerTextureCoordinates?.Length, data.Corners.Length, nameof(data.CornerTextureCoordinates));
        Check(data.FaceColors?.Length, data.FaceCount, nameof(data.FaceColors));
        foreach (FaceLabelSet set in data.FaceLabels)
        {
            Check(set.Labels.Length, data.FaceCount, $"labels of {set.Kind}");
            if (Array.Exists(set.Labels, l => l < -1 || l >= set.Names.Count))
                throw new ArgumentException($"A label of {set.Kind} is not the number of a name.", nameof(data));
        }

        static void Check(int? length, int expected, string name)
        {
            if (length is int given && given != expected)
                throw new ArgumentException($"{name} has {given} values for {expected} elements.", nameof(data));
        }
    }
}
