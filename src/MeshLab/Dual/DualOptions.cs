namespace MeshLab.Dual;

/// <summary>Where the vertex of the dual lies that stands for a face (对偶顶点).</summary>
public enum DualCenter
{
    /// <summary>The mean of the corners (重心): the textbook's DualA.</summary>
    Barycenter,

    /// <summary>The centre of the circle through the corners (外心), wherever it lies; triangles only. A triangle without area has none: its barycentre is taken.</summary>
    Circumcenter,

    /// <summary>The circumcentre of acute triangles, the barycentre of all other faces: the textbook's DualB.</summary>
    CircumcenterIfAcute,
}

/// <summary>What the cells of the dual are made of.</summary>
public enum DualForm
{
    /// <summary>Face centres only: V* = F, E* = E, F* = V on closed meshes.</summary>
    Pure,

    /// <summary>The textbook's cells: face centres and edge midpoints by turns, 2 · valence corners: V* = F + E, F* = V.</summary>
    Cells,
}

/// <summary>What becomes of the cells of boundary vertices.</summary>
public enum DualBoundary
{
    /// <summary>The cell is closed through the midpoints of the two boundary edges and the vertex itself, so that the dual covers the whole surface.</summary>
    Closed,

    /// <summary>Boundary vertices have no cell.</summary>
    Omitted,
}

/// <summary>How <see cref="DualMesh"/> makes the dual.</summary>
public sealed record DualOptions
{
    /// <summary>Where the vertices lie.</summary>
    public DualCenter Center { get; init => field = Enum.IsDefined(value) ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "There is no such centre."); }

    /// <summary>What the cells are made of.</summary>
    public DualForm Form { get; init => field = Enum.IsDefined(value) ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "There is no such form."); }

    /// <summary>What becomes of the cells of boundary vertices.</summary>
    public DualBoundary Boundary { get; init => field = Enum.IsDefined(value) ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "There is no such rule."); }
}
