using System.Globalization;

namespace MeshLab.IO;

/// <summary>A file that is not what its format asks for. The message begins with <c>FILE:LINE:COLUMN:</c>.</summary>
public sealed class MeshFormatException : Exception
{
    /// <summary>Creates the exception.</summary>
    /// <param name="file">The file's name, or <c>-</c> for a stream.</param>
    /// <param name="line">The line, from 1; 0 if the file is binary at this place.</param>
    /// <param name="column">The column, from 1; in a binary part the byte offset from the start of the file.</param>
    /// <param name="found">What stands there.</param>
    /// <param name="expected">What was expected.</param>
    public MeshFormatException(string file, long line, long column, string found, string expected)
        : base(string.Create(CultureInfo.InvariantCulture, $"{file}:{line}:{column}: found {found}, expected {expected}"))
    {
        File = file;
        Line = line;
        Column = column;
        Found = found;
        Expected = expected;
    }

    /// <summary>The file's name.</summary>
    public string File { get; }

    /// <summary>The line, from 1.</summary>
    public long Line { get; }

    /// <summary>The column, from 1.</summary>
    public long Column { get; }

    /// <summary>What stands there.</summary>
    public string Found { get; }

    /// <summary>What was expected.</summary>
    public string Expected { get; }
}
