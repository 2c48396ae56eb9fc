using System.Text;
using MeshLab.Simplification;

namespace MeshLab.Tests.Simplification;

/// <summary>The fields of a progressive mesh's file by name, to change one at a time: <c>magic0</c>, <c>version</c>, <c>vertexSlots</c> … <c>v0.outgoing</c>,
/// <c>e3.next0</c>, <c>f1.slot</c>, <c>s0.halfEdge</c>, <c>s0.left.gone</c>, <c>s0.kept.x</c>. For meshes without traits. Indices are as the
/// program knows them: −1 for none.</summary>
internal sealed class PmFields
{
    private readonly List<(string Name, object Value)> fields = [];

    public PmFields(ProgressiveMesh progressive)
    {
        using var stream = new MemoryStream();
        progressive.Save(stream);
        stream.Position = 0;
        using var reader = new BinaryReader(stream);
        void Byte(string name) => fields.Add((name, reader.ReadByte()));
        void Int(string name, int shift = 0) => fields.Add((name, shift == 0 ? reader.Read7BitEncodedInt() : new Shifted(reader.Read7BitEncodedInt() - 1)));
        void Point(string name) => fields.AddRange("xyz".Select(axis => ($"{name}.{axis}", (object)reader.ReadDouble())));

        for (int i = 0; i < 4; i++)
            Byte($"magic{i}");
        Byte("version");
        foreach (string name in (string[])["vertexSlots", "edgeSlots", "faceSlots", "vertices", "edges", "faces", "splits", "traits", "labels"])
            Int(name);
        for (int i = 0; i < this["vertices"]; i++)
        {
            Int($"v{i}.slot");
            Int($"v{i}.outgoing", 1);
            Point($"v{i}");
        }
        for (int i = 0; i < this["edges"]; i++)
        {
            Int($"e{i}.slot");
            foreach (int side in (int[])[0, 1])
            {
                Int($"e{i}.next{side}");
                Int($"e{i}.target{side}");
                Int($"e{i}.face{side}", 1);
            }
        }
        for (int i = 0; i < this["faces"]; i++)
        {
            Int($"f{i}.slot");
            Int($"f{i}.halfEdge");
        }
        for (int i = 0; i < this["splits"]; i++)
        {
            foreach (string name in (string[])["halfEdge", "removed", "kept", "removedOutgoing", "keptOutgoing"])
                Int($"s{i}.{name}");
            foreach (string side in (string[])["left", "right"])
            {
                Byte($"s{i}.{side}.keptIsNext");
                foreach (string name in (string[])["face", "kept", "gone", "faceHalfEdge", "outerHalfEdge", "apex", "apexOutgoing"])
                    Int($"s{i}.{side}.{name}", 1);
            }
            Point($"s{i}.removed");
            Point($"s{i}.kept");
        }
        if (stream.Position != stream.Length)
            throw new InvalidOperationException("The file has more fields.");
    }

    public int this[string name]
    {
        get => fields[IndexOf(name)].Value switch { byte b => b, Shifted s => s.Value, object value => (int)value };
        set
        {
            int at = IndexOf(name);
            fields[at] = (name, fields[at].Value switch { byte => (byte)value, Shifted => new Shifted(value), _ => value });
        }
    }

    public void SetReal(string name, double value) => fields[IndexOf(name)] = (name, value);

    public void Insert(string before, string name, object value) => fields.Insert(IndexOf(before), (name, value));

    /// <summary>The bytes up to the end of a field, or of all.</summary>
    public byte[] Bytes(string? through = null)
    {
        using var stream = new MemoryStream();
        using var writer = new BinaryWriter(stream, Encoding.UTF8);
        foreach ((string name, object value) in fields)
        {
            switch (value)
            {
                case byte b:
                    writer.Write(b);
                    break;
                case int i:
                    writer.Write7BitEncodedInt(i);
                    break;
                case Shifted s:
                    writer.Write7BitEncodedInt(s.Value + 1);
                    break;
                case string text:
                    writer.Write(text);
                    break;
                case double d:
                    writer.Write(d);
                    break;
            }
            if (name == through)
                break;
        }
        writer.Flush();
        return stream.ToArray();
    }

    public override string ToString() => string.Join('\n', fields.Select(f => $"{f.Name} = {(f.Value is Shifted s ? s.Value : f.Value)}"));

    private int IndexOf(string name)
    {
        int at = fields.FindIndex(f => f.Name == name);
        return at >= 0 ? at : throw new ArgumentException($"The file has no field {name}.", nameof(name));
    }

    /// <summary>An index that is written plus one.</summary>
    private sealed record Shifted(int Value);
}
