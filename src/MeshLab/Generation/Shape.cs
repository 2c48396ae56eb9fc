using System.Globalization;
using MeshLab.Structure;

namespace MeshLab.Generation;

/// <summary>A number that a shape takes.</summary>
/// <param name="Name">As the command line spells it.</param>
/// <param name="Description">What it is.</param>
/// <param name="Default">Its value if not given.</param>
/// <param name="Minimum">The smallest value allowed.</param>
/// <param name="Maximum">The largest value allowed.</param>
/// <param name="IsInteger">Whether only whole numbers are allowed.</param>
public sealed record ShapeParameter(string Name, string Description, double Default, double Minimum, double Maximum, bool IsInteger);

/// <summary>The values of a shape's parameters, all given and checked.</summary>
public sealed class ShapeArguments
{
    private readonly IReadOnlyDictionary<string, double> values;

    internal ShapeArguments(IReadOnlyDictionary<string, double> values) => this.values = values;

    /// <summary>The values by name.</summary>
    public IReadOnlyDictionary<string, double> Values => values;

    internal double Real(string name) => values[name];

    internal int Whole(string name) => (int)values[name];
}

/// <summary>A kind of shape that can be made by name.</summary>
public sealed class Shape
{
    private readonly Func<ShapeArguments, PolygonSoup>? soup;
    private readonly Func<ShapeArguments, Mesh>? mesh;

    internal Shape(string name, string section, string chineseName, string description, ShapeParameter[] parameters, Func<ShapeArguments, Mesh> mesh)
        : this(name, section, chineseName, description, parameters) => this.mesh = mesh;

    internal Shape(string name, string section, string chineseName, string description, ShapeParameter[] parameters, Func<ShapeArguments, PolygonSoup> soup)
        : this(name, section, chineseName, description, parameters) => this.soup = soup;

    private Shape(string name, string section, string chineseName, string description, ShapeParameter[] parameters) =>
        (Name, Section, ChineseName, Description, Parameters) = (name, section, chineseName, description, parameters);

    /// <summary>The name, in lower case with hyphens.</summary>
    public string Name { get; }

    /// <summary>The section of the book, 2.1 to 2.6, or 2 for shapes beyond it.</summary>
    public string Section { get; }

    /// <summary>The Chinese name.</summary>
    public string ChineseName { get; }

    /// <summary>One line on the shape.</summary>
    public string Description { get; }

    /// <summary>What it takes, in order.</summary>
    public IReadOnlyList<ShapeParameter> Parameters { get; }

    /// <summary>Completes the values given by the defaults, and checks all.</summary>
    /// <param name="values">By parameter name; <see langword="null"/> for the defaults alone.</param>
    /// <exception cref="ArgumentException">A name is not a parameter, a value is out of range or not whole where it must be.</exception>
    public ShapeArguments Complete(IReadOnlyDictionary<string, double>? values = null)
    {
        var complete = new Dictionary<string, double>(StringComparer.Ordinal);
        foreach (ShapeParameter parameter in Parameters)
            complete[parameter.Name] = parameter.Default;
        foreach ((string name, double value) in values ?? new Dictionary<string, double>(StringComparer.Ordinal))
        {
            ShapeParameter parameter = Parameters.FirstOrDefault(p => p.Name == name)
                ?? throw new ArgumentException($"\"{Name}\" has no parameter \"{name}\"; it takes {ParameterNames()}.", nameof(values));
            if (!(value >= parameter.Minimum && value <= parameter.Maximum))
                throw new ArgumentException(Message(parameter, value, $"from {Text(parameter.Minimum)} to {Text(parameter.Maximum)}"), nameof(values));
            if (parameter.IsInteger && value != Math.Floor(value))
                throw new ArgumentException(Message(parameter, value, "a whole number"), nameof(values));
            complete[name] = value;
        }
        return new(complete);
    }

    /// <summary>Makes the shape.</summary>
    /// <inheritdoc cref="Create(ShapeArguments, NonManifoldPolicy, out BuildReport)"/>
    public Mesh Create(IReadOnlyDictionary<string, double>? values = null) => Create(Complete(values), NonManifoldPolicy.Throw, out _);

    /// <summary>Makes the shape.</summary>
    /// <param name="arguments">From <see cref="Complete"/>.</param>
    /// <param name="policy">What is done if the shape is not an oriented manifold (the Möbius strip).</param>
    /// <param name="report">What was done.</param>
    /// <exception cref="TopologyException">The shape is not an oriented manifold and the policy is to throw.</exception>
    public Mesh Create(ShapeArguments arguments, NonManifoldPolicy policy, out BuildReport report)
    {
        ArgumentNullException.ThrowIfNull(arguments);
        if (soup is not null)
            return MeshBuilder.FromPolygons(soup(arguments), policy, out report);
        report = new([], null, null, 0);
        return mesh!(arguments);
    }

    private string ParameterNames() => Parameters.Count == 0 ? "none" : string.Join(", ", Parameters.Select(p => p.Name));

    private string Message(ShapeParameter parameter, double value, string expected) =>
        $"\"{parameter.Name}\" of \"{Name}\" is {Text(value)}; it must be {expected}.";

    private static string Text(double value) => value.ToString(CultureInfo.InvariantCulture);
}
