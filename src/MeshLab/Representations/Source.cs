using System.Runtime.CompilerServices;
using MeshLab.Structure;

namespace MeshLab.Representations;

/// <summary>What the conversions from a mesh have in common.</summary>
internal static class Source
{
    /// <summary>The mesh itself, or a copy without the slots of deleted elements.</summary>
    public static Mesh Compact(Mesh mesh)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        if (mesh.IsCompact)
            return mesh;
        Mesh copy = mesh.Clone();
        copy.Compact();
        return copy;
    }

    /// <summary>As <see cref="Compact"/>, for representations that hold triangles only.</summary>
    public static Mesh CompactTriangles(Mesh mesh)
    {
        mesh = Compact(mesh);
        foreach (Face f in mesh.Faces)
        {
            if (!f.IsTriangle)
                throw new ArgumentException($"{f} has {f.Degree} vertices; this representation holds triangles only.", nameof(mesh));
        }
        return mesh;
    }

    /// <summary>Throws unless the index is one of <paramref name="count"/>.</summary>
    public static void CheckIndex(int index, int count, [CallerArgumentExpression(nameof(index))] string? name = null)
    {
        if ((uint)index >= (uint)count)
            throw new ArgumentOutOfRangeException(name, index, $"There are {count}.");
    }
}
