using System.Text.RegularExpressions;
using Xunit;

namespace MeshLab.Tests;

/// <summary>The order of the folders as <c>docs/architecture.md</c> states it, and habits that every source file keeps.</summary>
[Trait("Section", "architecture")]
public sealed partial class ArchitectureTests
{
    private const int MostLines = 600;

    [Fact]
    public void Folders_OfTheLibrary_AreInTheDocument()
    {
        Assert.Empty(FoldersWithCode().Except(Layers().Keys, StringComparer.Ordinal));
        Assert.True(Layers().Count > 15);
    }

    [Fact]
    public void Arrows_BetweenFolders_PointToTheSameOrALowerLayer()
    {
        SortedDictionary<string, int> layers = Layers();
        foreach ((string from, string to, string file) in Arrows())
            Assert.True(layers.ContainsKey(to) && layers[to] <= layers[from], $"{file}: {from} may not use {to}");
    }

    [Fact]
    public void Arrows_BetweenFolders_MakeNoCircle()
    {
        ILookup<string, string> uses = Arrows().Select(arrow => (arrow.From, arrow.To)).Distinct().ToLookup(arrow => arrow.From, arrow => arrow.To, StringComparer.Ordinal);
        var done = new HashSet<string>(StringComparer.Ordinal);
        foreach (string folder in FoldersWithCode())
            Visit(folder, []);

        void Visit(string folder, List<string> path)
        {
            Assert.False(path.Contains(folder, StringComparer.Ordinal), $"a circle: {string.Join(" → ", path)} → {folder}");
            if (!done.Add(folder))
                return;
            foreach (string next in uses[folder])
                Visit(next, [.. path, folder]);
        }
    }

    [Fact]
    public void Namespaces_OfTheLibrary_AreTheFolders()
    {
        foreach (string file in LibraryFiles())
        {
            Match match = NamespaceLine().Match(File.ReadAllText(file));
            if (match.Success)
                Assert.True(match.Groups["name"].Value == FolderOf(file), $"{file}: namespace MeshLab.{match.Groups["name"].Value}");
        }
    }

    [Fact]
    public void Library_Files_NeitherPrintNorThrowWhatNobodyCanTell()
    {
        foreach (string file in LibraryFiles())
        {
            foreach (string line in CodeLines(file))
            {
                Assert.False(ConsoleCall().IsMatch(line), $"{file} prints: {line}");
                Assert.False(line.Contains("throw new Exception(", StringComparison.Ordinal), $"{file}: {line}");
            }
            Assert.False(EmptyCatch().IsMatch(File.ReadAllText(file)), $"{file} swallows an exception");
        }
    }

    [Fact]
    public void Visualization_UsesTheLibraryOnly()
    {
        foreach (string file in RepositoryFiles.Below("src/MeshLab.Visualization", "*.cs"))
        {
            foreach (string line in CodeLines(file))
                Assert.False(line.Contains("MeshLab.Cli", StringComparison.Ordinal) || ConsoleCall().IsMatch(line), $"{file}: {line}");
        }
    }

    [Fact]
    public void SourceFiles_AreShort()
    {
        foreach (string file in SourceFiles("*.cs"))
            Assert.True(File.ReadLines(file).Count() <= MostLines, $"{file} has more than {MostLines} lines");
    }

    [Fact]
    public void Sources_NameNoUnfinishedWorkAndNoFoldersOfOneMachine()
    {
        // Put together here, so that this file does not contain them.
        string[] unwanted = ["TO" + "DO", "FIX" + "ME", "/wo" + "rk/", "/home/" + "user"];
        foreach (string file in SourceFiles("*.cs").Concat(SourceFiles("*.csproj")).Concat(SourceFiles("*.md")).Concat(SourceFiles("*.sh")))
        {
            string text = File.ReadAllText(file);
            Assert.All(unwanted, word => Assert.False(text.Contains(word, StringComparison.Ordinal), $"{file} contains {word}"));
        }
    }

