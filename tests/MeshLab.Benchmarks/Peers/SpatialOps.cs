using MeshLab.Numerics;
using MeshLab.Spatial;

namespace MeshLab.Benchmarks.Peers;

internal static class SpatialOps
{
    [PeerOp("aabb-build")]
    public static void Build(PeerRun run) => run.Measure(
        () => run.Model.NewMesh(),
        mesh => FaceTree.Build(mesh),
        (_, tree, result) => result.Add("primitives", tree.TriangleCount));

    [PeerOp("closest-point-10k")]
    public static void ClosestPoints(PeerRun run)
    {
        FaceTree tree = FaceTree.Build(run.Model.NewMesh());
        Vector3D[] queries = Queries(run.Model);
        run.Measure(
            () => new ClosestPoint[queries.Length],
            found =>
            {
                tree.FindClosest(queries, found);
                return found;
            },
            (_, found, result) => result.Add("mean_distance", found.Average(p => p.Distance)));
    }

    [PeerOp("self-intersections")]
    public static void SelfIntersections(PeerRun run) => run.Measure(
        () => run.Model.NewMesh(),
        // The tree is part of the work, as in the other libraries.
        mesh => FaceTree.Build(mesh).FindSelfIntersections(),
        (_, pairs, result) => result.Add("pairs", pairs.Length));

    // The same 10,000 points in every library: a cube of the diagonal's length around the middle (xorshift64).
    private static Vector3D[] Queries(PeerModel model)
    {
        Vector3D center = model.BoxCenter;
        double size = model.Diagonal;
        ulong state = 88172645463325252;
        var queries = new Vector3D[10_000];
        for (int i = 0; i < queries.Length; i++)
        {
            double x = Next(), y = Next(), z = Next();
            queries[i] = center + new Vector3D(x, y, z) * size;
        }
        return queries;

        double Next()
        {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            return (state >> 11) / 9007199254740992.0 - 0.5;
        }
    }
}
