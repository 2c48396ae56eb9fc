using MeshLab.LinearAlgebra;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.HoleFilling;

/// <summary>§6.1 Fairing (光顺): moves the inner vertices of a patch so that it continues the surface around it (Liepa 2003, §5).</summary>
/// <remarks>
/// With cotangent weights w (within bounds, so that the matrix is positive definite), a third of the adjacent area as m, and the Laplacian
/// dᵢ = Σⱼ wᵢⱼ (xⱼ − xᵢ) / mᵢ, the sum that is made small over the patch and its rim is
/// <code>
///   continuity 0   Σ wᵢⱼ |xⱼ − xᵢ|²   the membrane, Δx = 0: only the rim's positions count
///   continuity 1   Σ mᵢ |dᵢ|²          the thin plate, Δ²x = 0: meets the surface around with its slope
///   continuity 2   Σ wᵢⱼ |dⱼ − dᵢ|²   Δ³x = 0: and with its curvature
/// </code>
/// The rows of the rim see the vertices around the hole; that is how slope and curvature come in. One sparse Cholesky factorization, three right-hand sides.
/// </remarks>
internal sealed class PatchFairing
{
    // A patch that leaves its place by more than this share of the hole's size extrapolates noise.
    private const double LargestMove = 0.5;

    private readonly Mesh mesh;
    private readonly HoleLoop loop;
    private readonly int firstInner;
    private readonly List<(int Row, int Column, double Value)> entries = [];
    private readonly Vector3D[] right;

    // One linear form: a weight per unknown, and a constant of the vertices that stay.
    private readonly List<(int Column, double Weight)> row = [];
    private Vector3D known;

    private PatchFairing(Mesh mesh, HoleLoop loop, int firstInner)
    {
        this.mesh = mesh;
        this.loop = loop;
        this.firstInner = firstInner;
        right = new Vector3D[mesh.VertexSlots - firstInner];
    }

    /// <summary>Moves the vertices from <paramref name="firstInner"/> on.</summary>
    /// <returns>Whether they moved; the patch stays as it was if the system is too badly conditioned, or its solution far away.</returns>
    public static bool Run(Mesh mesh, HoleLoop loop, int firstInner, int continuity)
    {
        if (mesh.VertexSlots == firstInner)
            return false;
        var fairing = new PatchFairing(mesh, loop, firstInner);
        fairing.AddForms(continuity);
        return fairing.SolveAndMove();
    }

    private void AddForms(int continuity)
    {
        if (continuity == 1)
        {
            for (int v = firstInner; v < mesh.VertexSlots; v++)
                AddLaplacian(v);
            foreach (int v in loop.Vertices)
                AddLaplacian(v);
            return;
        }
        // The edges with an end in the patch; for the curvature also those with an end on its rim.
        var rim = new HashSet<int>(continuity == 0 ? [] : loop.Vertices);
        for (int v = firstInner; v < mesh.VertexSlots; v++)
            AddEdges(v, continuity, rim);
        foreach (int v in loop.Vertices)
        {
            if (rim.Contains(v))
                AddEdges(v, continuity, rim);
        }
    }

    private void AddLaplacian(int v)
    {
        Clear();
        double mass = TakeLaplacian(v, 1);
        AddSquare(mass > 0 ? 1 / mass : 1);
    }

    private void AddEdges(int v, int continuity, HashSet<int> rim)
    {
        int start = mesh.outgoing[v], h = start;
        do
        {
            int w = mesh.target[h];
            bool again = (w >= firstInner || rim.Contains(w)) && w < v;
            // At the mesh's own boundary there is no curvature to continue.
            if (!again && (continuity == 0 || mesh.face[mesh.outgoing[w]] >= 0))
            {
                Clear();
                if (continuity == 0)
                {
                    Take(v, 1);
                    Take(w, -1);
                }
                else
                {
                    TakeLaplacian(v, 1 / Mass(v));
                    TakeLaplacian(w, -1 / Mass(w));
                }
                AddSquare(Weight(h));
            }
            h = mesh.next[h ^ 1];
        }
        while (h != start);
    }

    private void Clear()
    {
        row.Clear();
        known = default;
    }

    /// <summary>Adds the Laplacian of a vertex, times a factor, to the form.</summary>
    /// <returns>The vertex's share of the area.</returns>
    private double TakeLaplacian(int v, double factor)
    {
        double sum = 0, mass = 0;
        int start = mesh.outgoing[v], h = start;
        do
        {
            double w = Weight(h) * factor;
            Take(mesh.target[h], w);
            sum += w;
            mass += Area(h) / 3;
            h = mesh.next[h ^ 1];
        }
        while (h != start);
        Take(v, -sum);
        return mass;
    }

    private void Take(int vertex, double weight)
    {
        if (vertex < firstInner)
        {
            known += mesh.positions[vertex] * weight;
            return;
        }
        int column = vertex - firstInner;
        for (int i = 0; i < row.Count; i++)
        {
            if (row[i].Column == column)
            {
                row[i] = (column, row[i].Weight + weight);
                return;
            }
        }
        row.Add((column, weight));
    }

    /// <summary>Adds the square of the form to the normal equations.</summary>
    private void AddSquare(double scale)
    {
        for (int i = 0; i < row.Count; i++)
        {
            right[row[i].Column] -= known * (row[i].Weight * scale);
            for (int j = i; j < row.Count; j++)
                entries.Add((row[i].Column, row[j].Column, row[i].Weight * row[j].Weight * scale));
        }
    }

    private bool SolveAndMove()
    {
        Vector3D[] solution;
        try
        {
            solution = new SparseCholesky(SparseMatrix.FromEntries(right.Length, entries), mesh.Positions[firstInner..]).Solve(right);
        }
        catch (NotPositiveDefiniteException)
        {
            return false;
        }
        double limit = LargestMove * BoundingBox.Of(loop.Points).Diagonal;
        for (int u = 0; u < solution.Length; u++)
        {
            if (!(Vector3D.Distance(solution[u], mesh.positions[firstInner + u]) <= limit))
                return false;
        }
        for (int u = 0; u < solution.Length; u++)
            mesh.SetPosition(new(mesh, firstInner + u), solution[u]);
        return true;
    }

    private double Weight(int h) => Math.Clamp((Cotangent(h) + Cotangent(h ^ 1)) / 2, 0.02, 50);

    /// <summary>Of the angle opposite to a half-edge; that of 60° where there is no triangle.</summary>
    private double Cotangent(int h)
    {
        if (mesh.face[h] < 0 || mesh.next[mesh.next[mesh.next[h]]] != h)
            return 0.5773502691896258;
        Vector3D c = mesh.positions[mesh.target[mesh.next[h]]], a = mesh.positions[mesh.target[h ^ 1]] - c, b = mesh.positions[mesh.target[h]] - c;
        double sine = Vector3D.Cross(a, b).Length;
        return sine > 0 ? Vector3D.Dot(a, b) / sine : 0;
    }

    private double Mass(int v)
    {
        double mass = 0;
        int start = mesh.outgoing[v], h = start;
        do
        {
            mass += Area(h) / 3;
            h = mesh.next[h ^ 1];
        }
        while (h != start);
        return mass > 0 ? mass : 1;
    }

    private double Area(int h)
    {
        if (mesh.face[h] < 0)
            return 0;
        Vector3D a = mesh.positions[mesh.target[h ^ 1]];
        return Vector3D.Cross(mesh.positions[mesh.target[h]] - a, mesh.positions[mesh.target[mesh.next[h]]] - a).Length / 2;
    }
}
