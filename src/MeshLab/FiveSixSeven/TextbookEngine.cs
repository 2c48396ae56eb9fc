using MeshLab.Geometry;
using MeshLab.Structure;

namespace MeshLab.FiveSixSeven;

/// <summary>§9.2–9.6 one after the other, then the number of faces and the shape as in the default engine.</summary>
internal static class TextbookEngine
{
    public static FiveSixSevenResult Run(
        Mesh input, IReadOnlyDictionary<int, int> before, int target, FiveSixSevenOptions options, IProgress<double>? progress, CancellationToken cancellationToken)
    {
        var frame = UnitFrame.Of(input);
        Mesh mesh = frame.ToUnit(input);
        WorkMesh original = WorkMesh.From(mesh);
        InputSurface surface = FiveSixSevenMeshing.SurfaceOf(original, options);
        MarkCreases(mesh, original);

        var trace = StepTrace.Into(options.Trace, frame.FromUnit);
        using (OperationTrace.Of(mesh, trace))
        {
            mesh.RaiseValenceThree(null, cancellationToken);
            mesh.RaiseValenceFour(null, cancellationToken);
        }
        mesh = mesh.SplitFacesIntoNine(null, cancellationToken);
        trace?.Remake("nineSplit", mesh);
        using (OperationTrace.Of(mesh, trace))
        {
            mesh.LowerHighValences(null, cancellationToken);
            progress?.Report(0.2);
            mesh.SimplifyKeepingValences(target, null, cancellationToken);
        }
        mesh.Compact();
        trace?.Remake("compact", mesh);
        progress?.Report(0.5);

        WorkMesh work = WorkMesh.From(mesh);
        work.Trace = trace;
        TakeCreases(mesh, work);
        FiveSixSevenMeshing.Tools tools = FiveSixSevenMeshing.ToolsFor(work, surface, target, cancellationToken);
        FiveSixSevenMeshing.ApproachCount(tools, target, cancellationToken);
        if (options.ImproveShape)
            FiveSixSevenMeshing.ImproveShape(tools, target, progress);
        return FiveSixSevenMeshing.Finish(work, frame, input, before, target, tools.Walk.Walks, 0, false);
    }

    private static void MarkCreases(Mesh mesh, WorkMesh original)
    {
        EdgeTrait<int> crease = ValenceSimplification.AddCreaseTrait(mesh);
        foreach (Edge e in mesh.Edges)
            crease[e] = original.Crease[e.Index];
    }

    /// <summary>Lines as they are now; where they end or meet, and where the boundary turns, is a corner.</summary>
    private static void TakeCreases(Mesh mesh, WorkMesh work)
    {
        mesh.TryGetEdgeTrait(ValenceSimplification.CreaseTrait, out EdgeTrait<int>? crease);
        var lines = new int[work.VertexSlots];
        foreach (Edge e in mesh.Edges)
        {
            if (crease![e] == 0 && !e.IsBoundary)
                continue;
            work.Crease[e.Index] = 1;
            lines[e.Vertex0.Index]++;
            lines[e.Vertex1.Index]++;
        }
        Creases.SetKinds(work, lines);
    }
}
