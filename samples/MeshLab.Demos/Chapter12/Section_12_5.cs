using MeshLab.Demos.Hosting;
using MeshLab.LinearAlgebra;
using MeshLab.Morse;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter12;

/// <summary>§12.5 调和函数: a function without extrema of its own, with four kinds of weights.</summary>
[Demo("12.5", "调和函数", "Harmonic functions")]
public static class Section_12_5
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        LaplacianWeights[] kinds = [LaplacianWeights.Cotangent, LaplacianWeights.IntrinsicDelaunay, LaplacianWeights.Uniform, LaplacianWeights.MeanValue];
        MorseFunction[] functions = [.. kinds.Select(weights => mesh.HarmonicFunction(weights: weights))];
        output.Table(
            "10 at the lowest vertex, 100 at the highest: saddles = 2g where no other extrema appear",
            ["weights", "minima", "saddles", "maxima"],
            kinds.Zip(functions, (weights, function) => Row(weights, CriticalPoints.Of(function))));
        output.Picture("harmonic function", mesh, new RenderOptions
        {
            Coloring = Coloring.VertexScalars(functions[0].Values, title: "harmonic").WithIsolines(30),
            Points = CriticalMarks.Of(CriticalPoints.Of(functions[0]).Points),
        });
    }

    private static IReadOnlyList<object> Row(LaplacianWeights weights, CriticalPoints critical) =>
        [weights, critical.Minima.Count, critical.SaddleCount, critical.Maxima.Count];
}
