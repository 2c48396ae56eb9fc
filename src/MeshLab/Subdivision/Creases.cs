using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Subdivision;

/// <summary>Crease edges (折痕) for Loop's and Catmull and Clark's schemes: Hoppe et al. 1994, with sharpness after DeRose, Kass, Truong 1998.</summary>
/// <remarks>
/// The sharpness of an edge is a number in the edge trait <see cref="TraitName"/>: 0 is smooth, ∞ stays sharp for ever, s in between is sharp for s steps (each
/// step takes 1 off) and then smooth; a rest below 1 mixes the two rules. Boundary edges are sharp by themselves.
/// <code>
///   sharp edge            its middle
///   vertex of 2 of them   1/8 ── 3/4 ── 1/8 along them (折痕点)
///   of 3 or more          stays (角点)
///   of 1                  smooth (dart)
/// </code>
/// </remarks>
public static class Creases
{
    /// <summary>The name of the edge trait, of type <see cref="double"/>.</summary>
    public const string TraitName = "Sharpness";

    /// <summary>Gives edges a sharpness.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="edges">Edges of it.</param>
    /// <param name="sharpness">At least 0; infinite for ever.</param>
    /// <exception cref="ArgumentException">The sharpness is negative or NaN, or an edge is of another mesh.</exception>
    public static void Set(Mesh mesh, IEnumerable<Edge> edges, double sharpness = double.PositiveInfinity)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        ArgumentNullException.ThrowIfNull(edges);
        if (!(sharpness >= 0))
            throw new ArgumentOutOfRangeException(nameof(sharpness), sharpness, "A number of at least 0 is needed.");
        EdgeTrait<double> trait = mesh.GetOrAddEdgeTrait<double>(TraitName, 0);
        foreach (Edge edge in edges)
            trait[edge] = sharpness;
    }

    /// <summary>Makes sharp every interior edge whose faces meet at more than an angle. O(E).</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="angle">Between the normals of the faces, in radians, from 0 to π.</param>
    /// <param name="sharpness">At least 0; infinite for ever.</param>
    /// <returns>How many edges are sharp now.</returns>
    public static int SetByAngle(Mesh mesh, double angle, double sharpness = double.PositiveInfinity)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        if (!(angle is >= 0 and <= Math.PI))
            throw new ArgumentOutOfRangeException(nameof(angle), angle, "An angle between two faces is from 0 to π.");
        List<Edge> sharp = [.. mesh.Edges.Where(e => !e.IsBoundary && Vector3D.Angle(AreaVector(e.Face0), AreaVector(e.Face1)) > angle)];
        Set(mesh, sharp, sharpness);
        return sharp.Count;
    }

    /// <summary>The sharpness of an edge; 0 if the mesh has no creases.</summary>
    public static double Of(Edge edge)
    {
        edge.ThrowIfDead();
        return edge.Mesh.TryGetEdgeTrait(TraitName, out EdgeTrait<double>? trait) ? trait[edge] : 0;
    }

    /// <summary>The sharpness of the edges, all of them numbers; <see langword="null"/> if the mesh has no creases.</summary>
    /// <exception cref="ArgumentException">The sharpness of an edge is NaN.</exception>
    internal static EdgeTrait<double>? SharpnessOf(Mesh mesh)
    {
        if (!mesh.TryGetEdgeTrait(TraitName, out EdgeTrait<double>? sharpness))
            return null;
        foreach (Edge e in mesh.Edges)
        {
            if (double.IsNaN(sharpness[e]))
                throw new ArgumentException($"{e} has the sharpness NaN; a number is needed.", nameof(mesh));
        }
        return sharpness;
    }

    /// <summary>What is left of a sharpness after a step.</summary>
    internal static double AfterAStep(double sharpness) => Math.Max(0, sharpness - 1);

    /// <summary>Changes the smooth places of edges (V + e) and vertices to those of the crease rules.</summary>
    internal static void Sharpen(Mesh mesh, Vector3D[] placed)
    {
        if (SharpnessOf(mesh) is not { } sharpness)
            return;
        Dictionary<int, CreaseVertex> vertices = [];
        foreach (Edge e in mesh.Edges)
        {
            double s = sharpness[e];
            if (s <= 0 || e.IsBoundary)
                continue;
            Vector3D middle = 0.5 * (e.Vertex0.Position + e.Vertex1.Position);
            ref Vector3D place = ref placed[mesh.VertexSlots + e.Index];
            place = Vector3D.Lerp(place, middle, Math.Min(1, s));
            vertices.TryAdd(e.Vertex0.Index, CreaseVertex.Of(e.Vertex0, sharpness));
            vertices.TryAdd(e.Vertex1.Index, CreaseVertex.Of(e.Vertex1, sharpness));
        }
        foreach ((int v, CreaseVertex crease) in vertices)
        {
            Vector3D old = mesh.positions[v];
            if (crease.Count < 2)
                continue;
            Vector3D sharp = crease.Count > 2 ? old : 0.75 * old + 0.125 * crease.Ends;
            placed[v] = Vector3D.Lerp(placed[v], sharp, Math.Min(1, crease.Sharpness));
        }
    }

    private static Vector3D AreaVector(Face face)
    {
        Vector3D sum = default, origin = face.HalfEdge.Source.Position;
        foreach (HalfEdge h in face.HalfEdges)
            sum += Vector3D.Cross(h.Source.Position - origin, h.Target.Position - origin);
        return sum;
    }
}

/// <summary>The sharp edges at a vertex.</summary>
/// <param name="Count">How many, boundary edges included.</param>
/// <param name="Ends">The sum of their other ends.</param>
/// <param name="Sharpness">Their mean sharpness; on a boundary the largest of the interior ones.</param>
internal readonly record struct CreaseVertex(int Count, Vector3D Ends, double Sharpness)
{
    public static CreaseVertex Of(Vertex vertex, EdgeTrait<double>? sharpness)
    {
        int count = 0, interior = 0;
        double sum = 0, largest = 0;
        Vector3D ends = default;
        foreach (HalfEdge h in vertex.OutgoingHalfEdges)
        {
            bool boundary = h.Edge.IsBoundary;
            double s = boundary ? double.PositiveInfinity : sharpness is null ? 0 : sharpness[h.Edge];
            if (s <= 0)
                continue;
            count++;
            ends += h.Target.Position;
            if (boundary)
                continue;
            interior++;
            sum += s;
            largest = Math.Max(largest, s);
        }
        return new(count, ends, interior == 0 ? double.PositiveInfinity : interior == count ? sum / count : largest);
    }
}
