namespace MeshLab.Structure;

/// <summary>A topology that the half-edge structure cannot represent, or an operation that would lead to one.</summary>
public sealed class TopologyException : Exception
{
    /// <summary>Creates the exception.</summary>
    /// <param name="message">What is wrong, with the elements by name.</param>
    /// <param name="elements">The names of the elements to blame, such as <c>v12</c>, <c>e4</c>, <c>f5</c>.</param>
    public TopologyException(string message, params IReadOnlyList<string> elements)
        : base(message) => Elements = elements;

    /// <summary>The names of the elements to blame.</summary>
    public IReadOnlyList<string> Elements { get; }
}
