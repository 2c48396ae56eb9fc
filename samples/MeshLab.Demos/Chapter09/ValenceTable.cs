using System.Globalization;
using MeshLab.Demos.Hosting;
using MeshLab.FiveSixSeven;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter09;

/// <summary>How many inner vertices there are of each valence.</summary>
internal static class ValenceTable
{
    public static void Show(DemoOutput output, string title, Mesh mesh) => output.Table(
        $"{title}: {mesh.Faces.Count} faces, inner vertices by valence",
        [.. mesh.CountInnerValences().Select(v => (v.Key.ToString(CultureInfo.InvariantCulture), (object)v.Value))]);
}
