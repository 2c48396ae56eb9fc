using MeshLab.Simplification;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter08;

/// <summary>Subdivision multiplies faces: the demos begin with a coarse form of the model, as chapter 7 makes it.</summary>
internal static class Coarse
{
    public static Mesh Of(Mesh mesh, int mostFaces = 1000)
    {
        Mesh triangles = MeshBuilder.FromTriangles(mesh.Positions, Corners(mesh));
        if (triangles.Faces.Count > mostFaces)
        {
            triangles.Simplify(new QuadricOptions { TargetFaces = mostFaces });
            triangles.Compact();
        }
        return triangles;
    }

    private static int[] Corners(Mesh mesh)
    {
        var corners = new List<int>();
        foreach (Face f in mesh.Faces)
        {
            Vertex[] v = f.Vertices.ToArray();
            for (int i = 2; i < v.Length; i++)
                corners.AddRange([v[0].Index, v[i - 1].Index, v[i].Index]);
        }
        return [.. corners];
    }
}
