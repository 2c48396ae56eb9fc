using MeshLab.Demos.Hosting;
using MeshLab.Generation;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Topology;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter11;

/// <summary>§11.2 欧拉公式: V − E + F on the model and on well-known shapes.</summary>
[Demo("11.2", "欧拉公式", "Euler's theorem")]
public static class Section_11_2
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        output.Line($"the model: {mesh.ComputeTopology()}");
        Mesh twoTori = Tori.Torus(m: 24, n: 12), holes = Tori.KHoled(2);
        var aside = new Vector3D(twoTori.BoundingBox.Max.X - holes.BoundingBox.Min.X + 0.3, 0, 0);
        foreach (ref Vector3D p in holes.Positions)
            p += aside;
        twoTori.Append(holes);
        (string Name, Mesh Mesh)[] shapes =
        [
            ("the model", mesh), ("tetrahedron", Polyhedra.Tetrahedron()), ("cube", Polyhedra.Cube()), ("dodecahedron", Polyhedra.Dodecahedron()),
            ("torus", Tori.Torus()), ("three holes", Tori.KHoled(3)), ("a torus and two holes", twoTori),
        ];
        output.Table("V − E + F = 2C − 2g − B", ["", "V", "E", "F", "χ", "C", "g", "B", "2C − 2g − B"], shapes.Select(shape =>
        {
            TopologyReport r = shape.Mesh.ComputeTopology();
            return new object[]
            {
                shape.Name, r.Vertices, r.Edges, r.Faces, r.EulerCharacteristic, r.Components.Count, r.Genus, r.BoundaryLoops,
                (2 * r.Components.Count) - (2 * r.Genus) - r.BoundaryLoops,
            };
        }));
        output.Picture("a torus and two holes", twoTori, Coloring.FaceLabels(twoTori.FindComponents().FaceLabels, "component"));
    }
}
