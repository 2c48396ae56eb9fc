using System.Text;
using MeshLab.IO;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>Reads a progressive mesh as it arrives: the base at once, then split by split.</summary>
public sealed class ProgressiveMeshReader : IDisposable
{
    private const int MaxElements = 1 << 28;
    private readonly BinaryReader reader;
    private readonly CountingStream counting;
    private readonly string name;
    private readonly int splits;
    private int read;

    /// <summary>Reads the base.</summary>
    /// <param name="stream">The stream.</param>
    /// <param name="name">The name for messages.</param>
    /// <param name="leaveOpen">Whether disposing leaves the stream open.</param>
    /// <exception cref="MeshFormatException">The stream does not begin with a progressive mesh.</exception>
    public ProgressiveMeshReader(Stream stream, string name = "-", bool leaveOpen = false)
    {
        ArgumentNullException.ThrowIfNull(stream);
        ArgumentNullException.ThrowIfNull(name);
        this.name = name;
        counting = new CountingStream(stream, leaveOpen);
        reader = new BinaryReader(counting, Encoding.UTF8);
        (Progressive, splits) = Guard(ReadBase);
    }

    /// <summary>What was read so far, at the finest level that is known.</summary>
    public ProgressiveMesh Progressive { get; }

    /// <summary>Reads the next vertex split and does it, if the progressive mesh is at its finest level.</summary>
    /// <returns>False if there is none left.</returns>
    /// <exception cref="MeshFormatException">The stream ends too soon or the split does not fit the mesh.</exception>
    public bool ReadSplit()
    {
        if (read == splits)
            return false;
        Progressive.GoToFinest();
        Guard(() =>
        {
            ReadNextSplit();
            return 0;
        });
        read++;
        return true;
    }

    /// <summary>Closes the stream, unless it is to be left open.</summary>
    public void Dispose() => reader.Dispose();

    private T Guard<T>(Func<T> work)
    {
        try
        {
            return work();
        }
        catch (EndOfStreamException)
        {
            throw Damaged("the end of the data", "more");
        }
        catch (Exception e) when (e is InvalidDataException or FormatException or ArgumentException or IndexOutOfRangeException or TopologyException)
        {
            throw Damaged(e.Message, "a record that fits the mesh");
        }
    }

    private MeshFormatException Damaged(string found, string expected) => new(name, 0, counting.Count, found, expected);

    private (ProgressiveMesh Progressive, int Splits) ReadBase()
    {
        Span<byte> magic = stackalloc byte[4];
        counting.ReadExactly(magic);
        if (!magic.SequenceEqual(ProgressiveMeshFile.Magic))
            throw Damaged("other data", "a progressive mesh, which begins with MLPM");
        byte version = reader.ReadByte();
        if (version != ProgressiveMeshFile.Version)
            throw Damaged($"version {version}", $"version {ProgressiveMeshFile.Version}");
        int vertexSlots = Count(MaxElements), edgeSlots = Count(MaxElements), faceSlots = Count(MaxElements);
        int vertices = Count(vertexSlots), edges = Count(edgeSlots), faces = Count(faceSlots), count = Count(vertexSlots);
        // Every split brings back at least one vertex, two edges and a face: the slots cannot be more than the data will fill.
        if (vertexSlots != vertices + count || edgeSlots > edges + 3L * count || edgeSlots < edges + 2L * count || faceSlots > faces + 2L * count)
            throw Damaged($"{vertexSlots} vertices, {edgeSlots} edges, {faceSlots} faces for {count} splits", "counts that agree");

        if (counting.Known is long length && length < 60L * count)
            throw Damaged($"{length} bytes for {count} splits", "at least 60 bytes for each");

        var mesh = new Mesh { Counts = new(0, 0, 0, 0, 0, 0) };
        var labels = ReadTraitNames(mesh, out List<(ElementKind Kind, string Name, string Type)> traits);
        ReadElements(mesh, vertexSlots, edgeSlots, faceSlots, vertices, edges, faces);
        List<TraitDelta> deltas = AddTraits(mesh, traits, labels, count);
        foreach (TraitDelta delta in deltas)
        {
            foreach (int i in ProgressiveMeshFile.Live(mesh, delta.Trait.Kind))
                delta.ReadValue(reader, i);
        }
        IReadOnlyList<Violation> violations = mesh.Validate();
        if (violations.Count > 0)
            throw Damaged(violations[0].ToString(), "a valid base");
        var progressive = new ProgressiveMesh(mesh, new SplitRecord[count], new Vector3D[count], deltas, count);
        progressive.SetFaceRange(faces, faces);
        return (progressive, count);
    }

