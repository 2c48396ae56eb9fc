using MeshLab.Numerics;
using MeshLab.Spatial;
using MeshLab.Structure;

namespace MeshLab.Remeshing;

/// <summary>Moves vertices back to the input's surface: by walking from the face where they were, and by the tree where walking ends too far away.</summary>
/// <remarks>
/// Walking goes to the neighbour across whatever edge or vertex is closest, as long as the distance falls: one or two steps nearly always. It
/// ends in a local minimum for about one vertex in four hundred, seen only as self-intersections: then the tree decides, with the walk's
/// distance as its bound.
/// </remarks>
internal sealed class SurfaceProjection
{
    private const int MaxSteps = 1000;

    private readonly Mesh _mesh;
    private readonly FaceTree _tree;
    private readonly double _trustedSquared;

    /// <summary>Builds the tree.</summary>
    /// <param name="mesh">The input, triangles without gaps.</param>
    /// <param name="trusted">Up to this distance a walk is believed.</param>
    public SurfaceProjection(Mesh mesh, double trusted)
    {
        _mesh = mesh;
        _tree = FaceTree.Build(mesh);
        _trustedSquared = trusted * trusted;
    }

    /// <summary>The point of the surface closest to a point.</summary>
    /// <param name="point">The point.</param>
    /// <param name="face">The face where to start; then the face that was found.</param>
    public Vector3D Project(Vector3D point, ref int face)
    {
        double squared = Walk(point, ref face, out Vector3D place);
        if (squared <= _trustedSquared)
            return place;
        ClosestPoint found = _tree.FindClosest(point, squared * (1 - 1e-9));
        if (found.IsNone)
            return place;
        face = found.Face;
        return found.Point;
    }

    private double Walk(Vector3D point, ref int face, out Vector3D place)
    {
        Nearest best = Nearest.Of(point, _mesh, face);
        for (int step = 0; step < MaxSteps && best.Feature != Feature.Inside; step++)
        {
            Nearest better = best.Feature == Feature.Edge ? Across(point, best) : Around(point, best);
            if (better.Face == best.Face)
                break;
            best = better;
        }
        face = best.Face;
        place = best.Point;
        return best.Squared;
    }

    private Nearest Across(Vector3D point, Nearest from)
    {
        int other = _mesh.face[from.HalfEdge ^ 1];
        if (other < 0)
            return from;
        Nearest there = Nearest.Of(point, _mesh, other);
        return there.Squared < from.Squared * (1 - 1e-12) ? there : from;
    }

    private Nearest Around(Vector3D point, Nearest from)
    {
        Nearest best = from;
        int start = _mesh.outgoing[_mesh.target[from.HalfEdge ^ 1]], h = start;
        do
        {
            int f = _mesh.face[h];
            if (f >= 0 && f != from.Face)
            {
                Nearest there = Nearest.Of(point, _mesh, f);
                if (there.Squared < best.Squared * (1 - 1e-12))
                    best = there;
            }
            h = _mesh.next[h ^ 1];
        }
        while (h != start);
        return best;
    }

    private enum Feature
    {
        Inside,
        Edge,
        Vertex,
    }

    // The closest point of one face, and what of the face it lies on: inside, an edge, or the vertex where HalfEdge starts.
    private readonly record struct Nearest(int Face, Feature Feature, int HalfEdge, Vector3D Point, double Squared)
    {
        // By the regions of the plane around the triangle: Ericson 2005, §5.1.5.
        public static Nearest Of(Vector3D p, Mesh mesh, int face)
        {
            int ab = mesh.halfEdgeOf[face], bc = mesh.next[ab], ca = mesh.next[bc];
            Vector3D a = mesh.positions[mesh.target[ca]], b = mesh.positions[mesh.target[ab]], c = mesh.positions[mesh.target[bc]];
            Vector3D u = b - a, v = c - a, pa = p - a, pb = p - b, pc = p - c;
            double d1 = Vector3D.Dot(u, pa), d2 = Vector3D.Dot(v, pa);
            if (d1 <= 0 && d2 <= 0)
                return Found(Feature.Vertex, ab, a);
            double d3 = Vector3D.Dot(u, pb), d4 = Vector3D.Dot(v, pb);
            if (d3 >= 0 && d4 <= d3)
                return Found(Feature.Vertex, bc, b);
            double wc = d1 * d4 - d3 * d2;
            if (wc <= 0 && d1 >= 0 && d3 <= 0)
                return Found(Feature.Edge, ab, a + u * Share(d1, d1 - d3));
            double d5 = Vector3D.Dot(u, pc), d6 = Vector3D.Dot(v, pc);
            if (d6 >= 0 && d5 <= d6)
                return Found(Feature.Vertex, ca, c);
            double wb = d5 * d2 - d1 * d6;
            if (wb <= 0 && d2 >= 0 && d6 <= 0)
                return Found(Feature.Edge, ca, a + v * Share(d2, d2 - d6));
            double wa = d3 * d6 - d5 * d4;
            if (wa <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
                return Found(Feature.Edge, bc, b + (c - b) * Share(d4 - d3, d4 - d3 + d5 - d6));
            double all = 1 / (wa + wb + wc);
            return Found(Feature.Inside, ab, a + u * (wb * all) + v * (wc * all));

            Nearest Found(Feature feature, int h, Vector3D point) => new(face, feature, h, point, Vector3D.DistanceSquared(p, point));
        }

        private static double Share(double part, double whole) => whole > 0 ? part / whole : 0;
    }
}
