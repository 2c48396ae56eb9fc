using MeshLab.Structure;

namespace MeshLab.Cli.Values;

/// <summary>Marks a static method as the source of a named value per element.</summary>
/// <remarks>The method is <c>double[] F(Mesh, ValueOptions)</c> or <c>Vector3D[] F(Mesh, ValueOptions)</c>, one entry per slot of the element kind;
/// for <see cref="ElementKind.HalfEdge"/> (corners) one entry per half-edge: the corner at its target. NaN where there is no value.</remarks>
/// <param name="name">The name that <c>values --of</c> and <c>render --values</c> take.</param>
/// <param name="kind">The elements that have the value.</param>
[AttributeUsage(AttributeTargets.Method)]
internal sealed class MeshValueAttribute(string name, ElementKind kind) : Attribute
{
    public string Name { get; } = name;

    public ElementKind Kind { get; } = kind;

    /// <summary>What a legend says under the name.</summary>
    public string Unit { get; init; } = "";

    /// <summary>Whether 0 is the middle of the colours.</summary>
    public bool Signed { get; init; }

    /// <summary>Whether the numbers are names without order: each gets a colour of its own.</summary>
    public bool IsLabel { get; init; }

    /// <summary>Of vectors: whether they mean a line, so that v and −v are the same.</summary>
    public bool IsAxis { get; init; }
}
