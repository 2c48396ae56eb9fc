using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>
/// Writes long tables: blocks of rows are formatted on several threads and written in order, so that the bytes do not depend on the threads.
/// While one wave of blocks is formatted, the wave before is written.
/// </summary>
internal sealed class BlockWriter(Stream stream, IProgress<double>? progress, CancellationToken cancellationToken)
{
    private const int RowsPerBlock = 1024;
    private const int BlocksPerThread = 8;
    private readonly ByteBuffer head = new();
    private List<ByteBuffer> formatted = [];
    private List<ByteBuffer> written = [];
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
        int blocks = (int)(((long)rows + RowsPerBlock - 1) / RowsPerBlock), wave = BlocksPerThread * Parallelism.Threads;
        int waiting = 0;
        for (int first = 0; first < blocks; first += wave)
        {
            cancellationToken.ThrowIfCancellationRequested();
            progress?.Report(done + share * first / blocks);
            int count = Math.Min(wave, blocks - first), firstBlock = first, before = waiting;
            while (formatted.Count < count)
                formatted.Add(new ByteBuffer());
            // Job 0 writes the wave before; the others format this one.
            Parallelism.ForEach(count + 1, job =>
            {
                if (job == 0)
                    WriteOut(before);
                else
                    FormatBlock(firstBlock + job - 1, rows, formatted[job - 1], format);
            });
            (formatted, written) = (written, formatted);
            waiting = count;
        }

        WriteOut(waiting);
        done += share;
    }

    private static void FormatBlock(int block, int rows, ByteBuffer buffer, Formatter format)
    {
        buffer.Clear();
        long from = (long)block * RowsPerBlock;
        format((int)from, (int)Math.Min(rows, from + RowsPerBlock), buffer);
    }

    private void WriteOut(int count)
    {
        for (int b = 0; b < count; b++)
            stream.Write(written[b].Written.Span);
    }
}
