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
    /// <remarks>
    /// The smallest stray piece moves first. It joins a piece that then stays for the rest of the round, so every move leaves one piece less and the rounds end: if neighbours
    /// moved at once, two stray pieces alone on a component would exchange their labels for ever. A piece that is a whole component has no neighbour and keeps its label.
    /// </remarks>
    public static void JoinStrayPieces(Mesh mesh, int[] labels, double[] areas)
    {
        // A stray piece may have only other stray pieces as neighbours, so the rounds go on until nothing changes.
        while (JoinOnce(mesh, labels, areas))
        {
        }
    }

    private static bool JoinOnce(Mesh mesh, int[] labels, double[] areas)
    {
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
        Dictionary<int, double>[] borders = Borders(mesh, piece, count);
        bool[] stays = MainPieces(area, label), moved = new bool[count];
        int[] order = [.. Enumerable.Range(0, count).Where(p => !stays[p]).OrderBy(p => area[p]).ThenBy(p => p)];
        var target = (int[])label.Clone();
        foreach (int p in order)
        {
            if (stays[p] || borders[p].Count == 0)
                continue;
            int best = borders[p].GroupBy(b => label[b.Key], b => b.Value).Select(g => (Label: g.Key, Length: g.Sum())).OrderByDescending(b => b.Length).ThenBy(b => b.Label).First().Label;
            int[] hosts = [.. borders[p].Keys.Where(q => label[q] == best && !moved[q])];
            if (hosts.Length == 0)
                continue;
            foreach (int q in hosts)
                stays[q] = true;
            moved[p] = true;
            target[p] = best;
        }
        for (int f = 0; f < labels.Length; f++)
        {
            if (piece[f] >= 0)
                labels[f] = target[piece[f]];
        }
        return Array.IndexOf(moved, true) >= 0;
    }

    /// <summary>Per piece whether it is the largest of its label; of equal ones, the first.</summary>
    private static bool[] MainPieces(double[] area, int[] label)
    {
        var main = new Dictionary<int, int>();
        for (int p = 0; p < area.Length; p++)
        {
            if (!main.TryGetValue(label[p], out int best) || area[p] > area[best])
                main[label[p]] = p;
        }
        var isMain = new bool[area.Length];
        foreach (int p in main.Values)
            isMain[p] = true;
        return isMain;
    }

    /// <summary>Per piece the pieces next to it, with the length of the common border.</summary>
    private static Dictionary<int, double>[] Borders(Mesh mesh, int[] piece, int count)
    {
        var borders = new Dictionary<int, double>[count];
        for (int p = 0; p < count; p++)
            borders[p] = [];
        foreach (Edge e in mesh.Edges)
        {
            if (e.IsBoundary)
                continue;
            int p = piece[e.Face0.Index], q = piece[e.Face1.Index];
            if (p == q || p < 0 || q < 0)
                continue;
            double length = e.Length;
            borders[p][q] = borders[p].GetValueOrDefault(q) + length;
            borders[q][p] = borders[q].GetValueOrDefault(p) + length;
        }
        return borders;
    }
}
