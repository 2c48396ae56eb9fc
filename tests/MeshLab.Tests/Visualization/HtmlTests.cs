using System.IO.Compression;
using System.Text.Json;
using System.Text.RegularExpressions;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;
using Xunit;

namespace MeshLab.Tests.Visualization;

[Trait("Section", "pictures")]
public partial class HtmlTests
{
    [Fact]
    public void Page_Sections_AreListedAndEscaped()
    {
        var page = new HtmlPage("Tour <1>", "a & b");
        page.AddSection("4.7", "切换边", "Edge flip").AddText("x < y").AddPicture("out/a b.png", "before").AddPicture(new Image(2, 2, Color.White), "after")
            .AddTable("t", ["name", "n"], [["a", "1"], ["b", "2"]]).AddPreformatted("line 1\nline 2\n");
        page.AddSection("5.1", "邻域").AddModel("m.html", "m.png", "model").AddSvg("<svg/>");

        string html = page.ToHtml();

        Assert.Contains("<title>Tour &lt;1&gt;</title>", html, StringComparison.Ordinal);
        Assert.Contains("href=\"#s4-7\"", html, StringComparison.Ordinal);
        Assert.Contains("id=\"s4-7\"", html, StringComparison.Ordinal);
        Assert.Contains("x &lt; y", html, StringComparison.Ordinal);
        Assert.Contains("src=\"out/a%20b.png\"", html, StringComparison.Ordinal);
        Assert.Contains("src=\"data:image/png;base64,", html, StringComparison.Ordinal);
        Assert.Contains("<td>a</td><td class=\"number\">1</td>", html, StringComparison.Ordinal);
        Assert.Contains("data-src=\"m.html\"", html, StringComparison.Ordinal);
        Assert.DoesNotMatch(Network(), html);
        Assert.Equal(Count(html, "<div"), Count(html, "</div>"));
        Assert.Equal(Count(html, "<section"), Count(html, "</section>"));
    }

    [Fact]
    public void Page_RowOfWrongLength_Throws() =>
        Assert.Throws<ArgumentException>(() => new HtmlPage("p").AddSection("1", "s").AddTable("", ["a", "b"], [["1"]]));

    [Theory]
    [MemberData(nameof(Models.All), MemberType = typeof(Models))]
    public void Viewer_EveryModel_HoldsItsGeometry(string name)
    {
        Mesh mesh = Models.Create(name);
        string html = HtmlViewer.ToHtml(mesh, new() { Coloring = Coloring.ByValence(mesh) }, "{{title}} </script>");

        Assert.DoesNotMatch(Network(), html);
        JsonElement scene = Scene(html);
        byte[] data = Geometry(html);
        int vertices = scene.GetProperty("vertices").GetInt32(), triangles = scene.GetProperty("triangles").GetInt32(), edges = scene.GetProperty("edges").GetInt32();
        Assert.Equal(16 * vertices + 12 * triangles + 8 * edges, data.Length);
        Assert.Equal(mesh.Edges.Count, edges);
        Assert.Equal(mesh.Faces.Sum(f => f.Degree - 2), triangles);
        Assert.True(vertices >= mesh.Vertices.Count);
        for (int i = 0; i < 3 * triangles + 2 * edges; i++)
            Assert.InRange(BitConverter.ToInt32(data, 16 * vertices + 4 * i), 0, vertices - 1);
    }

    [Fact]
    public void Viewer_Places_AreNearThePositions()
    {
        Mesh mesh = MeshRendererTests.Sphere(12, 5, new(100, 0, -7));
        string html = HtmlViewer.ToHtml(mesh, embedded: true);
        JsonElement scene = Scene(html);
        byte[] data = Geometry(html);
        double[] low = [.. scene.GetProperty("low").EnumerateArray().Select(e => e.GetDouble())], size = [.. scene.GetProperty("size").EnumerateArray().Select(e => e.GetDouble())];
        for (int i = 0; i < scene.GetProperty("vertices").GetInt32(); i++)
        {
            var place = new Vector3D(Axis(i, 0), Axis(i, 1), Axis(i, 2));
            Assert.True(mesh.Vertices.Min(v => Vector3D.Distance(v.Position, place)) < 3e-4);
        }
        Assert.Contains("class=\"embedded\"", html, StringComparison.Ordinal);

        double Axis(int vertex, int axis) => low[axis] + BitConverter.ToUInt16(data, 16 * vertex + 2 * axis) / 65535.0 * size[axis];
    }

    [Fact]
    public void Viewer_Twice_GivesTheSameText()
    {
        Mesh mesh = Models.Create("torus");
        Assert.Equal(HtmlViewer.ToHtml(mesh), HtmlViewer.ToHtml(mesh));
    }

    private static JsonElement Scene(string html) => JsonDocument.Parse(Part(html, "id=\"scene\">")).RootElement;

    private static byte[] Geometry(string html)
    {
        using var gzip = new GZipStream(new MemoryStream(Convert.FromBase64String(Part(html, "id=\"geometry\">"))), CompressionMode.Decompress);
        using var all = new MemoryStream();
        gzip.CopyTo(all);
        return all.ToArray();
    }

    private static string Part(string html, string after)
    {
        int from = html.IndexOf(after, StringComparison.Ordinal) + after.Length;
        return html[from..html.IndexOf("</script>", from, StringComparison.Ordinal)];
    }

    private static int Count(string text, string part) => text.Split(part).Length - 1;

    // Anything that a browser would fetch from elsewhere.
    [GeneratedRegex("(src|href|url)\\s*[=(]\\s*[\"']?(https?:)?//", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 10_000)]
    private static partial Regex Network();
}
