using MeshLab.IO;
using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Simplification;

[Trait("Section", "7.5")]
public class ProgressiveMeshTests
{
    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void GoToBaseAndBack_EveryModel_IsTheIdentity(string name)
    {
        Mesh mesh = Models.Create(name);
        mesh.Compact();
        AddTraits(mesh);
        ulong before = mesh.StateHash();

        ProgressiveMesh progressive = ProgressiveMesh.Create(mesh);
        Assert.Equal(before, progressive.Mesh.StateHash());
        progressive.GoToBase();
        Assert.Empty(progressive.Mesh.Validate());
        Assert.Equal(progressive.MinFaces, progressive.FaceCount);
        progressive.GoToFinest();

        Assert.Equal(before, progressive.Mesh.StateHash());
        Assert.Equal(before, mesh.StateHash());
        Assert.Empty(progressive.Mesh.Validate());
    }

    [SkippableTheory]
    [Trait("Speed", "Slow")]
    [MemberData(nameof(ReferenceData.PublicModelCases), MemberType = typeof(ReferenceData))]
    public void GoToBaseAndBack_PublicModel_IsTheIdentity(string name)
    {
        Mesh mesh = ReferenceMesh.Load(name);
        ulong before = mesh.StateHash();

        ProgressiveMesh progressive = ProgressiveMesh.Create(mesh);
        progressive.GoToBase();
        Assert.Empty(progressive.Mesh.Validate());
        Assert.True(progressive.MinFaces < mesh.Faces.Count / 10);
        progressive.GoToFinest();

        Assert.Equal(before, progressive.Mesh.StateHash());
    }

    [Fact]
    public void GoToFaces_AnyOrder_GivesTheSameStateAtTheSameLevel()
    {
        Mesh mesh = Shapes.Torus(20, 12);
        AddTraits(mesh);
        ProgressiveMesh progressive = ProgressiveMesh.Create(mesh);
        var random = new Random(3);
        var states = new Dictionary<int, ulong>();

        for (int i = 0; i < 200; i++)
        {
            int faces = random.Next(progressive.MinFaces, progressive.MaxFaces + 1);
            progressive.GoToFaces(faces);
            Assert.InRange(progressive.FaceCount, faces - 1, faces);
            ulong state = progressive.Mesh.StateHash();
            Assert.Equal(state, states.GetValueOrDefault(progressive.CollapsesDone, state));
            states[progressive.CollapsesDone] = state;
            if (i % 20 == 0)
                Assert.Empty(progressive.Mesh.Validate());
        }
    }

    [Fact]
    public void GoToBase_EndpointPlacement_KeepsTheBitsOfPositions()
    {
        Mesh mesh = Shapes.Moved(Shapes.Torus(20, 12), p => new(0.3 * p.X, 0.7 * p.Y + 0.1 * p.X, p.Z));
        var before = mesh.Positions.ToArray().ToHashSet();
        ProgressiveMesh progressive = ProgressiveMesh.Create(mesh, new() { Placement = VertexPlacement.Endpoint });

        foreach (int level in (int[])[0, progressive.CollapseCount / 2, progressive.CollapseCount])
        {
            progressive.GoToCollapse(level);
            Assert.All(progressive.Mesh.Vertices, v => Assert.Contains(v.Position, before));
        }
    }

    [Fact]
    public void GoToFaces_FastMode_IsWhatSimplifyGives()
    {
        Mesh mesh = Shapes.Sheet(14, (x, y) => 0.1 * Math.Sin(8 * x) * y);
        ProgressiveMesh progressive = ProgressiveMesh.Create(mesh);

        progressive.GoToFaces(100);
        Mesh level = progressive.Mesh.Clone();
        level.Compact();
        mesh.Simplify(new() { TargetFaces = 100 });

        Assert.Equal(mesh.StateHash(), level.StateHash());
    }

