using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.FiveSixSeven;

/// <summary>What <see cref="ValenceSimplification"/> did.</summary>
/// <param name="StopReason">Why it ended.</param>
/// <param name="Collapses">Edges contracted.</param>
/// <param name="Flips">Edges flipped.</param>
public readonly record struct ValenceSimplificationResult(FiveSixSevenStop StopReason, int Collapses, int Flips);

/// <summary>§9.6 简化: collapses that keep every valence between 5 and 7, and flips that make room for more of them.</summary>
/// <remarks>
/// An edge is collapsed if val + val &lt; 12, so that the merged vertex has at most 7, both apexes have more than 5, and the collapse is legal and turns
/// no face. Otherwise it is flipped if all four valences stay in 5 … 7 and the new triangles are nearly coplanar (cosine above 0.95). On a regular
/// patch only flips are possible at first; they leave pairs of 5 and 7 that can be collapsed. Edges are taken from the shortest up, in a fixed number of
/// rounds, and it ends early when a round collapses next to nothing.
/// </remarks>
public static class ValenceSimplification
{
    /// <summary>The edge trait that holds 1 for edges to be kept as lines.</summary>
    internal const string CreaseTrait = "crease";

    private const int MaxRounds = 20;
    private const double FlatCosine = 0.95;
    private const double TurnCosine = 0.5;

    extension(Mesh mesh)
    {
        /// <summary>Simplifies a 5-6-7 mesh towards a number of faces; valences stay in 5, 6, 7.</summary>
        /// <param name="targetFaces">The number of faces to stop at.</param>
        /// <param name="progress">Told from 0 to 1 how far it is.</param>
        /// <param name="cancellationToken">Ends the work between two operations; the mesh is valid.</param>
        /// <returns>The number of collapses and of flips, and whether the number of faces was reached.</returns>
        /// <exception cref="ArgumentException">A face is not a triangle.</exception>
        /// <exception cref="ArgumentOutOfRangeException">The number of faces is negative.</exception>
        public ValenceSimplificationResult SimplifyKeepingValences(
            int targetFaces, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            Steps.RequireTriangles(mesh);
            ArgumentOutOfRangeException.ThrowIfNegative(targetFaces);
            EdgeTrait<int> crease = mesh.TryGetEdgeTrait(CreaseTrait, out EdgeTrait<int>? found) ? found : AddCreaseTrait(mesh);
            int first = mesh.Faces.Count, collapses = 0, flips = 0;
            for (int round = 0; round < MaxRounds && mesh.Faces.Count > targetFaces; round++)
            {
                int before = mesh.Faces.Count;
                foreach (Edge e in ShortestFirst(mesh))
                {
                    if (mesh.Faces.Count <= targetFaces)
                        break;
                    cancellationToken.ThrowIfCancellationRequested();
                    if (e.IsDeleted)
                        continue;
                    if (TryCollapse(e, crease))
                        collapses++;
                    else if (TryFlip(e, crease))
                        flips++;
                }
                progress?.Report((double)(first - mesh.Faces.Count) / (first - targetFaces));
                if (before - mesh.Faces.Count < before / 200)
                    break;
            }
            progress?.Report(1);
            FiveSixSevenStop stop = first <= targetFaces ? FiveSixSevenStop.NothingToDo
                : mesh.Faces.Count <= targetFaces ? FiveSixSevenStop.Reached
                : FiveSixSevenStop.CountOutOfReach;
            return new(stop, collapses, flips);
        }
    }

    internal static EdgeTrait<int> AddCreaseTrait(Mesh mesh) => mesh.AddEdgeTrait(CreaseTrait, 0, Blend.Largest);

    private static IEnumerable<Edge> ShortestFirst(Mesh mesh)
    {
        var edges = new List<(double Length, int Index)>(mesh.Edges.Count);
        foreach (Edge e in mesh.Edges)
            edges.Add((e.Length, e.Index));
        edges.Sort();
        return edges.Select(e => mesh.Edges[e.Index]);
    }

    private static bool TryCollapse(Edge e, EdgeTrait<int> crease)
    {
        HalfEdge h = e.HalfEdge0;
        Vertex a = h.Source, b = h.Target;
        if (a.Valence + b.Valence >= 12 || !CanSpareAnEdge(h) || !CanSpareAnEdge(h.Twin))
            return false;
        int linesAtA = LinesAt(a, crease), linesAtB = LinesAt(b, crease);
        // The end on a line stays where it is; along a line the two ends of which go on, the middle will do.
        if (linesAtA > 0 && (linesAtB == 0 || crease[e] != 0))
            (h, linesAtA, linesAtB) = (h.Twin, linesAtB, linesAtA);
        if (linesAtA > 0 && (crease[e] == 0 || linesAtA != 2))
            return false;
        bool onBoundary = h.Source.IsBoundary || h.Target.IsBoundary;
        if (onBoundary && !e.IsBoundary && h.Source.IsBoundary)
            return false;
        Vector3D p = linesAtB > 0 || onBoundary ? h.Target.Position : (h.Source.Position + h.Target.Position) * 0.5;
        return h.CanCollapse(out _) && !h.CollapseFlips(p, TurnCosine) && h.TryCollapse(p, out _);
    }

    private static bool CanSpareAnEdge(HalfEdge h)
    {
        if (h.IsBoundary)
            return true;
        Vertex apex = h.Next.Target;
        return apex.IsBoundary || apex.Valence > 5;
    }

    private static int LinesAt(Vertex v, EdgeTrait<int> crease)
    {
        int lines = 0;
        foreach (Edge e in v.Edges)
            lines += crease[e];
        return lines;
    }

    private static bool TryFlip(Edge e, EdgeTrait<int> crease)
    {
        if (e.IsBoundary || crease[e] != 0)
            return false;
        HalfEdge h = e.HalfEdge0, t = h.Twin;
        return Fits(h.Source, -1) && Fits(h.Target, -1) && Fits(h.Next.Target, 1) && Fits(t.Next.Target, 1)
            && e.CanFlip(out _) && !e.FlipFolds(FlatCosine) && e.TryFlip(out _);
    }

    private static bool Fits(Vertex v, int change) => v.IsBoundary ? v.Valence + change >= 3 : v.Valence + change is >= 5 and <= 7;
}
