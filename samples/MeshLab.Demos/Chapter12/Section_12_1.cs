using MeshLab.Demos.Hosting;
using MeshLab.Morse;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter12;

/// <summary>§12.1 莫斯函数: the book's functions on one model, with what Morse's theorem says of each.</summary>
[Demo("12.1", "莫斯函数", "Morse functions")]
public static class Section_12_1
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        (string Name, MorseFunction Function)[] functions =
        [
            ("height z", mesh.CoordinateFunction(2)),
            ("cosine of z", mesh.CosineFunction()),
            ("edge distance from v0", mesh.GeodesicFunction(mesh.Vertices[0])),
            ("mean curvature", mesh.MeanCurvatureFunction()),
        ];
        output.Table(
            "Morse's theorem: minima − saddles + maxima = χ",
            ["function", "minima", "saddles", "maxima", "sum of indices", "χ"],
            functions.Select(f => Row(f.Name, CriticalPoints.Of(f.Function))));
        foreach ((string name, MorseFunction function) in functions)
            output.Picture(name, mesh, Coloring.VertexScalars(function.Values, title: name).WithoutOutliers().WithIsolines(20));
    }

    private static IReadOnlyList<object> Row(string name, CriticalPoints critical) =>
        [name, critical.Minima.Count, critical.SaddleCount, critical.Maxima.Count, critical.IndexSum, critical.EulerCharacteristic];
}
