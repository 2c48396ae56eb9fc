using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.LinearAlgebra;

/// <summary>How a harmonic function is computed.</summary>
public sealed record HarmonicOptions
{
    /// <summary>The weights of the Laplacian. With negative weights (<see cref="LaplacianWeights.Cotangent"/>) values may leave the range of the fixed ones.</summary>
    public LaplacianWeights Weights { get; init; } = LaplacianWeights.Cotangent;

    /// <summary>Whether components without a fixed vertex get NaN. Otherwise they are an error.</summary>
    public bool AllowUndetermined { get; init; }
}

/// <summary>§12.5 调和函数 (harmonic function): L u = 0 at all vertices but the fixed ones, whose values are given (Dirichlet's problem).</summary>
/// <remarks>
/// <para>
/// Split the vertices into free (f) and fixed (c): L_ff u_f = −L_fc u_c. L_ff is positive definite where every component has a fixed vertex. It is
/// factored once, by <see cref="SparseCholesky"/>, and then serves any values at the same vertices. The mean-value Laplacian is not symmetric: there
/// the factor of its symmetric part preconditions a Krylov method (<see cref="Gmres"/>).
/// </para>
/// <para>With weights ≥ 0 every value is a mean of its neighbours', so extrema lie at the fixed vertices only. O(V^1.5) to prepare, O(V log V) per solution.</para>
/// </remarks>
public sealed class DirichletProblem
{
    private readonly SparseMatrix laplacian, freeMatrix;
    private readonly SparseCholesky? factor;
    private readonly int[] freeIndex, fixedSlots;
    private readonly bool[] isUndetermined;

    /// <summary>Prepares the problem.</summary>
    /// <param name="mesh">The mesh; a triangle mesh unless the weights are uniform. It is only read here.</param>
    /// <param name="fixedVertices">The vertices whose values are given; each once.</param>
    /// <param name="options">The weights, and what is an error.</param>
    /// <param name="cancellationToken">Stops the work.</param>
    /// <exception cref="ArgumentException">
    /// A vertex is not a live one of the mesh or named twice; there is none in a component; a face is not a triangle.
    /// </exception>
    /// <exception cref="NotPositiveDefiniteException">Rounding in nearly degenerate faces; <see cref="NotPositiveDefiniteException.Row"/> is the free vertex's slot.</exception>
    public DirichletProblem(
        Mesh mesh, IReadOnlyList<Vertex> fixedVertices, HarmonicOptions? options = null, CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        ArgumentNullException.ThrowIfNull(fixedVertices);
        options ??= new HarmonicOptions();
        fixedSlots = CheckFixed(mesh, fixedVertices);
        laplacian = mesh.ComputeLaplacian(options.Weights);
        (freeIndex, int[] free, isUndetermined) = NumberFree(mesh, options.AllowUndetermined);
        freeMatrix = laplacian.Principal(freeIndex, free.Length);
        cancellationToken.ThrowIfCancellationRequested();
        Vector3D[] position = mesh.positions;
        Vector3D[] freePositions = Array.ConvertAll(free, v => position[v]);
        try
        {
            factor = new SparseCholesky(
                freeMatrix.IsSymmetric ? freeMatrix : SymmetricPart(freeMatrix), freePositions, new CholeskyOptions { RelativeZero = 0 }, cancellationToken);
        }
        catch (NotPositiveDefiniteException e)
        {
            throw new NotPositiveDefiniteException(free[e.Row], e.Pivot);
        }
    }

    /// <summary>The number of unknowns.</summary>
    public int FreeCount => freeMatrix.Size;

    /// <summary>Solves for given values.</summary>
    /// <param name="values">The values of the fixed vertices, in the order in which these were given.</param>
    /// <returns>The function per vertex slot; NaN at isolated and deleted vertices, at those with faces without area only, and in components without fixed vertex.</returns>
    /// <exception cref="ArgumentException">The number of values is wrong, or one is not finite.</exception>
    public double[] Solve(params ReadOnlySpan<double> values)
    {
        if (values.Length != fixedSlots.Length)
            throw new ArgumentException($"{values.Length} values for {fixedSlots.Length} fixed vertices.", nameof(values));
        var u = new double[laplacian.Size];
        for (int i = 0; i < fixedSlots.Length; i++)
        {
            if (!double.IsFinite(values[i]))
                throw new ArgumentException($"The value {values[i]} of v{fixedSlots[i]} is not finite.", nameof(values));
            u[fixedSlots[i]] = values[i];
        }

        double[] right = RightSide(u);
        double[] solution = freeMatrix.IsSymmetric ? factor!.Solve(right) : Gmres.Solve(freeMatrix, factor!.Solve, right);
        for (int v = 0; v < u.Length; v++)
        {
            if (freeIndex[v] >= 0)
                u[v] = solution[freeIndex[v]];
            else if (isUndetermined[v])
                u[v] = double.NaN;
        }
        return u;
    }

