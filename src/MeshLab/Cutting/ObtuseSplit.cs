using MeshLab.Editing;
using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Cutting;

/// <summary>A vertex that splitting obtuse triangles put on an edge.</summary>
/// <param name="Vertex">The new vertex.</param>
/// <param name="From">One end of the edge, as it was at that moment: an old vertex, or one made before.</param>
/// <param name="To">The other end.</param>
/// <param name="Parameter">Where between them, from 0 at <paramref name="From"/> to 1 at <paramref name="To"/>.</param>
/// <param name="SourceEdge">The old edge that was split there, or of which a piece was; −1 if it was an altitude, inside an old face.</param>
public readonly record struct ObtuseFoot(int Vertex, int From, int To, double Parameter, int SourceEdge);

/// <summary>What splitting obtuse triangles did.</summary>
/// <param name="Splits">The number of edges split.</param>
/// <param name="Passes">How often the mesh was looked through.</param>
/// <param name="Remaining">Triangles that still have a larger angle, the largest angle first: splitting stopped, or the edge could not be split.</param>
/// <param name="SourceFace">Per face slot the old face that it is, or is a piece of. Old vertices keep their indices; new ones follow.</param>
/// <param name="Feet">Per new vertex, in order of index, the edge on which it was made.</param>
public sealed record ObtuseSplitResult(int Splits, int Passes, IReadOnlyList<Face> Remaining, int[] SourceFace, IReadOnlyList<ObtuseFoot> Feet)
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
            int passes = 0;
            var feet = new List<ObtuseFoot>();
            List<int> sourceEdge = [.. Enumerable.Range(0, mesh.EdgeSlots)];
            List<int> source = [.. Enumerable.Range(0, mesh.FaceSlots).Select(f => mesh.IsDeletedFace(f) ? -1 : f)];
            List<Face> obtuse = Find(mesh, angle);
            while (obtuse.Count > 0 && passes < maxPasses)
            {
                passes++;
                int before = feet.Count;
                foreach (Face f in obtuse)
                {
                    // An earlier split may have dealt with it, or made it another triangle.
                    HalfEdge opposite = LargestAngle(f, out double largest);
                    Edge half = opposite.Edge;
                    int from = opposite.Source.index, to = opposite.Target.index;
                    double t = Foot(opposite);
                    if (largest > angle && half.TrySplit(Vector3D.Lerp(mesh.positions[from], mesh.positions[to], t), out Vertex foot, out _))
                    {
                        feet.Add(new(foot.index, from, to, t, sourceEdge[half.index]));
                        NameSources(mesh, foot, half, source);
                        // The first new edge is the other half; the others are altitudes.
                        sourceEdge.Add(sourceEdge[half.index]);
                        sourceEdge.AddRange(Enumerable.Repeat(-1, mesh.EdgeSlots - sourceEdge.Count));
                    }
                }
                obtuse = Find(mesh, angle);
                if (feet.Count == before)
                    break;
            }
            return new(feet.Count, passes, obtuse, [.. source], feet);
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

    /// <summary>Where on the edge the foot of the altitude lies: inside, because the angles at its ends are acute.</summary>
    private static double Foot(HalfEdge opposite)
    {
        Vector3D a = opposite.Source.Position, ab = opposite.Target.Position - a, ac = opposite.Next.Target.Position - a;
        double t = Vector3D.Dot(ac, ab) / ab.LengthSquared;
        // A triangle so thin that rounding puts the foot on an end is cut in the middle.
        return t is > 1e-12 and < 1 - 1e-12 ? t : 0.5;
    }
}