    [Theory]
    [InlineData(QuadricMode.Fast)]
    [InlineData(QuadricMode.Accurate)]
    public void SaveAndLoad_WithTraitsAndLabels_RestoresEveryBit(QuadricMode mode)
    {
        Mesh mesh = Shapes.Torus(16, 12);
        AddTraits(mesh);
        FaceLabels labels = mesh.GetOrAddFaceLabels("material");
        foreach (Face f in mesh.Faces)
            labels.Labels[f] = labels.Number(f.Index % 2 == 0 ? "红" : "blue");
        ProgressiveMesh progressive = ProgressiveMesh.Create(mesh, new() { Mode = mode, TargetFaces = 40, KeepLabelBorders = false });
        using var stream = new MemoryStream();
        progressive.GoToFaces(200);
        ulong at200 = progressive.Mesh.StateHash();

        progressive.Save(stream);
        Assert.Equal(at200, progressive.Mesh.StateHash());
        stream.Position = 0;
        ProgressiveMesh loaded = ProgressiveMeshFile.Load(stream);

        Assert.Equal(mesh.StateHash(), loaded.Mesh.StateHash());
        Assert.Equal("红", loaded.Mesh.FaceLabels[0].NameOf(loaded.Mesh.Faces[2]));
        Assert.Equal(progressive.CollapseCount, loaded.CollapseCount);
        loaded.GoToFaces(200);
        progressive.GoToFaces(200);
        Assert.Equal(Live(progressive.Mesh), Live(loaded.Mesh));
        loaded.GoToBase();
        progressive.GoToBase();
        Assert.Equal(Live(progressive.Mesh), Live(loaded.Mesh));
        loaded.GoToFinest();
        Assert.Equal(mesh.StateHash(), loaded.Mesh.StateHash());
        Assert.Empty(loaded.Mesh.Validate());
    }

    [Fact]
    public void ReadSplit_AsTheStreamArrives_RefinesStepByStep()
    {
        ProgressiveMesh progressive = ProgressiveMesh.Create(Shapes.Torus(16, 12));
        using var stream = new MemoryStream();
        progressive.Save(stream);
        stream.Position = 0;

        using var reader = new ProgressiveMeshReader(stream);
        Assert.Equal(progressive.MinFaces, reader.Progressive.FaceCount);
        for (int i = 0; i < 50; i++)
            Assert.True(reader.ReadSplit());
        Assert.False(reader.Progressive.IsComplete);
        Assert.Empty(reader.Progressive.Mesh.Validate());
        reader.Progressive.GoToBase();
        Assert.Empty(reader.Progressive.Mesh.Validate());
        while (reader.ReadSplit())
        {
        }

        Assert.True(reader.Progressive.IsComplete);
        progressive.GoToFinest();
        Assert.Equal(progressive.Mesh.StateHash(), reader.Progressive.Mesh.StateHash());
    }

    /// <summary>At a corner of the border a contracted edge's triangle has two edges on it.</summary>
    [Theory]
    [InlineData(9, 7)]
    [InlineData(4, 3)]
    [InlineData(24, 15)]
    public void Load_OpenMeshDownToItsBase_RestoresEveryState(int m, int n)
    {
        Mesh mesh = MeshLab.Generation.Grids.Grid(m, n);
        ProgressiveMesh progressive = ProgressiveMesh.Create(mesh, new() { TargetFaces = 1 });
        using var stream = new MemoryStream();
        progressive.Save(stream);
        stream.Position = 0;

        ProgressiveMesh loaded = ProgressiveMeshFile.Load(stream);

        Assert.Equal(mesh.StateHash(), loaded.Mesh.StateHash());
        for (int faces = loaded.MaxFaces; faces >= loaded.MinFaces; faces--)
        {
            loaded.GoToFaces(faces);
            progressive.GoToFaces(faces);
            Assert.Equal(Live(progressive.Mesh), Live(loaded.Mesh));
            Assert.Empty(loaded.Mesh.Validate());
        }
    }

