using MeshLab.Cutting;
using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter06;

/// <summary>§6.2 沿平面切割: the section, and the half below it with a cap.</summary>
[Demo("6.2", "沿平面切割", "Cutting by a plane")]
public static class Section_6_2
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        if (!mesh.IsTriangleMesh)
            mesh = Triangulation.Triangulate(mesh).Mesh;
        CuttingPlane plane = CuttingPlane.Through(mesh.BoundingBox.Center, new Vector3D(0.3, 0.2, 1));

        PlaneSectionResult section = mesh.ComputeSection(plane);
        output.Line($"{section.ClosedLoops} closed lines and {section.OpenChains} open ones, {section.Segments} segments, length {section.Length:G4}, area {section.Area:G4}");
        Vector3D origin = plane.Normal * plane.Offset;
        output.Svg("section", new SvgPolylines().ToSvg(
            [.. section.Polylines.Where(line => line.IsClosed).Select(line => SvgPolylines.ToPlane(line.Points, origin, plane.Normal))],
            [.. section.Polylines.Where(line => !line.IsClosed).Select(line => SvgPolylines.ToPlane(line.Points, origin, plane.Normal))]));

        PlaneCutResult below = mesh.Clip(plane, PlaneSide.Below, new PlaneCutOptions { Cap = true });
        output.Line($"the part below: {below.Part.Mesh}, {below.CapFaces} faces of caps");
        output.Picture("below", below.Part.Mesh, Coloring.FaceLabels([.. below.Part.SourceFace.Select(f => f < 0 ? 1 : 0)]));
    }
}
