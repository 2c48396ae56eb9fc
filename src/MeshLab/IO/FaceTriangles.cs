using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>Faces as triangles, for formats that hold nothing else.</summary>
internal static class FaceTriangles
{
    /// <summary>The corners of the triangles, in face order, and the face of each.</summary>
    public static (int[] Corners, int[] Faces) Of(MeshData data)
    {
        List<int> corners = new(data.Corners.Length), faces = new(data.FaceCount);
        for (int f = 0; f < data.FaceCount; f++)
        {
            PolygonTriangulation.Triangulate(data.Positions, data.FaceCorners(f), corners);
            while (faces.Count < corners.Count / 3)
                faces.Add(f);
        }

        return ([.. corners], [.. faces]);
    }
}
