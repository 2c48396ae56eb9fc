using MeshLab.Demos.Hosting;
using MeshLab.Morse;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter12;

/// <summary>§12.6 莫斯理论的应用: persistence, a function simplified to its persistent extrema, the Reeb graph, the base mesh.</summary>
[Demo("12.6", "莫斯理论的应用", "Applications of Morse theory")]
public static class Section_12_6
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        MorseFunction height = mesh.CoordinateFunction(2);
        PersistencePairs pairs = PersistencePairs.Of(height);
        double threshold = 0.05 * (height.Values.Max() - height.Values.Min());
        SimplifiedFunction simplified = FunctionSimplification.Simplify(height, threshold);
        CriticalPoints before = pairs.Critical, after = CriticalPoints.Of(simplified.Function);
        ReebGraph reeb = ReebGraph.Of(simplified.Function);
        BaseMeshResult baseMesh = BaseMesh.Of(MorseComplex.Of(simplified.Function));

        output.Table(
            "the height before and after",
            ["", "minima", "saddles", "maxima"],
            [
                ["as it is", before.Minima.Count, before.SaddleCount, before.Maxima.Count],
                [FormattableString.Invariant($"without pairs up to {threshold:G3}"), after.Minima.Count, after.SaddleCount, after.Maxima.Count],
            ]);
        output.Line($"no value moved by more than {simplified.LargestChange:G3}; {simplified.Changed} of {mesh.Vertices.Count} moved");
        output.Line($"Reeb graph of the simplified function: {reeb.Nodes.Count} nodes, {reeb.Arcs.Count} arcs, {reeb.LoopCount} loops");
        output.Line($"base mesh: {baseMesh.Mesh}");
        output.Svg("persistence diagram", PersistenceDiagram.Of(pairs).ToSvg());
        output.Picture("persistent critical points", mesh, new RenderOptions
        {
            Coloring = Coloring.VertexScalars(simplified.Function.Values, title: "z").WithIsolines(24),
            Points = CriticalMarks.Of(after.Points, 16),
        });
        if (baseMesh.Mesh.Faces.Count > 0)
            output.Picture("base mesh", baseMesh.Mesh, new RenderOptions { Wireframe = true, Shading = Shading.Flat });
    }
}
