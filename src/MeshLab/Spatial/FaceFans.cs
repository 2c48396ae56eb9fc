using MeshLab.Structure;

namespace MeshLab.Spatial;

/// <summary>Cuts the faces of a mesh into triangles: polygons into fans from their first corner.</summary>
internal static class FaceFans
{
    /// <summary>Three vertices per triangle, in face order, and the face of each triangle (null if it is the triangle itself).</summary>
    public static (int[] Corners, int[]? FaceOf) Cut(Mesh mesh)
    {
        ReadOnlySpan<int> next = mesh.Next, target = mesh.Target, first = mesh.HalfEdgeOf;
        int triangles = 0;
        bool same = true;
        for (int f = 0; f < first.Length; f++)
        {
            int degree = first[f] < 0 ? 0 : Degree(next, first[f]);
            same &= degree == 3;
            triangles += Math.Max(0, degree - 2);
        }

        var corners = GC.AllocateUninitializedArray<int>(3 * triangles);
        int[]? faceOf = same ? null : new int[triangles];
        int t = 0;
        for (int f = 0; f < first.Length; f++)
        {
            int start = first[f];
            if (start < 0)
                continue;
            for (int h = next[start]; next[h] != start; h = next[h], t++)
            {
                (corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]) = (target[start ^ 1], target[h ^ 1], target[h]);
                if (faceOf is not null)
                    faceOf[t] = f;
            }
        }
        return (corners, faceOf);
    }

    private static int Degree(ReadOnlySpan<int> next, int start)
    {
        int degree = 1;
        for (int h = next[start]; h != start; h = next[h])
            degree++;
        return degree;
    }
}
