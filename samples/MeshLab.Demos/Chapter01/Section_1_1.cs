using MeshLab.Demos.Hosting;
using MeshLab.Geometry;
using MeshLab.IO;
using MeshLab.Structure;
using MeshLab.Topology;

namespace MeshLab.Demos.Chapter01;

/// <summary>§1.1 三维模型的组成: what a model is made of: geometry (where), topology (how it hangs together), attributes (all else).</summary>
[Demo("1.1", "三维模型的组成", "Geometry, topology, attributes")]
public static class Section_1_1
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        MeshMeasures geometry = MeshMeasures.Of(mesh);
        output.Table(
            "几何 geometry: positions, and what follows from them",
            ("box", geometry.BoundingBox.Size),
            ("area", geometry.Mass.Area),
            ("mean edge length", geometry.EdgeLength.Mean));

        TopologyReport topology = mesh.ComputeTopology();
        output.Table(
            "拓扑 topology: what would stay if every vertex moved",
            ("V, E, F", $"{mesh.Vertices.Count}, {mesh.Edges.Count}, {mesh.Faces.Count}"),
            ("components", topology.Components.Count),
            ("boundary loops", topology.BoundaryLoops),
            ("genus", topology.Genus));

        MeshData data = mesh.ToMeshData();
        output.Table(
            "属性 attributes: what the file says beside",
            ("normals", data.VertexNormals is not null || data.CornerNormals is not null ? "yes" : "no"),
            ("texture coordinates", data.VertexTextureCoordinates is not null || data.CornerTextureCoordinates is not null ? "yes" : "no"),
            ("colours", data.VertexColors is not null || data.FaceColors is not null ? "yes" : "no"),
            ("named groups of faces", string.Join(", ", mesh.FaceLabels.Select(labels => $"{labels.Sort} ({labels.Names.Count})")) is { Length: > 0 } sorts ? sorts : "none"));
        output.Picture("model", mesh);
    }
}
