namespace MeshLab.LinearAlgebra;

/// <summary>Neighbouring columns of the factor with (almost) the same rows, grouped into dense panels (超节点).</summary>
/// <remarks>
/// <para>
/// A supernode of c columns and r further rows is stored as one dense trapezoid of c columns and c + r rows, so that the factorization does
/// dense matrix products instead of following indices. Columns with exactly the same rows below come out of the column counts; small
/// neighbours are merged as well where that stores few zeros ("relaxed" supernodes: Ashcraft, Grimes 1989, ACM TOMS 15(4)).
/// </para>
/// <para>Parents come after children, as in the elimination tree.</para>
/// </remarks>
internal sealed class Supernodes
{
    /// <summary>The most columns in a supernode: longer ones would not fit the cache while they are factored.</summary>
    private const int MaxColumns = 512;

    private Supernodes(int[] first, int[] parent, long[] rowsStart, int[] rows, long[] panelStart)
    {
        First = first;
        Parent = parent;
        RowsStart = rowsStart;
        Rows = rows;
        PanelStart = panelStart;
        (FirstChild, NextSibling) = LinkChildren(parent);
    }

    /// <summary>The number of supernodes.</summary>
    public int Count => Parent.Length;

    /// <summary>The first column of each supernode, and the number of columns at the end.</summary>
    public int[] First { get; }

    /// <summary>The supernode of the first row below the diagonal block, −1 for a root.</summary>
    public int[] Parent { get; }

    /// <summary>The first child of each supernode, −1 if none; children in ascending order.</summary>
    public int[] FirstChild { get; }

    /// <summary>The next child of the same parent, −1 at the end.</summary>
    public int[] NextSibling { get; }

    /// <summary>Where the rows below the diagonal block begin in <see cref="Rows"/>.</summary>
    public long[] RowsStart { get; }

    /// <summary>The rows below the diagonal blocks, ascending within each supernode.</summary>
    public int[] Rows { get; }

    /// <summary>Where each supernode's panel begins in the factor's storage.</summary>
    public long[] PanelStart { get; }

    public int ColumnCount(int s) => First[s + 1] - First[s];

    public int RowCount(int s) => (int)(RowsStart[s + 1] - RowsStart[s]);

    /// <summary>The distance in memory between columns of a panel: a multiple of 8, so that every column begins at a cache line.</summary>
    public int PanelStride(int s) => (ColumnCount(s) + RowCount(s) + 7) & ~7;

    public static Supernodes Of(EliminationTree tree)
    {
        (int[] first, int[] heights) = Group(tree.Parent, tree.ColumnCounts);
        int count = first.Length - 1;
        var ofColumn = new int[tree.Order.Length];
        for (int s = 0; s < count; s++)
            ofColumn.AsSpan(first[s], first[s + 1] - first[s]).Fill(s);

        var parent = new int[count];
        var rowsStart = new long[count + 1];
        var panelStart = new long[count + 1];
        for (int s = 0; s < count; s++)
        {
            int columns = first[s + 1] - first[s];
            int above = tree.Parent[first[s + 1] - 1];
            parent[s] = above < 0 ? -1 : ofColumn[above];
            rowsStart[s + 1] = rowsStart[s] + heights[s] - columns;
            panelStart[s + 1] = panelStart[s] + (long)((heights[s] + 7) & ~7) * columns;
        }
        if (rowsStart[count] > Array.MaxLength || panelStart[count] > Array.MaxLength - 128)
            throw new NotSupportedException($"The factor would have {panelStart[count]} numbers, more than an array can hold.");
        int[] rows = ListRows(tree, ofColumn, parent, rowsStart);
        return new Supernodes(first, parent, rowsStart, rows, panelStart);
    }

    // Returns the first columns (one more than supernodes) and the heights of the panels.
    private static (int[] First, int[] Heights) Group(int[] parent, int[] columnCounts)
    {
        int n = parent.Length;
        var first = new int[n + 1];
        var heights = new int[n + 1];
        var zeros = new double[n];
        int count = 0;
        for (int from = 0; from < n;)
        {
            int last = from;
            while (last + 1 < n && last - from < MaxColumns - 1 && parent[last] == last + 1 && columnCounts[last + 1] == columnCounts[last] - 1)
                last++;

            // Take in the children just before, the last one first, as long as that pays.
            int begin = from, height = columnCounts[from];
            double stored = 0;
            while (count > 0 && parent[begin - 1] >= begin && parent[begin - 1] <= last)
            {
                int columns = begin - first[count - 1];
                int mergedHeight = height + columns, mergedColumns = last - first[count - 1] + 1;
                double mergedZeros = zeros[count - 1] + stored + (double)columns * (mergedHeight - heights[count - 1]);
                if (!Pays(mergedColumns, mergedHeight, mergedZeros))
                    break;
                count--;
                begin = first[count];
                height = mergedHeight;
                stored = mergedZeros;
            }
            first[count] = begin;
            heights[count] = height;
            zeros[count++] = stored;
            from = last + 1;
        }
        first[count] = n;
        return (first[..(count + 1)], heights[..count]);
    }

    // Small panels may be mostly zeros, since their cost is the handling; large ones hardly any.
    private static bool Pays(int columns, int height, double zeros)
    {
        if (columns > MaxColumns)
            return false;
        double entries = columns * (2.0 * height - columns + 1) / 2;
        return zeros == 0 || columns <= 4
            || (columns <= 16 && zeros < 0.8 * entries)
            || (columns <= 48 && zeros < 0.2 * entries)
            || zeros < 0.1 * entries;
    }

    // Row i belongs to the supernodes on the way from its earlier neighbours up to its own. Going through the rows in ascending order fills
    // every list in ascending order.
    private static int[] ListRows(EliminationTree tree, int[] ofColumn, int[] parent, long[] rowsStart)
    {
        int count = parent.Length;
        var rows = GC.AllocateUninitializedArray<int>((int)rowsStart[count]);
        var next = new int[count];
        var lastRow = new int[count];
        for (int s = 0; s < count; s++)
            next[s] = (int)rowsStart[s];
        Array.Fill(lastRow, -1);
        int[] rowStart = tree.RowStart, columns = tree.Columns;
        for (int i = 0; i < ofColumn.Length; i++)
        {
            lastRow[ofColumn[i]] = i;
            for (int k = rowStart[i]; k < rowStart[i + 1]; k++)
            {
                if (columns[k] >= i)
                    continue;
                for (int s = ofColumn[columns[k]]; lastRow[s] != i; s = parent[s])
                {
                    lastRow[s] = i;
                    rows[next[s]++] = i;
                }
            }
        }
        return rows;
    }

    private static (int[] FirstChild, int[] NextSibling) LinkChildren(int[] parent)
    {
        var firstChild = new int[parent.Length];
        var nextSibling = new int[parent.Length];
        Array.Fill(firstChild, -1);
        Array.Fill(nextSibling, -1);
        for (int s = parent.Length - 1; s >= 0; s--)
        {
            if (parent[s] < 0)
                continue;
            nextSibling[s] = firstChild[parent[s]];
            firstChild[parent[s]] = s;
        }
        return (firstChild, nextSibling);
    }
}
