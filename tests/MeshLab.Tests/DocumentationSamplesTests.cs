using System.Text;
using System.Text.RegularExpressions;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Xunit;

namespace MeshLab.Tests;

/// <summary>Every C# sample of the README and of the pages compiles against the library as it is.</summary>
[Trait("Section", "documentation")]
public sealed partial class DocumentationSamplesTests
{
    // What fragments may use without saying where it comes from.
    private const string Given = """
        static Mesh mesh = null!; static Vertex vertex, v0; static HalfEdge halfEdge, boundaryHalfEdge; static Edge edge; static Face face0;
        static Vector3D point, normal; static int v = 0, f = 0;
        """;

    private static readonly string[] Library = [.. typeof(MeshLab.Structure.Mesh).Assembly.GetExportedTypes().Select(type => type.Namespace!).Distinct(StringComparer.Ordinal)];

    public static TheoryData<string> PagesWithSamples =>
    [
        .. RepositoryFiles.Below("docs", "*.md").Append(RepositoryFiles.PathOf("README.md"))
            .Where(page => Sample().IsMatch(File.ReadAllText(page)))
            .Select(page => Path.GetRelativePath(RepositoryFiles.Root, page).Replace('\\', '/')),
    ];

    [Theory]
    [MemberData(nameof(PagesWithSamples))]
    public void Samples_OfThePage_Compile(string page)
    {
        foreach (Match sample in Sample().Matches(File.ReadAllText(RepositoryFiles.PathOf(page))))
        {
            string code = sample.Groups["code"].Value;
            Diagnostic[] errors = [.. Compile(code).Where(diagnostic => diagnostic.Severity == DiagnosticSeverity.Error)];
            Assert.True(errors.Length == 0, $"{page}: {string.Join("; ", errors.Take(3).Select(error => error.GetMessage(null)))}\n{code}");
        }
    }

    [Fact]
    public void Compile_NameThatDoesNotExist_IsAnError() =>
        Assert.Contains(Compile("mesh.MakeBeautiful();"), diagnostic => diagnostic.Id == "CS1061");

    private static IEnumerable<Diagnostic> Compile(string sample)
    {
        var source = new StringBuilder();
        foreach (string name in (string[])["System", "System.Collections.Generic", "System.IO", "System.Linq", .. Library])
            source.Append("using ").Append(name).Append(";\n");
        var body = new StringBuilder();
        foreach (string line in sample.Replace("…", ";", StringComparison.Ordinal).Split('\n'))
        {
            // The sample's own directives are at the top of the unit already.
            if (!UsingDirective().IsMatch(line))
                body.Append(line).Append('\n');
        }
        source.Append("static class Sample {\n").Append(Given).Append("\nstatic void Run() {\n").Append(body).Append("\n} }\n");
        string[] libraries = ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!).Split(Path.PathSeparator);
        return CSharpCompilation.Create(
            "Samples",
            [CSharpSyntaxTree.ParseText(source.ToString(), new CSharpParseOptions(LanguageVersion.Latest))],
            libraries.Select(path => MetadataReference.CreateFromFile(path)),
            new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, nullableContextOptions: NullableContextOptions.Enable)).GetDiagnostics();
    }

    [GeneratedRegex(@"```csharp\r?\n(?<code>.*?)```", RegexOptions.Singleline, 60_000)]
    private static partial Regex Sample();

    [GeneratedRegex(@"^using [\w.]+;\s*$", RegexOptions.None, 60_000)]
    private static partial Regex UsingDirective();
}
