using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Segmentation;

/// <summary>Area, unit normal and barycentre of every face, computed once per segmentation.</summary>
internal sealed class FaceGeometry
{
    public FaceGeometry(Mesh mesh)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        Areas = new double[mesh.FaceSlots];
        Normals = new Vector3D[mesh.FaceSlots];
        Centers = new Vector3D[mesh.FaceSlots];
        Live = [.. mesh.Faces.Select(f => f.Index)];
        foreach (int f in Live)
        {
            Vector3D origin = mesh.Faces[f].HalfEdge.Source.Position, vectorArea = default, sum = default;
            int corners = 0;
            foreach (HalfEdge h in mesh.Faces[f].HalfEdges)
            {
                vectorArea += Vector3D.Cross(h.Source.Position - origin, h.Target.Position - origin);
                sum += h.Source.Position - origin;
                corners++;
            }
            Areas[f] = vectorArea.Length / 2;
            // The normal of a face without area is the null vector: it agrees with no direction and contradicts none.
            Normals[f] = vectorArea.Normalized();
            Centers[f] = origin + sum / corners;
        }
    }

    public double[] Areas { get; }

    public Vector3D[] Normals { get; }

    public Vector3D[] Centers { get; }

    public int[] Live { get; }
}
