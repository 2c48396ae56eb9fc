using System.Text.Json;
using MeshLab.IO;
using MeshLab.Numerics;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Cli;

/// <summary><c>rings</c>, <c>boundary</c>, <c>topology</c>, <c>cut --to-disk</c> and <c>values</c> beside the reference values of the public models.</summary>
[Trait("Section", "command line")]
public sealed class NeighborhoodContractTests
{
    /// <summary>The largest two are left to the tests of the library: most of the time would go into reading their files.</summary>
    public static TheoryData<string> PublicModels => new(ReferenceData.PublicModels.Except(["horse", "isosurface_large"], StringComparer.Ordinal));

    public static TheoryData<string> AllPublicModels => ReferenceData.PublicModelCases;

    public static TheoryData<string> ModelsWithArrays => ReferenceData.ModelsWithArraysCases;

    [SkippableTheory]
    [MemberData(nameof(PublicModels))]
    public void Rings_OfVertices_HaveTheReferenceCounts(string name)
    {
        string path = ReferenceData.ModelPath(name);
        JsonElement rings = ReferenceData.Json(name, "extras").RootElement.GetProperty("rings");
        double[] vertices = Column("vertex"), first = Column("valence"), second = Column("vertices_at_edge_distance_2"), third = Column("vertices_at_edge_distance_3"), faces = Column("incident_faces");
        int step = ReferenceData.ModelsWithArrays.Contains(name, StringComparer.Ordinal) ? 7 : 24;
        for (int i = 0; i < vertices.Length; i += step)
        {
            int v = (int)vertices[i];
            JsonElement two = CliCall.Json(0, "rings", path, "--vertex", $"{v}", "--k", "2"), three = CliCall.Json(0, "rings", path, "--vertex", $"{v}", "--k", "3");
            Assert.Equal(first[i], Sorted(two, "vertices").Length);
            Assert.Equal(first[i], Sorted(two, "spokeEdges").Length);
            Assert.Equal(second[i], Sorted(two, "ring").Length);
            Assert.Equal(third[i], Sorted(three, "ring").Length);
            Assert.Equal(faces[i], Sorted(two, "faces").Length);
            Assert.Equal(faces[i], Sorted(two, "linkEdges").Length);
            Assert.Equal(1 + first[i] + second[i] + third[i], Sorted(three, "disk").Length);
            Assert.Equal(Sorted(two, "disk").Concat(Sorted(three, "ring")).Order(), Sorted(three, "disk"));
        }

        double[] Column(string column) => ReferenceData.Numbers(rings.GetProperty(column));
    }

    [SkippableTheory]
    [MemberData(nameof(PublicModels))]
    public void Rings_OfEdgesAndFaces_AreWhatACountOverTheFileGives(string name)
    {
        string path = ReferenceData.ModelPath(name);
        Mesh mesh = ReferenceData.Load(name);
        int[][] faces = [.. mesh.Faces.Select(f => f.Vertices.Select(v => v.Index).ToArray())];
        int f = faces.Length / 3;
        JsonElement face = CliCall.Json(0, "rings", path, "--face", $"{f}");
        Assert.Equal(Where(g => g != f && Shared(faces[g], faces[f]) > 0), Sorted(face, "facesSharingVertex"));
        Assert.Equal(Where(g => g != f && Shared(faces[g], faces[f]) > 1), Sorted(face, "facesSharingEdge"));
        int[] around = [.. Where(g => Shared(faces[g], faces[f]) > 0).SelectMany(g => faces[g]).Distinct().Except(faces[f]).Order()];
        Assert.Equal(around, Sorted(face, "vertices"));
        Assert.Equal(Opposite(faces[f]), Pairs(face, "ringEdgesPairs"));

        JsonElement edge = CliCall.Json(0, "rings", path, "--edge", $"{mesh.Edges.Count / 2}");
        int[] ends = Numbers(edge, "ends");
        Assert.Equal(Where(g => Shared(faces[g], ends) > 0), Sorted(edge, "faces"));
        Assert.Equal([.. Where(g => Shared(faces[g], ends) > 0).SelectMany(g => faces[g]).Distinct().Except(ends).Order()], Sorted(edge, "vertices"));
        Assert.Equal(Opposite(ends), Pairs(edge, "loopEdgesPairs"));

        int[] Where(Func<int, bool> condition) => [.. Enumerable.Range(0, faces.Length).Where(condition)];
        // The sides of the faces that touch the corners, without a corner among their ends.
        (int, int)[] Opposite(int[] corners) =>
        [
            .. Where(g => Shared(faces[g], corners) > 0).SelectMany(g => faces[g].Select((v, i) => (v, faces[g][(i + 1) % faces[g].Length])))
                .Where(side => !corners.Contains(side.v) && !corners.Contains(side.Item2)).Select(side => (Math.Min(side.v, side.Item2), Math.Max(side.v, side.Item2))).Distinct().Order(),
        ];
    }

