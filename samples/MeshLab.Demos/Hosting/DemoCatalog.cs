using System.Globalization;
using System.Reflection;
using MeshLab.Structure;

namespace MeshLab.Demos.Hosting;

/// <summary>One demo, ready to run.</summary>
internal sealed record Demo(string Section, string Chinese, string English, Action<Mesh, DemoOutput> Run)
{
    public string Title => $"§{Section} {Chinese} · {English}";
}

/// <summary>All demos of the program, in the book's order.</summary>
internal static class DemoCatalog
{
    public static IReadOnlyList<Demo> All { get; } =
    [
        .. typeof(DemoCatalog).Assembly.GetTypes()
            .Select(type => (Type: type, Mark: type.GetCustomAttribute<DemoAttribute>()))
            .Where(found => found.Mark is not null)
            .Select(found => new Demo(
                found.Mark!.Section,
                found.Mark.Chinese,
                found.Mark.English,
                (found.Type.GetMethod("Run", [typeof(Mesh), typeof(DemoOutput)])
                    ?? throw new InvalidOperationException($"{found.Type} has no method Run(Mesh, DemoOutput).")).CreateDelegate<Action<Mesh, DemoOutput>>()))
            .OrderBy(demo => demo.Section, SectionOrder.Instance),
    ];

    public static Demo? Find(string section) => All.FirstOrDefault(demo => demo.Section.Equals(section, StringComparison.OrdinalIgnoreCase));
}

/// <summary>2.10 after 2.9; chapters with letters (L1) after those with numbers.</summary>
internal sealed class SectionOrder : IComparer<string>
{
    public static SectionOrder Instance { get; } = new();

    public int Compare(string? x, string? y)
    {
        string[] a = (x ?? "").Split('.'), b = (y ?? "").Split('.');
        for (int i = 0; i < Math.Min(a.Length, b.Length); i++)
        {
            bool first = int.TryParse(a[i], CultureInfo.InvariantCulture, out int p), second = int.TryParse(b[i], CultureInfo.InvariantCulture, out int q);
            int order = (first, second) switch
            {
                (true, true) => p.CompareTo(q),
                (true, false) => -1,
                (false, true) => 1,
                _ => string.CompareOrdinal(a[i], b[i]),
            };
            if (order != 0)
                return order;
        }
        return a.Length.CompareTo(b.Length);
    }
}
