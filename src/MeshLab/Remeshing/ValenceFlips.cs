using MeshLab.Numerics;

namespace MeshLab.Remeshing;

/// <summary>The third step: edges are flipped (切换边) towards valence 6, 4 on the boundary; where that is equal, towards larger angles.</summary>
/// <remarks>
/// Every flip lowers Σ (valence − ideal)², or keeps it and makes the edge locally Delaunay, so the step ends. After a flip the four edges
/// around it are looked at again.
/// </remarks>
internal sealed class ValenceFlips(RemeshSurface s, FeatureSharpness? sharpness)
{
    private static readonly double LargestDihedralCosine = Math.Cos(30 * Math.PI / 180);

    // Both new faces must look to within acos √0.2 = 63° of where the old ones looked together.
    private const double LeastTurnCosineSquared = 0.2;

    // Below this quality a triangle is removed whatever the valences, and none is made: angles above about 165° or below 8°.
    private const double Poor = 0.15;

    private const double LongSquared = LengthSteps.Long * LengthSteps.Long;

    private readonly List<int> _again = [];

    public int Flips { get; private set; }

    public void Run()
    {
        _again.Clear();
        for (int h = 0; h < s.HalfEdgeSlots; h += 2)
        {
            if (!s.IsFreeEdge(h))
                TryFlip(h);
        }
        // The energy bounds the number of flips; the limit guards against rounding in the Delaunay test.
        for (int i = 0; i < _again.Count && i < 4 * s.HalfEdgeSlots; i++)
            TryFlip(_again[i]);
    }

    private void TryFlip(int h)
    {
        int t = h ^ 1;
        if (s.OnLine[h >> 1])
            return;
        int a = s.Target[t], b = s.Target[h], c = s.Target[s.Next[h]], d = s.Target[s.Next[t]];
        if (!(IsPoor(a, b, c, d) ? RemovesPoor(a, b, c, d) : Improves(a, b, c, d) && ShapeAllows(a, b, c, d)) || !s.CanFlip(h))
            return;
        if (sharpness is not null && !sharpness.AllowsFlip(h))
            return;
        s.Flip(h);
        Flips++;
        _again.Add(s.Next[h] & ~1);
        _again.Add(s.Previous[h] & ~1);
        _again.Add(s.Next[t] & ~1);
        _again.Add(s.Previous[t] & ~1);
    }

    private bool Improves(int a, int b, int c, int d)
    {
        int gain = ValenceGain(a, b, c, d);
        return gain > 0 || (gain == 0 && IsNotDelaunay(a, b, c, d));
    }

    // Whether a triangle beside the edge is hardly more than a segment.
    private bool IsPoor(int a, int b, int c, int d) => Math.Min(Quality(a, b, c), Quality(b, a, d)) < Poor;

    // Poor triangles go whatever the valences: if both new ones are better and look where the old quadrilateral did.
    private bool RemovesPoor(int a, int b, int c, int d)
    {
        if (!(Math.Min(Quality(c, d, b), Quality(d, c, a)) > 1.5 * Math.Min(Quality(a, b, c), Quality(b, a, d))))
            return false;
        Vector3D look = Normal(a, b, c) + Normal(b, a, d), m1 = Normal(d, b, c), m2 = Normal(a, d, c);
        return Aligned(m1) && Aligned(m2);

        bool Aligned(Vector3D m)
        {
            double dot = Vector3D.Dot(m, look);
            return dot > 0 && dot * dot >= LargestDihedralCosine * LargestDihedralCosine * m.LengthSquared * look.LengthSquared;
        }
    }

    private Vector3D Normal(int a, int b, int c)
    {
        Vector3D p = s.Positions[a];
        return Vector3D.Cross(s.Positions[b] - p, s.Positions[c] - p);
    }

    // 4√3 area / Σ length²: 1 for equilateral triangles, 0 for those without area.
    private double Quality(int a, int b, int c)
    {
        Vector3D pa = s.Positions[a], ab = s.Positions[b] - pa, ac = s.Positions[c] - pa;
        double lengths = ab.LengthSquared + ac.LengthSquared + (ac - ab).LengthSquared;
        return lengths > 0 ? 2 * Math.Sqrt(3) * Vector3D.Cross(ab, ac).Length / lengths : 0;
    }

    private int ValenceGain(int a, int b, int c, int d)
    {
        int xa = Surplus(a), xb = Surplus(b), xc = Surplus(c), xd = Surplus(d);
        return 2 * (xa + xb - xc - xd) - 4;

        int Surplus(int v) => s.Valence[v] - (s.LineCount[v] != 0 && s.IsOnBoundary(v) ? 4 : 6);
    }

    // Whether the angles opposite the edge are larger than π together: the other diagonal is the Delaunay one (if the four points are flat).
    private bool IsNotDelaunay(int a, int b, int c, int d)
    {
        Vector3D pa = s.Positions[a], pb = s.Positions[b], ca = pa - s.Positions[c], cb = pb - s.Positions[c], da = pa - s.Positions[d], db = pb - s.Positions[d];
        double sinC = Vector3D.Cross(ca, cb).Length, sinD = Vector3D.Cross(da, db).Length;
        return Vector3D.Dot(ca, cb) * sinD + Vector3D.Dot(da, db) * sinC < -1e-9 * sinC * sinD;
    }

    private bool ShapeAllows(int a, int b, int c, int d)
    {
        Vector3D pa = s.Positions[a], pb = s.Positions[b], pc = s.Positions[c], pd = s.Positions[d];
        Vector3D n1 = Vector3D.Cross(pb - pa, pc - pa), n2 = Vector3D.Cross(pd - pa, pb - pa);
        double l1 = n1.LengthSquared, l2 = n2.LengthSquared;
        if (Vector3D.Dot(n1, n2) < LargestDihedralCosine * Math.Sqrt(l1 * l2))
            return false;
        // Where the old faces look together; a face without area looks nowhere.
        Vector3D look = (l1 > 0 ? n1 / Math.Sqrt(l1) : default) + (l2 > 0 ? n2 / Math.Sqrt(l2) : default);
        double least = LeastTurnCosineSquared * look.LengthSquared;
        Vector3D m1 = Vector3D.Cross(pd - pc, pb - pc), m2 = Vector3D.Cross(pa - pc, pd - pc);
        double k1 = Vector3D.Dot(m1, look), k2 = Vector3D.Dot(m2, look);
        if (!(k1 > 0 && k2 > 0 && k1 * k1 > least * m1.LengthSquared && k2 * k2 > least * m2.LengthSquared))
            return false;
        if (Math.Min(Quality(c, d, b), Quality(d, c, a)) < Poor)
            return false;
        double wanted = (s.Size[c] + s.Size[d]) * 0.5, cd = Vector3D.DistanceSquared(pc, pd);
        return cd <= LongSquared * wanted * wanted || cd <= Vector3D.DistanceSquared(pa, pb);
    }
}
