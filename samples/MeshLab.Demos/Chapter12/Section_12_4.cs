using MeshLab.Demos.Hosting;
using MeshLab.Morse;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter12;

/// <summary>§12.4 莫斯复形: arcs that never cross and the cells between them, and where the book's steepest paths on mesh edges do cross.</summary>
[Demo("12.4", "莫斯复形", "The Morse complex")]
public static class Section_12_4
{
    private static readonly Color Down = new(0.10f, 0.35f, 0.85f), Up = new(0.85f, 0.20f, 0.12f);

    public static void Run(Mesh mesh, DemoOutput output)
    {
        MorseFunction height = mesh.CoordinateFunction(2);
        double threshold = 0.02 * (height.Values.Max() - height.Values.Min());
        DiscreteGradient gradient = GradientCancellation.Cancel(DiscreteGradient.Of(height), threshold).Gradient;
        MorseComplex complex = MorseComplex.Of(gradient);
        MorseCells cells = MorseCells.Of(complex);

        output.Line($"after cancelling pairs up to {threshold:G3}: {gradient.MinimumCount} minima, {gradient.SaddleCount} saddles, {gradient.MaximumCount} maxima");
        output.Line($"{complex.Arcs.Count} arcs, {cells.Cells.Count} cells, of which {cells.Cells.Count(c => c.EulerCharacteristic == 1)} are disks");
        SteepestPathsResult paths = SteepestPaths.Of(CriticalPoints.Of(height));
        output.Line($"steepest paths both ways on mesh edges would cross at {paths.Crossings.Count} vertices: {string.Join(" ", paths.Crossings.Take(12).Select(v => $"v{v}"))}");

        output.Picture("arcs and cells", mesh, new RenderOptions
        {
            Coloring = Coloring.VertexLabels([.. cells.OfVertex], "cell"),
            Legend = false,
            Polylines = [.. complex.Arcs.Select(arc => new Polyline(complex.Polyline(arc), arc.IsAscending ? Up : Down))],
        });
        output.Picture("steepest paths on mesh edges, and where they cross", mesh, new RenderOptions
        {
            Polylines =
            [
                .. paths.Descending.Select(path => new Polyline(Positions(mesh, path), Down, 1.5)),
                .. paths.Ascending.Select(path => new Polyline(Positions(mesh, path), Up, 1.5)),
            ],
            Points = [new PointMarks(Positions(mesh, paths.Crossings), Color.Black, 12)],
        });
        output.Picture("ascending manifolds of the minima", mesh, new RenderOptions
        {
            Coloring = Coloring.VertexLabels([.. complex.MinimumOf], "minimum"),
            Legend = false,
        });
    }

    private static Vector3D[] Positions(Mesh mesh, IEnumerable<int> vertices) => [.. vertices.Select(v => mesh.Vertices[v].Position)];
}