    private Dictionary<string, List<string>> ReadTraitNames(Mesh mesh, out List<(ElementKind Kind, string Name, string Type)> traits)
    {
        traits = [];
        int count = Count(1 << 16);
        for (int i = 0; i < count; i++)
        {
            byte kind = reader.ReadByte();
            if (kind > (byte)ElementKind.Face)
                throw Damaged($"element kind {kind}", "0 to 3");
            traits.Add(((ElementKind)kind, reader.ReadString(), reader.ReadString()));
        }
        var labels = new Dictionary<string, List<string>>(StringComparer.Ordinal);
        int sorts = Count(1 << 16);
        for (int i = 0; i < sorts; i++)
        {
            string sort = reader.ReadString();
            int names = Count(MaxElements);
            var list = new List<string>();
            for (int k = 0; k < names; k++)
                list.Add(reader.ReadString());
            labels[sort] = list;
        }
        return labels;
    }

    private static List<TraitDelta> AddTraits(
        Mesh mesh, List<(ElementKind Kind, string Name, string Type)> traits, Dictionary<string, List<string>> labels, int splits)
    {
        var deltas = new List<TraitDelta>();
        foreach ((ElementKind kind, string name, string type) in traits)
        {
            Trait? trait;
            if (kind == ElementKind.Face && labels.TryGetValue(name, out List<string>? names))
            {
                FaceLabels group = mesh.GetOrAddFaceLabels(name);
                foreach (string label in names)
                    group.Number(label);
                trait = group.Labels;
            }
            else
            {
                trait = TraitTypes.Add(mesh, kind, name, type);
            }
            deltas.Add((trait ?? throw new InvalidDataException($"a trait of the unknown type {type}")).NewDelta(splits));
        }
        return deltas;
    }

    private void ReadElements(Mesh mesh, int vertexSlots, int edgeSlots, int faceSlots, int vertices, int edges, int faces)
    {
        // Read first, allocate the slots afterwards: a damaged count then meets the end of the data, not the end of memory.
        var vertexRows = new List<(int Slot, int Outgoing, Vector3D Position)>();
        for (int i = 0; i < vertices; i++)
            vertexRows.Add((Index(vertexSlots), Count(2 * edgeSlots) - 1, Position()));
        var edgeRows = new List<(int Slot, int Next0, int Target0, int Face0, int Next1, int Target1, int Face1)>();
        for (int i = 0; i < edges; i++)
        {
            edgeRows.Add((
                Index(edgeSlots),
                Index(2 * edgeSlots), Index(vertexSlots), Count(faceSlots) - 1,
                Index(2 * edgeSlots), Index(vertexSlots), Count(faceSlots) - 1));
        }
        var faceRows = new List<(int Slot, int HalfEdge)>();
        for (int i = 0; i < faces; i++)
            faceRows.Add((Index(faceSlots), Index(2 * edgeSlots)));

        mesh.Counts = new(vertexSlots, 2 * edgeSlots, faceSlots, vertices, edges, faces);
        Array.Fill(mesh.outgoing, Mesh.DeletedVertexMark);
        foreach (int[] column in (int[][])[mesh.next, mesh.previous, mesh.target, mesh.face, mesh.halfEdgeOf])
            Array.Fill(column, -1);
        foreach (var (slot, outgoing, position) in vertexRows)
            (mesh.outgoing[slot], mesh.positions[slot]) = (outgoing, position);
        foreach (var (slot, next0, target0, face0, next1, target1, face1) in edgeRows)
        {
            int h = 2 * slot;
            (mesh.next[h], mesh.target[h], mesh.face[h]) = (next0, target0, face0);
            (mesh.next[h + 1], mesh.target[h + 1], mesh.face[h + 1]) = (next1, target1, face1);
            mesh.previous[next0] = h;
            mesh.previous[next1] = h + 1;
        }
        foreach (var (slot, halfEdge) in faceRows)
            mesh.halfEdgeOf[slot] = halfEdge;
    }

