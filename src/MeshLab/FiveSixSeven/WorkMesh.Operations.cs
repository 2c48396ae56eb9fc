using MeshLab.Numerics;

namespace MeshLab.FiveSixSeven;

/// <summary>Flip, split and collapse, with their topological conditions.</summary>
internal sealed partial class WorkMesh
{
    /// <summary>Whether the edge may be flipped: two faces, no crease, ends that can lose an edge, apexes not joined.</summary>
    public bool CanFlip(int h)
    {
        int t = h ^ 1;
        if (Crease[h >> 1] != 0 || Face[h] < 0 || Face[t] < 0)
            return false;
        int a = Target[t], b = Target[h], c = Apex(h), d = Apex(t);
        return c != d && Valence[a] > LeastValence(a) && Valence[b] > LeastValence(b) && Find(c, d) < 0;
    }

    private int LeastValence(int v) => OnRim[v] != 0 ? 2 : 3;

    /// <summary>§4.7: h from a to b becomes d to c.</summary>
    public void Flip(int h)
    {
        int t = h ^ 1, f = Face[h], g = Face[t];
        int bc = Next[h], ca = Previous[h], ad = Next[t], db = Previous[t];
        int a = Target[t], b = Target[h], c = Target[bc], d = Target[ad];
        LinkTriangle(f, h, ca, ad);
        LinkTriangle(g, t, db, bc);
        Put(Target, Column.Target, h, c);
        Put(Target, Column.Target, t, d);
        if (Outgoing[a] == h)
            Put(Outgoing, Column.Outgoing, a, ad);
        if (Outgoing[b] == t)
            Put(Outgoing, Column.Outgoing, b, bc);
        SetValence(a, Valence[a] - 1);
        SetValence(b, Valence[b] - 1);
        SetValence(c, Valence[c] + 1);
        SetValence(d, Valence[d] + 1);
        Note(new(StepKind.Flip, h >> 1, d, c, default));
    }

    private void LinkTriangle(int f, int a, int b, int c)
    {
        Link(a, b);
        Link(b, c);
        Link(c, a);
        Put(Face, Column.Face, a, f);
        Put(Face, Column.Face, b, f);
        Put(Face, Column.Face, c, f);
        Put(HalfEdgeOf, Column.HalfEdgeOf, f, a);
    }

    /// <summary>A vertex on the edge; h then ends at it. Returns the vertex.</summary>
    public int Split(int h, Vector3D position)
    {
        EnsureRoom();
        int t = h ^ 1, b = Target[h], f = Face[h], g = Face[t];
        int afterH = Next[h], beforeT = Previous[t];
        int m = VertexSlots++, n = NewEdge(m, b, Crease[h >> 1]), nBack = n ^ 1;
        Positions[m] = position;
        Quadrics[m] = default;
        OnRim[m] = f < 0 || g < 0 ? 1 : 0;
        Valence[m] = 2;
        Penalty += PenaltyOf(2, OnRim[m]);
        Kind[m] = Crease[h >> 1] != 0 ? VertexKind.OnCrease : VertexKind.Smooth;
        Outgoing[m] = n;

        Put(Target, Column.Target, h, m);
        if (Outgoing[b] == t)
            Put(Outgoing, Column.Outgoing, b, nBack);
        Link(n, afterH);
        Link(h, n);
        Link(beforeT, nBack);
        Link(nBack, t);
        Face[n] = f;
        Face[nBack] = g;
        if (f >= 0)
            CutOff(f, n, afterH);
        if (g >= 0)
            CutOff(g, beforeT, nBack);
        Note(new(StepKind.Split, h >> 1, m, -1, position));
        return m;
    }

    private int NewEdge(int from, int to, int crease)
    {
        int h = 2 * EdgeSlots;
        Crease[EdgeSlots++] = crease;
        Target[h] = to;
        Target[h + 1] = from;
        return h;
    }

    /// <summary>Makes the two sides of a quad a triangle of their own; the rest stays with the face.</summary>
    private void CutOff(int f, int first, int second)
    {
        int before = Previous[first], after = Next[second];
        int inner = NewEdge(Target[second], Target[before], 0), outer = inner ^ 1, cut = FaceSlots++;
        LiveFaces++;
        Link(before, outer);
        Link(outer, after);
        Face[outer] = f;
        Put(HalfEdgeOf, Column.HalfEdgeOf, f, outer);
        Face[inner] = cut;
        HalfEdgeOf[cut] = first;
        LinkTriangle(cut, first, second, inner);
        SetValence(Target[inner], Valence[Target[inner]] + 1);
        SetValence(Target[outer], Valence[Target[outer]] + 1);
    }

