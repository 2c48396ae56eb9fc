using MeshLab.Demos.Hosting;
using MeshLab.FiveSixSeven;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter09;

/// <summary>How many inner vertices there are of each valence.</summary>
internal static class ValenceTable
{
    public static void Show(DemoOutput output, string title, Mesh mesh)
    {
        IReadOnlyDictionary<int, int> counts = mesh.CountInnerValences();
        double all = Math.Max(1, counts.Values.Sum());
        output.Line($"{title}: {mesh.Faces.Count} faces");
        output.Table(title, ["valence", "inner vertices", "share, %"], counts.Select(v => new object[] { v.Key, v.Value, 100 * v.Value / all }));
    }
}
