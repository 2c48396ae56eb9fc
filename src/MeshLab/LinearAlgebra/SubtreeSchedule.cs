namespace MeshLab.LinearAlgebra;

/// <summary>Which subtrees of the supernodes are worked on by one thread each, and which supernodes above them come after.</summary>
/// <remarks>
/// Fixed by the matrix, not by the number of threads. A supernode whose subtree costs more than 1/32 of all work is at the top; the others' highest
/// ancestors not at the top are the roots of subtrees. Subtrees touch disjoint columns, so they may be done in any order and at once.
/// </remarks>
internal sealed class SubtreeSchedule
{
    private const int Shares = 32;

    public SubtreeSchedule(Supernodes nodes)
    {
        int count = nodes.Count;
        var work = new double[count];
        var firstDescendant = new int[count];
        double total = 0;
        for (int s = 0; s < count; s++)
        {
            double columns = nodes.ColumnCount(s), height = columns + nodes.RowCount(s);
            // Products, moves of the update matrix, and the handling of a supernode.
            work[s] += columns * height * height + 3 * height * height + 200;
            firstDescendant[s] = nodes.FirstChild[s] < 0 ? s : firstDescendant[nodes.FirstChild[s]];
            if (nodes.Parent[s] >= 0)
                work[nodes.Parent[s]] += work[s];
            else
                total += work[s];
        }

        var isTop = new bool[count];
        var roots = new List<int>();
        for (int s = count - 1; s >= 0; s--)
        {
            if (nodes.Parent[s] >= 0 && !isTop[nodes.Parent[s]])
                continue;
            if (work[s] > total / Shares)
                isTop[s] = true;
            else
                roots.Add(s);
        }

        // Large subtrees first, so that threads end at about the same time.
        int[] byWork = [.. roots.OrderByDescending(s => work[s]).ThenBy(s => s)];
        SubtreeRoots = byWork;
        SubtreeFirst = Array.ConvertAll(byWork, s => firstDescendant[s]);
        Top = [.. Enumerable.Range(0, count).Where(s => isTop[s])];
        TopPlace = new int[nodes.First[count]];
        foreach (int s in Top)
        {
            for (int j = nodes.First[s]; j < nodes.First[s + 1]; j++)
                TopPlace[j] = TopColumnCount++;
        }
    }

    /// <summary>The root of each subtree, the most work first.</summary>
    public int[] SubtreeRoots { get; }

    /// <summary>The first supernode of each subtree; it is the range from here to the root.</summary>
    public int[] SubtreeFirst { get; }

    /// <summary>The supernodes above the subtrees, ascending.</summary>
    public int[] Top { get; }

    /// <summary>The number of columns of the supernodes above the subtrees.</summary>
    public int TopColumnCount { get; }

    /// <summary>Per column of a supernode above the subtrees its place among them; 0 for other columns.</summary>
    public int[] TopPlace { get; }
}
