using MeshLab.Cutting;
using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Topology;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter06;

/// <summary>§6.4 沿选择的边切开: cuts the model open where two halves of it meet, and draws the two sides apart.</summary>
[Demo("6.4", "沿选择的边切开", "Cutting open along edges")]
public static class Section_6_4
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        // The edges between the faces on either side of the middle, but for a hinge at the top.
        Vector3D middle = mesh.BoundingBox.Center;
        double hinge = middle.Z + 0.25 * mesh.BoundingBox.Size.Z;
        Edge[] chosen =
        [
            .. mesh.Edges.Where(e => !e.IsBoundary
                && e.Face0.Barycenter.X < middle.X != e.Face1.Barycenter.X < middle.X
                && (e.Vertex0.Position.Z + e.Vertex1.Position.Z) / 2 < hinge),
        ];
        double gap = 0.01 * mesh.BoundingBox.Diagonal;
        EdgeCutResult cut = EdgeCutting.CutAlong(mesh, chosen, gap);

        TopologyReport before = mesh.ComputeTopology(), after = cut.Mesh.ComputeTopology();
        output.Table(
            $"cut along {chosen.Length} edges, opened by ±{gap:G3}",
            ["", "vertices", "boundary loops", "components"],
            [
                ["before", mesh.Vertices.Count, before.BoundaryLoops, before.Components.Count],
                ["after", cut.Mesh.Vertices.Count, after.BoundaryLoops, after.Components.Count],
            ]);
        output.Line($"{cut.Copies.Count(copies => copies.Count > 1)} vertices have copies, {cut.Uncut.Count} edges could not be opened.");

        var side = new int[cut.Mesh.FaceSlots];
        for (int f = 0; f < side.Length; f++)
            side[f] = mesh.Faces[cut.SourceFace[f]].Barycenter.X < middle.X ? 0 : 1;
        output.Picture("open", cut.Mesh, Coloring.FaceLabels(side));
    }
}
