using MeshLab.Demos.Hosting;
using MeshLab.Simplification;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter07;

/// <summary>§7.5 简化记录: down to the base, up to any number of faces, and back to the original, bit for bit.</summary>
[Demo("7.5", "简化记录", "Progressive mesh")]
public static class Section_7_5
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        ProgressiveMesh progressive = ProgressiveMesh.Create(mesh);
        ulong original = progressive.Mesh.StateHash();
        output.Line($"{progressive.CollapseCount} contractions recorded, from {progressive.MaxFaces} faces down to {progressive.MinFaces}");

        foreach (int percent in (int[])[1, 5, 20, 100])
        {
            int faces = Math.Max(progressive.MinFaces, (int)((long)progressive.MaxFaces * percent / 100));
            progressive.GoToFaces(faces);
            output.Picture($"{percent} percent", progressive.Mesh);
        }
        output.Line($"back at the top the state is {(progressive.Mesh.StateHash() == original ? "the same" : "another")}");

        progressive.Save(output.FileFor("model.pm"));
        ProgressiveMesh loaded = ProgressiveMeshFile.Load(output.FileFor("model.pm"));
        output.Line($"saved in {new FileInfo(output.FileFor("model.pm")).Length} bytes and loaded: {loaded.MinFaces} to {loaded.MaxFaces} faces");
    }
}
