namespace MeshLab.FiveSixSeven;

/// <summary>Where four times as many faces are asked for, every face is cut into four: old vertices keep their valences, new ones have 6 (4 on the boundary), so Φ stays.</summary>
/// <remarks>By local operations, as in the second laboratory: every edge is split, then every edge between an old and a new vertex that is no half of one is flipped.</remarks>
internal static class Refinement
{
    /// <summary>Cuts into four as long as that is not too many.</summary>
    public static void TowardsCount(Guard guard, int target, CancellationToken cancellationToken)
    {
        while (4L * guard.Mesh.LiveFaces <= target)
        {
            cancellationToken.ThrowIfCancellationRequested();
            CutIntoFour(guard);
        }
    }

    private static void CutIntoFour(Guard guard)
    {
        WorkMesh mesh = guard.Mesh;
        int edges = mesh.EdgeSlots, vertices = mesh.VertexSlots;
        var isHalf = new List<bool>(3 * edges);
        for (int e = 0; e < edges; e++)
        {
            if (!mesh.IsLiveEdge(e))
                continue;
            isHalf.Add(true);
            mesh.Split(2 * e, guard.SplitPosition(2 * e));
            // The first new edge is the other half, the rest cut the faces.
            while (edges + isHalf.Count < mesh.EdgeSlots)
                isHalf.Add(false);
        }
        for (int e = edges; e < mesh.EdgeSlots; e++)
        {
            int a = mesh.Target[2 * e], b = mesh.Target[2 * e + 1];
            if (!isHalf[e - edges] && (a < vertices) != (b < vertices))
                mesh.Flip(2 * e);
        }
        // Vertices stand for the planes of the finer faces from here on.
        mesh.GatherQuadrics();
    }
}
