using System.Text.Json;
using MeshLab.Morse;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Morse;

[Trait("Section", "12.6")]
public class PersistenceTests
{
    //   value  0   3   1   2   5     on a strip of triangles: the basin of the value 1 meets the deeper one at 3.
    [Fact]
    public void Of_TwoBasins_TheShallowerDiesAtThePass()
    {
        Mesh mesh = Models.Create("grid");
        double[] values = MorseCase.Values(mesh, v => 10 + v.Index);
        Vertex[] row = [.. mesh.Vertices.Where(v => !v.IsBoundary).Take(3)];
        (values[row[0].Index], values[row[1].Index], values[row[2].Index]) = (0, 3, 1);

        PersistencePairs pairs = PersistencePairs.Of(new MorseFunction(mesh, values));

        Assert.Contains(pairs.Pairs, p => p.Kind == PairKind.MinimumSaddle && p.Birth == row[2] && p.Death == row[1] && p.Persistence == 2);
        Assert.Equal([row[0]], pairs.EssentialMinima);
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void Of_AnyFunction_LeavesTheBettiNumbers(string model)
    {
        Mesh mesh = Models.Create(model);
        foreach (MorseFunction function in (MorseFunction[])[MorseCase.Height(mesh), MorseCase.Noise(mesh, 3), MorseCase.Constant(mesh)])
        {
            PersistencePairs pairs = PersistencePairs.Of(function);
            CriticalPoints critical = pairs.Critical;

            Assert.All(pairs.Pairs, pair => Assert.True(pair.Persistence >= 0));
            Assert.Equal(MorseCase.EulerCharacteristic(mesh), pairs.EssentialMinima.Count - pairs.EssentialSaddles.Count + pairs.EssentialMaxima.Count);
            Assert.Equal(critical.Minima.Count, pairs.EssentialMinima.Count + pairs.Pairs.Count(p => p.Kind == PairKind.MinimumSaddle));
            Assert.Equal(critical.Maxima.Count, pairs.EssentialMaxima.Count + pairs.Pairs.Count(p => p.Kind == PairKind.SaddleMaximum));
            Assert.Equal(critical.SaddleCount, pairs.EssentialSaddles.Count + pairs.Pairs.Count);
        }
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void Of_HeightOfPublicModels_EqualsTheReference(string model)
    {
        ReferenceData.SkipIfMissing();
        JsonElement extras = ReferenceData.Json(model, "extras").RootElement;
        Skip.IfNot(extras.TryGetProperty("persistence_of_z", out JsonElement expected), "not computed for this model");

        PersistencePairs pairs = PersistencePairs.Of(MorseCase.Height(ReferenceData.Load(model)));

        Compare(expected.GetProperty("dim0"), [.. pairs.Pairs.Where(p => p.Kind == PairKind.MinimumSaddle)], pairs.EssentialMinima.Count);
        Compare(expected.GetProperty("dim1"), [.. pairs.Pairs.Where(p => p.Kind == PairKind.SaddleMaximum)], pairs.EssentialSaddles.Count);
        Assert.Equal(expected.GetProperty("dim2").GetProperty("essential").GetInt32(), pairs.EssentialMaxima.Count);
    }

    private static void Compare(JsonElement expected, List<PersistencePair> pairs, int essential)
    {
        Assert.Equal(expected.GetProperty("essential").GetInt32(), essential);
        Assert.Equal(expected.GetProperty("count").GetInt32() - essential, pairs.Count);
        HashSet<(int, int)> found = [.. pairs.Select(p => (p.Birth.Index, p.Death.Index))];
        foreach (JsonElement pair in expected.GetProperty("pairs_birth_death_vertex").EnumerateArray())
        {
            if (pair[1].ValueKind != JsonValueKind.Null)
                Assert.Contains((pair[0].GetInt32(), pair[1].GetInt32()), found);
        }
    }
}
