using System.Text;
using MeshLab.IO;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>§7.5 Progressive meshes as files (<c>.pm</c>): the base first, then one vertex split after the other, so that a reader can show what it has.</summary>
/// <remarks>
/// Binary, little-endian: <c>MLPM</c>, version 1; slots and counts; traits and labels by name and type; the base's vertices, edges and faces with their slots;
/// then per split the connectivity record, the two positions, what it does to traits, and the trait values of the elements that appear.
/// Numbers are of seven bits a byte, reals are doubles: nothing is rounded.
/// </remarks>
public static class ProgressiveMeshFile
{
    internal const byte Version = 1;

    private const int StepsPerReport = 1 << 10;

    internal static ReadOnlySpan<byte> Magic => "MLPM"u8;

    extension(ProgressiveMesh progressive)
    {
        /// <summary>Writes the progressive mesh to a file. It goes to its base for that and back to where it was.</summary>
        /// <param name="path">The file; it is there only once all is written.</param>
        /// <param name="progress">Hears of the part of the splits that is written, from 0 to 1.</param>
        /// <param name="cancellationToken">Ends the writing; the mesh is valid, at the level that was reached.</param>
        /// <exception cref="ArgumentException">A trait's values are of a type that a file cannot hold, or the mesh is not complete.</exception>
        /// <exception cref="OperationCanceledException">Cancelled.</exception>
        public void Save(string path, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(path);
            Check(progressive);
            AtomicFile.Write(path, stream => progressive.Save(stream, progress, cancellationToken));
        }

        /// <summary>Writes the progressive mesh to a stream.</summary>
        /// <param name="stream">The stream; left open.</param>
        /// <param name="progress">Hears of the part of the splits that is written, from 0 to 1.</param>
        /// <param name="cancellationToken">Ends the writing; the mesh is valid, at the level that was reached.</param>
        /// <exception cref="ArgumentException">A trait's values are of a type that a file cannot hold, or the mesh is not complete.</exception>
        /// <exception cref="OperationCanceledException">Cancelled.</exception>
        public void Save(Stream stream, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(stream);
            Check(progressive);
            int level = progressive.CollapsesDone;
            using var buffered = new BufferedStream(new NonClosingStream(stream), 1 << 16);
            using var writer = new BinaryWriter(buffered, Encoding.UTF8, leaveOpen: true);
            progressive.GoToBase(null, cancellationToken);
            WriteHead(writer, progressive);
            WriteBase(writer, progressive);
            for (int step = progressive.CollapseCount - 1; step >= 0; step--)
            {
                WriteSplit(writer, progressive, step);
                if (step % StepsPerReport == 0)
                {
                    cancellationToken.ThrowIfCancellationRequested();
                    progress?.Report(1 - (double)step / progressive.CollapseCount);
                }
            }
            progressive.GoToCollapse(level, null, cancellationToken);
        }
    }

