namespace MeshLab.LinearAlgebra;

/// <summary>The elimination tree (消去树) of a symmetric matrix under an order of elimination, in postorder, with the lengths of the factor's columns.</summary>
/// <remarks>
/// <para>
/// Eliminating row j joins all later rows that j still touches. The first of them is j's parent: column j of the factor can change column i
/// only if i is an ancestor of j, so subtrees can be factored independently. Everything here is computed from the places of the entries alone,
/// in time almost proportional to their number, without building the factor.
/// </para>
/// <para>Liu 1990, "The role of elimination trees in sparse factorization", SIAM J. Matrix Anal. Appl. 11(1).</para>
/// </remarks>
internal sealed class EliminationTree
{
    private EliminationTree(int[] order, int[] rank, int[] parent, int[] rowStart, int[] columns, int[] columnCounts)
    {
        Order = order;
        Rank = rank;
        Parent = parent;
        RowStart = rowStart;
        Columns = columns;
        ColumnCounts = columnCounts;
    }

    /// <summary>The row of the matrix that is eliminated k-th.</summary>
    public int[] Order { get; }

    /// <summary>The inverse of <see cref="Order"/>.</summary>
    public int[] Rank { get; }

    /// <summary>Per rank the parent's rank, −1 for a root. Parents come after their children and subtrees are contiguous.</summary>
    public int[] Parent { get; }

    /// <summary>The rows of the matrix in order of elimination …</summary>
    public int[] RowStart { get; }

    /// <summary>… with the ranks of their columns, in the order in which the matrix holds them.</summary>
    public int[] Columns { get; }

    /// <summary>The number of entries of each column of the factor, the diagonal included.</summary>
    public int[] ColumnCounts { get; }

    public static EliminationTree Of(SparseMatrix matrix, int[] fillReducingOrder)
    {
        int[] rank = Inverse(fillReducingOrder);
        int[] parent = Parents(matrix, fillReducingOrder, rank);
        int[] postorder = Postorder(parent);

        // Renumber by the postorder: the fill stays the same, and each subtree becomes a range of ranks.
        int n = matrix.Size;
        var order = new int[n];
        int[] newRank = Inverse(postorder);
        var newParent = new int[n];
        for (int k = 0; k < n; k++)
        {
            int old = postorder[k];
            order[k] = fillReducingOrder[old];
            newParent[k] = parent[old] < 0 ? -1 : newRank[parent[old]];
        }
        rank = Inverse(order);
        (int[] rowStart, int[] columns) = Permute(matrix, order, rank);
        return new EliminationTree(order, rank, newParent, rowStart, columns, CountColumns(newParent, rowStart, columns));
    }

    private static int[] Inverse(int[] permutation)
    {
        var inverse = new int[permutation.Length];
        for (int k = 0; k < inverse.Length; k++)
            inverse[permutation[k]] = k;
        return inverse;
    }

    // Liu's algorithm: from every earlier neighbour of row i climb to the root found so far and hang it below i. The climbed path is
    // remembered in `ancestor` as a short cut for the next climb.
    private static int[] Parents(SparseMatrix matrix, int[] order, int[] rank)
    {
        ReadOnlySpan<int> rowStart = matrix.RowStart, columns = matrix.Columns;
        int n = order.Length;
        var parent = new int[n];
        var ancestor = new int[n];
        Array.Fill(parent, -1);
        Array.Fill(ancestor, -1);
        for (int i = 0; i < n; i++)
        {
            int row = order[i];
            foreach (int column in columns[rowStart[row]..rowStart[row + 1]])
            {
                for (int j = rank[column]; j >= 0 && j < i;)
                {
                    int next = ancestor[j];
                    ancestor[j] = i;
                    if (next < 0)
                        parent[j] = i;
                    j = next;
                }
            }
        }
        return parent;
    }

