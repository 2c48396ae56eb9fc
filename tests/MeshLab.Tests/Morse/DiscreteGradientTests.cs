using MeshLab.Morse;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Morse;

[Trait("Section", "12.4")]
public class DiscreteGradientTests
{
    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void Of_AnyFunction_IsAnAcyclicMatchingThatAgreesWithTheCriticalPoints(string model)
    {
        Mesh mesh = Models.Create(model);
        foreach (MorseFunction function in (MorseFunction[])[MorseCase.Height(mesh), MorseCase.Noise(mesh, 4), MorseCase.Constant(mesh)])
        {
            DiscreteGradient gradient = DiscreteGradient.Of(function);
            CheckMatching(gradient);
            CheckAcyclic(gradient);
            CheckAgreement(gradient, CriticalPoints.Of(function));
        }
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void Of_HeightOfPublicModels_AgreesWithTheCriticalPoints(string model)
    {
        ReferenceData.SkipIfMissing();
        MorseFunction function = MorseCase.Height(ReferenceData.Load(model));
        DiscreteGradient gradient = DiscreteGradient.Of(function);
        CheckMatching(gradient);
        CheckAgreement(gradient, CriticalPoints.Of(function));
    }

    [Theory]
    [InlineData("torus", 1, 2, 1)]
    [InlineData("genus-2", 1, 4, 1)]
    [InlineData("bumpy-sphere", 1, 0, 1)]
    [InlineData("annulus", 1, 1, 0)]
    [InlineData("grid", 1, 0, 0)]
    public void Cancel_WithoutLimit_LeavesTheLeastPossible(string model, int minima, int saddles, int maxima)
    {
        MorseFunction function = MorseCase.Noise(Models.Create(model), 5);

        CancellationResult result = GradientCancellation.Cancel(DiscreteGradient.Of(function), double.PositiveInfinity);

        Assert.Equal((minima, saddles, maxima), (result.Gradient.MinimumCount, result.Gradient.SaddleCount, result.Gradient.MaximumCount));
        Assert.Equal(0, result.Stuck);
        CheckMatching(result.Gradient);
        CheckAcyclic(result.Gradient);
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void Cancel_ToAThreshold_LeavesExactlyThePairsAboveIt(string model)
    {
        Mesh mesh = Models.Create(model);
        foreach (MorseFunction function in (MorseFunction[])[MorseCase.Height(mesh), MorseCase.Noise(mesh, 6)])
            CheckCancellation(function, 0.3 * MorseCase.Range(function));
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void Cancel_HeightOfPublicModels_LeavesExactlyThePairsAboveTheThreshold(string model)
    {
        ReferenceData.SkipIfMissing();
        Mesh mesh = ReferenceData.Load(model);
        MorseFunction function = MorseCase.Height(mesh);
        CheckCancellation(function, 0.01 * MorseCase.Range(function));

        DiscreteGradient least = GradientCancellation.Cancel(DiscreteGradient.Of(function), double.PositiveInfinity).Gradient;
        PersistencePairs pairs = PersistencePairs.Of(function);
        Assert.Equal(
            (pairs.EssentialMinima.Count, pairs.EssentialSaddles.Count, pairs.EssentialMaxima.Count),
            (least.MinimumCount, least.SaddleCount, least.MaximumCount));
    }

    [Fact]
    public void Cancel_NegativeThreshold_IsRefused()
    {
        DiscreteGradient gradient = DiscreteGradient.Of(MorseCase.Height(Models.Create("torus")));
        Assert.Throws<ArgumentOutOfRangeException>(() => GradientCancellation.Cancel(gradient, -1));
        Assert.Throws<ArgumentOutOfRangeException>(() => GradientCancellation.Cancel(gradient, double.NaN));
    }

    [Fact]
    public void Cancel_GivenGradient_IsNotChanged()
    {
        DiscreteGradient gradient = DiscreteGradient.Of(MorseCase.Noise(Models.Create("torus"), 7));
        (int, int, int) before = (gradient.MinimumCount, gradient.SaddleCount, gradient.MaximumCount);

        GradientCancellation.Cancel(gradient, double.PositiveInfinity);

        Assert.Equal(before, (gradient.MinimumCount, gradient.SaddleCount, gradient.MaximumCount));
    }

    private static void CheckCancellation(MorseFunction function, double threshold)
    {
        PersistencePairs pairs = PersistencePairs.Of(function);
        CancellationResult result = GradientCancellation.Cancel(DiscreteGradient.Of(function), threshold);
        int minima = pairs.Pairs.Count(p => p.Kind == PairKind.MinimumSaddle && p.Persistence <= threshold);
        int maxima = pairs.Pairs.Count(p => p.Kind == PairKind.SaddleMaximum && p.Persistence <= threshold);

        Assert.Equal((minima, maxima, 0), (result.CancelledMinima, result.CancelledMaxima, result.Stuck));
        Assert.Equal(pairs.Critical.SaddleCount - minima - maxima, result.Gradient.SaddleCount);
        Assert.Equal(pairs.Critical.EulerCharacteristic, result.Gradient.MinimumCount - result.Gradient.SaddleCount + result.Gradient.MaximumCount);
        HashSet<int> kept = [.. pairs.EssentialMinima.Select(v => v.Index), .. pairs.Pairs.Where(p => p.Kind == PairKind.MinimumSaddle && p.Persistence > threshold).Select(p => p.Birth.Index)];
        for (int v = 0; v < result.Gradient.VertexArrow.Length; v++)
            Assert.Equal(kept.Contains(v), result.Gradient.VertexArrow[v] == -1);
        CheckMatching(result.Gradient);
    }

    /// <summary>Every cell is in exactly one pair or critical, and every arrow belongs to its cell.</summary>
    private static void CheckMatching(DiscreteGradient gradient)
    {
        Mesh mesh = gradient.Function.Mesh;
        var uses = new int[mesh.EdgeSlots];
        foreach (Vertex v in mesh.Vertices)
        {
            int arrow = gradient.VertexArrow[v.Index];
            if (arrow < 0)
                continue;
            Assert.Equal(v, mesh.HalfEdges[arrow].Source);
            uses[arrow >> 1]++;
        }
        foreach (Face f in mesh.Faces)
        {
            int arrow = gradient.FaceArrow[f.Index];
            Assert.NotEqual(-2, arrow);
            if (arrow < 0)
                continue;
            Assert.Equal(f, mesh.HalfEdges[arrow].Face);
            uses[arrow >> 1]++;
        }
        foreach (Edge e in mesh.Edges)
            Assert.Equal(1, uses[e.Index] + (gradient.IsCriticalEdge[e.Index] ? 1 : 0));
    }

    /// <summary>No walk along the arrows comes back.</summary>
    private static void CheckAcyclic(DiscreteGradient gradient)
    {
        Mesh mesh = gradient.Function.Mesh;
        foreach (Vertex v in mesh.Vertices)
        {
            int steps = 0;
            for (int x = v.Index; gradient.VertexArrow[x] >= 0; x = mesh.Target[gradient.VertexArrow[x]])
                Assert.True(++steps <= mesh.VertexSlots, $"{v} flows in a circle");
        }
        foreach (Face f in mesh.Faces)
        {
            int steps = 0;
            for (int x = f.Index; x >= 0 && gradient.FaceArrow[x] >= 0; x = mesh.FaceOf[gradient.FaceArrow[x] ^ 1])
                Assert.True(++steps <= mesh.FaceSlots, $"{f} flows in a circle");
        }
    }

    private static void CheckAgreement(DiscreteGradient gradient, CriticalPoints critical)
    {
        Mesh mesh = gradient.Function.Mesh;
        var saddles = new int[mesh.VertexSlots];
        foreach (Edge e in gradient.CriticalEdges)
            saddles[gradient.HighestOfEdge(e.Index)]++;
        var maxima = new int[mesh.VertexSlots];
        foreach (Face f in mesh.Faces)
        {
            if (gradient.FaceArrow[f.Index] == -1)
                maxima[gradient.HighestOfFace(f.Index)]++;
        }
        foreach (Vertex v in mesh.Vertices)
        {
            CriticalKind kind = critical.KindOf(v);
            Assert.Equal(kind == CriticalKind.Minimum, gradient.VertexArrow[v.Index] == -1);
            Assert.Equal(kind == CriticalKind.Saddle ? critical.MultiplicityOf(v) : 0, saddles[v.Index]);
            Assert.Equal(kind == CriticalKind.Maximum ? 1 : 0, maxima[v.Index]);
        }
    }
}
