using MeshLab.Geometry;
using MeshLab.Neighborhoods;
using MeshLab.Structure;
using MeshLab.Topology;

namespace MeshLab.Cutting;

/// <summary>§6.5 分割组件: one mesh per connected component, or per region between sharp edges; with traits and maps.</summary>
/// <remarks>Isolated vertices belong to no part. <see cref="Mesh.Append"/> is the inverse. O(V + E + F) for all parts together, plus O(V + F) per part for its maps.</remarks>
public static class PartSplit
{
    extension(Mesh mesh)
    {
        /// <summary>One mesh per component, in order of their lowest vertex; the mesh given stays as it is.</summary>
        public IReadOnlyList<MeshPart> SplitComponents()
        {
            ArgumentNullException.ThrowIfNull(mesh);
            MeshComponents components = mesh.FindComponents();
            return ByLabel(mesh, components.FaceLabels, components.Count);
        }

        /// <summary>One mesh per region that sharp edges cut out, in order of their lowest face; the mesh given stays as it is.</summary>
        /// <param name="angle">Edges whose dihedral angle, convex or concave, is larger are sharp: in radians, between 0 and π.</param>
        /// <exception cref="ArgumentOutOfRangeException">The angle is not between 0 and π.</exception>
        public IReadOnlyList<MeshPart> SplitRegions(double angle)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            if (!(angle >= 0 && angle <= Math.PI))
                throw new ArgumentOutOfRangeException(nameof(angle), angle, "The angle must be between 0 and π.");
            double[] dihedral = mesh.ComputeUnsignedDihedralAngles();
            FaceRegions regions = mesh.FindRegions(Array.ConvertAll(dihedral, a => a > angle));
            return ByLabel(mesh, regions.Labels, regions.Count);
        }
    }

    private static MeshPart[] ByLabel(Mesh mesh, int[] labels, int count)
    {
        var faces = new List<int>[count];
        for (int f = 0; f < labels.Length; f++)
        {
            if (labels[f] >= 0)
                (faces[labels[f]] ??= []).Add(f);
        }
        return [.. faces.Where(list => list is not null).Select(list => MeshPart.OfFaces(mesh, list))];
    }
}
