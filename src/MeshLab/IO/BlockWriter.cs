using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>Writes long tables: blocks of rows are formatted on several threads and written in order, so that the bytes do not depend on the threads.</summary>
internal sealed class BlockWriter(Stream stream, IProgress<double>? progress, CancellationToken cancellationToken)
{
    private const int RowsPerBlock = 4096;
    private readonly List<ByteBuffer> buffers = [];
    private readonly ByteBuffer head = new();
    private double done;

    /// <summary>Formats the rows from one index to another.</summary>
    public delegate void Formatter(int from, int to, ByteBuffer buffer);

    /// <summary>Writes something short.</summary>
    public void Write(Action<ByteBuffer> format)
    {
        head.Clear();
        format(head);
        stream.Write(head.Written.Span);
    }

    /// <summary>Writes a table.</summary>
    /// <param name="rows">The number of rows.</param>
    /// <param name="share">Which share of the whole work this is.</param>
    /// <param name="format">Formats rows; called from several threads at once.</param>
    public void WriteRows(int rows, double share, Formatter format)
    {
        int blocks = (int)(((long)rows + RowsPerBlock - 1) / RowsPerBlock), wave = Math.Max(1, 4 * Parallelism.Threads);
        while (buffers.Count < Math.Min(wave, blocks))
            buffers.Add(new ByteBuffer());
        for (int first = 0; first < blocks; first += wave)
        {
            cancellationToken.ThrowIfCancellationRequested();
            progress?.Report(done + share * first / blocks);
            int count = Math.Min(wave, blocks - first), firstBlock = first;
            Parallelism.ForBlocks(count, 1, (b, _) =>
            {
                ByteBuffer buffer = buffers[b];
                buffer.Clear();
                long from = (long)(firstBlock + b) * RowsPerBlock;
                format((int)from, (int)Math.Min(rows, from + RowsPerBlock), buffer);
            });
            for (int b = 0; b < count; b++)
                stream.Write(buffers[b].Written.Span);
        }

        done += share;
    }
}
