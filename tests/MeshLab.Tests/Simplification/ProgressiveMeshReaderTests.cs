using System.IO.Compression;
using MeshLab.IO;
using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Simplification;

/// <summary>Files of progressive meshes with one or two fields changed: what the reader says, and up to where it had read.</summary>
[Trait("Section", "7.5")]
public class ProgressiveMeshReaderTests
{
    private const string Misfit = "a record that fits the mesh";

    /// <summary>A file of an octahedron in two splits, deflated.</summary>
    private const string Octahedron =
        "8/UJ8GVk4+FgYWNhYmBgkPgPBvftv50WLHroFmYD4zMJMIDBg/1Q2r7e0knvzokUG2Yxrq55PpaVq/ZAZD5AVTAwsHIwYAVAFQJMrGwMTMx8rEziDBzsjExMIqxsHGLMrPxMbFyCzGzsrBzcQP2iz"
        + "ByMfCxirILs4iwsDMLijIyMvLyCzAIM7OIi4oIsYjiMt0elEYCLkYmTn5GZl4WbkVWEgYWfi4eJjYM9RsRYbdlEG+yaPuyHyC+0gQkBAA==";

    /// <summary>A file of a sheet of two by two squares in six splits, along its border first, deflated.</summary>
    private const string Sheet =
        "jVBbDoIwEJzttqWlNSIGFOThTbyAJB7Rg3gYjuARbEyU8DA4X/ucndnueuvIJoaZNECMN+4PTMDpOH9ePpHx40r/7dCOEZNUiZGCEE5IZ8BxqYw7IUrrFLIh+GaJdfna0D9qbgsyTVvAVoQz/16aYhCYR7o"
        + "9kC7yPJNlICnnQ2uKAC+U24Dd1iWCg53qfzuDEi25LiDYMkQMle1NY87joX7VTvi4JSJWpFV4bOyxijnpCw==";

    private static PmFields FieldsOf(string name)
    {
        using var inflated = new DeflateStream(new MemoryStream(Convert.FromBase64String(name == "octahedron" ? Octahedron : Sheet)), CompressionMode.Decompress);
        return new(ProgressiveMeshFile.Load(inflated, name));
    }

    private static MeshFormatException LoadDamaged(PmFields fields) =>
        Assert.Throws<MeshFormatException>(() => ProgressiveMeshFile.Load(new MemoryStream(fields.Bytes()), "levels.pm"));

    private static void AssertSays(MeshFormatException e, PmFields fields, string lastRead, string found, string expected)
    {
        Assert.Equal(("levels.pm", 0, found, expected), (e.File, e.Line, e.Found, e.Expected));
        Assert.Equal(fields.Bytes(lastRead).Length, e.Column);
    }

    [Theory]
    [InlineData("magic2", 'Q', "magic3", "other data", "a progressive mesh, which begins with MLPM")]
    [InlineData("version", 2, "version", "version 2", "version 1")]
    [InlineData("vertexSlots", -1, "vertexSlots", "-1", "a number up to 268435456")]
    [InlineData("vertices", 7, "vertices", "7", "a number up to 6")]
    [InlineData("splits", 7, "splits", "7", "a number up to 6")]
    [InlineData("vertexSlots", 7, "splits", "7 vertices, 12 edges, 8 faces for 2 splits", "counts that agree")]
    [InlineData("edgeSlots", 13, "splits", "6 vertices, 13 edges, 8 faces for 2 splits", "counts that agree")]
    [InlineData("edgeSlots", 9, "splits", "6 vertices, 9 edges, 8 faces for 2 splits", "counts that agree")]
    [InlineData("faceSlots", 9, "splits", "6 vertices, 12 edges, 9 faces for 2 splits", "counts that agree")]
    [InlineData("v0.slot", 6, "v0.slot", "6", "an index below 6")]
    [InlineData("v0.slot", -1, "v0.slot", "-1", "an index below 6")]
    [InlineData("v1.outgoing", 24, "v1.outgoing", "25", "a number up to 24")]
    [InlineData("e2.next1", 24, "e2.next1", "24", "an index below 24")]
    [InlineData("e2.target0", 6, "e2.target0", "6", "an index below 6")]
    [InlineData("e2.face0", 8, "e2.face0", "9", "a number up to 8")]
    [InlineData("f3.slot", 8, "f3.slot", "8", "an index below 8")]
    [InlineData("f3.halfEdge", 24, "f3.halfEdge", "24", "an index below 24")]
    [InlineData("s0.halfEdge", 24, "s0.halfEdge", "24", "an index below 24")]
    [InlineData("s0.removed", 6, "s0.removed", "6", "an index below 6")]
    [InlineData("s1.left.gone", 24, "s1.left.gone", "25", "a number up to 24")]
    public void Load_FieldOutOfRange_SaysWhatAndWhere(string field, int value, string lastRead, string found, string expected)
    {
        PmFields fields = FieldsOf("octahedron");
        fields[field] = value;

        AssertSays(LoadDamaged(fields), fields, lastRead, found, expected);
    }