    [Fact]
    public void Load_DamagedAnywhere_SaysSoOrGivesAValidMesh()
    {
        ProgressiveMesh progressive = ProgressiveMesh.Create(Shapes.Torus(8, 6));
        using var stream = new MemoryStream();
        progressive.Save(stream);
        byte[] data = stream.ToArray();
        var random = new Random(11);
        int refused = 0;

        for (int at = 0; at < data.Length; at += 3)
        {
            byte[] damaged = [.. data];
            damaged[at] ^= (byte)(1 << random.Next(8));
            try
            {
                ProgressiveMesh loaded = ProgressiveMeshFile.Load(new MemoryStream(damaged));
                Assert.Empty(loaded.Mesh.Validate());
                loaded.GoToBase();
                Assert.Empty(loaded.Mesh.Validate());
                loaded.GoToFinest();
            }
            catch (MeshFormatException)
            {
                refused++;
            }
        }

        Assert.True(refused > 100);
        foreach (int length in (int[])[0, 3, 4, 5, 20, data.Length / 2, data.Length - 1])
            Assert.Throws<MeshFormatException>(() => ProgressiveMeshFile.Load(new MemoryStream(data, 0, length)));
    }

    [Fact]
    public void GoTo_Cancelled_LeavesAValidMeshOnTheWay()
    {
        Mesh mesh = Shapes.Torus(100, 60);
        AddTraits(mesh);
        ulong before = mesh.StateHash();
        ProgressiveMesh progressive = ProgressiveMesh.Create(mesh);

        using var down = new CancellationTokenSource();
        Assert.Throws<OperationCanceledException>(() => progressive.GoToBase(ProgressTeller.CancelAt(down, 0.3), down.Token));
        Assert.InRange(progressive.CollapsesDone, progressive.CollapseCount * 3 / 10, progressive.CollapseCount * 8 / 10);
        Assert.Equal(progressive.Mesh.Faces.Count(f => !f.IsDeleted), progressive.FaceCount);
        Assert.Empty(progressive.Mesh.Validate());

        progressive.GoToBase();
        using var up = new CancellationTokenSource();
        Assert.Throws<OperationCanceledException>(() => progressive.GoToFaces(11_000, ProgressTeller.CancelAt(up, 0.3), up.Token));
        Assert.InRange(progressive.FaceCount, progressive.MinFaces + 1, 9_000);
        Assert.Empty(progressive.Mesh.Validate());

        int level = progressive.CollapsesDone;
        Assert.Throws<OperationCanceledException>(() => progressive.GoToFinest(null, new CancellationToken(true)));
        Assert.Equal(level, progressive.CollapsesDone);
        progressive.GoToFinest();
        Assert.Equal(before, progressive.Mesh.StateHash());
    }

    [Fact]
    public void GoToFaces_Progress_RisesToOneAndShowsAValidMesh()
    {
        ProgressiveMesh progressive = ProgressiveMesh.Create(Shapes.Torus(60, 40));
        var told = new List<double>();

        progressive.GoToFaces(100, new ProgressTeller(value =>
        {
            told.Add(value);
            Assert.Empty(progressive.Mesh.Validate());
        }));

        Assert.True(told.Count > 2);
        Assert.Equal(told.Order(), told);
        Assert.Equal(1, told[^1]);
        Assert.Equal(100, progressive.FaceCount);
    }

