using MeshLab.LinearAlgebra;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geodesics;

/// <summary>How the heat method measures.</summary>
public sealed record HeatOptions
{
    private readonly double timeFactor = 1;

    /// <summary>The time of diffusion in squares of the mean edge length; 1 unless set. Larger is smoother and less exact.</summary>
    public double TimeFactor
    {
        get => timeFactor;
        init
        {
            ArgumentOutOfRangeException.ThrowIfNegativeOrZero(value);
            timeFactor = value;
        }
    }

    /// <summary>
    /// Whether the work is done on the intrinsic Delaunay triangulation (<see cref="IntrinsicDelaunay"/>): the same surface and vertices, without negative weights.
    /// True unless set: a tenth slower to prepare, the same on meshes that are Delaunay, and a great deal more exact on those with slivers. False takes the triangles as they are.
    /// </summary>
    public bool IntrinsicDelaunay { get; init; } = true;
}

/// <summary>热方法测地距离 (geodesic distance by the heat method): heat flows away from the sources along shortest paths.</summary>
/// <remarks>
/// <para>Crane, Weischedel, Wardetzky 2013, "Geodesics in heat", ACM TOG 32(5), algorithm 1:</para>
/// <list type="number">
/// <item>let heat diffuse from the sources for a short time: (M + t L) u = M δ, with t the squared mean edge length;</item>
/// <item>its gradient points the right way, only its length is wrong: X = −∇u/|∇u|, per face;</item>
/// <item>the distance is the function with that gradient: L φ = −∇·X, shifted to be 0 at the sources.</item>
/// </list>
/// <para>
/// Both matrices are factored once (their places are the same, so they share the analysis), after which every set of sources costs two solutions.
/// Cotangent weights of the intrinsic Delaunay triangulation, barycentric masses, natural boundary. On regular meshes the error is about half an edge length, one percent of
/// the largest distance or less; on uneven ones expect two to six percent, on a machine part of slivers ten. On the given triangles
/// (<see cref="HeatOptions.IntrinsicDelaunay"/> set to false) that part is 65 percent wrong, since slivers make weights negative.
/// </para>
/// </remarks>
public sealed class HeatGeodesics
{
    // Heat falls by a factor of about e per edge; starting high doubles the distance at which it underflows, to more than a thousand edges.
    private const double SourceHeat = 1e250;

    private readonly Mesh mesh;
    private readonly IntrinsicDelaunay? intrinsic;
    private readonly int[] next, outgoing;
    private readonly double[] cotangent, mass;
    private readonly int[] index, slots, component;
    private readonly SparseCholesky heat, poisson;

    /// <summary>Prepares a mesh: assembles and factors the two matrices. O(V^1.5).</summary>
    /// <param name="mesh">A triangle mesh. It must not change while this object is used.</param>
    /// <param name="options">The time of diffusion, and on which triangles.</param>
    /// <param name="cancellationToken">Stops the work.</param>
    /// <exception cref="ArgumentException">A face is not a triangle.</exception>
    public HeatGeodesics(Mesh mesh, HeatOptions? options = null, CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        options ??= new HeatOptions();
        this.mesh = mesh;
        (index, slots) = NumberVertices(mesh);
        SparseMatrix laplacian;
        if (options.IntrinsicDelaunay)
        {
            intrinsic = LinearAlgebra.IntrinsicDelaunay.Of(mesh);
            (next, outgoing) = (intrinsic.Next, Outgoing(intrinsic, mesh.VertexSlots));
            laplacian = intrinsic.ComputeLaplacian();
        }
        else
        {
            OppositeCotangents.RequireTriangles(mesh);
            (next, outgoing) = (mesh.next, mesh.outgoing);
            laplacian = Laplacian.PlacesOf(mesh);
        }
        SparseMatrix places = slots.Length < mesh.VertexSlots ? laplacian.Principal(index, slots.Length) : laplacian;

        // The analysis reads the places of the entries alone, so that their values may be worked on meanwhile.
        CholeskyAnalysis? analysis = null;
        Matrices? assembled = null;
        Parallelism.Invoke(
            () => analysis = CholeskyAnalysis.Of(places, Array.ConvertAll(slots, v => mesh.positions[v])),
            () => assembled = Assemble(laplacian, options.TimeFactor));
        (cotangent, mass, component, laplacian, SparseMatrix diffusion) = assembled!;

        var accept = new CholeskyOptions { RelativeZero = 0 };
        SparseCholesky? ofDiffusion = null, ofLaplacian = null;
        Parallelism.Invoke(
            () => ofDiffusion = new SparseCholesky(diffusion, analysis!, accept, cancellationToken),
            () => ofLaplacian = new SparseCholesky(laplacian, analysis!, accept, cancellationToken));
        (heat, poisson) = (ofDiffusion!, ofLaplacian!);
    }

