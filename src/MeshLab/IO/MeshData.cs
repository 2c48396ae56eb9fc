using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>What a file says, before anything is known about its topology: positions, polygons by corners, and attributes, all in file order.</summary>
/// <remarks>
/// The polygons need not form a manifold: this is also the form in which triangle soups and broken models are looked at. A corner (面角) is one vertex
/// of one face; the corners of face f are <c>Corners[FaceStart[f] .. FaceStart[f + 1]]</c>. Attributes that the file does not have are null; those it has
/// have one entry per vertex, corner or face.
/// </remarks>
public sealed class MeshData
{
    /// <summary>The vertices' positions.</summary>
    public Vector3D[] Positions { get; init; } = [];

    /// <summary>Where each face's corners begin; one more entry than there are faces.</summary>
    public int[] FaceStart { get; init; } = [0];

    /// <summary>The vertex index of each corner.</summary>
    public int[] Corners { get; init; } = [];

    /// <summary>Vertex normals as the file gives them, of any length.</summary>
    public Vector3D[]? VertexNormals { get; set; }

    /// <summary>Texture coordinates (纹理坐标) per vertex.</summary>
    public Vector2D[]? VertexTextureCoordinates { get; set; }

    /// <summary>Colours per vertex.</summary>
    public Color[]? VertexColors { get; set; }

    /// <summary>Normals per corner, where the corners of a vertex differ.</summary>
    public Vector3D[]? CornerNormals { get; set; }

    /// <summary>Texture coordinates per corner, where the corners of a vertex differ: the image has a seam there.</summary>
    public Vector2D[]? CornerTextureCoordinates { get; set; }

    /// <summary>Colours per face.</summary>
    public Color[]? FaceColors { get; set; }

    /// <summary>Named groups of faces; at most one set of each kind.</summary>
    public IReadOnlyList<FaceLabelSet> FaceLabels { get; set; } = [];

    /// <summary>The number of vertices, used by a face or not.</summary>
    public int VertexCount => Positions.Length;

    /// <summary>The number of faces.</summary>
    public int FaceCount => FaceStart.Length - 1;

    /// <summary>The vertices of a face in order.</summary>
    /// <param name="face">The face's index.</param>
    public ReadOnlySpan<int> FaceCorners(int face) => Corners.AsSpan(FaceStart[face]..FaceStart[face + 1]);
}

/// <summary>A partition of the faces by name: the materials, the groups, the objects or the smoothing groups of a file.</summary>
/// <param name="Kind">What the names are: <c>material</c>, <c>group</c>, <c>object</c>, <c>smoothing</c> or a name of your own.</param>
/// <param name="Names">The names; a label is an index into them.</param>
/// <param name="Labels">The label of each face; −1 for a face without one.</param>
public sealed record FaceLabelSet(string Kind, IReadOnlyList<string> Names, int[] Labels)
{
    /// <summary>The kind of OBJ's <c>usemtl</c>.</summary>
    public const string Material = "material";

    /// <summary>The kind of OBJ's <c>g</c>.</summary>
    public const string Group = "group";

    /// <summary>The kind of OBJ's <c>o</c> and of STL's <c>solid</c>.</summary>
    public const string Object = "object";

    /// <summary>The kind of OBJ's <c>s</c>.</summary>
    public const string Smoothing = "smoothing";
}
