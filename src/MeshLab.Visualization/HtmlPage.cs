using System.Globalization;
using System.Text;

namespace MeshLab.Visualization;

/// <summary>
/// A page of pictures, tables and charts in one HTML file that needs no network: a heading, a list of contents, sections. It fits small
/// and large windows, light and dark, and paper.
/// </summary>
public sealed class HtmlPage
{
    private readonly List<HtmlSection> sections = [];

    /// <summary>An empty page.</summary>
    /// <param name="title">The title.</param>
    /// <param name="subtitle">A line under it, such as the model's name.</param>
    public HtmlPage(string title, string subtitle = "")
    {
        ArgumentNullException.ThrowIfNull(title);
        ArgumentNullException.ThrowIfNull(subtitle);
        Title = title;
        Subtitle = subtitle;
    }

    /// <summary>The title.</summary>
    public string Title { get; }

    /// <summary>The line under the title.</summary>
    public string Subtitle { get; }

    /// <summary>The sections so far.</summary>
    public IReadOnlyList<HtmlSection> Sections => sections;

    /// <summary>Adds a section at the end.</summary>
    /// <param name="number">Its number, such as <c>4.7</c>; what stands before the first dot groups the contents.</param>
    /// <param name="title">Its heading, such as 切换边.</param>
    /// <param name="secondTitle">The heading in the other language, such as Edge flip.</param>
    public HtmlSection AddSection(string number, string title, string secondTitle = "")
    {
        var section = new HtmlSection(number, title, secondTitle);
        sections.Add(section);
        return section;
    }

    /// <summary>The whole page.</summary>
    public string ToHtml()
    {
        var html = new StringBuilder();
        html.Append("<!DOCTYPE html>\n<html lang=\"zh-Hans\">\n<head>\n<meta charset=\"utf-8\">\n");
        html.Append("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n");
        html.Append(CultureInfo.InvariantCulture, $"<title>{SvgWriter.Escape(Title)}</title>\n<style>\n{Style}</style>\n</head>\n<body>\n");
        html.Append(CultureInfo.InvariantCulture, $"<header><h1>{SvgWriter.Escape(Title)}</h1>");
        if (Subtitle.Length > 0)
            html.Append(CultureInfo.InvariantCulture, $"<p>{SvgWriter.Escape(Subtitle)}</p>");
        html.Append("</header>\n");
        AppendContents(html);
        html.Append("<main>\n");
        foreach (HtmlSection section in sections)
            section.AppendTo(html);
        html.Append(CultureInfo.InvariantCulture, $"</main>\n<script>\n{Script}</script>\n</body>\n</html>\n");
        return html.ToString();
    }

    /// <summary>Writes the page as a file; folders on the way are made.</summary>
    public void Save(string path) => TextFile.Save(path, ToHtml());

    private void AppendContents(StringBuilder html)
    {
        if (sections.Count < 2)
            return;
        html.Append("<nav aria-label=\"contents 目录\">");
        string? chapter = null;
        foreach (HtmlSection section in sections)
        {
            string own = section.Number.Split('.')[0];
            if (own != chapter)
                html.Append(chapter is null ? "<div>" : "</div><div>");
            chapter = own;
            html.Append(CultureInfo.InvariantCulture, $"<a href=\"#{section.Id}\"><b>{SvgWriter.Escape(section.Number)}</b> {SvgWriter.Escape(section.Title)}{SecondTitle(section)}</a>");
        }
        html.Append("</div></nav>\n");
    }

    private static string SecondTitle(HtmlSection section) =>
        section.SecondTitle.Length == 0 ? "" : $" <span lang=\"en\">{SvgWriter.Escape(section.SecondTitle)}</span>";

