namespace MeshLab.Editing;

/// <summary>Why elements cannot be deleted.</summary>
public enum RemovalRefusal
{
    /// <summary>They can.</summary>
    None,

    /// <summary>A vertex would be left in which two fans of faces touch (蝴蝶结点, bow-tie), and <see cref="RemovalOptions.SplitPinched"/> is off.</summary>
    Pinch,
}

/// <summary>How faces, edges and vertices are deleted (§4.2–4.4).</summary>
public sealed record RemovalOptions
{
    /// <summary>The usual way.</summary>
    public static RemovalOptions Default { get; } = new();

    /// <summary>Whether vertices that lose their last face are deleted too; else they stay as isolated vertices.
    /// Edges that lose their last face never stay: an edge without faces is no part of a surface.</summary>
    public bool DeleteOrphans { get; init; } = true;

    /// <summary>Whether a vertex in which two fans of faces would touch becomes one vertex per fan; else the removal is refused.</summary>
    public bool SplitPinched { get; init; }
}