    [Fact]
    public void Links_OfTheDocumentation_LeadSomewhere()
    {
        foreach (string file in SourceFiles("*.md").Concat(Directory.EnumerateFiles(RepositoryFiles.Root, "*.md")))
        {
            foreach (Match link in MarkdownLink().Matches(File.ReadAllText(file)))
            {
                string target = link.Groups["name"].Value.Split('#')[0];
                if (target.Length == 0 || target.Contains("://", StringComparison.Ordinal))
                    continue;
                string path = Path.GetFullPath(Path.Combine(Path.GetDirectoryName(file)!, target));
                Assert.True(File.Exists(path) || Directory.Exists(path), $"{file}: there is no {target}");
            }
        }
    }

    /// <summary>Each folder's layer, from the indented lines with arrows of the document: what stands further left stands lower.</summary>
    private static SortedDictionary<string, int> Layers()
    {
        var layers = new SortedDictionary<string, int>(StringComparer.Ordinal);
        IEnumerable<string> lines = File.ReadLines(RepositoryFiles.PathOf("docs/architecture.md"))
            .SkipWhile(line => !line.StartsWith("    Numerics ←", StringComparison.Ordinal))
            .TakeWhile(line => line.StartsWith("    ", StringComparison.Ordinal));
        string[] groups = string.Join(' ', lines).Split('←');
        for (int layer = 0; layer < groups.Length; layer++)
        {
            foreach (Match name in Word().Matches(groups[layer]))
                layers.Add(name.Value, layer);
        }
        return layers;
    }

    private static IEnumerable<(string From, string To, string File)> Arrows()
    {
        foreach (string file in LibraryFiles())
        {
            string from = FolderOf(file);
            foreach (string line in CodeLines(file))
            {
                Match match = LibraryName().Match(line);
                if (match.Success && match.Groups["name"].Value != from && !line.StartsWith("namespace", StringComparison.Ordinal))
                    yield return (from, match.Groups["name"].Value, Path.GetFileName(file));
            }
        }
    }

    private static IEnumerable<string> FoldersWithCode() => LibraryFiles().Select(FolderOf).Distinct(StringComparer.Ordinal);

    private static IEnumerable<string> LibraryFiles() => RepositoryFiles.Below("src/MeshLab", "*.cs");

    private static IEnumerable<string> SourceFiles(string pattern) => ((string[])["src", "tests", "samples", "docs", "models"]).SelectMany(folder => RepositoryFiles.Below(folder, pattern));

    private static string FolderOf(string file) => Path.GetRelativePath(RepositoryFiles.PathOf("src/MeshLab"), file).Split(Path.DirectorySeparatorChar)[0];

    private static IEnumerable<string> CodeLines(string file) => File.ReadLines(file).Where(line => !line.TrimStart().StartsWith("//", StringComparison.Ordinal));

    [GeneratedRegex(@"\bMeshLab\.(?<name>[A-Z]\w+)", RegexOptions.None, 60_000)]
    private static partial Regex LibraryName();

    [GeneratedRegex(@"^namespace MeshLab\.(?<name>[A-Z]\w+)", RegexOptions.Multiline, 60_000)]
    private static partial Regex NamespaceLine();

    [GeneratedRegex(@"\bConsole\.", RegexOptions.None, 60_000)]
    private static partial Regex ConsoleCall();

    [GeneratedRegex(@"catch\s*(?:\([^)]*\))?\s*\{\s*\}", RegexOptions.None, 60_000)]
    private static partial Regex EmptyCatch();

    [GeneratedRegex(@"\w+", RegexOptions.None, 60_000)]
    private static partial Regex Word();

    [GeneratedRegex(@"\]\((?<name>[^)\s]+)\)", RegexOptions.None, 60_000)]
    private static partial Regex MarkdownLink();
}
