using System.Text.Json;
using MeshLab.Morse;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Morse;

[Trait("Section", "12.2")]
public class CriticalPointsTests
{
    [Fact]
    public void Of_OctahedronByHeight_HasOneMinimumAndOneMaximum()
    {
        CriticalPoints critical = CriticalPoints.Of(MorseCase.Height(Models.Create("octahedron")));

        Assert.Equal((1, 0, 1), (critical.Minima.Count, critical.SaddleCount, critical.Maxima.Count));
        Assert.Equal(2, critical.IndexSum);
    }

    //   The centre is at 0 and its six neighbours alternate + − + − + −: three wedges fall, three rise.
    [Fact]
    public void Of_MonkeySaddle_HasMultiplicityTwo()
    {
        Mesh mesh = MeshBuilder.FromFaces(7, [0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5], [0, 5, 6], [0, 6, 1]);

        CriticalPoints critical = CriticalPoints.Of(new MorseFunction(mesh, [0, 1, -1, 1.1, -1.1, 1.2, -1.2]));

        Assert.Equal(CriticalKind.Saddle, critical.KindOf(mesh.Vertices[0]));
        Assert.Equal(2, critical.MultiplicityOf(mesh.Vertices[0]));
        Assert.Equal(1, critical.IndexSum);
    }

    [Fact]
    public void Of_OneTriangle_CountsTheHighestVertexAsNothing()
    {
        Mesh mesh = Models.Create("one-triangle");

        CriticalPoints critical = CriticalPoints.Of(new MorseFunction(mesh, [0, 1, 2]));

        Assert.Equal([mesh.Vertices[0]], critical.Minima);
        Assert.Equal([mesh.Vertices[2]], critical.BoundaryMaxima);
        Assert.Empty(critical.Maxima);
        Assert.Equal(1, critical.IndexSum);
    }

    [Fact]
    public void Of_SaddleOfValence1200_CountsMultiplicitiesBeyondAByte()
    {
        Mesh mesh = Models.Create("bipyramid-1200");
        Vertex pole = mesh.Vertices.MaxBy(v => v.Valence);
        double[] values = MorseCase.Values(mesh, _ => 5);
        int i = 0;
        foreach (Vertex w in pole.Neighbors)
            values[w.Index] = i++ % 2 == 0 ? -1 : 1;
        values[pole.Index] = 0;

        CriticalPoints critical = CriticalPoints.Of(new MorseFunction(mesh, values));

        Assert.Equal(pole.Valence / 2 - 1, critical.MultiplicityOf(pole));
        Assert.Equal(2, critical.IndexSum);
    }

    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void IndexSum_AnyFunction_IsTheEulerCharacteristic(string model)
    {
        Mesh mesh = Models.Create(model);
        int expected = MorseCase.EulerCharacteristic(mesh);
        foreach (MorseFunction function in (MorseFunction[])[MorseCase.Height(mesh), MorseCase.Noise(mesh, 1), MorseCase.Noise(mesh, 2), MorseCase.Constant(mesh)])
        {
            CriticalPoints critical = CriticalPoints.Of(function);
            Assert.Equal(expected, critical.IndexSum);
            Assert.Equal(expected, critical.EulerCharacteristic);
        }
    }

    [SkippableTheory]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void Of_HeightOfPublicModels_EqualsTheReference(string model)
    {
        ReferenceData.SkipIfMissing();
        JsonElement expected = ReferenceData.Json(model, "core").RootElement.GetProperty("morse_z");

        CriticalPoints critical = CriticalPoints.Of(MorseCase.Height(ReferenceData.Load(model)));

        Assert.Equal(Indices(expected, "minima"), critical.Minima.Select(v => v.Index));
        Assert.Equal(Indices(expected, "maxima_interior"), critical.Maxima.Select(v => v.Index));
        Assert.Equal(Indices(expected, "boundary_local_maxima_index0"), critical.BoundaryMaxima.Select(v => v.Index));
        Assert.Equal(Indices(expected, "saddles"), critical.Saddles.Select(v => v.Index));
        Assert.Equal(Indices(expected, "saddle_multiplicity"), critical.Saddles.Select(critical.MultiplicityOf));
        Assert.Equal(expected.GetProperty("chi").GetInt32(), critical.IndexSum);
    }

    [Fact]
    public void Of_PlateausAndNegativeZero_AreDecidedByIndex()
    {
        Mesh mesh = Models.Create("tetrahedron");

        CriticalPoints critical = CriticalPoints.Of(new MorseFunction(mesh, [0.0, -0.0, 0.0, -0.0]));

        Assert.Equal([0], critical.Minima.Select(v => v.Index));
        Assert.Equal([3], critical.Maxima.Select(v => v.Index));
    }

    [Fact]
    public void MorseFunction_BadInput_NamesTheCulprit()
    {
        Mesh mesh = Models.Create("tetrahedron");

        Assert.Contains("v2", Assert.Throws<ArgumentException>(() => new MorseFunction(mesh, [0, 1, double.NaN, 3])).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => new MorseFunction(mesh, [0, 1, 2]));
        Assert.Throws<ArgumentNullException>(() => new MorseFunction(mesh, null!));
        Assert.Contains("f0", Assert.Throws<ArgumentException>(() => MorseCase.Height(Models.Create("cube-quads"))).Message, StringComparison.Ordinal);
    }

    private static IEnumerable<int> Indices(JsonElement reference, string name) => reference.GetProperty(name).EnumerateArray().Select(i => i.GetInt32());
}
