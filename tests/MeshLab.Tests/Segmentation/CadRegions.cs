using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Tests.Segmentation;

/// <summary>The regions of a CAD model between its sharp edges, found by the plain definition: a second opinion for the methods under test.</summary>
internal static class CadRegions
{
    public static int[] Between(Mesh mesh, double degrees, out int count)
    {
        var labels = new int[mesh.FaceSlots];
        Array.Fill(labels, -1);
        count = 0;
        foreach (Face seed in mesh.Faces)
        {
            if (labels[seed.Index] >= 0)
                continue;
            var stack = new Stack<Face>([seed]);
            labels[seed.Index] = count;
            while (stack.TryPop(out Face f))
            {
                foreach (Face g in f.Neighbors)
                {
                    if (labels[g.Index] >= 0 || Vector3D.Angle(Normal(f), Normal(g)) > degrees * Math.PI / 180)
                        continue;
                    labels[g.Index] = count;
                    stack.Push(g);
                }
            }
            count++;
        }
        return labels;
    }

    private static Vector3D Normal(Face f)
    {
        Vector3D a = f.HalfEdge.Source.Position, b = f.HalfEdge.Target.Position, c = f.HalfEdge.Next.Target.Position;
        return Vector3D.Cross(b - a, c - a);
    }
}
