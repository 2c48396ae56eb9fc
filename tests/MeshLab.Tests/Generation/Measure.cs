using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Tests.Generation;

/// <summary>Plain sums over faces, so that the generators' tests depend on the structure alone.</summary>
internal static class Measure
{
    public static int EulerCharacteristic(Mesh mesh) => mesh.Vertices.Count - mesh.Edges.Count + mesh.Faces.Count;

    public static double Area(Mesh mesh) => mesh.Faces.Sum(f => VectorArea(f).Length);

    /// <summary>Signed; faces are fanned from their first vertex.</summary>
    public static double Volume(Mesh mesh)
    {
        double sum = 0;
        foreach (Face f in mesh.Faces)
        {
            HalfEdge first = f.HalfEdge;
            for (HalfEdge h = first.Next; h.Target != first.Source; h = h.Next)
                sum += Vector3D.Determinant(first.Source.Position, h.Source.Position, h.Target.Position);
        }
        return sum / 6;
    }

    public static Vector3D VectorArea(Face f)
    {
        Vector3D sum = default, origin = f.HalfEdge.Source.Position;
        foreach (HalfEdge h in f.HalfEdges)
            sum += Vector3D.Cross(h.Source.Position - origin, h.Target.Position - origin);
        return sum / 2;
    }

    public static int BoundaryLoops(Mesh mesh)
    {
        var seen = new HashSet<HalfEdge>();
        int loops = 0;
        foreach (HalfEdge h in mesh.HalfEdges)
        {
            if (!h.IsBoundary || !seen.Add(h))
                continue;
            loops++;
            foreach (HalfEdge g in h.Loop)
                seen.Add(g);
        }
        return loops;
    }

    public static int Components(Mesh mesh)
    {
        var seen = new bool[mesh.VertexSlots];
        var stack = new Stack<Vertex>();
        int components = 0;
        foreach (Vertex start in mesh.Vertices)
        {
            if (seen[start.Index])
                continue;
            components++;
            stack.Push(start);
            seen[start.Index] = true;
            while (stack.TryPop(out Vertex v))
            {
                foreach (Vertex w in v.Neighbors)
                {
                    if (seen[w.Index])
                        continue;
                    seen[w.Index] = true;
                    stack.Push(w);
                }
            }
        }
        return components;
    }
}
