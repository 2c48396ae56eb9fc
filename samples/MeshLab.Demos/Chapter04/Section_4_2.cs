using MeshLab.Demos.Hosting;
using MeshLab.Editing;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter04;

/// <summary>§4.2 删除面: deletes every twentieth face; where two holes would meet in a vertex, the deletion is refused.</summary>
[Demo("4.2", "删除面", "Deleting faces")]
public static class Section_4_2
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        int deleted = 0, refused = 0;
        for (int f = 0; f < mesh.FaceSlots; f += 20)
        {
            if (mesh.Faces[f].TryDelete(out _))
                deleted++;
            else
                refused++;
        }
        output.Line($"{deleted} faces deleted, {refused} refused because two fans would touch in a vertex");
        output.Table("after", ("vertices", mesh.Vertices.Count), ("edges", mesh.Edges.Count), ("faces", mesh.Faces.Count));
        output.Picture("holes", mesh);
    }
}
