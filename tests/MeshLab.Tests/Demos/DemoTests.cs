using System.Reflection;
using MeshLab.Demos.Hosting;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Demos;

/// <summary>The demos: found, in the book's order, and all of them run on a small model.</summary>
[Trait("Section", "demos")]
public sealed class DemoTests : IDisposable
{
    private readonly string folder = Directory.CreateTempSubdirectory("demos").FullName;

    public void Dispose() => Directory.Delete(folder, true);

    [Fact]
    public void EveryDemo_HasRunAndTitles()
    {
        Type[] types = [.. typeof(DemoCatalog).Assembly.GetTypes().Where(type => type.GetCustomAttribute<DemoAttribute>() is not null)];
        Assert.Equal(types.Length, DemoCatalog.All.Count);
        foreach (Type type in types)
        {
            MethodInfo? run = type.GetMethod("Run", [typeof(Mesh), typeof(DemoOutput)]);
            Assert.True(run is { IsStatic: true } && run.ReturnType == typeof(void), $"{type} has no method Run(Mesh, DemoOutput)");
            DemoAttribute mark = type.GetCustomAttribute<DemoAttribute>()!;
            Assert.Matches(@"^(L?\d+)(\.\d+)*$", mark.Section);
            Assert.Contains(mark.Chinese, c => c > 0x2E80);
            Assert.All(mark.English, c => Assert.True(c < 0x2E80, $"{type}: {mark.English}"));
        }
    }

    [Fact]
    public void Catalog_Sections_AreDifferentAndInOrder()
    {
        string[] sections = [.. DemoCatalog.All.Select(demo => demo.Section)];
        Assert.Equal(sections.Length, sections.Distinct(StringComparer.OrdinalIgnoreCase).Count());
        Assert.True(sections.Order(SectionOrder.Instance).SequenceEqual(sections, StringComparer.Ordinal));
        Assert.True(SectionOrder.Instance.Compare("2.9", "2.10") < 0);
        Assert.True(SectionOrder.Instance.Compare("14.3", "L1") < 0);
        Assert.True(SectionOrder.Instance.Compare("4", "4.1") < 0);
        Assert.All(sections, section => Assert.Equal(section, DemoCatalog.Find(section)!.Section));
        Assert.Null(DemoCatalog.Find("99.9"));
    }

    [Fact]
    public void Catalog_ChaptersWithADemoPerSection_AreComplete()
    {
        foreach (string section in (string[])
            ["1.1", "1.2", "1.3", "1.4", "1.5", "2.1", "2.2", "2.3", "2.4", "2.5", "2.6", "4.1", "4.2", "4.3", "4.4", "4.5", "4.6", "4.7", "4.8", "5.1", "5.2", "5.3", "5.4", "5.5",
             "5.6", "5.7", "10.1", "10.2", "10.3", "10.4", "10.5", "10.6", "10.7", "10.8", "11.1", "11.2", "11.3", "11.4", "11.5", "11.6", "14.1", "14.2",
             "8.1", "8.2", "8.3", "8.4", "9.2", "9.3", "9.4", "9.5", "9.6", "L1", "L2", "L3", "L4"])
        {
            Assert.NotNull(DemoCatalog.Find(section));
        }
    }

    /// <summary>Slow: it runs every demo.</summary>
    [Fact]
    [Trait("Speed", "slow")]
    public void Tour_SmallModel_ShowsEverySection()
    {
        Mesh mesh = Models.BumpySphere(14, 18, 0.05);
        ulong before = mesh.StateHash();

        Assert.Equal(0, Tour.Run(mesh, "small.obj", folder, pictureScale: 0.15));

        Assert.Equal(before, mesh.StateHash());
        string page = File.ReadAllText(Path.Combine(folder, "index.html"));
        foreach (Demo demo in DemoCatalog.All)
            Assert.Contains(demo.Chinese, page, StringComparison.Ordinal);
        Assert.DoesNotContain("Not for this model", page, StringComparison.Ordinal);
        Assert.DoesNotContain("cut into triangles", page, StringComparison.Ordinal);
        Assert.NotEmpty(Directory.GetFiles(folder, "*.png", SearchOption.AllDirectories));
        Assert.Empty(mesh.Validate());
    }

    /// <summary>Slow: every demo on models that are too small, open, in pieces, or of polygons. It may say that it is not for the model, but never fail.</summary>
    [Theory]
    [InlineData("one-triangle")]
    [InlineData("cube-quads")]
    [InlineData("isolated-vertices")]
    [InlineData("holes")]
    [Trait("Speed", "slow")]
    public void RunDemo_OddModel_ShowsSomethingOrSaysWhyNot(string model)
    {
        Mesh mesh = Models.Create(model);
        foreach (Demo demo in DemoCatalog.All)
        {
            var output = new DemoOutput(folder, null) { PictureScale = 0.05 };
            DemoEnd end = Tour.RunDemo(demo, mesh, output);
            Assert.True(end.Kind != DemoEndKind.Failed, $"{demo.Title}: {end.Note}");
            Assert.True(end.Kind == DemoEndKind.NotForThisModel ? end.Note.Length > 30 && !end.Note.Contains("Parameter", StringComparison.Ordinal) : output.Items.Count > 0, demo.Title);
            if (demo.Section.Split('.')[0] is "1" or "2" or "4" or "14" && mesh.IsTriangleMesh && mesh.Faces.Count > 1)
                Assert.True(end.Kind == DemoEndKind.Done, $"{demo.Title}: {end.Note}");
        }
    }

    [Fact]
    public void Tour_EmptyModel_IsRefused() => Assert.Throws<ArgumentException>(() => Tour.Run(new Mesh(), "empty.obj", folder));

    [Fact]
    public void Run_WrongWords_HasStatus2()
    {
        Assert.Equal(2, DemoProgram.Run(["no-such-section"]));
        Assert.Equal(2, DemoProgram.Run(["4.7", Path.Combine(folder, "nowhere.obj")]));
        Assert.Equal(2, DemoProgram.Run(["4.7", "a", "b"]));
        Assert.Equal(0, DemoProgram.Run([]));
    }
}
