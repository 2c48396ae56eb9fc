using MeshLab.Demos.Hosting;
using MeshLab.Morse;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter12;

/// <summary>§12.2 临界点: minima, saddles and maxima of the height, by the sign changes around the link.</summary>
[Demo("12.2", "临界点", "Critical points")]
public static class Section_12_2
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        MorseFunction height = mesh.CoordinateFunction(2);
        CriticalPoints critical = CriticalPoints.Of(height);

        output.Line($"{critical.Minima.Count} minima, {critical.SaddleCount} saddles, {critical.Maxima.Count} maxima; {critical.BoundaryMaxima.Count} boundary vertices above all their neighbours count as nothing");
        output.Table(
            "saddles by multiplicity",
            ["multiplicity", "saddles"],
            critical.Saddles.GroupBy(critical.MultiplicityOf).OrderBy(g => g.Key).Select(g => (IReadOnlyList<object>)[g.Key, g.Count()]));
        output.Picture("critical points", mesh, new RenderOptions
        {
            Coloring = Coloring.VertexScalars(height.Values, title: "z").WithIsolines(24),
            Points = CriticalMarks.Of(critical.Points),
        });
    }
}