    /// <summary>The distance from the nearest of some vertices.</summary>
    /// <param name="sources">The vertices at distance 0.</param>
    /// <returns>The distance per vertex slot; +∞ in components without a source, NaN at deleted vertices and, unless they are sources, at those without area around them.</returns>
    /// <exception cref="ArgumentException">There is no source, or one is not a live vertex of the mesh.</exception>
    public double[] ComputeDistances(params ReadOnlySpan<Vertex> sources)
    {
        SourceVertices.Check(mesh, sources);
        var start = new double[slots.Length];
        foreach (Vertex source in sources)
        {
            if (index[source.Index] >= 0)
                start[index[source.Index]] = SourceHeat * mass[source.Index];
        }
        double[] u = heat.Solve(start);
        double[] phi = poisson.Solve(Divergence(FluxOfFlow(u)));
        return Shift(phi, sources);
    }

    private sealed record Matrices(double[] Cotangent, double[] Mass, int[] Component, SparseMatrix Laplacian, SparseMatrix Diffusion);

    private Matrices Assemble(SparseMatrix laplacian, double timeFactor)
    {
        double[] cotangents, masses;
        if (intrinsic is not null)
        {
            (cotangents, masses) = (intrinsic.ComputeCotangents(), Masses(intrinsic, mesh.VertexSlots));
        }
        else
        {
            cotangents = OppositeCotangents.Of(mesh, out double[] doubleArea);
            masses = MassMatrix.Lumped(mesh, cotangents, doubleArea, MassKind.Barycentric);
            Laplacian.Fill(laplacian, mesh, Laplacian.CotangentWeights(cotangents, double.NegativeInfinity));
        }
        if (slots.Length < mesh.VertexSlots)
            laplacian = laplacian.Principal(index, slots.Length);

        int[] components = VertexComponents.Of(mesh);
        double edge = MeanEdgeLength(mesh);
        SparseMatrix diffusion = laplacian.ScaleAndAdd(timeFactor * edge * edge, SparseMatrix.FromDiagonal(Array.ConvertAll(slots, v => masses[v])));
        FillEmptyRows(diffusion);
        FillEmptyRows(laplacian);
        // The Laplacian alone is singular: doubling one diagonal entry per component fixes that vertex at 0, since the right-hand side sums to 0.
        PinComponents(laplacian, slots, components);
        return new Matrices(cotangents, masses, components, laplacian, diffusion);
    }

    private static (int[] Index, int[] Slots) NumberVertices(Mesh mesh)
    {
        var index = new int[mesh.VertexSlots];
        var slots = new int[mesh.VertexSlots];
        int count = 0;
        for (int v = 0; v < index.Length; v++)
        {
            if (mesh.outgoing[v] < 0)
            {
                index[v] = -1;
                continue;
            }
            slots[count] = v;
            index[v] = count++;
        }
        return (index, slots[..count]);
    }

