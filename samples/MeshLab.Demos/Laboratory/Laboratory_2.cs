using MeshLab.Demos.Chapter08;
using MeshLab.Demos.Hosting;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Subdivision;

namespace MeshLab.Demos.Laboratory;

/// <summary>L2 Loop 细分: by splits and flips on the mesh itself, and the same again as a new mesh.</summary>
[Demo("L2", "Loop 细分", "Loop subdivision by splits and flips")]
public static class Laboratory_2
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        Mesh script = Coarse.Of(mesh);
        output.Picture("coarse", script);
        var rows = new List<object[]>();
        for (int step = 1; step <= 2; step++)
        {
            Mesh direct = LoopSubdivision.Subdivide(script);
            LaboratorySubdivisionResult result = script.SubdivideInLaboratory();
            rows.Add([step, result.Splits, result.Flips, script.Faces.Count, SameFaces(script, direct), LargestDistance(script, direct)]);
            output.Picture($"step-{step}", script);
        }
        output.Table("by splits and flips, beside the direct form", ["step", "splits", "flips", "faces", "same faces", "largest distance of two vertices"], rows);
        output.Viewer("subdivided", script);
    }

    private static double LargestDistance(Mesh a, Mesh b) => Enumerable.Range(0, a.VertexSlots).Max(v => Vector3D.Distance(a.Positions[v], b.Positions[v]));

    private static bool SameFaces(Mesh a, Mesh b) => Faces(a).SetEquals(Faces(b));

    private static HashSet<(int, int, int)> Faces(Mesh mesh) => [.. mesh.Faces.Select(f =>
    {
        int[] v = [.. f.Vertices.Select(w => w.Index)];
        int first = Array.IndexOf(v, v.Min());
        return (v[first], v[(first + 1) % 3], v[(first + 2) % 3]);
    })];
}
