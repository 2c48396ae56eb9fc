using MeshLab.Simplification;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Simplification;

/// <summary>Runs alone: the memory of other tests must not be counted.</summary>
[CollectionDefinition(nameof(MemoryOfSimplification), DisableParallelization = true)]
public sealed class MemoryOfSimplification;

[Collection(nameof(MemoryOfSimplification))]
[Trait("Section", "7.2")]
[Trait("Speed", "Slow")]
public class SimplificationMemoryTests
{
    /// <summary>Bytes of the columns: four numbers per half-edge, a number and a position per vertex, a number per face.</summary>
    private static long BytesOf(Mesh mesh) => 16L * mesh.HalfEdgeSlots + 28L * mesh.VertexSlots + 4L * mesh.FaceSlots;

    /// <summary>What was in use when the collector last looked, which it does now.</summary>
    private static long LiveBytes()
    {
        GC.Collect();
        GCMemoryInfo info = GC.GetGCMemoryInfo(GCKind.FullBlocking);
        return info.HeapSizeBytes - info.FragmentedBytes;
    }

    [Theory]
    [InlineData(QuadricMode.Fast, 0.1, 2.3)]
    [InlineData(QuadricMode.Fast, 0.5, 2.3)]
    [InlineData(QuadricMode.Accurate, 0.1, 3)]
    [InlineData(QuadricMode.Accurate, 0.5, 3)]
    public void Simplify_NeedsAtMostSoManyTimesTheMemoryOfTheMesh(QuadricMode mode, double ratio, double most)
    {
        Mesh mesh = Shapes.Torus(300, 150);
        mesh.Clone().Simplify(new() { Mode = mode, TargetRatio = ratio });

        // What the test runner does meanwhile is counted too, so the least of a few tries is closest to the truth.
        double least = double.PositiveInfinity;
        for (int attempt = 0; attempt < 4 && least > most; attempt++)
            least = Math.Min(least, PeakBytes(mesh.Clone(), new() { Mode = mode, TargetRatio = ratio }) / (double)BytesOf(mesh));

        Assert.InRange(least, 0.5, most);
    }

    private static long PeakBytes(Mesh mesh, QuadricOptions options)
    {
        // What earlier tests left for the finalizers would go during the measurement.
        GC.Collect();
        GC.WaitForPendingFinalizers();
        var sampler = new Sampler(LiveBytes());
        mesh.Simplify(options, sampler);
        Assert.True(sampler.Samples >= 5, $"{sampler.Samples} samples");
        Assert.Empty(mesh.Validate());
        return sampler.Peak;
    }

    /// <summary>Looks at the memory whenever the work has come a fiftieth further: on the working thread, so the work waits.</summary>
    private sealed class Sampler(long before) : IProgress<double>
    {
        private double next;

        public long Peak { get; private set; }

        public int Samples { get; private set; }

        public void Report(double value)
        {
            if (value < next)
                return;
            next = value + 0.02;
            Samples++;
            Peak = Math.Max(Peak, LiveBytes() - before);
        }
    }
}
