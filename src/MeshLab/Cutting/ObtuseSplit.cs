using MeshLab.Editing;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Cutting;

/// <summary>What splitting obtuse triangles did.</summary>
/// <param name="Splits">The number of edges split.</param>
/// <param name="Passes">How often the mesh was looked through.</param>
/// <param name="Remaining">Triangles that still have a larger angle, the largest angle first: splitting stopped, or the edge could not be split.</param>
/// <param name="SourceFace">Per face slot the old face that it is, or is a piece of. Old vertices keep their indices; new ones follow.</param>
public sealed record ObtuseSplitResult(int Splits, int Passes, IReadOnlyList<Face> Remaining, int[] SourceFace)
{
    /// <summary>Per old face slot its pieces, the one in the old place first; empty for deleted faces.</summary>
    public IReadOnlyList<IReadOnlyList<int>> Pieces { get; } = PiecesOf(SourceFace);

    private static List<int>[] PiecesOf(int[] sourceFace)
    {
        var pieces = new List<int>[sourceFace.Length == 0 ? 0 : sourceFace.Max() + 1];
        for (int f = 0; f < pieces.Length; f++)
            pieces[f] = [];
        for (int f = 0; f < sourceFace.Length; f++)
        {
            if (sourceFace[f] >= 0)
                pieces[sourceFace[f]].Add(f);
        }
        return pieces;
    }
}

/// <summary>§6.6 分割钝角 (splitting obtuse triangles).</summary>
/// <remarks>
/// <code>
///         c                    c
///      ╱     ╲              ╱  |  ╲       the edge opposite to the large angle is split at the foot of the altitude:
///    a ─────── b    ⟶    a ───m─── b      two right-angled triangles; the neighbour across becomes two as well
///      ╲     ╱              ╲  |  ╱
///         d                    d
/// </code>
/// The neighbour's new triangles may be obtuse again, so passes are repeated up to a limit; each pass takes the triangles with the largest angles first.
/// </remarks>
public static class ObtuseSplit
{
    extension(Mesh mesh)
    {
        /// <summary>Splits all triangles with an angle larger than a bound.</summary>
        /// <param name="angle">The bound in radians, between π/2 and π; 150° if not given, as in the textbook.</param>
        /// <param name="maxPasses">How often at most the mesh is looked through.</param>
        /// <exception cref="ArgumentOutOfRangeException">The angle is not between π/2 and π, or the number of passes is negative.</exception>
        /// <exception cref="ArgumentException">A face is not a triangle; it is named.</exception>
        public ObtuseSplitResult SplitObtuse(double angle = Math.PI * 150 / 180, int maxPasses = 10)
        {
            mesh.RequireTriangles();
            if (!(angle > Math.PI / 2 && angle < Math.PI))
                throw new ArgumentOutOfRangeException(nameof(angle), angle, "The angle must be larger than π/2 and smaller than π.");
            ArgumentOutOfRangeException.ThrowIfNegative(maxPasses);
            int splits = 0, passes = 0;
            List<int> source = [.. Enumerable.Range(0, mesh.FaceSlots).Select(f => mesh.IsDeletedFace(f) ? -1 : f)];
            List<Face> obtuse = Find(mesh, angle);
            while (obtuse.Count > 0 && passes < maxPasses)
            {
                passes++;
                int before = splits;
                foreach (Face f in obtuse)
                {
                    // An earlier split may have dealt with it, or made it another triangle.
                    HalfEdge opposite = LargestAngle(f, out double largest);
                    Edge half = opposite.Edge;
                    if (largest > angle && opposite.Edge.TrySplit(Foot(opposite), out Vertex foot, out _))
                    {
                        splits++;
                        NameSources(mesh, foot, half, source);
                    }
                }
                obtuse = Find(mesh, angle);
                if (splits == before)
                    break;
            }
            return new(splits, passes, obtuse, [.. source]);
        }
    }

    /// <summary>The new faces at a foot: each is a piece of the face that it meets along the altitude, which kept its place.</summary>
    private static void NameSources(Mesh mesh, Vertex foot, Edge half, List<int> source)
    {
        source.AddRange(Enumerable.Repeat(-1, mesh.FaceSlots - source.Count));
        foreach (HalfEdge altitude in foot.OutgoingHalfEdges)
        {
            if (altitude.IsBoundary || altitude.Twin.IsBoundary || altitude.Edge == half)
                continue;
            int left = altitude.Face.Index, right = altitude.Twin.Face.Index;
            if (source[left] < 0 != source[right] < 0)
                source[Math.Max(left, right)] = source[Math.Min(left, right)];
        }
    }

    private static List<Face> Find(Mesh mesh, double angle)
    {
        var found = new List<(double Angle, Face Face)>();
        foreach (Face f in mesh.Faces)
        {
            LargestAngle(f, out double largest);
            if (largest > angle)
                found.Add((largest, f));
        }
        found.Sort((x, y) => x.Angle != y.Angle ? y.Angle.CompareTo(x.Angle) : x.Face.index.CompareTo(y.Face.index));
        return [.. found.Select(x => x.Face)];
    }

    /// <summary>The half-edge opposite to the largest angle, that is the longest.</summary>
    private static HalfEdge LargestAngle(Face face, out double angle)
    {
        HalfEdge longest = face.HalfEdge;
        foreach (HalfEdge h in face.HalfEdges)
        {
            if (LengthSquared(h) > LengthSquared(longest))
                longest = h;
        }
        Vector3D apex = longest.Next.Target.Position;
        angle = Vector3D.Angle(longest.Source.Position - apex, longest.Target.Position - apex);
        return longest;
    }

    private static double LengthSquared(HalfEdge h) => Vector3D.DistanceSquared(h.Source.Position, h.Target.Position);

    /// <summary>The foot of the altitude: inside the edge, because the angles at its ends are acute.</summary>
    private static Vector3D Foot(HalfEdge opposite)
    {
        Vector3D a = opposite.Source.Position, ab = opposite.Target.Position - a, ac = opposite.Next.Target.Position - a;
        double t = Vector3D.Dot(ac, ab) / ab.LengthSquared;
        // A triangle so thin that rounding puts the foot on an end is cut in the middle.
        return a + ab * (t is > 1e-12 and < 1 - 1e-12 ? t : 0.5);
    }
}
