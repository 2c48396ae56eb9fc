using MeshLab.LinearAlgebra;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Smoothing;

/// <summary>How implicit smoothing works.</summary>
public sealed record ImplicitSmoothingOptions : SmoothingOptions
{
    private readonly double time = 1;

    /// <summary>One step unless set: an implicit step can be as long as wanted.</summary>
    public ImplicitSmoothingOptions() => Steps = 1;

    /// <summary>The time of one step, in units of the mean area per vertex; 1 unless set.</summary>
    public double Time
    {
        get => time;
        init => time = Checked(value, 0, double.MaxValue, nameof(Time));
    }

    /// <summary>The weights of the Laplacian; symmetric ones only.</summary>
    public LaplacianWeights Weights { get; init; } = LaplacianWeights.Cotangent;
}

/// <summary>隐式光顺 (implicit smoothing): mean-curvature flow by backward Euler steps, stable for every length of step.</summary>
/// <remarks>
/// <para>
/// (M + t L) x' = M x with the barycentric masses M and the Laplacian L of the surface before the step: one factorization and three solutions, one
/// per coordinate. Desbrun, Meyer, Schröder, Barr 1999, "Implicit fairing of irregular meshes using diffusion and curvature flow", SIGGRAPH, eq. 9.
/// </para>
/// <para>Fixed boundary vertices are known values on the right-hand side; boundary curves flow by the same rule in one dimension. O(V^1.5) per step.</para>
/// </remarks>
public static class ImplicitSmoothing
{
    extension(Mesh mesh)
    {
        /// <summary>Smooths by implicit steps.</summary>
        /// <param name="options">Steps, their time, weights and boundary.</param>
        /// <param name="progress">The part of the steps done.</param>
        /// <param name="cancellationToken">Stops the work; the mesh is then left as it was.</param>
        /// <exception cref="ArgumentException">A face is not a triangle, or the weights are not symmetric.</exception>
        public SmoothingResult SmoothImplicitly(
            ImplicitSmoothingOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            options ??= new ImplicitSmoothingOptions();
            OppositeCotangents.RequireTriangles(mesh);
            if (options.Weights == LaplacianWeights.MeanValue)
                throw new ArgumentException("Mean-value weights are not symmetric.", nameof(options));

            var positions = new MovingPositions(mesh);
            CholeskyAnalysis? analysis = null;
            for (int step = 0; step < options.Steps; step++)
            {
                positions.Replace(Step(mesh, positions.Current, options, ref analysis, cancellationToken));
                progress?.Report((step + 1.0) / options.Steps);
            }
            return positions.Finish(options.Steps);
        }
    }

    private static Vector3D[] Step(
        Mesh mesh, Vector3D[] positions, ImplicitSmoothingOptions options, ref CholeskyAnalysis? analysis, CancellationToken cancellationToken)
    {
        cancellationToken.ThrowIfCancellationRequested();
        bool isCotangent = options.Weights == LaplacianWeights.Cotangent;
        SparseMatrix laplacian = isCotangent ? Laplacian.PlacesOf(mesh) : LaplacianAt(mesh, positions, options.Weights);
        (int[] index, int[] free) = NumberFree(mesh, isCotangent ? null : Masses(mesh, positions, out _), options.Boundary);
        SparseMatrix places = free.Length == laplacian.Size ? laplacian : laplacian.Principal(index, free.Length);
        Vector3D[] result = (Vector3D[])positions.Clone();

        // Where the entries lie is known before their values are. Intrinsic Delaunay triangulations differ from step to step.
        CholeskyAnalysis? known = options.Weights == LaplacianWeights.IntrinsicDelaunay ? null : analysis;
        (SparseMatrix Matrix, Vector3D[] Right)? equations = null;
        Parallelism.Invoke(
            () => known ??= CholeskyAnalysis.Of(places, Array.ConvertAll(free, v => positions[v])),
            () => equations = Equations(mesh, positions, laplacian, index, free, options, result, cancellationToken));
        analysis = known;

        (SparseMatrix matrix, Vector3D[] right) = equations!.Value;
        var factor = new SparseCholesky(matrix, known!, new CholeskyOptions { RelativeZero = 0 }, cancellationToken);
        Vector3D[] solution = factor.Solve(right);
        for (int i = 0; i < free.Length; i++)
            result[free[i]] = solution[i];
        return result;
    }

    private static (SparseMatrix Matrix, Vector3D[] Right) Equations(
        Mesh mesh, Vector3D[] positions, SparseMatrix laplacian, int[] index, int[] free, ImplicitSmoothingOptions options, Vector3D[] result, CancellationToken cancellationToken)
    {
        double[] mass = Masses(mesh, positions, out double[] cotangent);
        if (options.Weights == LaplacianWeights.Cotangent)
            Laplacian.Fill(laplacian, mesh, Laplacian.CotangentWeights(cotangent, double.NegativeInfinity));
        double time = options.Time * MeanMass(mesh, mass);
        if (options.Boundary == SmoothingBoundary.AlongCurve)
            BoundaryCurves.Step(mesh, positions, time, result, cancellationToken);

        SparseMatrix matrix = (free.Length == laplacian.Size ? laplacian : laplacian.Principal(index, free.Length))
            .ScaleAndAdd(time, SparseMatrix.FromDiagonal(Array.ConvertAll(free, v => mass[v])));
        var right = new Vector3D[free.Length];
        Parallelism.ForBlocks(free.Length, (from, to) => FillRight(laplacian, positions, mass, time, index, free, result, right, from, to));

        // A vertex with faces without area only has an empty row, and no mass to move by.
        Span<double> diagonal = matrix.Diagonal;
        for (int i = 0; i < free.Length; i++)
        {
            if (diagonal[i] == 0 && mass[free[i]] == 0)
                (diagonal[i], right[i]) = (1, positions[free[i]]);
        }
        return (matrix, right);
    }

