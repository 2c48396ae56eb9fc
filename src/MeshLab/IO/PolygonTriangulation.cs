using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>Cuts polygons into triangles for formats that hold nothing else.</summary>
internal static class PolygonTriangulation
{
    /// <summary>The faces as triangles, in face order, and the face of each.</summary>
    public static (int[] Corners, int[] Faces) Triangulate(MeshData data)
    {
        List<int> corners = new(data.Corners.Length), faces = new(data.FaceCount);
        List<int> polygon = [];
        for (int f = 0; f < data.FaceCount; f++)
        {
            ReadOnlySpan<int> face = data.FaceCorners(f);
            if (face.Length == 3)
            {
                corners.AddRange(face);
                faces.Add(f);
                continue;
            }

            polygon.Clear();
            polygon.AddRange(face);
            CutEars(polygon, data.Positions, corners);
            while (faces.Count < corners.Count / 3)
                faces.Add(f);
        }

        return ([.. corners], [.. faces]);
    }

    /// <summary>Ear clipping (Meisters 1975) in the plane of the polygon's area vector; where no ear is left, as in polygons that cross themselves, the next corner is taken.</summary>
    private static void CutEars(List<int> polygon, Vector3D[] positions, List<int> triangles)
    {
        Vector3D normal = AreaVector(polygon, positions);
        int i = 0, sinceLastEar = 0;
        while (polygon.Count > 3)
        {
            int n = polygon.Count;
            i %= n;
            int a = polygon[(i + n - 1) % n], b = polygon[i], c = polygon[(i + 1) % n];
            if (sinceLastEar < n && !IsEar(a, b, c, polygon, positions, normal))
            {
                i++;
                sinceLastEar++;
                continue;
            }

            triangles.AddRange([a, b, c]);
            polygon.RemoveAt(i);
            sinceLastEar = 0;
        }

        triangles.AddRange(polygon);
    }

    private static Vector3D AreaVector(List<int> polygon, Vector3D[] positions)
    {
        Vector3D sum = default, origin = positions[polygon[0]];
        for (int k = 1; k + 1 < polygon.Count; k++)
            sum += Vector3D.Cross(positions[polygon[k]] - origin, positions[polygon[k + 1]] - origin);
        return sum;
    }

    private static bool IsEar(int a, int b, int c, List<int> polygon, Vector3D[] positions, Vector3D normal)
    {
        Vector3D p = positions[a], q = positions[b], r = positions[c];
        if (Turn(p, q, r, normal) <= 0)
            return false;
        foreach (int v in polygon)
        {
            if (v == a || v == b || v == c)
                continue;
            Vector3D x = positions[v];
            if (Turn(p, q, x, normal) >= 0 && Turn(q, r, x, normal) >= 0 && Turn(r, p, x, normal) >= 0)
                return false;
        }

        return true;
    }

    private static double Turn(Vector3D a, Vector3D b, Vector3D c, Vector3D normal) => Vector3D.Determinant(b - a, c - a, normal);
}
