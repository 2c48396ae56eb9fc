using MeshLab.Structure;

namespace MeshLab.Subdivision;

/// <summary>What all schemes share: checks, the budget, the steps, the traits.</summary>
internal static class Stepper
{
    /// <summary>One step of a scheme: the new mesh with positions, without traits.</summary>
    public delegate Mesh Step(Mesh mesh, int number);

    public static Mesh Run(
        Mesh mesh,
        SubdivisionOptions? options,
        Func<MeshSize, int, MeshSize> grow,
        Func<Mesh, int, CancellationToken, Mesh> step,
        Action<Mesh, Mesh> traits,
        IProgress<double>? progress,
        CancellationToken cancellationToken)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        options ??= SubdivisionOptions.Default;
        MeshSize size = MeshSize.Of(mesh), total = default;
        for (int number = 0; number < options.Steps; number++)
        {
            size = grow(size, number);
            // Every step is checked: numbers that pass here cannot overflow in the next.
            size.Check(options, number + 1);
            total = total with { Faces = total.Faces + size.Faces };
        }

        Mesh result = Compacted(mesh);
        var trace = StepTrace.Into(options.Trace);
        double done = 0;
        for (int number = 0; number < options.Steps; number++)
        {
            cancellationToken.ThrowIfCancellationRequested();
            Mesh finer = step(result, number, cancellationToken);
            traits(result, finer);
            result = finer;
            trace?.Remake("subdivide", finer);
            done += finer.Faces.Count;
            progress?.Report(Math.Min(1, done / Math.Max(1, total.Faces)));
        }
        return ReferenceEquals(result, mesh) ? mesh.Clone() : result;
    }

    /// <summary>The mesh itself, or a copy without the slots of deleted elements.</summary>
    public static Mesh Compacted(Mesh mesh)
    {
        if (mesh.IsCompact)
            return mesh;
        Mesh copy = mesh.Clone();
        copy.Compact();
        return copy;
    }

    public static void RequireTriangles(Mesh mesh)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        if (mesh.IsTriangleMesh)
            return;
        Face polygon = mesh.Faces.First(f => !f.IsTriangle);
        throw new ArgumentException($"{polygon} has {polygon.Degree} vertices; this scheme takes triangles only.", nameof(mesh));
    }
}