    /// <summary>Whether the half-edge's source may be merged into its target.</summary>
    public bool CanCollapse(int h)
    {
        int t = h ^ 1, a = Target[t], b = Target[h], f = Face[h], g = Face[t];
        if (f >= 0 && g >= 0 && OnRim[a] != 0 && OnRim[b] != 0)
            return false;
        if ((f >= 0 && !CanLoseFace(h)) || (g >= 0 && !CanLoseFace(t)))
            return false;
        if ((f < 0 && Next[Next[Next[h]]] == h) || (g < 0 && Next[Next[Next[t]]] == t))
            return false;
        int lost = f < 0 || g < 0 ? 3 : 4;
        if (Valence[a] + Valence[b] - lost < (OnRim[a] != 0 || OnRim[b] != 0 ? 2 : 3))
            return false;
        return CommonNeighbors(a, b) == (f >= 0 ? 1 : 0) + (g >= 0 ? 1 : 0);
    }

    private bool CanLoseFace(int h)
    {
        int apex = Apex(h);
        return Valence[apex] > LeastValence(apex) && (Face[Next[h] ^ 1] >= 0 || Face[Previous[h] ^ 1] >= 0);
    }

    private int CommonNeighbors(int a, int b)
    {
        int[] marks = FreshStamps(out int current);
        int start = Outgoing[a], h = start;
        do
        {
            marks[Target[h]] = current;
            h = Next[h ^ 1];
        }
        while (h != start);
        int common = 0;
        start = h = Outgoing[b];
        do
        {
            if (marks[Target[h]] == current)
                common++;
            h = Next[h ^ 1];
        }
        while (h != start);
        return common;
    }

    /// <summary>Merges the half-edge's source into its target, which goes to a position. Creases of merged edges stay creases.</summary>
    public void Collapse(int h, Vector3D position)
    {
        int t = h ^ 1, a = Target[t], b = Target[h], f = Face[h], g = Face[t];
        int hNext = Next[h], hPrevious = Previous[h], tNext = Next[t], tPrevious = Previous[t];
        int valence = Valence[a] + Valence[b] - 2 - (f >= 0 ? 1 : 0) - (g >= 0 ? 1 : 0);
        Quadric sum = Quadrics[a];
        sum.Add(in Quadrics[b]);
        SetQuadric(b, sum);

        int start = Outgoing[a], k = start;
        do
        {
            Put(Target, Column.Target, k ^ 1, b);
            k = Next[k ^ 1];
        }
        while (k != start);
        int outgoing = hNext;
        if (f >= 0)
            CloseTwoGon(hNext, hPrevious, f);
        else
            Link(hPrevious, hNext);
        (tNext, tPrevious) = (Next[t], Previous[t]);
        if (g >= 0)
        {
            CloseTwoGon(tPrevious, tNext, g);
            outgoing = tPrevious ^ 1;
        }
        else
        {
            Link(tPrevious, tNext);
        }
        DeleteEdge(h >> 1);
        Penalty -= PenaltyOf(Valence[a], OnRim[a]);
        if (OnRim[a] != 0 && OnRim[b] == 0)
            SetOnRim(b);
        Put(Outgoing, Column.Outgoing, a, -1);
        Put(Outgoing, Column.Outgoing, b, outgoing);
        SetValence(b, valence);
        SetPosition(b, position);
        Note(new(StepKind.Collapse, h >> 1, b, a, position));
    }

    /// <summary>The face of the sides <paramref name="kept"/> and <paramref name="gone"/> vanishes; kept takes the place of gone's twin.</summary>
    private void CloseTwoGon(int kept, int gone, int f)
    {
        int outer = gone ^ 1, apex = Apexes(kept, gone), outside = Face[outer];
        int before = Previous[outer], after = Next[outer];
        Link(before, kept);
        Link(kept, after);
        Put(Face, Column.Face, kept, outside);
        if (outside >= 0)
            Put(HalfEdgeOf, Column.HalfEdgeOf, outside, kept);
        if (Crease[gone >> 1] > Crease[kept >> 1])
            Put(Crease, Column.Crease, kept >> 1, Crease[gone >> 1]);
        Put(Outgoing, Column.Outgoing, apex, Target[kept] == apex ? kept ^ 1 : kept);
        Put(HalfEdgeOf, Column.HalfEdgeOf, f, -1);
        LiveFaces--;
        DeleteEdge(gone >> 1);
        SetValence(apex, Valence[apex] - 1);
    }

    /// <summary>The vertex of a vanishing triangle that is not the merged one: where its two sides meet.</summary>
    private int Apexes(int kept, int gone) => Next[kept] == gone ? Target[kept] : Target[gone];

    private void DeleteEdge(int e)
    {
        Put(Target, Column.Target, 2 * e, -1);
        Put(Target, Column.Target, 2 * e + 1, -1);
    }
}
