using MeshLab.LinearAlgebra;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.HoleFilling;

/// <summary>§6.1 Fairing (光顺): moves the inner vertices of a patch so that it continues the surface around it with its slope (Liepa 2003, §5).</summary>
/// <remarks>
/// Minimizes Σ |Σⱼ wᵢⱼ (xⱼ − xᵢ)|² / mᵢ over the inner and the rim vertices i, with cotangent weights w (within bounds, so that the matrix is positive definite) and
/// a third of the adjacent area as m: the second-order Laplacian vanishes inside, Δ²x = 0. Because the rim's own rows see the vertices around the hole, the patch meets them
/// with their slope. One sparse Cholesky factorization, three right-hand sides.
/// </remarks>
internal static class PatchFairing
{
    /// <summary>Moves the vertices from <paramref name="firstInner"/> on.</summary>
    /// <returns>Whether they moved; the patch stays as it was if the system is too badly conditioned.</returns>
    public static bool Run(Mesh mesh, HoleLoop loop, int firstInner)
    {
        int unknowns = mesh.VertexSlots - firstInner;
        if (unknowns == 0)
            return false;
        var entries = new List<(int Row, int Column, double Value)>(40 * unknowns);
        var right = new Vector3D[unknowns];
        var row = new List<(int Column, double Weight)>();
        for (int u = 0; u < unknowns; u++)
            AddRow(mesh, firstInner + u, firstInner, row, entries, right);
        foreach (int v in loop.Vertices)
            AddRow(mesh, v, firstInner, row, entries, right);

        Vector3D[] solution;
        try
        {
            solution = new SparseCholesky(SparseMatrix.FromEntries(unknowns, entries), mesh.Positions[firstInner..]).Solve(right);
        }
        catch (NotPositiveDefiniteException)
        {
            return false;
        }
        if (!Array.TrueForAll(solution, p => p.IsFinite))
            return false;
        for (int u = 0; u < unknowns; u++)
            mesh.SetPosition(new(mesh, firstInner + u), solution[u]);
        return true;
    }

    /// <summary>Adds the squared Laplacian at one vertex to the normal equations.</summary>
    private static void AddRow(Mesh mesh, int v, int firstInner, List<(int Column, double Weight)> row, List<(int Row, int Column, double Value)> entries, Vector3D[] right)
    {
        row.Clear();
        Vector3D known = default;
        double sum = 0, mass = 0;
        int start = mesh.outgoing[v], h = start;
        do
        {
            double w = Math.Clamp((Cotangent(mesh, h) + Cotangent(mesh, h ^ 1)) / 2, 0.02, 50);
            Take(mesh.target[h], w);
            sum += w;
            mass += Area(mesh, h) / 3;
            h = mesh.next[h ^ 1];
        }
        while (h != start);
        Take(v, -sum);

        double scale = mass > 0 ? 1 / mass : 1;
        for (int i = 0; i < row.Count; i++)
        {
            right[row[i].Column] -= known * (row[i].Weight * scale);
            for (int j = i; j < row.Count; j++)
                entries.Add((row[i].Column, row[j].Column, row[i].Weight * row[j].Weight * scale));
        }

        void Take(int vertex, double weight)
        {
            if (vertex >= firstInner)
                row.Add((vertex - firstInner, weight));
            else
                known += mesh.positions[vertex] * weight;
        }
    }

    /// <summary>Of the angle opposite to a half-edge; that of 60° where there is no triangle.</summary>
    private static double Cotangent(Mesh mesh, int h)
    {
        if (mesh.face[h] < 0 || mesh.next[mesh.next[mesh.next[h]]] != h)
            return 0.5773502691896258;
        Vector3D c = mesh.positions[mesh.target[mesh.next[h]]], a = mesh.positions[mesh.target[h ^ 1]] - c, b = mesh.positions[mesh.target[h]] - c;
        double sine = Vector3D.Cross(a, b).Length;
        return sine > 0 ? Vector3D.Dot(a, b) / sine : 0;
    }

    private static double Area(Mesh mesh, int h)
    {
        if (mesh.face[h] < 0)
            return 0;
        Vector3D a = mesh.positions[mesh.target[h ^ 1]];
        return Vector3D.Cross(mesh.positions[mesh.target[h]] - a, mesh.positions[mesh.target[mesh.next[h]]] - a).Length / 2;
    }
}
