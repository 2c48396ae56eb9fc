using System.Globalization;
using System.Text;
using MeshLab.Numerics;

namespace MeshLab.Structure;

/// <summary>A step trace: one line of JSON per step (NDJSON), with a hash that depends on all lines before it.</summary>
/// <remarks>
/// <code>
/// {"step":0,"operation":"flip","edge":17,"vertices":[3,8],"hash":"…"}
/// {"step":1,"operation":"split","edge":4,"vertex":90,"position":[0.5,0,0.25],"hash":"…"}
/// {"step":2,"operation":"collapse","edge":9,"kept":5,"removed":12,"position":[0,1,0],"hash":"…"}
/// </code>
/// Two runs did the same if their last lines have the same hash. An algorithm with a <c>Trace</c> option writes into it whatever it works on; operations called by hand are
/// traced with <see cref="OperationTrace"/>.
/// </remarks>
internal sealed class StepTrace
{
    private readonly TextWriter writer;
    private readonly StringBuilder line = new();
    private int step;
    private ulong hash = 14695981039346656037;

    private readonly Func<Vector3D, Vector3D>? place;

    private StepTrace(TextWriter writer, Func<Vector3D, Vector3D>? place) => (this.writer, this.place) = (writer, place);

    /// <summary>A trace into a writer; none without one.</summary>
    /// <param name="writer">The writer.</param>
    /// <param name="place">From coordinates of the work to those of the model, if they differ.</param>
    public static StepTrace? Into(TextWriter? writer, Func<Vector3D, Vector3D>? place = null) => writer is null ? null : new(writer, place);

    private Vector3D Placed(Vector3D p) => place is null ? p : place(p);

    /// <summary>An edge got other ends.</summary>
    public void Flip(int edge, int from, int to) => Begin("flip").Add("edge", edge).Add("vertices", [from, to]).End();

    /// <summary>A vertex was put on an edge.</summary>
    public void Split(int edge, int vertex, Vector3D position) => Begin("split").Add("edge", edge).Add("vertex", vertex).Add("position", position).End();

    /// <summary>An edge was contracted.</summary>
    public void Collapse(int edge, int kept, int removed, Vector3D position) =>
        Begin("collapse").Add("edge", edge).Add("kept", kept).Add("removed", removed).Add("position", position).End();

    /// <summary>Vertices were moved.</summary>
    public void Move(string operation, ReadOnlySpan<Vector3D> positions)
    {
        ulong state = hash;
        foreach (Vector3D p in positions)
        {
            Mix(ref state, BitConverter.DoubleToUInt64Bits(p.X));
            Mix(ref state, BitConverter.DoubleToUInt64Bits(p.Y));
            Mix(ref state, BitConverter.DoubleToUInt64Bits(p.Z));
        }
        hash = state;
        Begin(operation).Add("vertices", positions.Length).End();
    }

    /// <summary>A whole new mesh.</summary>
    public void Remake(string operation, Mesh mesh)
    {
        Mix(ref hash, mesh.StateHash());
        Remake(operation, mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count);
    }

    /// <summary>New elements all over.</summary>
    public void Remake(string operation, int vertices, int edges, int faces) =>
        Begin(operation).Add("vertices", vertices).Add("edges", edges).Add("faces", faces).End();

    /// <summary>A recorded operation on a mesh.</summary>
    public void Operation(OperationRecord record)
    {
        string name = record.Kind.ToString();
        Begin(char.ToLowerInvariant(name[0]) + name[1..]).Add("element", record.Element);
        line.Append(",\"created\":[").AppendJoin(',', Created(record).Select(n => $"\"{n}\"")).Append(']');
        line.Append(",\"removed\":[").AppendJoin(',', record.Removed.Select(r => $"\"{Name(r.Kind, r.Index)}\"")).Append(']');
        string comma = "";
        line.Append(",\"moved\":[");
        foreach ((int vertex, _, Vector3D to) in record.Moves)
        {
            Vector3D p = Placed(to);
            line.Append(CultureInfo.InvariantCulture, $"{comma}[{vertex},{p.X:R},{p.Y:R},{p.Z:R}]");
            comma = ",";
        }
        line.Append(']');
        End();
    }

    private static IEnumerable<string> Created(OperationRecord record)
    {
        foreach ((ElementKind kind, Range range) in new[] { (ElementKind.Vertex, record.CreatedVertices), (ElementKind.Edge, record.CreatedEdges), (ElementKind.Face, record.CreatedFaces) })
        {
            for (int i = range.Start.Value; i < range.End.Value; i++)
                yield return Name(kind, i);
        }
    }

    private static string Name(ElementKind kind, int index) => kind switch
    {
        ElementKind.Vertex => ElementName.Vertex(index),
        ElementKind.HalfEdge => ElementName.HalfEdge(index),
        ElementKind.Edge => ElementName.Edge(index),
        _ => ElementName.Face(index),
    };

    private StepTrace Begin(string operation)
    {
        line.Clear().Append(CultureInfo.InvariantCulture, $"{{\"step\":{step},\"operation\":\"{operation}\"");
        step++;
        return this;
    }

    private StepTrace Add(string name, int value)
    {
        line.Append(CultureInfo.InvariantCulture, $",\"{name}\":{value}");
        return this;
    }

    private StepTrace Add(string name, ReadOnlySpan<int> values)
    {
        line.Append(CultureInfo.InvariantCulture, $",\"{name}\":[");
        for (int i = 0; i < values.Length; i++)
            line.Append(CultureInfo.InvariantCulture, $"{(i > 0 ? "," : "")}{values[i]}");
        line.Append(']');
        return this;
    }

    private StepTrace Add(string name, Vector3D position)
    {
        Vector3D p = Placed(position);
        line.Append(CultureInfo.InvariantCulture, $",\"{name}\":[{p.X:R},{p.Y:R},{p.Z:R}]");
        return this;
    }

    private void End()
    {
        ulong state = hash;
        foreach (ReadOnlyMemory<char> chunk in line.GetChunks())
        {
            foreach (char c in chunk.Span)
                Mix(ref state, c);
        }
        hash = state;
        writer.Write(line.Append(CultureInfo.InvariantCulture, $",\"hash\":\"{hash:x16}\"}}\n"));
    }

    /// <summary>FNV-1a over words.</summary>
    private static void Mix(ref ulong hash, ulong word) => hash = (hash ^ word) * 1099511628211;
}
