using MeshLab.Neighborhoods;
using MeshLab.Numerics;
using MeshLab.Spatial;
using MeshLab.Structure;

namespace MeshLab.HoleFilling;

/// <summary>How a patch continues the surface around a hole: flat, by slope or by curvature — whichever foretells a ring of that surface best.</summary>
/// <remarks>
/// What was in the hole nobody knows, but what is around it: the ring of faces that touch the hole is left out too, the larger hole is filled in each
/// way, and the ways are compared by how near they come to that ring (cross-validation). Where the surface is smooth, fairing foretells it several times better than triangles
/// straight across; where it has creases or corners, fairing overshoots. At the end of a tube
/// a membrane is drawn instead of a dome. The simpler way stays unless another is clearly better. The trial is made on a copy of the
/// faces near by: O(n³) for the triangulation, as for the filling itself.
/// </remarks>
internal static class FillingTrial
{
    /// <summary>No fairing: the triangles straight across.</summary>
    public const int Flat = -1;

    private const int Rings = 6;
    private const int MaxEdges = 400;
    private const double ClearlyBetter = 0.8;
    private const double Better = 0.9;
    private const double SameAsNothing = 1e-6;
    private const double LargestTilt = 0.15;
    private const double SameWay = 0.6;

    /// <summary>The continuity to fill the hole with; <see cref="Flat"/> too if no trial can be made.</summary>
    public static int Choose(HoleLoop loop, CancellationToken cancellationToken)
    {
        if (loop.Count > MaxEdges || IsPlanar(loop))
            return Flat;
        (Mesh around, List<int[]> ring) = CopyAround(loop);
        if (LargerHole(around, ring) is not { } start)
            return Flat;
        cancellationToken.ThrowIfCancellationRequested();
        var larger = new HoleLoop(around, start);
        if (larger.Count > MaxEdges || MinimumWeightTriangulation.Triangulate(larger, HoleWeight.TotalBend, null, cancellationToken) is not { } triangles)
            return Flat;

        double size = BoundingBox.Of(larger.Points).Diagonal;
        double flat = Error(around, start, triangles, Flat, ring);
        if (flat <= SameAsNothing * size)
            return Flat;
        double slope = Error(around, start, triangles, 1, ring), curvature = Error(around, start, triangles, 2, ring);
        if (Math.Min(slope, curvature) > ClearlyBetter * flat)
            return Flat;
        if (IsEndOfTube(loop))
            return 0;
        return curvature < Better * slope ? 2 : 1;
    }

    /// <summary>Whether the hole and the faces at it lie in one plane.</summary>
    private static bool IsPlanar(HoleLoop loop)
    {
        Vector3D normal = loop.RimNormals[0], origin = loop.Points[0];
        double limit = SameAsNothing * BoundingBox.Of(loop.Points).Diagonal;
        return Array.TrueForAll(loop.RimNormals, n => Vector3D.Distance(n, normal) <= SameAsNothing)
            && Array.TrueForAll(loop.Points, p => Math.Abs(Vector3D.Dot(p - origin, normal)) <= limit);
    }

    /// <summary>Whether the faces around all run the same way, across the hole's plane: a neck or a pipe was cut off there, and a dome would have nothing to go by.</summary>
    private static bool IsEndOfTube(HoleLoop loop)
    {
        Vector3D across = default, normals = default, onward = default;
        double length = 0;
        for (int i = 0; i < loop.Count; i++)
        {
            Vector3D a = loop.Points[i], b = loop.Points[(i + 1) % loop.Count], n = loop.RimNormals[i];
            across += Vector3D.Cross(a - loop.Points[0], b - loop.Points[0]);
            normals += n * Vector3D.Distance(a, b);
            onward += Vector3D.Cross(n, b - a);
            length += Vector3D.Distance(a, b);
        }
        return Vector3D.Dot(normals, across.Normalized()) < LargestTilt * length && onward.Length > SameWay * length;
    }

    /// <summary>The faces some rings around the hole, as a mesh of its own without the first ring; and that ring's corners, as positions in the list of the mesh's vertices.</summary>
    private static (Mesh Around, List<int[]> Ring) CopyAround(HoleLoop loop)
    {
        Mesh mesh = loop.Mesh;
        var number = new Dictionary<int, int>();
        var vertices = new List<int>();
        foreach (int v in loop.Vertices)
            Number(v);
        var seen = new HashSet<int>();
        var ring = new List<int[]>();
        var faces = new List<int[]>();
        int from = 0;
        for (int k = 0; k < Rings; k++)
        {
            int to = vertices.Count;
            for (; from < to; from++)
            {
                foreach (Face face in mesh.Vertices[vertices[from]].Faces)
                {
                    if (seen.Add(face.Index))
                        (k == 0 ? ring : faces).Add([.. face.Vertices.Select(v => Number(v.Index))]);
                }
            }
        }
        Mesh around = MeshBuilder.FromPolygons(PolygonSoup.From([.. vertices.Select(v => mesh.positions[v])], [.. faces]), NonManifoldPolicy.Split, out _);
        return (around, ring);

        int Number(int v)
        {
            if (!number.TryGetValue(v, out int n))
            {
                number[v] = n = vertices.Count;
                vertices.Add(v);
            }
            return n;
        }
    }

    /// <summary>A half-edge of the hole that the ring left; nothing if it left several, or none.</summary>
    private static int? LargerHole(Mesh around, List<int[]> ring)
    {
        var touched = new HashSet<int>(ring.SelectMany(corners => corners));
        int? found = null;
        foreach (int start in BoundaryLoops.LoopStarts(around))
        {
            bool all = true, any = false;
            int h = start;
            do
            {
                bool own = touched.Contains(around.target[h]);
                all &= own;
                any |= own;
                h = around.next[h];
            }
            while (h != start);
            if (any && (!all || found is not null))
                return null;
            if (all)
                found = start;
        }
        return found;
    }

    /// <summary>Fills the larger hole and measures how far the ring's faces are from the patch, root mean square by area.</summary>
    private static double Error(Mesh around, int start, List<int> triangles, int continuity, List<int[]> ring)
    {
        Mesh trial = around.Clone();
        var loop = new HoleLoop(trial, start);
        HolePatch patch = HolePatch.Insert(loop, triangles, [], continuity >= 0);
        if (continuity >= 0)
        {
            patch.Refine(int.MaxValue);
            if (!patch.Fair(continuity))
                return double.PositiveInfinity;
        }
        var corners = new List<int>();
        for (int f = patch.FirstFace; f < trial.FaceSlots; f++)
            corners.AddRange(trial.Faces[f].Vertices.Select(v => v.Index));
        FaceTree tree = FaceTree.Build(trial.Positions, [.. corners]);
        double squares = 0, areas = 0;
        foreach (int[] face in ring)
        {
            Vector3D a = trial.positions[face[0]];
            for (int k = 2; k < face.Length; k++)
            {
                Vector3D b = trial.positions[face[k - 1]], c = trial.positions[face[k]];
                double area = Vector3D.Cross(b - a, c - a).Length;
                squares += area * (Squared((a + b) / 2) + Squared((b + c) / 2) + Squared((c + a) / 2) + Squared((a + b + c) / 3)) / 4;
                areas += area;
            }
        }
        return areas > 0 ? Math.Sqrt(squares / areas) : 0;

        double Squared(Vector3D p) => tree.FindClosest(p).DistanceSquared;
    }
}
