using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.HoleFilling;

/// <summary>§6.1 Refinement (细化): gives a patch triangles of the size of those around the hole (Liepa 2003, §4).</summary>
/// <remarks>
/// Every vertex has a scale: on the rim the mean length of its edges outside of the patch, inside the mean of the three corners it was born in. A triangle gets a vertex at its
/// centroid if that is farther from each corner, times 2, than its scale and the corner's. After each pass edges are flipped until none lies
/// within the other triangle's circle, so that triangles stay round; not before the first, as the triangulation's few edges hold the shape of the patch.
/// </remarks>
internal sealed class PatchRefinement
{
    // Liepa has √2, which leaves a patch with half as many triangles as its surroundings; twice the squared density fills that up.
    private const double Density = 2;
    private const int MaxPasses = 20;
    private const int MaxSweeps = 30;

    private readonly Mesh mesh;
    private readonly Dictionary<int, double> scale;
    private readonly int firstFace;
    private readonly int firstEdge;

    /// <summary>Prepares the refinement of a patch that was just put in.</summary>
    /// <param name="mesh">The mesh with the patch in it.</param>
    /// <param name="scale">Per rim vertex.</param>
    /// <param name="firstFace">The faces from here on are the patch.</param>
    /// <param name="firstEdge">The edges from here on are its inner edges.</param>
    public PatchRefinement(Mesh mesh, Dictionary<int, double> scale, int firstFace, int firstEdge)
    {
        this.mesh = mesh;
        this.scale = scale;
        this.firstFace = firstFace;
        this.firstEdge = firstEdge;
    }

    /// <summary>Per vertex of the loop the mean length of its edges; to be asked before the hole is filled.</summary>
    public static Dictionary<int, double> RimScales(HoleLoop loop)
    {
        var scale = new Dictionary<int, double>(loop.Count);
        foreach (int v in loop.Vertices)
        {
            double sum = 0;
            int count = 0;
            foreach (Vertex w in loop.Mesh.Vertices[v].Neighbors)
            {
                sum += Vector3D.Distance(loop.Mesh.positions[v], w.Position);
                count++;
            }
            scale[v] = sum / count;
        }
        return scale;
    }

    /// <summary>Adds vertices until the patch is as dense as its surroundings, or the budget is spent.</summary>
    /// <returns>The number of vertices added.</returns>
    public int Run(int budget)
    {
        int added = 0;
        for (int pass = 0; pass < MaxPasses; pass++)
        {
            int before = added, faces = mesh.FaceSlots;
            for (int f = firstFace; f < faces && added < budget; f++)
            {
                if (SplitIfLarge(mesh.Faces[f]))
                    added++;
            }
            if (added == before)
                break;
            Relax();
        }
        return added;
    }

    private bool SplitIfLarge(Face face)
    {
        HalfEdge h = face.HalfEdge;
        Vertex a = h.Source, b = h.Target, c = h.Next.Target;
        if (!scale.TryGetValue(a.Index, out double sa) || !scale.TryGetValue(b.Index, out double sb) || !scale.TryGetValue(c.Index, out double sc))
            return false;
        Vector3D center = (a.Position + b.Position + c.Position) / 3;
        double own = (sa + sb + sc) / 3;
        double da = Density * Vector3D.Distance(center, a.Position), db = Density * Vector3D.Distance(center, b.Position), dc = Density * Vector3D.Distance(center, c.Position);
        if (!(da > own && da > sa && db > own && db > sb && dc > own && dc > sc))
            return false;
        HalfEdge second = h.Next, third = second.Next;
        scale[face.Split(center).Index] = own;
        RelaxEdge(h.Edge);
        RelaxEdge(second.Edge);
        RelaxEdge(third.Edge);
        return true;
    }

    /// <summary>Flips edges of the patch until none lies within the other triangle's circle.</summary>
    public void Relax()
    {
        for (int sweep = 0; sweep < MaxSweeps; sweep++)
        {
            bool flipped = false;
            for (int e = firstEdge; e < mesh.EdgeSlots; e++)
                flipped |= RelaxEdge(mesh.Edges[e]);
            if (!flipped)
                return;
        }
    }

    /// <summary>Flips an inner edge whose opposite angles are together larger than π, unless the patch would fold.</summary>
    private bool RelaxEdge(Edge edge)
    {
        if (edge.Index < firstEdge)
            return false;
        HalfEdge h = edge.HalfEdge0, t = h.Twin;
        Vector3D a = h.Source.Position, b = h.Target.Position, c = h.Next.Target.Position, d = t.Next.Target.Position;
        Vector3D left = Vector3D.Cross(a - c, b - c), right = Vector3D.Cross(b - d, a - d);
        double cosC = Vector3D.Dot(a - c, b - c), cosD = Vector3D.Dot(a - d, b - d), sinC = left.Length, sinD = right.Length;
        if (cosC * sinD + sinC * cosD >= -1e-9 * (Math.Abs(cosC) * sinD + sinC * Math.Abs(cosD)))
            return false;
        Vector3D atA = Vector3D.Cross(d - a, c - a), atB = Vector3D.Cross(c - b, d - b);
        double bend = Vector3D.Dot(atA.Normalized(), atB.Normalized());
        return bend > Math.Min(0.5, Vector3D.Dot(left.Normalized(), right.Normalized()) - 0.1) && edge.TryFlip(out _);
    }
}