    private const string Style = """
        :root { color-scheme: light dark; --ink: #1f2430; --soft: #5c6475; --page: #f6f7fa; --card: #fff; --line: #dfe3ea; --accent: #3159b5; --code: #f1f3f7; }
        @media (prefers-color-scheme: dark) {
          :root { --ink: #e6e9f0; --soft: #a0a8b8; --page: #15181f; --card: #1e222b; --line: #333947; --accent: #8fb0ff; --code: #171b23; }
          .figure img { filter: brightness(.93); }
        }
        * { box-sizing: border-box; }
        html { scroll-behavior: smooth; scroll-padding-top: 12px; }
        body { margin: 0; background: var(--page); color: var(--ink); font: 16px/1.6 system-ui, "Segoe UI", "Noto Sans CJK SC", "PingFang SC", "Microsoft YaHei", sans-serif; }
        header, nav, main { max-width: 1180px; margin: 0 auto; padding: 0 20px; }
        header { padding-top: 34px; }
        h1 { font-size: 30px; line-height: 1.25; margin: 0; letter-spacing: -.01em; }
        header p { margin: 6px 0 0; color: var(--soft); }
        nav { padding-top: 18px; font-size: 14px; }
        nav div { display: flex; flex-wrap: wrap; gap: 2px 16px; padding: 5px 0; border-bottom: 1px solid var(--line); }
        a { color: var(--accent); text-decoration: none; }
        a:hover { text-decoration: underline; }
        nav span { color: var(--soft); }
        section { background: var(--card); border: 1px solid var(--line); border-radius: 14px; margin: 22px 0; padding: 20px 24px 24px; }
        h2 { font-size: 21px; margin: 0 0 6px; line-height: 1.35; }
        h2 .number { color: var(--accent); margin-right: .45em; font-variant-numeric: tabular-nums; }
        h2 .second { color: var(--soft); font-weight: 400; font-size: 17px; margin-left: .6em; }
        p { margin: 8px 0; max-width: 78ch; }
        .row { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 440px), 1fr)); gap: 18px; margin: 14px 0; align-items: start; }
        .figure { margin: 0; min-width: 0; }
        .figure:only-child { max-width: 720px; }
        .figure img, .figure .model { display: block; width: 100%; height: auto; border: 1px solid var(--line); border-radius: 10px; background: #fff; }
        .figure .model { position: relative; aspect-ratio: 9 / 7; overflow: hidden; }
        .model img { border: 0; border-radius: 0; width: 100%; height: 100%; object-fit: contain; }
        .model iframe { position: absolute; inset: 0; width: 100%; height: 100%; border: 0; }
        .model button { position: absolute; left: 12px; bottom: 12px; font: inherit; font-size: 14px; padding: 5px 13px; border-radius: 8px; border: 0; background: #3159b5; color: #fff; cursor: pointer; }
        .model button:focus-visible { outline: 3px solid #9db9ff; }
        .figure svg { max-width: 100%; height: auto; display: block; }
        figcaption { color: var(--soft); font-size: 14px; margin-top: 6px; }
        .scroll { overflow-x: auto; margin: 14px 0; }
        table { border-collapse: collapse; font-size: 14.5px; font-variant-numeric: tabular-nums; }
        caption { text-align: left; color: var(--soft); font-size: 14px; padding-bottom: 4px; }
        th, td { padding: 4px 14px 4px 0; text-align: left; border-bottom: 1px solid var(--line); vertical-align: top; }
        th { font-weight: 600; }
        td.number, th.number { text-align: right; }
        pre { background: var(--code); border: 1px solid var(--line); border-radius: 10px; padding: 12px 14px; overflow-x: auto; font: 13.5px/1.5 ui-monospace, "Cascadia Mono", Consolas, "Noto Sans Mono CJK SC", monospace; margin: 14px 0; }
        @media print { body { background: #fff; } section { break-inside: avoid; border: 0; padding: 0; } .model button { display: none; } }

        """;

