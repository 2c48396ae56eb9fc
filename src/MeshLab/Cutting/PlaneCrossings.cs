using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Cutting;

/// <summary>Which edges a plane crosses, and how the faces join them into chains. Every vertex is inside or not, so that a triangle has two crossed edges or none.</summary>
internal sealed class PlaneCrossings
{
    private PlaneCrossings(Mesh mesh, double[] distance, bool[] inside)
    {
        Mesh = mesh;
        Distance = distance;
        Inside = inside;
    }

    public Mesh Mesh { get; }

    /// <summary>Per vertex slot its signed distance; 0 within the tolerance.</summary>
    public double[] Distance { get; }

    /// <summary>Per vertex slot.</summary>
    public bool[] Inside { get; }

    /// <summary>Per chain the half-edges that leave the inside, in order: face after face, along the cut with the inside to the left of the pieces.</summary>
    public List<Chain> Chains { get; } = [];

    /// <summary>Faces crossed.</summary>
    public int FaceCount { get; private set; }

    public readonly record struct Chain(int[] Leaving, bool IsClosed);

    /// <summary>Signed distances, snapped to 0 within the tolerance. O(V), in parallel.</summary>
    public static double[] Distances(Mesh mesh, CuttingPlane plane, double tolerance)
    {
        Vector3D[] positions = mesh.positions;
        Vector3D normal = plane.Normal;
        double offset = plane.Offset;
        var distance = new double[mesh.VertexSlots];
        Parallelism.ForBlocks(distance.Length, 16384, (from, to) =>
        {
            for (int v = from; v < to; v++)
            {
                double s = Vector3D.Dot(normal, positions[v]) - offset;
                distance[v] = Math.Abs(s) <= tolerance ? 0 : s;
            }
        });
        return distance;
    }

    /// <summary>Finds the crossings.</summary>
    /// <param name="mesh">Triangles.</param>
    /// <param name="distance">From <see cref="Distances"/>.</param>
    /// <param name="sign">1 to have the part above inside, −1 the part below.</param>
    /// <param name="touchingIsInside">Whether vertices on the plane are inside.</param>
    public static PlaneCrossings Find(Mesh mesh, double[] distance, int sign, bool touchingIsInside)
    {
        var inside = new bool[distance.Length];
        for (int v = 0; v < inside.Length; v++)
            inside[v] = sign * distance[v] > 0 || (touchingIsInside && distance[v] == 0);
        var crossings = new PlaneCrossings(mesh, distance, inside);
        crossings.Trace(crossings.LeavingHalfEdges());
        return crossings;
    }

    /// <summary>Throws unless every face is a triangle and the tolerance makes sense.</summary>
    public static void Check(Mesh mesh, CuttingPlane plane, double tolerance)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        plane.ThrowIfNone(nameof(plane));
        mesh.RequireTriangles();
        if (!(tolerance >= 0) || !double.IsFinite(tolerance))
            throw new ArgumentOutOfRangeException(nameof(tolerance), tolerance, "The tolerance must be finite and not negative.");
    }

    /// <summary>The point where the plane crosses an edge: at the outer end if that lies on the plane.</summary>
    public Vector3D PointOn(int leaving) => Vector3D.Lerp(Mesh.positions[Mesh.target[leaving ^ 1]], Mesh.positions[Mesh.target[leaving]], ParameterOf(leaving));

    /// <summary>Where on the half-edge the point lies, from 0 at its source to 1 at its target.</summary>
    public double ParameterOf(int leaving)
    {
        double a = Distance[Mesh.target[leaving ^ 1]], b = Distance[Mesh.target[leaving]];
        return a / (a - b);
    }

    /// <summary>Per crossed edge the half-edge from inside to outside, in index order.</summary>
    private List<int> LeavingHalfEdges()
    {
        int[] target = Mesh.target;
        var leaving = new List<int>();
        for (int h = 0; h < Mesh.HalfEdgeSlots; h += 2)
        {
            int to = target[h], from = target[h + 1];
            if (to >= 0 && Inside[to] != Inside[from])
                leaving.Add(Inside[from] ? h : h + 1);
        }
        return leaving;
    }

    private void Trace(List<int> leaving)
    {
        int[] face = Mesh.face, next = Mesh.next, target = Mesh.target;
        var done = new HashSet<int>(leaving.Count);
        var chain = new List<int>();

        // Chains of open meshes begin where no face comes before.
        foreach (int h in leaving)
        {
            if (face[h ^ 1] < 0)
                Follow(h);
        }
        foreach (int h in leaving)
        {
            if (!done.Contains(h))
                Follow(h);
        }

        void Follow(int first)
        {
            chain.Clear();
            int h = first;
            bool closed = false;
            while (true)
            {
                done.Add(h);
                chain.Add(h);
                if (face[h] < 0)
                    break;
                FaceCount++;
                // Around the face from the outer end: the first half-edge that comes back inside.
                int back = next[h];
                if (!Inside[target[back]])
                    back = next[back];
                h = back ^ 1;
                if (h == first)
                {
                    closed = true;
                    break;
                }
            }
            Chains.Add(new Chain([.. chain], closed));
        }
    }
}
