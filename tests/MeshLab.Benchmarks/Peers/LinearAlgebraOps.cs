using MeshLab.Geodesics;
using MeshLab.LinearAlgebra;
using MeshLab.Numerics;
using MeshLab.Smoothing;
using MeshLab.Structure;

namespace MeshLab.Benchmarks.Peers;

internal static class LinearAlgebraOps
{
    // 0 at the first vertex, 1 at the one farthest from it: assembly, factorization, solution.
    [PeerOp("harmonic")]
    public static void Harmonic(PeerRun run)
    {
        Mesh mesh = run.Model.NewMesh();
        Vertex[] ends = [mesh.Vertices[0], Farthest(mesh)];
        run.Measure(() => mesh, m => new DirichletProblem(m, ends).Solve(0, 1), (m, u, result) => Check(m, ends, u, result));
    }

    [PeerOp("harmonic-solve")]
    public static void HarmonicSolve(PeerRun run)
    {
        Mesh mesh = run.Model.NewMesh();
        Vertex[] ends = [mesh.Vertices[0], Farthest(mesh)];
        var problem = new DirichletProblem(mesh, ends);
        run.Measure(() => problem, p => p.Solve(0, 1), (_, u, result) => Check(mesh, ends, u, result));
    }

    [PeerOp("smooth-implicit")]
    public static void SmoothImplicit(PeerRun run) => run.Measure(
        run.Model.NewMesh,
        mesh =>
        {
            mesh.SmoothImplicitly(new ImplicitSmoothingOptions { Boundary = SmoothingBoundary.Free });
            return mesh;
        },
        (_, mesh, result) => result.Measure(mesh));

    [PeerOp("heat-geodesic")]
    public static void HeatGeodesic(PeerRun run)
    {
        Mesh mesh = run.Model.NewMesh();
        run.Measure(
            () => mesh,
            // The peers work on the triangles as they are.
            m => new HeatGeodesics(m, new HeatOptions { IntrinsicDelaunay = false }).ComputeDistances(m.Vertices[0]),
            (_, d, result) => result.Add("mean", d.Average()).Add("max", d.Max()));
    }

    private static Vertex Farthest(Mesh mesh)
    {
        Vector3D from = mesh.Positions[0];
        int farthest = 0;
        for (int v = 1; v < mesh.VertexSlots; v++)
        {
            if (Vector3D.DistanceSquared(mesh.Positions[v], from) > Vector3D.DistanceSquared(mesh.Positions[farthest], from))
                farthest = v;
        }
        return mesh.Vertices[farthest];
    }

    private static void Check(Mesh mesh, Vertex[] ends, double[] u, PeerResult result)
    {
        bool IsFree(int v) => v != ends[0].Index && v != ends[1].Index;
        double[] residual = mesh.ComputeLaplacian().Multiply(u), right = new double[u.Length];
        right[ends[1].Index] = 1;
        right = mesh.ComputeLaplacian().Multiply(right);
        int[] free = [.. Enumerable.Range(0, u.Length).Where(IsFree)];
        result.Add("mean", free.Average(v => u[v])).Add("min", free.Min(v => u[v])).Add("max", free.Max(v => u[v]))
            .Add("residual", Math.Sqrt(free.Sum(v => residual[v] * residual[v]) / free.Sum(v => right[v] * right[v])));
    }
}
