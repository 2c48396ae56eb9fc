using MeshLab.Morse;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Morse;

[Trait("Section", "12.4")]
public class MorseComplexTests
{
    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void Of_AnyFunction_ArcsFollowTheFunctionAndNeverCross(string model)
    {
        Mesh mesh = Models.Create(model);
        foreach (MorseFunction function in (MorseFunction[])[MorseCase.Height(mesh), MorseCase.Noise(mesh, 10)])
        {
            MorseComplex complex = MorseComplex.Of(function);
            foreach (MorseArc arc in complex.Arcs)
            {
                for (int i = 1; i < arc.Vertices.Count; i++)
                {
                    Assert.True(mesh.Vertices[arc.Vertices[i - 1]].IsNeighborOf(mesh.Vertices[arc.Vertices[i]]));
                    Assert.Equal(arc.IsAscending, function.IsLower(arc.Vertices[i - 1], arc.Vertices[i]));
                }
            }
            // Descending arcs pass from edge middles to vertices only, ascending ones to face centres only: no segment is shared, no point but saddles.
            Assert.All(complex.Arcs, arc => Assert.DoesNotContain(arc.Points, p => p.Kind == (arc.IsAscending ? ElementKind.Vertex : ElementKind.Face)));
            HashSet<PathPoint> down = [.. complex.Arcs.Where(arc => !arc.IsAscending).SelectMany(arc => arc.Points.Skip(1))];
            Assert.DoesNotContain(complex.Arcs.Where(arc => arc.IsAscending).SelectMany(arc => arc.Points.Skip(1)), down.Contains);
        }
    }

    [Theory]
    [InlineData("torus")]
    [InlineData("genus-2")]
    [InlineData("bumpy-sphere")]
    public void Cells_OfAClosedConnectedSurface_AreDisksAndSatisfyEuler(string model)
    {
        Mesh mesh = Models.Create(model);
        foreach (MorseFunction function in (MorseFunction[])[MorseCase.Noise(mesh, 11), MorseCase.Noise(mesh, 12)])
        {
            DiscreteGradient gradient = DiscreteGradient.Of(function);
            CheckDisks(MorseComplex.Of(gradient));
            CheckDisks(MorseComplex.Of(GradientCancellation.Cancel(gradient, 0.4).Gradient));
        }
    }

    [SkippableTheory]
    [InlineData("spot")]
    [InlineData("rocker_arm")]
    [InlineData("three_holes")]
    [InlineData("fandisk")]
    [InlineData("featuretype")]
    public void Cells_OfClosedPublicModels_AreDisksAndSatisfyEuler(string model)
    {
        ReferenceData.SkipIfMissing();
        CheckDisks(MorseComplex.Of(MorseCase.Height(ReferenceData.Load(model))));
    }

    [Fact]
    public void BaseMesh_OfASimplifiedTorus_HasTheCriticalPointsAsVertices()
    {
        MorseComplex complex = MorseComplex.Of(MorseCase.Noise(Models.Create("torus"), 13));

        BaseMeshResult result = BaseMesh.Of(complex);

        Assert.Empty(result.Mesh.Validate());
        CriticalPoints critical = CriticalPoints.Of(complex.Gradient.Function);
        HashSet<int> known = [.. critical.Points.Select(p => p.Vertex.Index)];
        Assert.All(result.CriticalVertex, v => Assert.Contains(v, known));
        Assert.True(result.Mesh.Faces.Count > 0);
    }

    [Fact]
    public void SteepestPaths_OfNoise_EndInExtrema()
    {
        CriticalPoints critical = CriticalPoints.Of(MorseCase.Noise(Models.Create("genus-2"), 14));

        SteepestPathsResult paths = SteepestPaths.Of(critical);

        Assert.All(paths.Descending, path => Assert.Contains(critical.Function.Mesh.Vertices[path[^1]], critical.Minima));
        Assert.All(paths.Ascending, path => Assert.Contains(critical.Function.Mesh.Vertices[path[^1]], critical.Maxima));
    }

    [SkippableTheory]
    [InlineData("rocker_arm", 5)]
    [InlineData("box_assembly", 73)]
    public void SteepestPaths_OfPublicModels_CrossWhereArcsOfTheComplexCannot(string model, int crossings)
    {
        ReferenceData.SkipIfMissing();
        Assert.Equal(crossings, SteepestPaths.Of(CriticalPoints.Of(MorseCase.Height(ReferenceData.Load(model)))).Crossings.Count);
    }

    [Theory]
    [InlineData("torus", 1)]
    [InlineData("genus-2", 2)]
    [InlineData("bumpy-sphere", 0)]
    public void ReebGraph_OfAClosedSurface_HasAsManyLoopsAsHandles(string model, int genus)
    {
        Mesh mesh = Models.Create(model);
        foreach (MorseFunction function in (MorseFunction[])[MorseCase.Height(mesh), MorseCase.Noise(mesh, 15), MorseCase.Noise(mesh, 16), MorseCase.Constant(mesh)])
        {
            ReebGraph graph = ReebGraph.Of(function);
            Assert.Equal(genus, graph.LoopCount);
            Assert.All(graph.Arcs, arc => Assert.True(function.IsLower(arc.Lower, arc.Upper)));
        }
    }

    [SkippableTheory]
    [InlineData("three_holes", 3)]
    [InlineData("rocker_arm", 1)]
    [InlineData("featuretype", 9)]
    [InlineData("spot", 0)]
    public void ReebGraph_OfPublicModels_HasAsManyLoopsAsHandles(string model, int genus)
    {
        ReferenceData.SkipIfMissing();
        Assert.Equal(genus, ReebGraph.Of(MorseCase.Height(ReferenceData.Load(model))).LoopCount);
    }

    private static void CheckDisks(MorseComplex complex)
    {
        DiscreteGradient gradient = complex.Gradient;
        MorseCells cells = MorseCells.Of(complex);
        Assert.All(cells.Cells, cell => Assert.Equal(1, cell.EulerCharacteristic));
        // Four arcs meet at every saddle and bound four cells each on both sides: nodes − arcs + cells = χ.
        int nodes = gradient.MinimumCount + gradient.SaddleCount + gradient.MaximumCount;
        Assert.Equal(MorseCase.EulerCharacteristic(gradient.Function.Mesh), nodes - complex.Arcs.Count + cells.Cells.Count);
    }
}