    [Fact]
    public void Load_BaseThatIsNoMesh_SaysSo()
    {
        PmFields fields = FieldsOf("octahedron");
        fields["e0.next0"] = fields["e5.next0"];

        MeshFormatException e = LoadDamaged(fields);

        Assert.Equal("a valid base", e.Expected);
        Assert.Equal(fields.Bytes("f3.halfEdge").Length, e.Column);
    }

    [Theory]
    [InlineData("s0.halfEdge", 0, "e0 is there already")]
    [InlineData("s0.removed", 2, "v2 is there already")]
    [InlineData("s0.kept", 1, "v1 is not there")]
    [InlineData("s0.right.face", 0, "f0 on both sides")]
    [InlineData("s0.left.kept", -1, "a side without half-edges")]
    [InlineData("s0.left.gone", -1, "a side without half-edges")]
    [InlineData("s0.left.kept", 2, "e1 is not there")]
    [InlineData("s0.left.face", 1, "f1 is there already")]
    [InlineData("s0.left.gone", 0, "e0 is there already")]
    [InlineData("s0.left.gone", 4, "e2 is there already")]
    [InlineData("s0.left.apex", 1, "v1 is not there")]
    [InlineData("s0.left.apex", -1, "v-1 is not there")]
    [InlineData("s0.left.apex", 3, "h0 does not join v3")]
    [InlineData("s0.left.kept", 17, "h17 does not join v0")]
    [InlineData("s0.left.faceHalfEdge", -1, "a side without its first half-edges")]
    [InlineData("s0.left.apexOutgoing", -1, "a side without its first half-edges")]
    [InlineData("s0.left.outerHalfEdge", -1, "a side without its first half-edges")]
    [InlineData("s0.right.gone", 12, "one edge on both sides")]
    [InlineData("s0.left.faceHalfEdge", 16, "h16 is not of f0")]
    [InlineData("s0.left.faceHalfEdge", 5, "h5 is not of f0")]
    [InlineData("s0.left.outerHalfEdge", 14, "h14 is not of f4")]
    [InlineData("s0.removedOutgoing", 0, "h0 does not leave v4")]
    [InlineData("s0.keptOutgoing", 14, "h14 does not leave v0")]
    [InlineData("s0.keptOutgoing", 2, "h2 does not leave v0")]
    [InlineData("s0.left.apexOutgoing", 0, "h0 does not leave v2")]
    public void Load_SplitThatDoesNotFit_SaysWhy(string field, int value, string found)
    {
        PmFields fields = FieldsOf("octahedron");
        fields[field] = value;

        AssertSays(LoadDamaged(fields), fields, "s0.kept.z", found, Misfit);
    }

    [Theory]
    [InlineData("s0.right.gone", 10, "s0", "h10 is not on a border")]
    [InlineData("s0.right.kept", 10, "s0", "h10 is not on a border")]
    [InlineData("s0.right.kept", 29, "s0", "e14 twice on a border")]
    [InlineData("s1.right.kept", 2, "s1", "h2 is not before h2 on a border")]
    [InlineData("s0.right.apex", 8, "s0", "a border with the numbers of a triangle")]
    [InlineData("s0.right.kept", 2, "s0", "The half-edges around h26 do not close.")]
    [InlineData("s0.left.gone", 29, "s0", "f6 is not a triangle")]
    [InlineData("s2.right.gone", 20, "s2", "h20 is not linked")]
    [InlineData("s0.keptOutgoing", 28, "s0", "v8 does not begin at its border")]
    public void Load_SplitThatDoesNotFitABorder_SaysWhy(string field, int value, string split, string found)
    {
        PmFields fields = FieldsOf("sheet");
        fields[field] = value;

        AssertSays(LoadDamaged(fields), fields, $"{split}.kept.z", found, Misfit);
    }

    [Fact]
    public void Load_SplitWithoutAFace_SaysSo()
    {
        PmFields fields = FieldsOf("octahedron");
        fields["s0.left.face"] = fields["s0.right.face"] = -1;

        AssertSays(LoadDamaged(fields), fields, "s0.kept.z", "a split of v0 without a face", Misfit);
    }

    [Theory]
    [InlineData("v0.y", double.NaN, "v0.z")]
    [InlineData("s1.removed.x", double.PositiveInfinity, "s1.removed.z")]
    [InlineData("s1.kept.z", double.NegativeInfinity, "s1.kept.z")]
    public void Load_PositionThatIsNotFinite_IsRefused(string field, double value, string lastRead)
    {
        PmFields fields = FieldsOf("octahedron");
        fields.SetReal(field, value);

        MeshFormatException e = LoadDamaged(fields);

        Assert.Equal("finite coordinates", e.Expected);
        Assert.Equal(fields.Bytes(lastRead).Length, e.Column);
    }

    [Fact]
    public void Load_TraitsOfUnknownKindOrType_AreRefused()
    {
        PmFields kind = FieldsOf("octahedron"), type = FieldsOf("octahedron");
        kind["traits"] = type["traits"] = 1;
        kind.Insert("labels", "kind", (byte)4);
        type.Insert("labels", "kind", (byte)3);
        type.Insert("labels", "name", "colour");
        type.Insert("labels", "type", "Blob");

        AssertSays(LoadDamaged(kind), kind, "kind", "element kind 4", "0 to 3");
        AssertSays(LoadDamaged(type), type, "f3.halfEdge", "a trait of the unknown type Blob", Misfit);
    }

