using MeshLab.Structure;

namespace MeshLab.Topology;

/// <summary>Options of <see cref="HomologyGenerators"/>.</summary>
public sealed record HomologyOptions
{
    /// <summary>Whether the loops are to be short: each is shortened greedily, and gives way to a shorter one of the trees chosen for short loops
    /// (Erickson, Whittlesey 2005) where the loops remain a basis. Ordered by length, no loop is longer than without.</summary>
    public bool Shorten { get; init; }
}

/// <summary>A closed simple path of half-edges: each begins where the one before ends.</summary>
/// <param name="HalfEdges">The half-edges in order.</param>
/// <param name="Length">The sum of their lengths, in model units.</param>
public sealed record MeshLoop(IReadOnlyList<HalfEdge> HalfEdges, double Length)
{
    /// <summary>The vertices in order.</summary>
    public IReadOnlyList<Vertex> Vertices => [.. HalfEdges.Select(h => h.Source)];
}

/// <summary>§11.5 同调群的生成元 (homology generators): the 2g independent loops around and through the handles, by tree and cotree (Eppstein 2003).</summary>
/// <remarks>
/// <code>
///      ╭───────────╮
///     ╱   ╭─────╮   ╲      T  a spanning tree of the vertices
///    │ ●══│     │     │     C  a spanning tree of the faces over edges not in T
///     ╲   ╰─────╯   ╱          the V − E + F = 2 − 2g edges' shortfall: 2g edges are in neither;
///      ╰───────────╯           each closes one loop with T
/// </code>
/// Boundary loops are taken as filled, so a surface with boundary has 2g generators too. Each loop is simple. The loops are independent, because cutting along
/// all of them does not separate the surface. O(V + E) breadth first; with shortening O(E log E), and for n loops O(n E + n³) at most.
/// </remarks>
public static class HomologyGenerators
{
    /// <summary>The 2g generators of each component, in order of the edge that closes them; when shortened, of the edge whose loop they stand for.</summary>
    public static IReadOnlyList<MeshLoop> Compute(Mesh mesh, HomologyOptions? options = null, CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        options ??= new();
        var trees = new TreeCotree(mesh, shortest: false);
        MeshLoop[] basis = Loops(trees, options, cancellationToken);
        if (options.Shorten && basis.Length > 0)
        {
            MeshLoop[] others = Loops(new TreeCotree(mesh, shortest: true), options, cancellationToken);
            LoopExchange.Shorten(basis, others, loop => trees.Coordinates(loop.HalfEdges), cancellationToken);
        }
        return basis;
    }

    private static MeshLoop[] Loops(TreeCotree trees, HomologyOptions options, CancellationToken cancellationToken)
    {
        var loops = new List<MeshLoop>();
        foreach (int e in trees.RemainingEdges)
        {
            cancellationToken.ThrowIfCancellationRequested();
            List<HalfEdge> loop = trees.LoopThrough(e);
            if (options.Shorten)
                LoopShortening.Shorten(loop);
            loops.Add(new(loop, loop.Sum(h => h.Edge.Length)));
        }
        return [.. loops];
    }
}