    [Fact]
    public void SaveAndLoad_Cancelled_LeaveNoFileAndAValidMesh()
    {
        ProgressiveMesh progressive = ProgressiveMesh.Create(Shapes.Torus(60, 40));
        ulong before = progressive.Mesh.StateHash();
        string folder = Directory.CreateTempSubdirectory("mlab-pm").FullName, path = Path.Combine(folder, "levels.pm");
        try
        {
            using var source = new CancellationTokenSource();
            Assert.Throws<OperationCanceledException>(() => progressive.Save(path, ProgressTeller.CancelAt(source, 0.4), source.Token));
            Assert.Empty(Directory.GetFiles(folder));
            Assert.Empty(progressive.Mesh.Validate());
            progressive.GoToFinest();
            Assert.Equal(before, progressive.Mesh.StateHash());

            var told = new List<double>();
            progressive.Save(path, new ProgressTeller(told.Add));
            Assert.Equal(1, told[^1]);
            Assert.Throws<OperationCanceledException>(() => ProgressiveMeshFile.Load(path, null, new CancellationToken(true)));
            ProgressiveMesh loaded = ProgressiveMeshFile.Load(path, new ProgressTeller(told.Add));
            Assert.Equal(1, told[^1]);
            Assert.Equal(before, loaded.Mesh.StateHash());
        }
        finally
        {
            Directory.Delete(folder, true);
        }
    }

    [Fact]
    public void Create_BadArguments_AreNamed()
    {
        Mesh mesh = Shapes.Torus(8, 6);
        ProgressiveMesh progressive = ProgressiveMesh.Create(mesh, new() { TargetFaces = 20 });
        Assert.Equal((StopReason.TargetReached, mesh.Faces.Count, progressive.MinFaces, progressive.CollapseCount),
            (progressive.Recording!.StopReason, progressive.Recording.FacesBefore, progressive.Recording.FacesAfter, progressive.Recording.Collapses));
        Assert.Equal(StopReason.MaxErrorReached, ProgressiveMesh.Create(mesh, new() { MaxError = 0 }).Recording!.StopReason);

        Assert.Throws<ArgumentException>(() => ProgressiveMesh.Create(MeshBuilder.FromFaces(4, [0, 1, 2, 3])));
        Assert.Throws<ArgumentException>(() => ProgressiveMesh.Create(mesh, new() { Mode = QuadricMode.Textbook }));
        Assert.Throws<ArgumentOutOfRangeException>(() => progressive.GoToFaces(19));
        Assert.Throws<ArgumentOutOfRangeException>(() => progressive.GoToFaces(97));
        Assert.Throws<ArgumentOutOfRangeException>(() => progressive.GoToCollapse(-1));
        mesh.AddVertexTrait<string>("name");
        Assert.Throws<ArgumentException>(() => ProgressiveMesh.Create(mesh).Save(new MemoryStream()));
    }

    private static void AddTraits(Mesh mesh)
    {
        VertexTrait<double> x = mesh.AddVertexTrait("x", 0.0, Blend.Linear);
        VertexTrait<Color> color = mesh.AddVertexTrait<Color>(TraitNames.Color, default, Blend.Linear);
        HalfEdgeTrait<Vector2D> texture = mesh.AddHalfEdgeTrait<Vector2D>("uv", default, Blend.Linear);
        EdgeTrait<int> flag = mesh.AddEdgeTrait(TraitNames.SelectedFlag, 0, Blend.Largest);
        FaceTrait<int> number = mesh.AddFaceTrait<int>("number");
        foreach (Vertex v in mesh.Vertices)
        {
            x[v] = Math.Sin(v.Index);
            color[v] = new((float)v.Position.X, (float)v.Position.Y, (float)v.Position.Z);
        }
        foreach (HalfEdge h in mesh.HalfEdges)
            texture[h] = new(Math.Cos(h.Index), h.Index);
        foreach (Edge e in mesh.Edges)
            flag[e] = e.Index % 7;
        foreach (Face f in mesh.Faces)
            number[f] = f.Index;
    }

    /// <summary>What can be seen of a mesh, without the values of deleted slots.</summary>
    private static string Live(Mesh mesh)
    {
        Mesh copy = mesh.Clone();
        copy.Compact();
        return $"{copy.StateHash():x16} {string.Join(' ', mesh.Vertices.Select(v => v.Index))} {string.Join(' ', mesh.Faces.Select(f => f.Index))}";
    }
}
