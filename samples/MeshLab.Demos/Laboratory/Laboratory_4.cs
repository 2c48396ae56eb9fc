using MeshLab.Demos.Hosting;
using MeshLab.Remeshing;
using MeshLab.Simplification;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Laboratory;

/// <summary>L4 各向同性重新网格化: the laboratory's four steps beside the remesher that projects back to the model.</summary>
[Demo("L4", "各向同性重新网格化", "Isotropic remeshing")]
public static class Laboratory_4
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh script = mesh.Clone();
        script.RemeshInLaboratory();
        Mesh projected = mesh.RemeshIsotropically().Mesh;

        output.Table(
            "five passes at the mean edge length",
            ["", "faces", "mean smallest angle", "smallest angle", "valence 6", "valence 5–7", "rms distance / diagonal"],
            [Row("model", mesh), Row("laboratory", script), Row("with projection", projected)]);
        output.Picture("model", mesh, Coloring.ByValence(mesh));
        output.Picture("laboratory", script, Coloring.ByValence(script));
        output.Picture("projected", projected, Coloring.ByValence(projected));
        output.Viewer("projected", projected);

        object[] Row(string name, Mesh m)
        {
            RemeshingQuality q = RemeshingQuality.Of(m);
            MeshDistanceReport distance = mesh.DistanceTo(m, new MeshDistanceOptions { Samples = 20_000 });
            return [name, m.Faces.Count, q.MeanSmallestAngle * 180 / Math.PI, q.SmallestAngle * 180 / Math.PI, q.Valence6, q.Valence567, distance.Rms / distance.Diagonal];
        }
    }
}
