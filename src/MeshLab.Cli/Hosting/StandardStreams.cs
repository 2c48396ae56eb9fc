namespace MeshLab.Cli.Hosting;

/// <summary>Standard input and output as bytes, opened when a mesh is named <c>-</c>.</summary>
internal sealed record StandardStreams(Func<Stream> OpenInput, Func<Stream> OpenOutput)
{
    public static StandardStreams OfConsole { get; } = new(Console.OpenStandardInput, Console.OpenStandardOutput);
}
