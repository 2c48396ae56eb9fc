using System.CommandLine;
using System.Text.RegularExpressions;
using MeshLab.Cli.Hosting;
using Xunit;

namespace MeshLab.Tests;

/// <summary>What the pages name exists: verbs and their options, types, chapters.</summary>
[Trait("Section", "documentation")]
public sealed partial class DocumentationTests
{
    [Fact]
    public void Commands_OfThePages_ExistWithTheirOptions()
    {
        RootCommand root = MlabApp.BuildRoot((_, _) => { });
        HashSet<string> common = root.Options.Select(option => option.Name).ToHashSet(StringComparer.Ordinal);
        foreach (string page in Pages())
        {
            foreach (Match call in MlabCall().Matches(File.ReadAllText(page)))
            {
                Command? verb = root.Subcommands.FirstOrDefault(command => command.Name == call.Groups["name"].Value);
                Assert.True(verb is not null, $"{page}: there is no verb {call.Groups["name"].Value}");
                foreach (Match option in OptionName().Matches(call.Groups["rest"].Value))
                {
                    string name = option.Groups["name"].Value;
                    Assert.True(common.Contains(name) || verb.Options.Any(o => o.Name == name), $"{page}: {call.Value.Trim()} has no {name}");
                }
            }
        }
    }

    [Fact]
    public void Demos_OfThePages_Exist()
    {
        foreach (string page in Pages())
        {
            foreach (Match call in DemoCall().Matches(File.ReadAllText(page)))
                Assert.True(MeshLab.Demos.Hosting.DemoCatalog.Find(call.Groups["name"].Value) is not null, $"{page}: there is no demo {call.Groups["name"].Value}");
        }
    }

    [Fact]
    public void Glossary_NamesOfTheCode_AreInTheCode()
    {
        HashSet<string> words = RepositoryFiles.Below("src", "*.cs")
            .SelectMany(file => Identifier().Matches(File.ReadAllText(file)).Select(match => match.Value))
            .ToHashSet(StringComparer.Ordinal);
        foreach (string row in File.ReadLines(RepositoryFiles.PathOf("docs/glossary.md")).Where(line => line.StartsWith('|')))
        {
            foreach (Match name in Code().Matches(row.Split('|')[3]))
            {
                foreach (Match part in Identifier().Matches(name.Groups["name"].Value))
                    Assert.True(part.Value == "T" || words.Contains(part.Value), $"glossary: {name.Groups["name"].Value} is not in the code");
            }
        }
    }

    [Fact]
    public void Index_ListsThePagesOfAllChapters()
    {
        string index = File.ReadAllText(RepositoryFiles.PathOf("docs/README.md"));
        foreach (string page in Directory.EnumerateFiles(RepositoryFiles.PathOf("docs"), "*.md").Select(path => Path.GetFileName(path)))
            Assert.True(page == "README.md" || index.Contains($"({page})", StringComparison.Ordinal), $"docs/README.md does not list {page}");
        foreach (string chapter in (string[])["01", "02", "04", "14"])
            Assert.Contains($"(chapters/{chapter}-", index, StringComparison.Ordinal);
    }

    private static IEnumerable<string> Pages() =>
        RepositoryFiles.Below("docs", "*.md").Concat(RepositoryFiles.Below("models", "*.md")).Concat(Directory.EnumerateFiles(RepositoryFiles.Root, "README*.md"));

    [GeneratedRegex(@"\bmlab(?:\.dll)? (?<name>[a-z][a-z-]+)(?<rest>[^`\n|&]*)", RegexOptions.None, 60_000)]
    private static partial Regex MlabCall();

    [GeneratedRegex(@"(?<=\s)(?<name>--[a-z][a-z0-9-]*)", RegexOptions.None, 60_000)]
    private static partial Regex OptionName();

    [GeneratedRegex(@"samples/MeshLab\.Demos -- (?<name>L?\d+(?:\.\d+)*)", RegexOptions.None, 60_000)]
    private static partial Regex DemoCall();

    [GeneratedRegex("`(?<name>[^`]+)`", RegexOptions.None, 60_000)]
    private static partial Regex Code();

    [GeneratedRegex(@"[A-Za-z_]\w*", RegexOptions.None, 60_000)]
    private static partial Regex Identifier();
}