    private void ReadNextSplit()
    {
        Mesh mesh = Progressive.Mesh;
        var record = new SplitRecord(
            Index(mesh.HalfEdgeSlots), Index(mesh.VertexSlots), Index(mesh.VertexSlots), Index(mesh.HalfEdgeSlots), Index(mesh.HalfEdgeSlots), Side(mesh), Side(mesh));
        Vector3D removed = Position(), kept = Position();
        SplitCheck.Check(mesh, record);
        int step = Progressive.CollapsesDone - 1;
        foreach (TraitDelta delta in Progressive.Deltas)
            delta.ReadStep(reader, step);
        mesh.positions[record.Removed] = removed;
        Progressive.AddFiner(record, kept);
        Progressive.GoToCollapse(step);
        SplitCheck.CheckAfter(mesh, record);
        foreach (TraitDelta delta in Progressive.Deltas)
        {
            foreach (int i in ProgressiveMeshFile.Restored(record, delta.Trait.Kind))
                delta.ReadValue(reader, i);
        }
    }

    private SplitSide Side(Mesh mesh)
    {
        bool keptIsNext = reader.ReadBoolean();
        return new(
            Count(mesh.FaceSlots) - 1, Count(mesh.HalfEdgeSlots) - 1, Count(mesh.HalfEdgeSlots) - 1, keptIsNext, Count(mesh.HalfEdgeSlots) - 1,
            Count(mesh.HalfEdgeSlots) - 1, Count(mesh.VertexSlots) - 1, Count(mesh.HalfEdgeSlots) - 1);
    }

    private int Index(int slots)
    {
        int value = reader.Read7BitEncodedInt();
        return (uint)value < (uint)slots ? value : throw Damaged($"{value}", $"an index below {slots}");
    }

    private int Count(int most)
    {
        int value = reader.Read7BitEncodedInt();
        return (uint)value <= (uint)most ? value : throw Damaged($"{value}", $"a number up to {most}");
    }

    private Vector3D Position()
    {
        var p = new Vector3D(reader.ReadDouble(), reader.ReadDouble(), reader.ReadDouble());
        return p.IsFinite ? p : throw Damaged($"the position {p}", "finite coordinates");
    }

    /// <summary>Buffers, and knows how far the reader is.</summary>
    private sealed class CountingStream(Stream inner, bool leaveOpen) : Stream
    {
        private readonly byte[] buffer = new byte[1 << 16];
        private int at;
        private int end;

        public long Count { get; private set; }

        /// <summary>The length of the data, if it is known.</summary>
        public long? Known => inner.CanSeek ? inner.Length : null;

        public override bool CanRead => true;

        public override bool CanSeek => false;

        public override bool CanWrite => false;

        public override long Length => throw new NotSupportedException();

        public override long Position
        {
            get => Count;
            set => throw new NotSupportedException();
        }

        public override int Read(byte[] target, int offset, int count) => Read(target.AsSpan(offset, count));

        public override int Read(Span<byte> target)
        {
            if (at == end)
            {
                end = inner.Read(buffer);
                at = 0;
            }
            int count = Math.Min(target.Length, end - at);
            buffer.AsSpan(at, count).CopyTo(target);
            at += count;
            Count += count;
            return count;
        }

        public override void Flush()
        {
        }

        public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

        public override void SetLength(long value) => throw new NotSupportedException();

        public override void Write(byte[] source, int offset, int count) => throw new NotSupportedException();

        protected override void Dispose(bool disposing)
        {
            if (disposing && !leaveOpen)
                inner.Dispose();
            base.Dispose(disposing);
        }
    }
}

/// <summary>Whether a split that was read fits the mesh: what it brings back must be absent, what it hangs on must be there.</summary>
internal static class SplitCheck
{
    public static void Check(Mesh mesh, SplitRecord record)
    {
        Require(mesh.IsDeletedEdge(record.HalfEdge >> 1), $"e{record.HalfEdge >> 1} is there already");
        Require(mesh.IsDeletedVertex(record.Removed), $"v{record.Removed} is there already");
        Require(mesh.Outgoing[record.Kept] >= 0, $"v{record.Kept} is not there");
        Require(record.Left.Face >= 0 || record.Right.Face >= 0, $"a split of v{record.Kept} without a face");
        Require(record.Left.Face != record.Right.Face, $"f{record.Left.Face} on both sides");
        CheckSide(mesh, record, record.Left, record.Right);
        CheckSide(mesh, record, record.Right, record.Left);
        Require(record.Left.Face < 0 || record.Right.Face < 0 || record.Left.Gone >> 1 != record.Right.Gone >> 1, "one edge on both sides");
    }