    [SkippableTheory]
    [MemberData(nameof(PublicModels))]
    public void Boundary_Loops_HaveTheReferenceCountsAndLengths(string name)
    {
        JsonElement topology = ReferenceData.Json(name, "core").RootElement.GetProperty("topology");
        Mesh mesh = ReferenceData.Load(name);
        JsonElement[] loops = [.. CliCall.Json(0, "boundary", ReferenceData.ModelPath(name)).GetProperty("loops").EnumerateArray()];
        Assert.Equal(topology.GetProperty("boundary_loops").GetInt32(), loops.Length);
        Assert.Equal(ReferenceData.Numbers(topology.GetProperty("boundary_loop_vertex_counts")).Order(), loops.Select(l => (double)l.GetProperty("vertices").GetArrayLength()).Order());
        double[] expected = [.. ReferenceData.Numbers(topology.GetProperty("boundary_loop_lengths")).Order()], lengths = [.. loops.Select(l => l.GetProperty("length").GetDouble()).Order()];
        Assert.All(expected.Zip(lengths), pair => Assert.Equal(pair.First, pair.Second, 1e-12 * pair.First));
        foreach (JsonElement loop in loops)
        {
            // In order, with the hole to the left; each loop from its lowest vertex.
            int[] vertices = Numbers(loop, "vertices");
            Assert.Equal(vertices.Min(), vertices[0]);
            for (int i = 0; i < vertices.Length; i++)
                Assert.True(mesh.FindHalfEdge(mesh.Vertices[vertices[i]], mesh.Vertices[vertices[(i + 1) % vertices.Length]]).IsBoundary);
        }
    }

    [SkippableTheory]
    [MemberData(nameof(AllPublicModels))]
    public void Topology_PublicModel_EqualsTheReferenceAndHasItsGenerators(string name)
    {
        JsonElement reference = ReferenceData.Json(name, "core").RootElement.GetProperty("topology");
        JsonElement topology = CliCall.Json(0, "topology", ReferenceData.ModelPath(name), "--generators", "--cut-graph");
        foreach ((string field, string other) in ((string, string)[])[("eulerCharacteristic", "chi"), ("boundaryLoops", "boundary_loops"), ("genus", "genus_total")])
            Assert.Equal(reference.GetProperty(other).GetInt32(), topology.GetProperty(field).GetInt32());
        Assert.Equal(reference.GetProperty("components").GetInt32(), topology.GetProperty("components").GetArrayLength());

        Mesh mesh = ReferenceData.Load(name);
        JsonElement[] generators = [.. topology.GetProperty("generators").EnumerateArray()];
        Assert.Equal(2 * reference.GetProperty("genus_total").GetInt32(), generators.Length);
        double[] lengths = ReferenceData.Numbers(topology.GetProperty("generatorLengths"));
        for (int g = 0; g < generators.Length; g++)
        {
            Vertex[] loop = [.. ReferenceData.Numbers(generators[g]).Select(v => mesh.Vertices[(int)v])];
            Assert.Equal(loop.Length, loop.Distinct().Count());
            Edge[] edges = [.. loop.Select((v, i) => mesh.FindEdge(v, loop[(i + 1) % loop.Length]))];
            Assert.DoesNotContain(edges, e => e.IsNone);
            Assert.Equal(edges.Sum(e => Vector3D.Distance(e.Vertex0.Position, e.Vertex1.Position)), lengths[g], 1e-12 * lengths[g]);
        }
        (int Low, int High)[] cut = Pairs(topology, "cutGraph");
        Assert.All(cut, pair => Assert.False(mesh.FindEdge(mesh.Vertices[pair.Low], mesh.Vertices[pair.High]).IsNone));
    }

    [SkippableTheory]
    [MemberData(nameof(PublicModels))]
    public void CutToDisk_PublicModel_MakesEveryComponentOneDisk(string name)
    {
        JsonElement reference = ReferenceData.Json(name, "core").RootElement.GetProperty("topology");
        int components = reference.GetProperty("components").GetInt32();
        using var folder = new CliFolder();
        JsonElement cut = CliCall.Json(0, "cut", ReferenceData.ModelPath(name), folder.PathOf("disk.obj"), "--to-disk");
        foreach ((string field, int value) in ((string, int)[])[("components", components), ("boundaryLoops", components), ("genus", 0), ("eulerCharacteristic", components)])
            Assert.True(value == cut.GetProperty(field).GetInt32(), $"{name}: {field}");

        Mesh disks = MeshFile.Read(folder.PathOf("disk.obj"));
        Assert.Empty(disks.Validate());
        Assert.Equal(reference.GetProperty("F").GetInt32(), disks.Faces.Count);
        Assert.Equal(components, disks.Vertices.Count - disks.Edges.Count + disks.Faces.Count);
        // Nothing moved: cutting adds copies of points that were there.
        Assert.Empty(disks.Vertices.Select(v => v.Position).Except(ReferenceData.Load(name).Vertices.Select(v => v.Position)));
    }