    // Some half-edge of the triangulation that leaves each vertex; flips have taken away those of the mesh.
    private static int[] Outgoing(IntrinsicDelaunay triangulation, int vertexSlots)
    {
        var outgoing = new int[vertexSlots];
        Array.Fill(outgoing, -1);
        for (int h = 0; h < triangulation.Next.Length; h++)
        {
            if (triangulation.Next[h] >= 0)
                outgoing[triangulation.Target[h ^ 1]] = h;
        }
        return outgoing;
    }

    private static double[] Masses(IntrinsicDelaunay triangulation, int vertexSlots)
    {
        var mass = new double[vertexSlots];
        foreach (int h in triangulation.HalfEdgeOf)
        {
            if (h < 0)
                continue;
            (Vector3D first, Vector3D second) = triangulation.Unfold(h);
            double third = Vector3D.Cross(first, second).Length / 6;
            mass[triangulation.Target[h]] += third;
            mass[triangulation.Target[triangulation.Next[h]]] += third;
            mass[triangulation.Target[h ^ 1]] += third;
        }
        return mass;
    }

    private static double MeanEdgeLength(Mesh mesh)
    {
        int[] next = mesh.next, target = mesh.target;
        Vector3D[] position = mesh.positions;
        double sum = Parallelism.SumBlocks(mesh.EdgeSlots, (from, to) =>
        {
            double partial = 0;
            for (int e = from; e < to; e++)
            {
                if (next[2 * e] >= 0)
                    partial += Vector3D.Distance(position[target[2 * e]], position[target[2 * e + 1]]);
            }
            return partial;
        });
        return sum / Math.Max(1, mesh.Edges.Count);
    }

    // A vertex with faces without area only has neither mass nor stiffness; it gets any value, and in the end NaN.
    private static void FillEmptyRows(SparseMatrix matrix)
    {
        foreach (ref double d in matrix.Diagonal)
            d = d == 0 ? 1 : d;
    }

    private static void PinComponents(SparseMatrix laplacian, int[] slots, int[] component)
    {
        Span<double> diagonal = laplacian.Diagonal;
        for (int i = 0; i < slots.Length; i++)
        {
            if (component[slots[i]] == slots[i])
                diagonal[i] *= 2;
        }
    }

    // Per half-edge what flows into its source within its face, along X = −∇u/|∇u|: −½ (cot θ₁ (e₁·X) + cot θ₂ (e₂·X)).
    private double[] FluxOfFlow(double[] u)
    {
        var flux = new double[mesh.HalfEdgeSlots];
        if (intrinsic is null)
            Parallelism.ForBlocks(mesh.FaceSlots, (from, to) => FillFlux(new InSpace(mesh), index, cotangent, u, flux, from, to));
        else
            Parallelism.ForBlocks(mesh.FaceSlots, (from, to) => FillFlux(new Unfolded(intrinsic), index, cotangent, u, flux, from, to));
        return flux;
    }

    // With N the (long) normal, ∇u is a multiple of N × ((u₂ − u₀)(p₁ − p₀) − (u₁ − u₀)(p₂ − p₀)).
    private static void FillFlux<TTriangles>(TTriangles triangles, int[] index, double[] cotangent, double[] u, double[] flux, int from, int to)
        where TTriangles : struct, ITriangles
    {
        int[] next = triangles.Next, target = triangles.Target, halfEdgeOf = triangles.HalfEdgeOf;
        for (int f = from; f < to; f++)
        {
            int h0 = halfEdgeOf[f];
            if (h0 < 0)
                continue;
            int h1 = next[h0], h2 = next[h1], v0 = target[h0], v1 = target[h1], v2 = target[h2];
            double u0 = u[index[v0]], d1 = u[index[v1]] - u0, d2 = u[index[v2]] - u0, largest = Math.Max(Math.Abs(d1), Math.Abs(d2));
            if (!(largest > 0))
                continue;
            (Vector3D e1, Vector3D e2) = triangles.Vectors(h1, v0, v1, v2);
            Vector3D e0 = -(e1 + e2);
            // Only the direction counts: dividing first keeps tiny and huge temperatures from under- and overflowing.
            Vector3D gradient = Vector3D.Cross(Vector3D.Cross(e0, e1), (d2 / largest) * e1 + (d1 / largest) * e0), x = gradient.Normalized();
            double along0 = 0.5 * cotangent[h0] * Vector3D.Dot(e0, x), along1 = 0.5 * cotangent[h1] * Vector3D.Dot(e1, x), along2 = 0.5 * cotangent[h2] * Vector3D.Dot(e2, x);
            flux[h1] = along1 - along0;
            flux[h2] = along2 - along1;
            flux[h0] = along0 - along2;
        }
    }