    // A browser allows few 3D views at a time, so a model starts when asked for and the one before is put away.
    private const string Script = """
        let active = null;
        const close = () => { if (active) { active.querySelector("iframe").remove(); active.querySelector("button").hidden = false; active = null; } };
        for (const model of document.querySelectorAll(".model")) {
          model.querySelector("button").addEventListener("click", e => {
            close();
            const frame = document.createElement("iframe");
            frame.src = model.dataset.src;
            frame.title = model.querySelector("img").alt;
            model.append(frame);
            e.currentTarget.hidden = true;
            active = model;
          });
        }

        """;
}

/// <summary>A section of an <see cref="HtmlPage"/>. Every method adds something at its end and returns the section.</summary>
public sealed class HtmlSection
{
    private readonly StringBuilder body = new();
    private bool inRow;

    internal HtmlSection(string number, string title, string secondTitle)
    {
        ArgumentNullException.ThrowIfNull(number);
        ArgumentNullException.ThrowIfNull(title);
        ArgumentNullException.ThrowIfNull(secondTitle);
        Number = number;
        Title = title;
        SecondTitle = secondTitle;
        Id = "s" + string.Concat(number.Select(c => char.IsAsciiLetterOrDigit(c) ? c : '-'));
    }

    /// <summary>The number.</summary>
    public string Number { get; }

    /// <summary>The heading.</summary>
    public string Title { get; }

    /// <summary>The heading in the other language.</summary>
    public string SecondTitle { get; }

    /// <summary>The anchor, such as <c>s4-7</c>.</summary>
    public string Id { get; }

    /// <summary>Adds a paragraph.</summary>
    public HtmlSection AddText(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        return Block($"<p>{SvgWriter.Escape(text)}</p>");
    }

    /// <summary>Adds lines as they are, in a fixed-width font.</summary>
    public HtmlSection AddPreformatted(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        return Block($"<pre>{SvgWriter.Escape(text.TrimEnd('\n', '\r'))}</pre>");
    }

    /// <summary>Adds a picture by reference; pictures that follow each other stand side by side where the window is wide enough.</summary>
    /// <param name="path">The file's path relative to the page.</param>
    /// <param name="caption">What is seen.</param>
    public HtmlSection AddPicture(string path, string caption)
    {
        ArgumentException.ThrowIfNullOrEmpty(path);
        ArgumentNullException.ThrowIfNull(caption);
        return Figure($"<img src=\"{Link(path)}\" alt=\"{SvgWriter.Escape(caption)}\" loading=\"lazy\">", caption);
    }

    /// <summary>Adds a picture inside the page.</summary>
    /// <param name="picture">The picture.</param>
    /// <param name="caption">What is seen.</param>
    public HtmlSection AddPicture(Image picture, string caption)
    {
        ArgumentNullException.ThrowIfNull(picture);
        ArgumentNullException.ThrowIfNull(caption);
        return Figure(
            $"<img src=\"data:image/png;base64,{Convert.ToBase64String(picture.ToPng())}\" width=\"{picture.Width}\" height=\"{picture.Height}\" alt=\"{SvgWriter.Escape(caption)}\">",
            caption);
    }

    /// <summary>Adds a turnable model: a picture that becomes the model when asked for.</summary>
    /// <param name="viewerPath">A page of <see cref="HtmlViewer"/> (embedded), relative to this page.</param>
    /// <param name="picturePath">The picture shown before, relative to this page.</param>
    /// <param name="caption">What is seen.</param>
    public HtmlSection AddModel(string viewerPath, string picturePath, string caption)
    {
        ArgumentException.ThrowIfNullOrEmpty(viewerPath);
        ArgumentException.ThrowIfNullOrEmpty(picturePath);
        ArgumentNullException.ThrowIfNull(caption);
        return Figure(
            $"<div class=\"model\" data-src=\"{Link(viewerPath)}\"><img src=\"{Link(picturePath)}\" alt=\"{SvgWriter.Escape(caption)}\" loading=\"lazy\"><button type=\"button\">turn 旋转</button></div>",
            caption);
    }

