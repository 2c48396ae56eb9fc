using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Generation;

/// <summary>Writes texture coordinates into the textbook's traits: at vertices where the map has no seam, at corners where it has one.</summary>
internal static class TextureMapping
{
    /// <summary>Writes one coordinate per vertex.</summary>
    public static void SetVertices(Mesh mesh, ReadOnlySpan<Vector2D> coordinates) =>
        coordinates.CopyTo(mesh.GetOrAddVertexTrait<Vector2D>(TraitNames.UV, default, Blend.Linear).Values);

    /// <summary>Writes one coordinate per corner.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="coordinates">Per corner, face after face, in the order of each face's vertices.</param>
    public static void SetCorners(Mesh mesh, ReadOnlySpan<Vector2D> coordinates)
    {
        Span<Vector2D> values = mesh.GetOrAddHalfEdgeTrait<Vector2D>(TraitNames.TextureCoordinate, default, Blend.Linear).Values;
        ReadOnlySpan<int> next = mesh.Next, previous = mesh.Previous, first = mesh.HalfEdgeOf;
        int corner = 0;
        for (int f = 0; f < first.Length; f++)
        {
            int h = first[f];
            do
            {
                // A half-edge carries the corner at its target, and h leaves the face's corner.
                values[previous[h]] = coordinates[corner++];
                h = next[h];
            }
            while (h != first[f]);
        }
    }
}