    // M x, and what is known already of the neighbours' new positions on this side.
    private static void FillRight(
        SparseMatrix laplacian, Vector3D[] positions, double[] mass, double time, int[] index, int[] free, Vector3D[] result, Vector3D[] right, int from, int to)
    {
        bool isAllFree = free.Length == laplacian.Size;
        for (int i = from; i < to; i++)
        {
            int v = free[i];
            right[i] = mass[v] * positions[v];
            if (isAllFree)
                continue;
            for (int k = laplacian.RowStart[v]; k < laplacian.RowStart[v + 1]; k++)
            {
                int j = laplacian.Columns[k];
                if (index[j] < 0)
                    right[i] -= time * laplacian.Values[k] * result[j];
            }
        }
    }

    private static double[] Masses(Mesh mesh, Vector3D[] positions, out double[] cotangent)
    {
        cotangent = OppositeCotangents.Of(mesh, positions, out double[] doubleArea);
        return MassMatrix.Lumped(mesh, cotangent, doubleArea, MassKind.Barycentric);
    }

    // The other weights are asked of a mesh, so they get one with these positions.
    private static SparseMatrix LaplacianAt(Mesh mesh, Vector3D[] positions, LaplacianWeights weights)
    {
        Mesh moved = mesh.Clone();
        positions.CopyTo(moved.Positions);
        return moved.ComputeLaplacian(weights);
    }

    // With weights that do not vanish with the areas, vertices without mass stay where they are.
    private static (int[] Index, int[] Free) NumberFree(Mesh mesh, double[]? mass, SmoothingBoundary boundary)
    {
        var index = new int[mesh.VertexSlots];
        var free = new int[mesh.VertexSlots];
        int count = 0;
        for (int v = 0; v < index.Length; v++)
        {
            int h = mesh.outgoing[v];
            bool isFree = h >= 0 && (mass is null || mass[v] > 0) && (boundary == SmoothingBoundary.Free || mesh.face[h] >= 0);
            index[v] = isFree ? count : -1;
            if (isFree)
                free[count++] = v;
        }
        return (index, free[..count]);
    }

    private static double MeanMass(Mesh mesh, double[] mass)
    {
        double sum = Parallelism.SumBlocks(mass.Length, (from, to) =>
        {
            double partial = 0;
            for (int v = from; v < to; v++)
                partial += mass[v];
            return partial;
        });
        int count = 0;
        foreach (int h in mesh.Outgoing)
            count += h >= 0 ? 1 : 0;
        return sum / Math.Max(1, count);
    }
}

/// <summary>The same flow for the boundary loops as curves: weights 1/|e|, masses half the length of the two edges.</summary>
internal static class BoundaryCurves
{
    public static void Step(Mesh mesh, Vector3D[] positions, double time, Vector3D[] result, CancellationToken cancellationToken)
    {
        var index = new int[mesh.VertexSlots];
        var vertices = new List<int>();
        for (int v = 0; v < index.Length; v++)
        {
            index[v] = mesh.outgoing[v] >= 0 && mesh.face[mesh.outgoing[v]] < 0 ? vertices.Count : -1;
            if (index[v] >= 0)
                vertices.Add(v);
        }
        var entries = new List<(int, int, double)>(4 * vertices.Count);
        var right = new Vector3D[vertices.Count];
        for (int i = 0; i < right.Length; i++)
        {
            // Each vertex begins one edge of its loop.
            int j = index[mesh.target[mesh.outgoing[vertices[i]]]];
            double length = Vector3D.Distance(positions[vertices[i]], positions[vertices[j]]);
            double weight = length > 0 ? time / length : 0;
            entries.AddRange([(i, i, 0.5 * length + weight), (j, j, 0.5 * length + weight), (i, j, -weight)]);
            right[i] += 0.5 * length * positions[vertices[i]];
            right[j] += 0.5 * length * positions[vertices[j]];
        }
        var factor = new SparseCholesky(
            SparseMatrix.FromEntries(right.Length, entries), [.. vertices.Select(v => positions[v])], new CholeskyOptions { AllowSemidefinite = true }, cancellationToken);
        Vector3D[] moved = factor.Solve(right);
        for (int i = 0; i < moved.Length; i++)
            result[vertices[i]] = moved[i];
        // A loop of length zero has nothing to flow by.
        foreach (int row in factor.FixedRows)
            result[vertices[row]] = positions[vertices[row]];
    }
}