    /// <summary>Reads a progressive mesh; it is at its finest level.</summary>
    /// <param name="path">The file.</param>
    /// <param name="progress">Hears of the part of the splits that is read, from 0 to 1.</param>
    /// <param name="cancellationToken">Ends the reading; nothing is returned then.</param>
    /// <exception cref="MeshFormatException">The file is not a progressive mesh, or damaged.</exception>
    /// <exception cref="OperationCanceledException">Cancelled.</exception>
    public static ProgressiveMesh Load(string path, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
    {
        using FileStream stream = File.OpenRead(path);
        return Load(stream, path, progress, cancellationToken);
    }

    /// <summary>Reads a progressive mesh; it is at its finest level.</summary>
    /// <param name="stream">The stream; read to the last split.</param>
    /// <param name="name">The name for messages.</param>
    /// <param name="progress">Hears of the part of the splits that is read, from 0 to 1.</param>
    /// <param name="cancellationToken">Ends the reading; nothing is returned then.</param>
    /// <exception cref="MeshFormatException">The stream is not a progressive mesh, or damaged.</exception>
    /// <exception cref="OperationCanceledException">Cancelled.</exception>
    public static ProgressiveMesh Load(
        Stream stream, string name = "-", IProgress<double>? progress = null, CancellationToken cancellationToken = default)
    {
        using var reader = new ProgressiveMeshReader(stream, name, leaveOpen: true);
        ProgressiveMesh progressive = reader.Progressive;
        for (int step = 0; reader.ReadSplit(); step++)
        {
            if (step % StepsPerReport != 0)
                continue;
            cancellationToken.ThrowIfCancellationRequested();
            progress?.Report((step + 1.0) / progressive.CollapseCount);
        }
        cancellationToken.ThrowIfCancellationRequested();
        progress?.Report(1);
        return progressive;
    }

    /// <summary>The half-edges that a split brings back, beside the contracted one's.</summary>
    internal static IEnumerable<int> EdgesOf(SplitRecord record)
    {
        yield return record.HalfEdge >> 1;
        if (record.Left.Face >= 0)
            yield return record.Left.Gone >> 1;
        if (record.Right.Face >= 0)
            yield return record.Right.Gone >> 1;
    }

    /// <summary>The elements of a kind that a split brings back.</summary>
    internal static IEnumerable<int> Restored(SplitRecord record, ElementKind kind) => kind switch
    {
        ElementKind.Vertex => [record.Removed],
        ElementKind.Edge => EdgesOf(record),
        ElementKind.HalfEdge => EdgesOf(record).SelectMany(e => new[] { 2 * e, 2 * e + 1 }),
        _ => new[] { record.Left.Face, record.Right.Face }.Where(f => f >= 0),
    };

    /// <summary>The live elements of a kind.</summary>
    internal static IEnumerable<int> Live(Mesh mesh, ElementKind kind) => kind switch
    {
        ElementKind.Vertex => mesh.Vertices.Select(v => v.Index),
        ElementKind.Edge => mesh.Edges.Select(e => e.Index),
        ElementKind.HalfEdge => mesh.HalfEdges.Select(h => h.Index),
        _ => mesh.Faces.Select(f => f.Index),
    };

    private static void Check(ProgressiveMesh progressive)
    {
        if (!progressive.IsComplete)
            throw new ArgumentException("The progressive mesh is still being read.", nameof(progressive));
        foreach (TraitDelta delta in progressive.Deltas)
        {
            if (!delta.IsPlain || delta.Trait.ValueType.IsEnum || delta.Trait.ValueType == typeof(char))
                throw new ArgumentException($"The trait \"{delta.Trait.Name}\" holds {delta.Trait.ValueType.Name}, which a file cannot hold; remove it first.", nameof(progressive));
        }
    }

    private static void WriteHead(BinaryWriter writer, ProgressiveMesh progressive)
    {
        Mesh mesh = progressive.Mesh;
        writer.Write(Magic);
        writer.Write(Version);
        foreach (int count in (int[])[mesh.VertexSlots, mesh.EdgeSlots, mesh.FaceSlots, mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count, progressive.CollapseCount])
            writer.Write7BitEncodedInt(count);
        writer.Write7BitEncodedInt(progressive.Deltas.Count);
        foreach (TraitDelta delta in progressive.Deltas)
        {
            writer.Write((byte)delta.Trait.Kind);
            writer.Write(delta.Trait.Name);
            writer.Write(delta.Trait.ValueType.Name);
        }
        writer.Write7BitEncodedInt(mesh.FaceLabels.Count);
        foreach (FaceLabels labels in mesh.FaceLabels)
        {
            writer.Write(labels.Sort);
            writer.Write7BitEncodedInt(labels.Names.Count);
            foreach (string name in labels.Names)
                writer.Write(name);
        }
    }

    private static void WriteBase(BinaryWriter writer, ProgressiveMesh progressive)
    {
        Mesh mesh = progressive.Mesh;
        foreach (Vertex v in mesh.Vertices)
        {
            writer.Write7BitEncodedInt(v.Index);
            writer.Write7BitEncodedInt(mesh.Outgoing[v.Index] + 1);
            Write(writer, v.Position);
        }
        foreach (Edge e in mesh.Edges)
        {
            writer.Write7BitEncodedInt(e.Index);
            for (int h = 2 * e.Index; h <= 2 * e.Index + 1; h++)
            {
                writer.Write7BitEncodedInt(mesh.Next[h]);
                writer.Write7BitEncodedInt(mesh.Target[h]);
                writer.Write7BitEncodedInt(mesh.FaceOf[h] + 1);
            }
        }
        foreach (Face f in mesh.Faces)
        {
            writer.Write7BitEncodedInt(f.Index);
            writer.Write7BitEncodedInt(mesh.HalfEdgeOf[f.Index]);
        }
        foreach (TraitDelta delta in progressive.Deltas)
        {
            foreach (int i in Live(mesh, delta.Trait.Kind))
                delta.WriteValue(writer, i);
        }
    }

    private static void WriteSplit(BinaryWriter writer, ProgressiveMesh progressive, int step)
    {
        SplitRecord record = progressive.RecordAt(step);
        foreach (int value in (int[])[record.HalfEdge, record.Removed, record.Kept, record.RemovedOutgoing, record.KeptOutgoing])
            writer.Write7BitEncodedInt(value);
        foreach (SplitSide side in (SplitSide[])[record.Left, record.Right])
        {
            writer.Write(side.KeptIsNext);
            foreach (int value in (int[])[side.Face, side.Kept, side.Gone, side.FaceHalfEdge, side.OuterHalfEdge, side.Apex, side.ApexOutgoing])
                writer.Write7BitEncodedInt(value + 1);
        }
        Write(writer, progressive.Mesh.positions[record.Removed]);
        Write(writer, progressive.OtherPosition(step));
        foreach (TraitDelta delta in progressive.Deltas)
            delta.WriteStep(writer, step);
        progressive.GoToCollapse(step);
        foreach (TraitDelta delta in progressive.Deltas)
        {
            foreach (int i in Restored(record, delta.Trait.Kind))
                delta.WriteValue(writer, i);
        }
    }

    private static void Write(BinaryWriter writer, Vector3D p)
    {
        writer.Write(p.X);
        writer.Write(p.Y);
        writer.Write(p.Z);
    }

    /// <summary>Lets a buffer be disposed of without closing the caller's stream.</summary>
    private sealed class NonClosingStream(Stream inner) : Stream
    {
        public override bool CanRead => false;

        public override bool CanSeek => false;

        public override bool CanWrite => true;

        public override long Length => inner.Length;

        public override long Position
        {
            get => inner.Position;
            set => inner.Position = value;
        }

        public override void Flush() => inner.Flush();

        public override int Read(byte[] buffer, int offset, int count) => inner.Read(buffer, offset, count);

        public override long Seek(long offset, SeekOrigin origin) => inner.Seek(offset, origin);

        public override void SetLength(long value) => inner.SetLength(value);

        public override void Write(byte[] buffer, int offset, int count) => inner.Write(buffer, offset, count);

        public override void Write(ReadOnlySpan<byte> buffer) => inner.Write(buffer);
    }
}
