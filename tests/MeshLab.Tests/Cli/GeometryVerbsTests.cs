using System.Text.Json;
using MeshLab.Cli.Values;
using MeshLab.IO;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Visualization;
using Xunit;

namespace MeshLab.Tests.Cli;

/// <summary>The verbs info, rings, boundary, topology, cut and the values of chapter 10, as their JSON says it.</summary>
[Trait("Section", "5.1")]
[Trait("Section", "10.1")]
[Trait("Section", "11.1")]
public sealed class GeometryVerbsTests : IDisposable
{
    private readonly string folder = Directory.CreateTempSubdirectory("mlab-geometry").FullName;

    public void Dispose() => Directory.Delete(folder, true);

    [SkippableFact]
    public void Values_ArraysOfCore_EqualTheReferenceValues()
    {
        const string Name = "spot";
        string path = ReferenceData.ModelPath(Name);
        foreach (var (value, array, width) in new[]
        {
            ("normal-uniform", "vertex_normal_uniform", 3), ("normal-area", "vertex_normal_area", 3), ("normal-angle", "vertex_normal_angle", 3),
            ("normal-max", "vertex_normal_max", 3), ("mixed-area", "mixed_area", 1), ("barycentric-area", "barycentric_area", 1),
            ("angle-defect", "gauss_integrated", 1), ("gaussian", "gauss_curvature", 1), ("mean", "mean_curvature_signed", 1), ("k1", "k1", 1),
            ("k2", "k2", 1), ("dihedral", "dihedral_signed", 1), ("area", "face_area", 1), ("normal", "face_normal", 3), ("angle", "interior_angles", 3),
        })
        {
            JsonElement result = Run(0, "values", path, "--of", value);
            Assert.Equal(0, result.GetProperty("skipped").GetInt32());
            ReferenceMesh.Compare(Name, array, ReferenceData.Numbers(result.GetProperty("values")), width: width);
        }
        JsonElement weights = Run(0, "values", path, "--of", "cotangent");
        double[] expected = ReferenceData.Numbers(ReferenceData.Arrays(Name).RootElement.GetProperty("cotan_weight"));
        double[] pairs = ReferenceData.Numbers(ReferenceData.Arrays(Name).RootElement.GetProperty("cotan_weight_ij"));
        Assert.Equal(pairs, ReferenceData.Numbers(weights.GetProperty("pairs")));
        Assert.All(expected.Zip(ReferenceData.Numbers(weights.GetProperty("values"))), p => Assert.Equal(p.First, p.Second, 1e-9));
    }

    [Fact]
    public void Values_EveryName_GivesOneEntryPerElement()
    {
        string path = Save(Models.Create("isolated-vertices"));
        foreach (string name in MeshValue.All.Keys)
        {
            if (name is "harmonic" or "distance" || MeshValue.All[name].Mark.Kind != ElementKind.Vertex)
                continue;
            JsonElement result = Run(0, "values", path, "--of", name);
            int count = result.GetProperty("count").GetInt32(), components = result.GetProperty("components").GetInt32();
            Assert.Equal(count * components, result.GetProperty("values").GetArrayLength());
            int unused = Models.Create("isolated-vertices").Vertices.Count(v => v.IsIsolated);
            Assert.Equal(unused, result.GetProperty("skipped").GetInt32());
        }
    }