    // Children before parents, siblings in ascending order; without recursion, since a tree can be a path of a million nodes.
    private static int[] Postorder(int[] parent)
    {
        int n = parent.Length;
        var firstChild = new int[n];
        var nextSibling = new int[n];
        Array.Fill(firstChild, -1);
        for (int j = n - 1; j >= 0; j--)
        {
            if (parent[j] < 0)
                continue;
            nextSibling[j] = firstChild[parent[j]];
            firstChild[parent[j]] = j;
        }

        var postorder = new int[n];
        var stack = new int[n];
        int count = 0;
        for (int root = 0; root < n; root++)
        {
            if (parent[root] >= 0)
                continue;
            int depth = 0;
            stack[depth++] = root;
            while (depth > 0)
            {
                int v = stack[depth - 1], child = firstChild[v];
                if (child < 0)
                {
                    postorder[count++] = v;
                    depth--;
                    continue;
                }
                firstChild[v] = nextSibling[child];
                stack[depth++] = child;
            }
        }
        return postorder;
    }

    private static (int[] RowStart, int[] Columns) Permute(SparseMatrix matrix, int[] order, int[] rank)
    {
        ReadOnlySpan<int> rowStart = matrix.RowStart, columns = matrix.Columns;
        var newStart = new int[order.Length + 1];
        var newColumns = GC.AllocateUninitializedArray<int>(columns.Length);
        int at = 0;
        for (int i = 0; i < order.Length; i++)
        {
            foreach (int column in columns[rowStart[order[i]]..rowStart[order[i] + 1]])
                newColumns[at++] = rank[column];
            newStart[i + 1] = at;
        }
        return (newStart, newColumns);
    }

    // Gilbert, Ng, Peyton 1994: row i of the factor is the part of the tree spanned by i and its earlier neighbours ("row subtree"). Column j's
    // length is the number of row subtrees that contain j. Instead of walking them, +1 is put on each leaf of each row subtree, −1 on the
    // lowest common ancestor of each leaf and the leaf before it, and −1 on the parent of the root: sums over subtrees then give the lengths.
    private static int[] CountColumns(int[] parent, int[] rowStart, int[] columns)
    {
        int n = parent.Length;
        var firstDescendant = new int[n];
        var lastSeen = new int[n];
        var previousLeaf = new int[n];
        var ancestor = new int[n];
        var count = new int[n];
        Array.Fill(firstDescendant, -1);
        Array.Fill(lastSeen, -1);
        Array.Fill(previousLeaf, -1);
        for (int k = 0; k < n; k++)
        {
            ancestor[k] = k;
            count[k] = firstDescendant[k] < 0 ? 1 : 0;
            for (int j = k; j >= 0 && firstDescendant[j] < 0; j = parent[j])
                firstDescendant[j] = k;
        }

        for (int j = 0; j < n; j++)
        {
            if (parent[j] >= 0)
                count[parent[j]]--;
            int first = firstDescendant[j];
            for (int k = rowStart[j]; k < rowStart[j + 1]; k++)
            {
                int i = columns[k];
                if (i <= j || first <= lastSeen[i])
                    continue;
                // j is a new leaf of row i's subtree.
                lastSeen[i] = first;
                count[j]++;
                int previous = previousLeaf[i];
                previousLeaf[i] = j;
                if (previous >= 0)
                    count[CommonAncestor(previous, ancestor)]--;
            }
            if (parent[j] >= 0)
                ancestor[j] = parent[j];
        }

        for (int j = 0; j < n; j++)
        {
            if (parent[j] >= 0)
                count[parent[j]] += count[j];
        }
        return count;
    }

    // Disjoint sets with path compression: the root of the set of `leaf` is its lowest ancestor not finished yet.
    private static int CommonAncestor(int leaf, int[] ancestor)
    {
        int root = leaf;
        while (root != ancestor[root])
            root = ancestor[root];
        while (leaf != root)
            (leaf, ancestor[leaf]) = (ancestor[leaf], root);
        return root;
    }
}
