using MeshLab.Structure;

namespace MeshLab.Segmentation;

/// <summary>Small jobs on labels that several methods share.</summary>
internal static class Relabeling
{
    /// <summary>Numbers the labels that occur from 0, in the order of their lowest face. Returns how many there are.</summary>
    /// <param name="labels">Per face; −1 stays.</param>
    /// <param name="keepsZero">Whether the label 0, if it occurs, stays the first.</param>
    public static int Compact(int[] labels, bool keepsZero = false)
    {
        var number = new Dictionary<int, int>();
        if (keepsZero && Array.IndexOf(labels, 0) >= 0)
            number[0] = 0;
        for (int f = 0; f < labels.Length; f++)
        {
            if (labels[f] < 0)
                continue;
            if (!number.TryGetValue(labels[f], out int fresh))
                number[labels[f]] = fresh = number.Count;
            labels[f] = fresh;
        }
        return number.Count;
    }

    /// <summary>Per face the piece of equal labels, joined across edges, that it belongs to; pieces are numbered by their lowest face.</summary>
    public static int[] Pieces(Mesh mesh, int[] labels, out int count)
    {
        var piece = new int[labels.Length];
        Array.Fill(piece, -1);
        var stack = new Stack<int>();
        count = 0;
        for (int seed = 0; seed < labels.Length; seed++)
        {
            if (labels[seed] < 0 || piece[seed] >= 0)
                continue;
            piece[seed] = count;
            stack.Push(seed);
            while (stack.TryPop(out int f))
            {
                foreach (Face g in mesh.Faces[f].Neighbors)
                {
                    if (piece[g.Index] >= 0 || labels[g.Index] != labels[f])
                        continue;
                    piece[g.Index] = count;
                    stack.Push(g.Index);
                }
            }
            count++;
        }
        return piece;
    }

    /// <summary>Keeps the largest piece (by area) of every label and gives each other piece to the neighbour with which it has the longest border.</summary>
    public static void JoinStrayPieces(Mesh mesh, int[] labels, double[] areas)
    {
        // A stray piece may have only other stray pieces as neighbours, so the rounds go on until nothing changes.
        for (bool changed = true; changed;)
        {
            changed = false;
            int[] piece = Pieces(mesh, labels, out int count);
            var area = new double[count];
            var label = new int[count];
            for (int f = 0; f < labels.Length; f++)
            {
                if (piece[f] < 0)
                    continue;
                area[piece[f]] += areas[f];
                label[piece[f]] = labels[f];
            }
            var main = new Dictionary<int, int>();
            for (int p = 0; p < count; p++)
            {
                if (!main.TryGetValue(label[p], out int best) || area[p] > area[best])
                    main[label[p]] = p;
            }
            Dictionary<int, double>[] borders = Borders(mesh, labels, piece, count);
            var target = new int[count];
            for (int p = 0; p < count; p++)
            {
                target[p] = label[p];
                if (main[label[p]] == p || borders[p].Count == 0)
                    continue;
                target[p] = borders[p].OrderByDescending(b => b.Value).ThenBy(b => b.Key).First().Key;
                changed = true;
            }
            for (int f = 0; f < labels.Length; f++)
            {
                if (piece[f] >= 0)
                    labels[f] = target[piece[f]];
            }
        }
    }

    /// <summary>Per piece the length of its border with every other label.</summary>
    private static Dictionary<int, double>[] Borders(Mesh mesh, int[] labels, int[] piece, int count)
    {
        var borders = new Dictionary<int, double>[count];
        for (int p = 0; p < count; p++)
            borders[p] = [];
        foreach (Edge e in mesh.Edges)
        {
            if (e.IsBoundary)
                continue;
            int f = e.Face0.Index, g = e.Face1.Index;
            if (labels[f] == labels[g])
                continue;
            double length = e.Length;
            borders[piece[f]][labels[g]] = borders[piece[f]].GetValueOrDefault(labels[g]) + length;
            borders[piece[g]][labels[f]] = borders[piece[g]].GetValueOrDefault(labels[f]) + length;
        }
        return borders;
    }
}