    [Theory]
    [InlineData("normal")]
    [InlineData("area")]
    [InlineData("normal-angle")]
    public void Values_FacesOfZeroArea_AreCounted(string name)
    {
        string path = Save(MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 0, 0), new(0, 1, 0), new(2, 0, 0)], [0, 1, 2, 1, 0, 3]));
        JsonElement result = Run(0, "values", path, "--of", name);
        Assert.Equal(1, result.GetProperty("zeroAreaFaces").GetInt32());
        Assert.All(ReferenceData.Numbers(result.GetProperty("values")), x => Assert.False(double.IsNaN(x)));
        if (name == "normal")
            Assert.Equal([0, 0, 1, 0, 0, 0], ReferenceData.Numbers(result.GetProperty("values")));
        Assert.Equal(0, Run(0, "values", Save(Models.Create("grid")), "--of", name).GetProperty("zeroAreaFaces").GetInt32());
    }

    [SkippableTheory]
    [InlineData(20)]
    [InlineData(30)]
    [InlineData(60)]
    public void Values_Region_CutsAtTheGivenAngle(int degrees)
    {
        const string Name = "fandisk";
        JsonElement result = Run(0, "values", ReferenceData.ModelPath(Name), "--of", "region", "--angle", $"{degrees}");
        int expected = ReferenceData.Json(Name, "extras").RootElement.GetProperty("sharp_edge_regions").GetProperty($"{degrees}_deg").GetProperty("regions").GetInt32();
        Assert.Equal(expected, ReferenceData.Numbers(result.GetProperty("values")).Distinct().Count());
    }

    [Fact]
    public void Values_RegionWithoutAngle_CutsAt30Degrees()
    {
        string path = Save(Models.Create("cube"));
        Assert.Equal(6, ReferenceData.Numbers(Run(0, "values", path, "--of", "region").GetProperty("values")).Distinct().Count());
        Assert.Single(ReferenceData.Numbers(Run(0, "values", path, "--of", "region", "--angle", "90.1").GetProperty("values")).Distinct());
        Run(2, "values", path, "--of", "region", "--angle", "181");
        Run(2, "values", path, "--of", "region", "--angle", "NaN");
    }

    /// <summary>Scalars, labels and vectors alike, of every kind of element, also on an open mesh with vertices that have no faces.</summary>
    [Fact]
    public void ColoringOf_EveryValue_HasALegend()
    {
        Mesh mesh = Models.Create("holes");
        mesh.AddVertex(new(3, 3, 3));
        foreach (MeshValue value in MeshValue.All.Values)
        {
            if (value.Mark.Name == "harmonic")
                continue;
            Coloring coloring = ValueColoring.Of(mesh, value, new ValueOptions(-1, [], Math.PI / 6));
            Assert.Contains(value.Mark.Name, coloring.Title, StringComparison.Ordinal);
            Assert.True(coloring.Values is not null || coloring.Labels is not null || coloring.Entries.Count is 3 or 6, value.Mark.Name);
            Image image = MeshRenderer.Render(mesh, new RenderOptions { Coloring = coloring, Width = 120, Height = 90, Supersampling = 1 });
            Assert.Equal(120, image.Width);
        }
    }

    [Fact]
    public void Render_FileWithColors_PaintsThem()
    {
        Mesh plain = Models.Create("torus"), colored = Models.Create("torus");
        colored.AddVertexTrait(TraitNames.Color, new Color(1, 0, 0));
        Assert.NotEqual(Picture(plain, "plain.png"), Picture(colored, "colored.png"));

        byte[] Picture(Mesh mesh, string name)
        {
            string picture = Path.Combine(folder, name);
            Run(0, "render", Save(mesh), picture, "--size", "60x40");
            return File.ReadAllBytes(picture);
        }
    }

    [Fact]
    public void Render_Normals_WritesAPicture()
    {
        string picture = Path.Combine(folder, "normals.png");
        Run(0, "render", Save(Models.Create("torus")), picture, "--values", "normal-angle", "--size", "60x40");
        Assert.True(new FileInfo(picture).Length > 100);
    }

    [SkippableFact]
    public void Info_PublicModel_HasTheReferenceValues()
    {
        JsonElement info = Run(0, "info", ReferenceData.ModelPath("reference_annulus"));
        JsonElement core = ReferenceData.Json("reference_annulus", "core").RootElement;
        Assert.Equal(core.GetProperty("topology").GetProperty("V").GetInt32(), info.GetProperty("vertices").GetInt32());
        Assert.Equal(core.GetProperty("topology").GetProperty("chi").GetInt32(), info.GetProperty("eulerCharacteristic").GetInt32());
        Assert.Equal(core.GetProperty("topology").GetProperty("boundary_edges").GetInt32(), info.GetProperty("boundaryEdges").GetInt32());
        Assert.Equal(core.GetProperty("measures").GetProperty("area").GetDouble(), info.GetProperty("area").GetDouble(), 1e-6);
        Assert.Equal(core.GetProperty("measures").GetProperty("volume_signed").GetDouble(), info.GetProperty("volume").GetDouble(), 1e-5);
        Assert.Equal(2 * info.GetProperty("edges").GetInt32(), info.GetProperty("halfEdges").GetInt32());
        Assert.False(info.GetProperty("isClosed").GetBoolean());
        Assert.Equal(info.GetProperty("vertices").GetInt32(), info.GetProperty("valence").GetProperty("histogram").EnumerateObject().Sum(p => p.Value.GetInt32()));
    }

    [Fact]
    public void Info_EmptyMesh_HasNoNumbersButNoError()
    {
        JsonElement info = Run(0, "info", Save(Models.Create("isolated-vertices")));
        Assert.True(info.GetProperty("isolatedVertices").GetInt32() > 0);
        Assert.Equal(2, info.GetProperty("eulerCharacteristic").GetInt32());
    }

    [Fact]
    public void Rings_OfEachKind_ListTheQueries()
    {
        string path = Save(Models.Create("grid"));
        JsonElement vertex = Run(0, "rings", path, "--vertex", "9", "--k", "2");
        Assert.Equal(6, vertex.GetProperty("vertices").GetArrayLength());
        Assert.Equal(6, vertex.GetProperty("spokeEdges").GetArrayLength());
        Assert.Equal(6, vertex.GetProperty("linkEdgesPairs").GetArrayLength());
        Assert.True(vertex.GetProperty("ring").GetArrayLength() > 3);
        Assert.True(Run(0, "rings", path, "--edge", "5").GetProperty("loopEdges").GetArrayLength() > 0);
        Assert.True(Run(0, "rings", path, "--face", "5").GetProperty("facesSharingEdge").GetArrayLength() > 0);
        Run(2, "rings", path, "--vertex", "100000");
        Run(2, "rings", path, "--vertex", "1", "--k", "-1");
        Run(2, "rings", path);
    }

    [Fact]
    public void Boundary_Annulus_HasTwoLoops()
    {
        JsonElement loops = Run(0, "boundary", Save(Models.Create("annulus"))).GetProperty("loops");
        Assert.Equal(2, loops.GetArrayLength());
        Assert.All(loops.EnumerateArray(), loop => Assert.True(loop.GetProperty("length").GetDouble() > 0));
    }

    [Fact]
    public void Topology_GenusTwo_HasFourGeneratorsAndACutGraph()
    {
        string path = Save(Models.Create("genus-2"));
        JsonElement topology = Run(0, "topology", path, "--generators", "--cut-graph");
        Assert.Equal(2, topology.GetProperty("components")[0].GetProperty("genus").GetInt32());
        Assert.Equal(4, topology.GetProperty("generators").GetArrayLength());
        Assert.True(topology.GetProperty("cutGraph").GetArrayLength() > 0);
        Assert.Equal(4, Run(0, "topology", path, "--generators", "--shorten").GetProperty("generators").GetArrayLength());
    }

    [Fact]
    public void Cut_ToDiskAndAlongEdges_WritesTheCutMesh()
    {
        string path = Save(Models.Create("genus-2")), disk = Path.Combine(folder, "disk.obj");
        JsonElement cut = Run(0, "cut", path, disk, "--to-disk");
        Assert.Equal(1, cut.GetProperty("components").GetInt32());
        Assert.Equal(1, cut.GetProperty("boundaryLoops").GetInt32());
        Assert.Equal(0, cut.GetProperty("genus").GetInt32());
        Assert.Equal(1, Run(0, "info", disk).GetProperty("eulerCharacteristic").GetInt32());

        Mesh grid = Models.QuadGrid(4, 2);
        string list = Path.Combine(folder, "edges.txt");
        File.WriteAllText(list, "# the middle column\n2 7\n7 12\n");
        Assert.Equal(2, Run(0, "cut", Save(grid), disk, "--edges", list).GetProperty("components").GetInt32());
        File.WriteAllText(list, "0 9\n");
        Run(3, "cut", Save(grid), disk, "--edges", list);
        Run(2, "cut", path, disk);
    }

    private string Save(Mesh mesh)
    {
        string path = Path.Combine(folder, $"{Guid.NewGuid():N}.obj");
        MeshFile.Write(mesh, path);
        return path;
    }

    private static JsonElement Run(int status, params string[] args) => CliCall.Json(status, args);
}
