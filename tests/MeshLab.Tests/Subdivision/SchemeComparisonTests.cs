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

    /// <summary>On the icosahedron a vertex and the middle of its neighbours stay on their axis: iterating the rules for both leads to the limit.</summary>
    [Fact]
    public void Compare_Sqrt3Limit_IsTheFixedPointOfItsRules()
    {
        Mesh mesh = Polyhedra.Icosahedron();
        Vertex vertex = mesh.Vertices[0];
        double alpha = (4 - 2 * Math.Cos(2 * Math.PI / 5)) / 9, start = vertex.Position.Length, v = start;
        double m = vertex.Neighbors.Average(w => Vector3D.Dot(w.Position, vertex.Position) / start);
        for (int i = 0; i < 200; i++)
            (v, m) = ((1 - alpha) * v + alpha * m, (v + 2 * m) / 3);

        SchemeResult result = SchemeComparison.Compare(mesh, 0, SubdivisionScheme.Sqrt3)[0];

        Assert.Equal(start - v, result.Shrinkage, 1e-13);
        Assert.Equal(start - v, result.DistanceToLimit, 1e-13);
    }

    /// <summary>Twelve right angles and six flat edges on a cube: the root of the mean of their squares.</summary>
    [Fact]
    public void Compare_Bend_IsTheRootMeanSquareAngle() =>
        Assert.Equal(Math.PI / 2 * Math.Sqrt(12.0 / 18), SchemeComparison.Compare(Models.Create("cube"), 0, SubdivisionScheme.Midpoint)[0].Bend, 1e-14);

    /// <summary>The limit of the border of a sheet does not count: the border is another curve.</summary>
    [Fact]
    public void Compare_Border_DoesNotCount()
    {
        Mesh mesh = Remeshing.RemeshSurfaces.Sheet(6, 1, 0);
        foreach (Vertex v in mesh.Vertices)
            v.Position += new Vector3D(0, 0, v.IsBoundary ? v.Index % 3 : 0.5);
        foreach (Vertex v in mesh.Vertices.Where(v => !v.IsBoundary && v.Neighbors.Any(w => w.IsBoundary)))
            Assert.Equal(0.5, v.Position.Z);
        SchemeResult result = SchemeComparison.Compare(mesh, 0, SubdivisionScheme.Loop)[0];
        Vector3D[] limit = LimitSurface.OfLoop(mesh).Positions;
        double expected = mesh.Vertices.Where(v => !v.IsBoundary).Max(v => Vector3D.Distance(v.Position, limit[v.Index]));
        Assert.Equal(expected, result.Shrinkage, 1e-15);
        Assert.True(mesh.Vertices.Max(v => Vector3D.Distance(v.Position, limit[v.Index])) > 1.1 * expected);
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
