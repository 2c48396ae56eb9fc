namespace MeshLab.IO;

/// <summary>The file formats (文件格式) of meshes.</summary>
public enum MeshFormat
{
    /// <summary>Wavefront OBJ, text (§14.1).</summary>
    Obj,

    /// <summary>Object File Format of Geomview, text (§14.2).</summary>
    Off,

    /// <summary>Stereolithography, text or binary: triangles without shared vertices.</summary>
    Stl,

    /// <summary>Polygon File Format of Stanford, text or binary.</summary>
    Ply,

    /// <summary>Binary glTF 2.0, for viewers; written only.</summary>
    Glb,
}

/// <summary>How the numbers stand in a file.</summary>
public enum MeshEncoding
{
    /// <summary>As the format is commonly written: OBJ and OFF as text, STL, PLY and GLB in binary.</summary>
    Default,

    /// <summary>Decimal text: the shortest that gives the same double when read, in every culture the same.</summary>
    Text,

    /// <summary>Binary, least significant byte first.</summary>
    BinaryLittleEndian,

    /// <summary>Binary, most significant byte first (PLY only).</summary>
    BinaryBigEndian,
}

/// <summary>What the library can do with a format.</summary>
/// <param name="Format">The format.</param>
/// <param name="Extension">The file name's extension with its point, lower case.</param>
/// <param name="Name">The format's name for people.</param>
/// <param name="CanRead">Whether it is read; then also with <c>.gz</c> behind the extension.</param>
/// <param name="CanWrite">Whether it is written; then also with <c>.gz</c> behind the extension.</param>
public sealed record MeshFormatInfo(MeshFormat Format, string Extension, string Name, bool CanRead, bool CanWrite);