    /// <summary>Adds a chart or other SVG element.</summary>
    /// <param name="svg">The element, as <see cref="SvgChart.ToSvg"/> gives it; it is not escaped.</param>
    /// <param name="caption">What is seen.</param>
    public HtmlSection AddSvg(string svg, string caption = "")
    {
        ArgumentNullException.ThrowIfNull(svg);
        ArgumentNullException.ThrowIfNull(caption);
        return Figure(svg, caption);
    }

    /// <summary>Adds a table; cells that are numbers are set to the right.</summary>
    /// <param name="caption">The caption; none if empty.</param>
    /// <param name="headers">The heads of the columns.</param>
    /// <param name="rows">The rows, each with as many cells.</param>
    /// <exception cref="ArgumentException">A row has another number of cells.</exception>
    public HtmlSection AddTable(string caption, IReadOnlyList<string> headers, IEnumerable<IReadOnlyList<string>> rows)
    {
        ArgumentNullException.ThrowIfNull(caption);
        ArgumentNullException.ThrowIfNull(headers);
        ArgumentNullException.ThrowIfNull(rows);
        List<IReadOnlyList<string>> all = [.. rows];
        if (all.Find(row => row.Count != headers.Count) is { } wrong)
            throw new ArgumentException($"A row has {wrong.Count} cells, but there are {headers.Count} heads.", nameof(rows));
        bool[] numeric = [.. headers.Select((_, i) => all.Count > 0 && all.TrueForAll(row => IsNumber(row[i])))];

        var html = new StringBuilder("<div class=\"scroll\"><table>");
        if (caption.Length > 0)
            html.Append(CultureInfo.InvariantCulture, $"<caption>{SvgWriter.Escape(caption)}</caption>");
        html.Append("<thead><tr>");
        for (int i = 0; i < headers.Count; i++)
            Cell(html, "th", headers[i], numeric[i]);
        html.Append("</tr></thead><tbody>");
        foreach (IReadOnlyList<string> row in all)
        {
            html.Append("<tr>");
            for (int i = 0; i < row.Count; i++)
                Cell(html, "td", row[i], numeric[i]);
            html.Append("</tr>\n");
        }
        return Block(html.Append("</tbody></table></div>").ToString());
    }

    internal void AppendTo(StringBuilder html)
    {
        html.Append(CultureInfo.InvariantCulture, $"<section id=\"{Id}\">\n<h2><span class=\"number\">{SvgWriter.Escape(Number)}</span>{SvgWriter.Escape(Title)}");
        if (SecondTitle.Length > 0)
            html.Append(CultureInfo.InvariantCulture, $"<span class=\"second\" lang=\"en\">{SvgWriter.Escape(SecondTitle)}</span>");
        html.Append("</h2>\n").Append(body).Append(inRow ? "</div>\n" : "").Append("</section>\n");
    }

    private HtmlSection Block(string html)
    {
        body.Append(inRow ? "</div>\n" : "").Append(html).Append('\n');
        inRow = false;
        return this;
    }

    private HtmlSection Figure(string content, string caption)
    {
        if (!inRow)
            body.Append("<div class=\"row\">\n");
        inRow = true;
        body.Append("<figure class=\"figure\">").Append(content);
        if (caption.Length > 0)
            body.Append(CultureInfo.InvariantCulture, $"<figcaption>{SvgWriter.Escape(caption)}</figcaption>");
        body.Append("</figure>\n");
        return this;
    }

    private static void Cell(StringBuilder html, string tag, string text, bool number) =>
        html.Append(CultureInfo.InvariantCulture, $"<{tag}{(number ? " class=\"number\"" : "")}>{SvgWriter.Escape(text)}</{tag}>");

    private static bool IsNumber(string text) =>
        text is "" or "–" or "-" || double.TryParse(text.AsSpan().TrimEnd("%°× "), NumberStyles.Float | NumberStyles.AllowThousands, CultureInfo.InvariantCulture, out _);

    // Slashes stay; everything else that a link must not hold is escaped.
    private static string Link(string path) => string.Join('/', path.Replace('\\', '/').Split('/').Select(Uri.EscapeDataString));
}