    private static int[] CheckFixed(Mesh mesh, IReadOnlyList<Vertex> vertices)
    {
        if (vertices.Count == 0)
            throw new ArgumentException("No vertex is fixed, so the function is not determined.", nameof(vertices));
        var slots = new int[vertices.Count];
        var seen = new HashSet<int>();
        for (int i = 0; i < slots.Length; i++)
        {
            Vertex v = vertices[i];
            if (v.IsNone || v.Mesh != mesh)
                throw new ArgumentException($"{v} is not a vertex of this mesh.", nameof(vertices));
            v.ThrowIfDead();
            slots[i] = v.Index;
            if (!seen.Add(v.Index))
                throw new ArgumentException($"{v} is fixed twice.", nameof(vertices));
        }
        return slots;
    }

    // Spreads from the fixed vertices over the edges; every other vertex reached is free, unless all its faces are without area and so its
    // row is empty.
    private (int[] Index, int[] Free, bool[] IsUndetermined) NumberFree(Mesh mesh, bool allowUndetermined)
    {
        int[] next = mesh.next, target = mesh.target, outgoing = mesh.outgoing;
        int n = mesh.VertexSlots, count = 0;
        var reached = new bool[n];
        var stack = new int[n];
        foreach (int v in fixedSlots)
        {
            reached[v] = true;
            stack[count++] = v;
        }
        while (count > 0)
        {
            int first = outgoing[stack[--count]];
            if (first < 0)
                continue;
            int h = first;
            do
            {
                if (!reached[target[h]])
                {
                    reached[target[h]] = true;
                    stack[count++] = target[h];
                }
                h = next[h ^ 1];
            }
            while (h != first);
        }

        var index = new int[n];
        var undetermined = new bool[n];
        for (int v = 0; v < n; v++)
        {
            bool isTied = reached[v] && laplacian.Diagonal[v] != 0;
            undetermined[v] = !isTied;
            if (!reached[v] && outgoing[v] >= 0 && !allowUndetermined)
                throw new ArgumentException($"No vertex is fixed in the component of v{v}, so the function is not determined there.", nameof(mesh));
            index[v] = isTied ? 0 : -1;
        }
        foreach (int v in fixedSlots)
            (index[v], undetermined[v]) = (-1, false);
        for (int v = 0; v < n; v++)
        {
            if (index[v] == 0)
                (index[v], stack[count]) = (count++, v);
        }
        return (index, stack[..count], undetermined);
    }

    // −L_fc u_c, from the rows of the fixed vertices' neighbours in the order of the fixed vertices.
    private double[] RightSide(double[] u)
    {
        var right = new double[FreeCount];
        foreach (int c in fixedSlots)
        {
            foreach (int j in laplacian.Columns[laplacian.RowStart[c]..laplacian.RowStart[c + 1]])
            {
                if (freeIndex[j] >= 0)
                    right[freeIndex[j]] -= laplacian[j, c] * u[c];
            }
        }
        return right;
    }

    private static SparseMatrix SymmetricPart(SparseMatrix matrix)
    {
        var entries = new List<(int, int, double)>(matrix.NonZeros);
        for (int i = 0; i < matrix.Size; i++)
        {
            double sum = 0;
            for (int k = matrix.RowStart[i]; k < matrix.RowStart[i + 1]; k++)
            {
                int j = matrix.Columns[k];
                double mean = 0.5 * (matrix.Values[k] + matrix[j, i]);
                sum -= mean - matrix.Values[k];
                if (j < i)
                    entries.Add((i, j, mean));
            }
            // Keeps the row's surplus over its neighbours, so that the symmetric part is diagonally dominant as well.
            entries.Add((i, i, matrix.Diagonal[i] + sum));
        }
        return SparseMatrix.FromEntries(matrix.Size, entries);
    }
}
