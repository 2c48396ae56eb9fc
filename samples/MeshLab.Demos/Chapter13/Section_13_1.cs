using MeshLab.Demos.Hosting;
using MeshLab.Morse;
using MeshLab.Numerics;
using MeshLab.Segmentation;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter13;

/// <summary>§13.1 分段的属性: limbs and body of a model by the watershed of its distance from the middle.</summary>
[Demo("13.1", "分段的属性", "What segments a model: limbs by watershed")]
public static class Section_13_1
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Vector3D mean = mesh.Vertices.Aggregate(default(Vector3D), (sum, v) => sum + v.Position) / mesh.Vertices.Count;
        Vertex middle = mesh.Vertices.Where(v => !v.IsIsolated).MinBy(v => (v.Position - mean).LengthSquared);
        MorseFunction distance = mesh.GeodesicFunction(middle);
        FaceSegmentation limbs = Watershed.Segment(distance, new WatershedOptions { Segments = 10 });

        output.Line($"distance along edges from {middle}, the vertex nearest to the mean: {limbs.Count} segments, the first of them the body");
        output.Picture("distance", mesh, Coloring.VertexScalars(distance.Values, title: "distance").WithIsolines(24));
        output.Picture("limbs", mesh, Coloring.FaceLabels(limbs.Labels, "segment"));
    }
}
