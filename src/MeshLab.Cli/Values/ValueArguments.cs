using System.CommandLine;
using System.Globalization;
using MeshLab.Cli.Hosting;

namespace MeshLab.Cli.Values;

/// <summary>The options that values depend on, shared by the verbs that compute or paint them.</summary>
internal static class ValueArguments
{
    public static readonly Option<int> From = new("--from") { Description = "The vertex that distances start from.", DefaultValueFactory = _ => -1 };

    public static readonly Option<string?> Fixed = new("--fixed") { Description = "Vertices with given values for a harmonic function: i=v,j=w." };

    public static readonly Option<double> Angle = new("--angle")
    {
        Description = "Regions: edges with a larger dihedral angle are sharp (degrees).",
        DefaultValueFactory = _ => 30,
    };

    public static ValueOptions Parse(VerbContext context) => new(context.Get(From), ParseFixed(context.Get(Fixed)), ParseAngle(context));

    /// <summary>The sharp angle in radians.</summary>
    public static double ParseAngle(VerbContext context)
    {
        double degrees = context.Get(Angle);
        return degrees is >= 0 and <= 180 ? degrees * Math.PI / 180 : throw new UsageException("--angle must be between 0 and 180");
    }

    /// <summary>Reads <c>i=v,j=w</c>.</summary>
    public static IReadOnlyList<(int Vertex, double Value)> ParseFixed(string? text)
    {
        var pairs = new List<(int, double)>();
        foreach (string pair in (text ?? "").Split(',', StringSplitOptions.RemoveEmptyEntries))
        {
            string[] sides = pair.Split('=');
            if (sides.Length != 2
                || !int.TryParse(sides[0], NumberStyles.None, CultureInfo.InvariantCulture, out int vertex)
                || !double.TryParse(sides[1], NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
                || !double.IsFinite(value))
            {
                throw new UsageException($"--fixed {text}: '{pair}' is not VERTEX=NUMBER");
            }
            pairs.Add((vertex, value));
        }
        return pairs;
    }
}