    // −∇·X, integrated over each vertex's cell.
    private double[] Divergence(double[] flux)
    {
        var divergence = new double[slots.Length];
        Parallelism.ForBlocks(slots.Length, (from, to) => Gather(next, outgoing, slots, flux, divergence, from, to));
        return divergence;
    }

    private static void Gather(int[] next, int[] outgoing, int[] slots, double[] flux, double[] divergence, int from, int to)
    {
        for (int i = from; i < to; i++)
        {
            int first = outgoing[slots[i]], h = first;
            double sum = 0;
            do
            {
                sum += flux[h];
                h = next[h ^ 1];
            }
            while (h != first);
            divergence[i] = sum;
        }
    }

    // In every component the mean over its sources becomes 0.
    private double[] Shift(double[] phi, ReadOnlySpan<Vertex> sources)
    {
        var sum = new Dictionary<int, (double Sum, int Count)>();
        var distance = new double[mesh.VertexSlots];
        Array.Fill(distance, double.NaN);
        foreach (Vertex source in sources)
        {
            int v = source.Index;
            if (index[v] < 0)
                continue;
            (double before, int count) = sum.GetValueOrDefault(component[v]);
            sum[component[v]] = (before + phi[index[v]], count + 1);
        }
        int last = -1;
        double shift = double.PositiveInfinity;
        for (int i = 0; i < slots.Length; i++)
        {
            int v = slots[i];
            if (component[v] != last)
            {
                last = component[v];
                shift = sum.TryGetValue(last, out (double Sum, int Count) s) ? s.Sum / s.Count : double.NegativeInfinity;
            }
            distance[v] = mass[v] > 0 ? phi[i] - shift : double.NaN;
        }
        foreach (Vertex source in sources)
        {
            if (double.IsNaN(distance[source.Index]))
                distance[source.Index] = 0;
        }
        return distance;
    }

    /// <summary>Triangles to work on; the vectors are those of a half-edge and the next one, in space or unfolded.</summary>
    private interface ITriangles
    {
        int[] Next { get; }

        int[] Target { get; }

        int[] HalfEdgeOf { get; }

        (Vector3D First, Vector3D Second) Vectors(int halfEdge, int from, int middle, int to);
    }

    private readonly struct InSpace(Mesh mesh) : ITriangles
    {
        private readonly Vector3D[] position = mesh.positions;

        public int[] Next => mesh.next;

        public int[] Target => mesh.target;

        public int[] HalfEdgeOf => mesh.halfEdgeOf;

        public (Vector3D First, Vector3D Second) Vectors(int halfEdge, int from, int middle, int to) =>
            (position[middle] - position[from], position[to] - position[middle]);
    }

    private readonly struct Unfolded(IntrinsicDelaunay triangulation) : ITriangles
    {
        public int[] Next => triangulation.Next;

        public int[] Target => triangulation.Target;

        public int[] HalfEdgeOf => triangulation.HalfEdgeOf;

        public (Vector3D First, Vector3D Second) Vectors(int halfEdge, int from, int middle, int to) => triangulation.Unfold(halfEdge);
    }
}
