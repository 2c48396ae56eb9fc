using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.LinearAlgebra;

/// <summary>The cotangent of the angle opposite each half-edge, from which all weights and areas of a triangle mesh follow.</summary>
internal static class OppositeCotangents
{
    /// <summary>Per half-edge the cotangent of the angle opposite to it in its face; 0 on the boundary and in faces without area.</summary>
    /// <remarks>A face without area has no stiffness to give: its cotangents would be infinite with both signs.</remarks>
    /// <param name="mesh">The mesh.</param>
    /// <param name="doubleArea">Receives twice the area of each face.</param>
    /// <exception cref="ArgumentException">A face is not a triangle.</exception>
    public static double[] Of(Mesh mesh, out double[] doubleArea)
    {
        RequireTriangles(mesh);
        return Of(mesh, mesh.positions, out doubleArea);
    }

    /// <summary>The same with other positions, on a mesh known to have triangles only.</summary>
    public static double[] Of(Mesh mesh, Vector3D[] position, out double[] doubleArea)
    {
        var cotangent = new double[mesh.HalfEdgeSlots];
        var area = new double[mesh.FaceSlots];
        Parallelism.ForBlocks(area.Length, (from, to) => Fill(mesh, position, from, to, cotangent, area));
        doubleArea = area;
        return cotangent;
    }

    private static void Fill(Mesh mesh, ReadOnlySpan<Vector3D> position, int from, int to, Span<double> cotangent, Span<double> area)
    {
        ReadOnlySpan<int> next = mesh.Next, target = mesh.Target, halfEdgeOf = mesh.HalfEdgeOf;
        for (int f = from; f < to; f++)
        {
            int h0 = halfEdgeOf[f];
            if (h0 < 0)
                continue;
            int h1 = next[h0], h2 = next[h1];
            // Corner i lies at the target of half-edge i, opposite half-edge i − 1.
            Vector3D p0 = position[target[h0]], p1 = position[target[h1]], p2 = position[target[h2]];
            Vector3D e1 = p1 - p0, e2 = p2 - p1, e0 = p0 - p2;
            double a = Vector3D.Cross(e1, e2).Length;
            area[f] = a;
            if (!(a > 0))
                continue;
            double scale = -1 / a;
            cotangent[h2] = Vector3D.Dot(e0, e1) * scale;
            cotangent[h0] = Vector3D.Dot(e1, e2) * scale;
            cotangent[h1] = Vector3D.Dot(e2, e0) * scale;
        }
    }

    /// <summary>Throws unless all faces are triangles.</summary>
    /// <exception cref="ArgumentException">Names the first face that is not, and what helps.</exception>
    public static void RequireTriangles(Mesh mesh)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        if (mesh.IsTriangleMesh)
            return;
        Face face = mesh.Faces.First(f => !f.IsTriangle);
        throw new ArgumentException($"{face} has {face.Degree} corners and this needs triangles; Triangulation.Triangulate makes them.", nameof(mesh));
    }
}