    /// <summary>What cannot be in the data that follows is refused before memory is taken for it; what comes from a pipe ends when it ends.</summary>
    [Fact]
    public void Load_MoreSplitsThanTheDataCanHold_IsRefusedAtOnce()
    {
        PmFields fields = FieldsOf("octahedron");
        const int N = 1000;
        (fields["vertexSlots"], fields["edgeSlots"], fields["faceSlots"], fields["splits"]) = (4 + N, 6 + 3 * N, 4 + 2 * N, N);
        byte[] data = fields.Bytes();

        AssertSays(LoadDamaged(fields), fields, "splits", $"{data.Length} bytes for 1000 splits", "at least 60 bytes for each");
        MeshFormatException e = Assert.Throws<MeshFormatException>(() => ProgressiveMeshFile.Load(new Pipe(data)));
        Assert.Equal(("-", "the end of the data"), (e.File, e.Found));
    }

    [Fact]
    public void Load_CutOffAnywhere_SaysWhereTheDataEnds()
    {
        byte[] data = FieldsOf("octahedron").Bytes();

        for (int length = 0; length < data.Length; length++)
        {
            // Above, the length of a file that can be known is checked first.
            MeshFormatException e = Assert.Throws<MeshFormatException>(() => ProgressiveMeshFile.Load(new Pipe(data[..length])));
            Assert.Equal((0, length, "the end of the data", "more"), (e.Line, e.Column, e.Found, e.Expected));
        }
    }

    [Fact]
    public void Load_ThroughAPipe_IsTheSameAndLeavesItOpen()
    {
        ProgressiveMesh progressive = ProgressiveMesh.Create(Models.Create("octahedron"));
        using var pipe = new Pipe(new PmFields(progressive).Bytes());

        Assert.Equal(progressive.Mesh.StateHash(), ProgressiveMeshFile.Load(pipe).Mesh.StateHash());

        Assert.True(pipe.CanRead);
        using (new ProgressiveMeshReader(new MemoryStream(FieldsOf("sheet").Bytes()), leaveOpen: true))
        {
        }
        var closed = new Pipe(FieldsOf("sheet").Bytes());
        new ProgressiveMeshReader(closed).Dispose();
        Assert.False(closed.CanRead);
    }

    [Fact]
    public void Load_VertexTraitNamedAsALabel_StaysAVertexTrait()
    {
        Mesh mesh = Models.Create("octahedron");
        VertexTrait<int> trait = mesh.AddVertexTrait<int>("material");
        FaceLabels labels = mesh.GetOrAddFaceLabels("material");
        foreach (Vertex v in mesh.Vertices)
            trait[v] = 10 + v.Index;
        foreach (Face f in mesh.Faces)
            labels.Labels[f] = labels.Number($"m{f.Index % 3}");
        using var stream = new MemoryStream();
        ProgressiveMesh.Create(mesh, new() { KeepLabelBorders = false }).Save(stream);
        stream.Position = 0;

        Mesh loaded = ProgressiveMeshFile.Load(stream).Mesh;

        Assert.Equal(mesh.StateHash(), loaded.StateHash());
        Assert.Equal("m2", loaded.FaceLabels[0].NameOf(loaded.Faces[5]));
    }

    [Fact]
    public void Save_WhatAFileCannotHold_IsRefusedByName()
    {
        Mesh colours = Models.Create("octahedron"), letters = colours.Clone();
        colours.AddVertexTrait<ConsoleColor>("colour");
        letters.AddFaceTrait<char>("letter");

        Assert.Contains("\"colour\"", Assert.Throws<ArgumentException>(() => ProgressiveMesh.Create(colours).Save(new MemoryStream())).Message, StringComparison.Ordinal);
        Assert.Contains("\"letter\"", Assert.Throws<ArgumentException>(() => ProgressiveMesh.Create(letters).Save(new MemoryStream())).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Save_WhileItIsRead_IsRefused()
    {
        byte[] data = FieldsOf("octahedron").Bytes();
        using var reader = new ProgressiveMeshReader(new MemoryStream(data));
        Assert.True(reader.ReadSplit());

        Assert.Throws<ArgumentException>(() => reader.Progressive.Save(new MemoryStream()));

        Assert.True(reader.ReadSplit());
        Assert.False(reader.ReadSplit());
        Assert.Equal(data, new PmFields(reader.Progressive).Bytes());
    }

    /// <summary>A stream whose length nobody knows, that gives a few bytes at a time.</summary>
    private sealed class Pipe(byte[] data) : MemoryStream(data)
    {
        public override bool CanSeek => false;

        public override long Length => throw new NotSupportedException();

        public override int Read(Span<byte> buffer) => base.Read(buffer[..Math.Min(buffer.Length, 7)]);
    }
}
