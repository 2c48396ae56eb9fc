using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Editing;

/// <summary>What the operations ask of their arguments.</summary>
internal static class Arguments
{
    extension(Vector3D position)
    {
        /// <summary>Throws unless the position is finite.</summary>
        public void ThrowIfNotFinite(string parameter)
        {
            if (!position.IsFinite)
                throw new ArgumentException($"The position {position} is not finite.", parameter);
        }

        /// <summary>Where the foot of the position lies between two points: 0 at the first, 1 at the second, and never beyond; ½ if they coincide.</summary>
        public double ParameterBetween(Vector3D first, Vector3D second)
        {
            Vector3D along = second - first;
            double length2 = along.LengthSquared;
            return length2 > 0 ? Math.Clamp(Vector3D.Dot(position - first, along) / length2, 0, 1) : 0.5;
        }
    }

    /// <summary>Throws unless the mesh is there, and returns it.</summary>
    public static Mesh NotNull(Mesh mesh)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        return mesh;
    }
}
