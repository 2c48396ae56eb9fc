using MeshLab.Structure;

namespace MeshLab.Subdivision;

/// <summary>What all schemes share: checks, the budget, the steps, the traits.</summary>
internal static class Stepper
{
    /// <summary>Where the vertices of a scheme's mesh end up.</summary>
    public delegate LimitPoints Limit(Mesh mesh, IProgress<double>? progress, CancellationToken cancellationToken);

    public static Mesh Run(
        Mesh mesh,
        SubdivisionOptions? options,
        Func<MeshSize, int, MeshSize> grow,
        Func<Mesh, int, CancellationToken, Mesh> step,
        Action<Mesh, Mesh> traits,
        Limit? limit,
        IProgress<double>? progress,
        CancellationToken cancellationToken)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        options ??= SubdivisionOptions.Default;
        if (options.ToLimit && limit is null)
            throw new ArgumentException($"{nameof(SubdivisionOptions.ToLimit)}: the limit is known for Loop's and for Catmull and Clark's scheme.", nameof(options));
        MeshSize size = MeshSize.Of(mesh), total = default;
        for (int number = 0; number < options.Steps; number++)
        {
            size = grow(size, number);
            // Every step is checked: numbers that pass here cannot overflow in the next.
            size.Check(options, number + 1);
            total = total with { Faces = total.Faces + size.Faces };
        }

        // Moving to the limit counts as one more pass over the last mesh.
        double work = Math.Max(1, total.Faces + (options.ToLimit ? size.Faces : 0));
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
            progress?.Report(Math.Min(1, done / work));
        }
        if (ReferenceEquals(result, mesh))
            result = mesh.Clone();
        if (options.ToLimit)
        {
            IProgress<double>? rest = progress is null ? null : new PartOfProgress(progress, Math.Min(1, done / work));
            limit!(result, rest, cancellationToken).Positions.CopyTo(result.Positions);
            trace?.Move("limit", result.Positions);
            progress?.Report(1);
        }
        return result;
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

    /// <summary>The progress of the last part of a work: from where the others ended on to 1.</summary>
    private sealed class PartOfProgress(IProgress<double> all, double from) : IProgress<double>
    {
        public void Report(double value) => all.Report(from + (1 - from) * value);
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
