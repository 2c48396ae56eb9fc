using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geometry;

/// <summary>The one error of every formula that is for triangles only.</summary>
internal static class TriangleRequirement
{
    /// <summary>Throws unless every face is a triangle. O(F).</summary>
    /// <exception cref="ArgumentException">Names the first face that is not a triangle, and what triangulates it.</exception>
    public static void RequireTriangles(this Mesh mesh, string parameter = "mesh")
    {
        ArgumentNullException.ThrowIfNull(mesh, parameter);
        int[] next = mesh.next, halfEdgeOf = mesh.halfEdgeOf;
        int faces = mesh.FaceSlots;
        const int Block = 65536;
        var firstBad = new int[faces / Block + 1];
        Array.Fill(firstBad, -1);
        Parallelism.ForBlocks(faces, (from, to) =>
        {
            for (int f = from; f < to; f++)
            {
                int h = halfEdgeOf[f];
                if (h >= 0 && next[next[next[h]]] != h)
                {
                    firstBad[from / Block] = f;
                    return;
                }
            }
        }, Block);
        foreach (int f in firstBad)
        {
            if (f >= 0)
                throw NotATriangle(mesh.Faces[f], parameter);
        }
    }

    /// <summary>The three corners of a face, from its first vertex.</summary>
    /// <exception cref="ArgumentException">The face is dead or not a triangle.</exception>
    public static Triangle Triangle(Face face)
    {
        face.ThrowIfDead();
        if (!face.IsTriangle)
            throw NotATriangle(face, nameof(face));
        HalfEdge h = face.HalfEdge;
        return new(h.Source.Position, h.Target.Position, h.Next.Target.Position);
    }

    private static ArgumentException NotATriangle(Face face, string parameter) =>
        new($"{face} has {face.Degree} corners and this needs triangles; {nameof(Triangulation)}.{nameof(Triangulation.Triangulate)} makes them.", parameter);
}