    /// <summary>The rules around the two vertices, after the split.</summary>
    public static void CheckAfter(Mesh mesh, SplitRecord record)
    {
        foreach (int v in (ReadOnlySpan<int>)[record.Removed, record.Kept, record.Left.Apex, record.Right.Apex])
        {
            if (v < 0)
                continue;
            int start = mesh.Outgoing[v], g = start, left = mesh.HalfEdgeSlots;
            bool boundary = false;
            do
            {
                Require(mesh.Next[g] >= 0 && mesh.Target[g ^ 1] == v, $"h{g} does not leave v{v}");
                Require(mesh.Previous[mesh.Next[g]] == g && mesh.FaceOf[mesh.Next[g]] == mesh.FaceOf[g], $"h{g} is not linked");
                Require(mesh.FaceOf[g] < 0 || mesh.Next[mesh.Next[mesh.Next[g]]] == g, $"f{mesh.FaceOf[g]} is not a triangle");
                boundary |= mesh.FaceOf[g] < 0;
                g = mesh.Next[g ^ 1];
                Require(g >= 0 && --left > 0, $"the ring of v{v} does not close");
            }
            while (g != start);
            Require(!boundary || mesh.FaceOf[start] < 0, $"v{v} does not begin at its border");
        }
        CheckFaces(mesh, record.Left);
        CheckFaces(mesh, record.Right);
    }

    /// <summary>The face that came back and the one beyond the edge that did begin with half-edges of their own.</summary>
    private static void CheckFaces(Mesh mesh, SplitSide side)
    {
        if (side.Face < 0)
            return;
        Require(mesh.FaceOf[side.FaceHalfEdge] == side.Face, $"h{side.FaceHalfEdge} is not of f{side.Face}");
        int outer = mesh.FaceOf[side.Gone ^ 1];
        Require(outer < 0 || mesh.FaceOf[mesh.HalfEdgeOf[outer]] == outer, $"h{side.OuterHalfEdge} is not of f{outer}");
    }

    private static void CheckSide(Mesh mesh, SplitRecord record, SplitSide side, SplitSide other)
    {
        Require(side.Kept >= 0 && side.Gone >= 0, "a side without half-edges");
        if (side.Face < 0)
        {
            CheckBorder(mesh, side, other);
            return;
        }
        Require(!mesh.IsDeletedEdge(side.Kept >> 1), $"e{side.Kept >> 1} is not there");
        Require(mesh.IsDeletedFace(side.Face), $"f{side.Face} is there already");
        Require(mesh.IsDeletedEdge(side.Gone >> 1) && side.Gone >> 1 != record.HalfEdge >> 1, $"e{side.Gone >> 1} is there already");
        Require(side.Apex >= 0 && mesh.Outgoing[side.Apex] >= 0, $"v{side.Apex} is not there");
        Require(mesh.Target[side.KeptIsNext ? side.Kept : side.Kept ^ 1] == side.Apex, $"h{side.Kept} does not join v{side.Apex}");
        Require(mesh.Target[side.KeptIsNext ? side.Kept ^ 1 : side.Kept] == record.Kept, $"h{side.Kept} does not join v{record.Kept}");
        Require(side.FaceHalfEdge >= 0 && side.ApexOutgoing >= 0 && (side.OuterHalfEdge >= 0 || mesh.FaceOf[side.Kept] < 0), "a side without its first half-edges");
    }

    /// <summary>A border's half-edge before or after the contracted one may lie on the edge that comes back with the triangle of the other side.</summary>
    private static void CheckBorder(Mesh mesh, SplitSide side, SplitSide other)
    {
        Require(side is { FaceHalfEdge: < 0, OuterHalfEdge: < 0, Apex: < 0, ApexOutgoing: < 0 }, "a border with the numbers of a triangle");
        bool goneReturns = other.Face >= 0 && side.Gone >> 1 == other.Gone >> 1, keptReturns = other.Face >= 0 && side.Kept >> 1 == other.Gone >> 1;
        Require(goneReturns || (!mesh.IsDeletedEdge(side.Gone >> 1) && mesh.FaceOf[side.Gone] < 0), $"h{side.Gone} is not on a border");
        Require(keptReturns || (!mesh.IsDeletedEdge(side.Kept >> 1) && mesh.FaceOf[side.Kept] < 0), $"h{side.Kept} is not on a border");
        Require(goneReturns || keptReturns || mesh.Next[side.Gone] == side.Kept, $"h{side.Gone} is not before h{side.Kept} on a border");
        Require(!goneReturns || !keptReturns, $"e{other.Gone >> 1} twice on a border");
    }

    private static void Require(bool condition, string found)
    {
        if (!condition)
            throw new InvalidDataException(found);
    }
}
