using System.Text.RegularExpressions;
using MeshLab.IO;
using MeshLab.Structure;

namespace MeshLab.Cli.Hosting;

/// <summary>The command was called wrongly.</summary>
internal sealed class UsageException(string message) : Exception(message);

/// <summary>The operation was refused; the input is as it was.</summary>
internal sealed class RefusedException(string message, params IReadOnlyList<string> elements) : Exception(message)
{
    public IReadOnlyList<string> Elements { get; } = elements;
}

/// <summary>How an exception is told to the user: exit status and the fields of the error object.</summary>
internal sealed partial record CliError(int ExitStatus, string Kind, string Message)
{
    public string? File { get; init; }

    public long? Line { get; init; }

    public long? Column { get; init; }

    public IReadOnlyList<string>? Elements { get; init; }

    public static CliError Of(Exception error, bool reading, string? file) => error switch
    {
        OperationCanceledException => new(130, "cancelled", "cancelled"),
        AggregateException { InnerException: { } inner } => Of(inner, reading, file),
        UsageException => new(2, "usage", FirstLine(error.Message)),
        RefusedException refused => new(1, "refused", error.Message) { Elements = refused.Elements },
        MeshFormatException format => new(3, "format", error.Message) { File = format.File, Line = format.Line, Column = format.Column },
        TopologyException topology when reading => new(3, "topology", $"{file}: {error.Message}") { File = file, Elements = topology.Elements },
        TopologyException topology => new(1, "refused", error.Message) { Elements = topology.Elements },
        ArgumentException when reading => new(3, "format", $"{file}: {FirstLine(error.Message)}") { File = file },
        IOException or UnauthorizedAccessException => new(3, "io", error.Message) { File = file },
        // The options are right; it is the mesh that the operation cannot take.
        ArgumentException { ParamName: "mesh" or "face" } => new(1, "refused", FirstLine(error.Message)) { Elements = ElementsIn(error.Message) },
        ArgumentException => new(2, "usage", FirstLine(error.Message)),
        OutOfMemoryException => new(1, "refused", "not enough memory"),
        _ => new(1, "refused", error.Message),
    };

    /// <summary>The fields of the error object.</summary>
    public ResultFields ToFields()
    {
        var fields = new ResultFields().Add("kind", Kind).Add("message", Message);
        if (File is not null)
            fields.Add("file", File);
        if (Line is not null)
            fields.Add("line", Line.Value);
        if (Column is not null)
            fields.Add("column", Column.Value);
        if (Elements is { Count: > 0 })
            fields.Add("elements", Elements);
        return fields;
    }

    /// <summary>The names of elements in a message: v12, h3, e4, f5.</summary>
    private static string[] ElementsIn(string message) => [.. ElementName().Matches(message).Select(match => match.Value).Distinct(StringComparer.Ordinal)];

    [GeneratedRegex(@"\b[vhef][0-9]+\b", RegexOptions.None, 1000)]
    private static partial Regex ElementName();

    /// <summary>Argument exceptions add the parameter on a further line or in brackets; the user has no parameters.</summary>
    private static string FirstLine(string message)
    {
        int end = message.IndexOfAny(['\r', '\n']);
        if (end >= 0)
            message = message[..end];
        int parameter = message.IndexOf(" (Parameter '", StringComparison.Ordinal);
        return parameter >= 0 ? message[..parameter] : message;
    }
}
