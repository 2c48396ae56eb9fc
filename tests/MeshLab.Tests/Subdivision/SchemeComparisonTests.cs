using MeshLab.Generation;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Subdivision;
using Xunit;

namespace MeshLab.Tests.Subdivision;

[Trait("Section", "8.4")]
public class SchemeComparisonTests
{
    [Fact]
    public void Compare_OfAnIcosahedron_ShowsWhatTheSchemesAreLike()
    {
        Mesh mesh = Polyhedra.Icosahedron();

        IReadOnlyList<SchemeResult> results = SchemeComparison.Compare(mesh, 3);

        Assert.Equal([SubdivisionScheme.Loop, SubdivisionScheme.ModifiedButterfly, SubdivisionScheme.Sqrt3], results.Select(r => r.Scheme));
        Assert.Equal([1280, 1280, 540], results.Select(r => r.Mesh.Faces.Count));
        (SchemeResult loop, SchemeResult butterfly, SchemeResult sqrt3) = (results[0], results[1], results[2]);
        // Approximating schemes shrink, interpolating ones do not.
        double volume = MeshLab.Tests.Generation.Measure.Volume(mesh);
        Assert.True(loop.Volume < volume && sqrt3.Volume < volume && butterfly.Volume > volume);
        Assert.Equal(MeshLab.Tests.Generation.Measure.Volume(loop.Mesh), loop.Volume, 1e-12);
        Assert.Equal(MeshLab.Tests.Generation.Measure.Area(loop.Mesh), loop.Area, 1e-12);
        Assert.Equal(0, butterfly.DistanceToLimit);
        Assert.InRange(loop.DistanceToLimit, 1e-6, 0.02);
        Assert.InRange(sqrt3.DistanceToLimit, 1e-6, 0.02);
        Assert.True(loop.Shrinkage > loop.DistanceToLimit && butterfly.Shrinkage == 0);
        Assert.True(loop.Bend < butterfly.Bend);
    }

    [Fact]
    public void Compare_Sqrt3Limit_IsWhereTenStepsLead()
    {
        Mesh mesh = Polyhedra.Icosahedron();
        SchemeResult before = SchemeComparison.Compare(mesh, 0, SubdivisionScheme.Sqrt3)[0], after = SchemeComparison.Compare(mesh, 7, SubdivisionScheme.Sqrt3)[0];
        double moved = Enumerable.Range(0, 12).Max(v => Vector3D.Distance(mesh.Positions[v], after.Mesh.Positions[v]));

        Assert.Equal(before.Shrinkage, moved, 1e-3);
    }

    [Fact]
    public void Compare_ProgressAndCancellation_ByScheme()
    {
        var told = new List<double>();
        using var source = new CancellationTokenSource();
        Mesh mesh = Polyhedra.Icosahedron();
        SubdivisionScheme[] schemes = [SubdivisionScheme.Loop, SubdivisionScheme.Midpoint, SubdivisionScheme.DooSabin, SubdivisionScheme.Sqrt3];
        Assert.Equal(schemes, SchemeComparison.Compare(mesh, 1, schemes, new Teller(told.Add)).Select(r => r.Scheme));
        Assert.Equal([0.25, 0.5, 0.75, 1], told);
        var stop = new Teller(share =>
        {
            if (share >= 0.5)
                source.Cancel();
        });
        Assert.Throws<OperationCanceledException>(() => SchemeComparison.Compare(mesh, 1, schemes, stop, source.Token));
    }

    private sealed class Teller(Action<double> tell) : IProgress<double>
    {
        public void Report(double value) => tell(value);
    }

    [Fact]
    public void Compare_OfQuads_TakesThePolygonSchemes()
    {
        IReadOnlyList<SchemeResult> results = SchemeComparison.Compare(Polyhedra.Cube(), 2, SubdivisionScheme.CatmullClark, SubdivisionScheme.DooSabin);

        Assert.True(double.IsNaN(results[1].DistanceToLimit));
        Assert.True(results[0].DistanceToLimit > 0);
        Assert.Throws<ArgumentException>(() => SchemeComparison.Compare(Polyhedra.Cube()));
        Assert.Throws<ArgumentOutOfRangeException>(() => SchemeComparison.Compare(Polyhedra.Cube(), -1));
    }
}