    /// <summary>Of those whose numbers are well conditioned; the others are compared with the slack that they need in the tests of the library.</summary>
    [SkippableTheory]
    [MemberData(nameof(ModelsWithArrays))]
    public void Values_OfEveryKindOfElement_EqualTheReferenceValues(string name)
    {
        string path = ReferenceData.ModelPath(name);
        foreach ((string value, string array, int width) in ((string, string, int)[])
        [
            ("normal-uniform", "vertex_normal_uniform", 3), ("normal-area", "vertex_normal_area", 3), ("normal-angle", "vertex_normal_angle", 3), ("normal-max", "vertex_normal_max", 3),
            ("mixed-area", "mixed_area", 1), ("barycentric-area", "barycentric_area", 1), ("angle-defect", "gauss_integrated", 1), ("gaussian", "gauss_curvature", 1),
            ("mean-bending", "mean_curvature_edge_based", 1), ("area", "face_area", 1), ("normal", "face_normal", 3), ("angle", "interior_angles", 3),
        ])
        {
            ReferenceMesh.Compare(name, array, Values(path, "--of", value), width: width);
        }
        // Those of the boundary are NaN and not stored.
        ReferenceMesh.Compare(name, "dihedral_signed", [.. Values(path, "--of", "dihedral").Where(angle => !double.IsNaN(angle))]);

        JsonElement harmonic = ReferenceData.Json(name, "core").RootElement.GetProperty("harmonic");
        double[] u = Values(path, "--of", "harmonic");
        Assert.All(Samples(harmonic), sample => Assert.Equal(sample.Value, u[sample.Index], 1e-9));
        Assert.Equal(0, u[harmonic.GetProperty("fixed_zero").GetInt32()]);
        Assert.Equal(1, u[harmonic.GetProperty("fixed_one").GetInt32()]);

        double[] d = Values(path, "--of", "geodesic-edges", "--from", "0");
        JsonElement dijkstra = ReferenceData.Json(name, "extras").RootElement.GetProperty("geodesic_from_vertex_0").GetProperty("edge_dijkstra");
        Assert.All(Samples(dijkstra), sample => Assert.True(sample.Value == d[sample.Index] || Math.Abs(sample.Value - d[sample.Index]) <= 1e-12 * sample.Value));
    }

    [SkippableTheory]
    [MemberData(nameof(ModelsWithArrays))]
    public void ValuesRegion_EveryAngle_HasTheReferenceRegions(string name)
    {
        JsonElement regions = ReferenceData.Json(name, "extras").RootElement.GetProperty("sharp_edge_regions");
        foreach (string degrees in (string[])["20", "30", "40", "60"])
        {
            double[] labels = Values(ReferenceData.ModelPath(name), "--of", "region", "--angle", degrees);
            JsonElement expected = regions.GetProperty(degrees + "_deg");
            int[] sizes = [.. labels.GroupBy(l => l).Select(g => g.Count()).OrderDescending()];
            Assert.Equal(expected.GetProperty("regions").GetInt32(), sizes.Length);
            Assert.Equal(ReferenceData.Numbers(expected.GetProperty("largest_sizes")).Select(size => (int)size), sizes.Take(10));
        }
    }

    private static double[] Values(params string[] args) => ReferenceData.Numbers(CliCall.Json(0, ["values", .. args]).GetProperty("values"));

    private static IEnumerable<(int Index, double Value)> Samples(JsonElement stored) =>
        ReferenceData.Numbers(stored.GetProperty("sample_index")).Zip(ReferenceData.Numbers(stored.GetProperty("sample")), (i, value) => ((int)i, value));

    private static int Shared(int[] corners, int[] others) => corners.Count(others.Contains);

    private static int[] Numbers(JsonElement fields, string name) => Array.ConvertAll(ReferenceData.Numbers(fields.GetProperty(name)), number => (int)number);

    /// <summary>A list of indices, which is in index order and names nothing twice.</summary>
    private static int[] Sorted(JsonElement fields, string name)
    {
        int[] list = Numbers(fields, name);
        Assert.Equal(list.Distinct().Order(), list);
        return list;
    }

    private static (int Low, int High)[] Pairs(JsonElement fields, string name) =>
        [.. fields.GetProperty(name).EnumerateArray().Select(pair => (pair[0].GetInt32(), pair[1].GetInt32()))];
}
