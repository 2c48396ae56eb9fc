using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>Compares what data say with what a format can hold. O(size), and O(1) where the format holds everything.</summary>
internal static class FormatLosses
{
    public static MeshWriteReport Of(MeshData data, MeshFormat format, MeshEncoding encoding)
    {
        bool isTriangles = format is MeshFormat.Stl or MeshFormat.Glb;
        bool isSingle = format == MeshFormat.Glb || (format == MeshFormat.Stl && encoding != MeshEncoding.Text);
        return new MeshWriteReport
        {
            Format = format,
            Encoding = encoding,
            LeftOut = LeftOut(data, format, encoding),
            TriangulatedFaces = isTriangles ? CountPolygons(data) : 0,
            RoundedVertices = isSingle ? data.Positions.Count(IsRounded) : 0,
        };
    }

    private static SortedDictionary<string, int> LeftOut(MeshData data, MeshFormat format, MeshEncoding encoding)
    {
        SortedDictionary<string, int> left = new(StringComparer.Ordinal);
        void Note(string what, int count)
        {
            if (count > 0)
                left.Add(what, count);
        }

        bool isStl = format == MeshFormat.Stl, holdsCorners = format is MeshFormat.Obj or MeshFormat.Ply;
        if (isStl)
        {
            Note("unused vertices", CountUnused(data));
            Note("vertex normals", data.VertexNormals?.Length ?? 0);
            Note("vertex texture coordinates", data.VertexTextureCoordinates?.Length ?? 0);
            Note("vertex colours", data.VertexColors?.Length ?? 0);
        }

        // Where the corners of OBJ have values of their own, those of the vertices have no place.
        if (format == MeshFormat.Obj && data.CornerNormals is not null)
            Note("vertex normals", data.VertexNormals?.Length ?? 0);
        if (format == MeshFormat.Obj && data.CornerTextureCoordinates is not null)
            Note("vertex texture coordinates", data.VertexTextureCoordinates?.Length ?? 0);
        if (!holdsCorners)
        {
            Note("corner normals", data.CornerNormals?.Length ?? 0);
            Note("corner texture coordinates", data.CornerTextureCoordinates?.Length ?? 0);
        }

        if (format is not (MeshFormat.Off or MeshFormat.Ply))
            Note("face colours", data.FaceColors?.Length ?? 0);
        foreach (FaceLabelSet set in data.FaceLabels)
        {
            if (!HoldsLabels(format, encoding, set.Kind))
                Note($"labels of {set.Kind}", set.Labels.Count(label => label >= 0));
        }

        return left;
    }

    private static bool HoldsLabels(MeshFormat format, MeshEncoding encoding, string kind) => format switch
    {
        MeshFormat.Ply => true,
        MeshFormat.Obj => kind is FaceLabelSet.Object or FaceLabelSet.Group or FaceLabelSet.Material or FaceLabelSet.Smoothing,
        MeshFormat.Stl => encoding == MeshEncoding.Text && kind == FaceLabelSet.Object,
        _ => false,
    };

    private static int CountPolygons(MeshData data)
    {
        int polygons = 0;
        for (int f = 0; f < data.FaceCount; f++)
            polygons += data.FaceStart[f + 1] - data.FaceStart[f] > 3 ? 1 : 0;
        return polygons;
    }

    private static int CountUnused(MeshData data)
    {
        bool[] isUsed = new bool[data.VertexCount];
        foreach (int v in data.Corners)
            isUsed[v] = true;
        return isUsed.Count(used => !used);
    }

    private static bool IsRounded(Vector3D p) => (float)p.X != p.X || (float)p.Y != p.Y || (float)p.Z != p.Z;
}
