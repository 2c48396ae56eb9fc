using System.Text.Json;
using MeshLab.Editing;
using MeshLab.FiveSixSeven;
using MeshLab.Remeshing;
using MeshLab.Structure;
using MeshLab.Subdivision;
using MeshLab.Tests.Subdivision;
using Xunit;

namespace MeshLab.Tests.Structure;

/// <summary>The step traces of operations and of the algorithms of chapters 8, 9 and L4: lines of JSON that tell what happened.</summary>
public class OperationTraceTests
{
    [Fact]
    [Trait("Section", "4")]
    public void Start_Operations_AreWrittenUntilDisposed()
    {
        Mesh mesh = Models.Create("grid");
        using var writer = new StringWriter();
        using (OperationHistory history = mesh.StartRecording())
        {
            using (OperationTrace.Start(mesh, writer))
            {
                Edge edge = mesh.Edges.First(e => e.CanFlip(out _));
                edge.Flip();
                edge.Split();
            }
            Assert.Equal(2, history.Count);
            mesh.Edges.First(e => e.CanFlip(out _)).Flip();
            Assert.Equal(3, history.Count);
        }

        JsonElement[] lines = Lines(writer);
        Assert.Equal(["edgeFlip", "edgeSplit"], lines.Select(line => line.GetProperty("operation").GetString()!), StringComparer.Ordinal);
        Assert.Equal([0, 1], lines.Select(line => line.GetProperty("step").GetInt32()));
        Assert.Equal($"v{mesh.VertexSlots - 1}", lines[1].GetProperty("created")[0].GetString());
        Assert.Equal(mesh.VertexSlots - 1, lines[1].GetProperty("moved")[0][0].GetInt32());
        Assert.Equal(0, lines[0].GetProperty("removed").GetArrayLength());
        Assert.Throws<ArgumentNullException>(() => OperationTrace.Start(mesh, null!));
        Assert.Throws<ArgumentNullException>(() => OperationTrace.Start(null!, writer));
    }

    [Fact]
    [Trait("Section", "L4")]
    public void Remesh_Trace_HasALinePerOperation()
    {
        using var writer = new StringWriter();
        RemeshingResult result = Models.Create("bumpy-sphere").RemeshIsotropically(new() { Trace = writer, Passes = 2 });
        Assert.Equal(RemeshingStop.PassesDone, result.StopReason);
        Assert.Equal(result.Mesh.StateHash(), Models.Create("bumpy-sphere").RemeshIsotropically(new() { Passes = 2 }).Mesh.StateHash());
        AssertCounts(writer, ("split", result.Splits), ("collapse", result.Collapses), ("flip", result.Flips), ("smooth", 2));
    }

    [Fact]
    [Trait("Section", "L4")]
    public void RemeshInLaboratory_Trace_HasALinePerOperation()
    {
        Mesh mesh = Models.Create("bumpy-sphere"), silent = mesh.Clone();
        using var writer = new StringWriter();
        LaboratoryRemeshingResult result = mesh.RemeshInLaboratory(new() { Trace = writer });
        silent.RemeshInLaboratory();
        Assert.Equal(silent.StateHash(), mesh.StateHash());
        Assert.Null(mesh.Listener);
        AssertCounts(writer, ("edgeSplit", result.Splits), ("edgeCollapse", result.Collapses), ("edgeFlip", result.Flips));
    }

    [Theory]
    [Trait("Section", "9")]
    [InlineData(FiveSixSevenEngine.Repair)]
    [InlineData(FiveSixSevenEngine.Textbook)]
    public void ToFiveSixSeven_Trace_LeadsToTheResult(FiveSixSevenEngine engine)
    {
        Mesh mesh = Models.Create("bumpy-sphere");
        using var writer = new StringWriter();
        FiveSixSevenResult result = mesh.ToFiveSixSeven(new() { Engine = engine, Trace = writer });
        Assert.Equal(FiveSixSevenStop.Reached, result.StopReason);
        Assert.Equal(result.Mesh.StateHash(), mesh.ToFiveSixSeven(new() { Engine = engine }).Mesh.StateHash());

        // Counted along the trace: a split adds two faces of a closed mesh, a collapse takes two away.
        int faces = mesh.Faces.Count;
        foreach (JsonElement line in Lines(writer))
        {
            faces = line.GetProperty("operation").GetString() switch
            {
                "split" or "edgeSplit" or "vertexSplit" => faces + 2,
                "collapse" or "edgeCollapse" => faces - 2,
                "nineSplit" or "compact" => line.GetProperty("faces").GetInt32(),
                _ => faces,
            };
        }
        Assert.Equal(result.Mesh.Faces.Count, faces);
    }

    [Theory]
    [Trait("Section", "8")]
    [MemberData(nameof(SchemeTests.Schemes), MemberType = typeof(SchemeTests))]
    public void Subdivide_Trace_HasALinePerStep(SubdivisionScheme scheme)
    {
        using var writer = new StringWriter();
        Mesh finer = Models.Create("sphere").Subdivide(scheme, new() { Steps = 3, Trace = writer });
        JsonElement[] lines = Lines(writer);
        Assert.Equal(3, lines.Length);
        Assert.Equal(finer.Faces.Count, lines[2].GetProperty("faces").GetInt32());
        Assert.Equal(finer.Vertices.Count, lines[2].GetProperty("vertices").GetInt32());
    }

    [Theory]
    [Trait("Section", "L2")]
    [InlineData("cube")]
    [InlineData("holes")]
    public void SubdivideInLaboratory_Trace_HasALinePerOperation(string name)
    {
        using var writer = new StringWriter();
        Mesh mesh = Models.Create(name);
        LaboratorySubdivisionResult result = mesh.SubdivideInLaboratory(trace: writer);
        Assert.Equal(SubdivisionStop.StepsDone, result.StopReason);
        AssertCounts(writer, ("edgeSplit", result.Splits), ("edgeFlip", result.Flips));
        Assert.Null(mesh.Listener);
        Assert.Empty(mesh.Validate());
    }

    private static void AssertCounts(StringWriter writer, params (string Operation, int Count)[] expected)
    {
        JsonElement[] lines = Lines(writer);
        foreach ((string operation, int count) in expected)
            Assert.Equal(count, lines.Count(line => line.GetProperty("operation").GetString() == operation));
        Assert.Equal(Enumerable.Range(0, lines.Length), lines.Select(line => line.GetProperty("step").GetInt32()));
        Assert.Equal(lines.Length, lines.Select(line => line.GetProperty("hash").GetString()).Distinct(StringComparer.Ordinal).Count());
    }

    private static JsonElement[] Lines(StringWriter writer) =>
        [.. writer.ToString().Split('\n', StringSplitOptions.RemoveEmptyEntries).Select(line => JsonDocument.Parse(line).RootElement)];
}
