using System.Text;
using MeshLab.Demos.Hosting;
using MeshLab.IO;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;

namespace MeshLab.Demos.Chapter14;

/// <summary>§14.2 OFF 文件: colours the vertices by their place in the box, writes COFF, and reads the colours back.</summary>
[Demo("14.2", "OFF 文件", "OFF files")]
public static class Section_14_2
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        BoundingBox box = mesh.BoundingBox;
        foreach (Vertex v in mesh.Vertices)
        {
            Vector3D p = v.Position - box.Min;
            VertexTraits traits = v.Traits;
            traits.Color = new Color(Share(p.X, box.Size.X), Share(p.Y, box.Size.Y), Share(p.Z, box.Size.Z));
        }

        string path = output.FileFor("model.off");
        MeshFile.Write(mesh, path);
        foreach (string line in File.ReadLines(path).Take(4))
            output.Line($"{line}");

        Mesh again = MeshFile.Read(path);
        output.Table(
            "read back",
            ("vertices", again.Vertices.Count),
            ("faces", again.Faces.Count),
            ("colours equal to the last bit", mesh.Vertices.Zip(again.Vertices).All(pair => pair.First.Traits.Color == pair.Second.Traits.Color)));

        foreach (string text in (string[])["OFF\n3 1 0\n0 0 0\n1 0 0\n", "OFF BINARY\n", "OFF\n2000000000 1 0\n0 0 0\n"])
        {
            try
            {
                MeshFile.Read(new MemoryStream(Encoding.UTF8.GetBytes(text)), MeshFormat.Off);
            }
            catch (MeshFormatException error)
            {
                output.Line($"refused: {error.Message}");
            }
        }

        Color[] colors = [.. again.Vertices.Select(v => v.Traits.Color)];
        output.Picture("colours", again, Coloring.VertexColors(colors));
    }

    private static float Share(double part, double whole) => whole > 0 ? (float)(part / whole) : 0;
}
