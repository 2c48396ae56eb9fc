using MeshLab.Numerics;

namespace MeshLab.LinearAlgebra;

/// <summary>A sparse matrix with entries in symmetric places (稀疏矩阵): the diagonal, and by rows the other entries of both triangles.</summary>
/// <remarks>
/// <para>
/// Row i holds the columns <c>Columns[RowStart[i] .. RowStart[i + 1]]</c> and as many values; the diagonal lies apart. Both a_ij and a_ji are
/// stored, which doubles the memory of half storage, but a row then knows all its neighbours as a vertex does: a product needs no scattered
/// writes, runs in parallel, and adds in the same order always.
/// </para>
/// <para>
/// The order of columns within a row is free and kept. The values may be changed in place; keep both triangles equal if <see cref="IsSymmetric"/>.
/// The one matrix here whose values are not symmetric is the mean-value Laplacian.
/// </para>
/// </remarks>
public sealed class SparseMatrix
{
    private readonly int[] rowStart;
    private readonly int[] columns;
    private readonly double[] values;
    private readonly double[] diagonal;

    internal SparseMatrix(int[] rowStart, int[] columns, double[] values, double[] diagonal, bool isSymmetric = true)
    {
        IsSymmetric = isSymmetric;
        this.rowStart = rowStart;
        this.columns = columns;
        this.values = values;
        this.diagonal = diagonal;
    }

    /// <summary>The number of rows, and of columns.</summary>
    public int Size => diagonal.Length;

    /// <summary>Whether a_ij = a_ji.</summary>
    public bool IsSymmetric { get; }

    /// <summary>The number of stored entries, the diagonal and both triangles.</summary>
    public int NonZeros => diagonal.Length + columns.Length;

    /// <summary>Where each row begins in <see cref="Columns"/> and <see cref="Values"/>; one more entry than rows.</summary>
    public ReadOnlySpan<int> RowStart => rowStart;

    /// <summary>The columns of the entries beside the diagonal, row by row.</summary>
    public ReadOnlySpan<int> Columns => columns;

    /// <summary>The entries beside the diagonal, row by row.</summary>
    public Span<double> Values => values;

    /// <summary>The diagonal.</summary>
    public Span<double> Diagonal => diagonal;

    internal int[] RowStartArray => rowStart;

    internal int[] ColumnArray => columns;

    internal double[] ValueArray => values;

    internal double[] DiagonalArray => diagonal;

    /// <summary>An entry; 0 where none is stored. Cost: the length of the row.</summary>
    /// <param name="row">The row.</param>
    /// <param name="column">The column.</param>
    public double this[int row, int column]
    {
        get
        {
            ArgumentOutOfRangeException.ThrowIfNegative(row);
            ArgumentOutOfRangeException.ThrowIfNegative(column);
            ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(row, Size);
            ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(column, Size);
            if (row == column)
                return diagonal[row];
            int at = columns.AsSpan(rowStart[row], rowStart[row + 1] - rowStart[row]).IndexOf(column);
            return at < 0 ? 0 : values[rowStart[row] + at];
        }
    }

    /// <summary>Builds a matrix from entries of one triangle: (i, j, a) stands for a_ij and a_ji. Entries of the same place are added, in the order given.</summary>
    /// <param name="size">The number of rows.</param>
    /// <param name="entries">The entries; (i, j) and (j, i) are the same place, so give each pair once.</param>
    /// <exception cref="ArgumentOutOfRangeException">An index is not in [0, size).</exception>
    public static SparseMatrix FromEntries(int size, IEnumerable<(int Row, int Column, double Value)> entries)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(size);
        ArgumentNullException.ThrowIfNull(entries);
        var diagonal = new double[size];
        var list = new List<(int Row, int Column, double Value)>();
        var end = new int[size + 1];
        foreach ((int row, int column, double value) in entries)
        {
            if ((uint)row >= (uint)size || (uint)column >= (uint)size)
                throw new ArgumentOutOfRangeException(nameof(entries), (row, column), $"The entry lies outside a matrix of {size} rows.");
            if (row == column)
            {
                diagonal[row] += value;
                continue;
            }
            list.Add((row, column, value));
            end[row + 1]++;
            end[column + 1]++;
        }
        for (int i = 0; i < size; i++)
            end[i + 1] += end[i];

        // Deal the entries out to the rows in the order given …
        var columns = new int[end[size]];
        var values = new double[columns.Length];
        int[] next = end[..size];
        foreach ((int row, int column, double value) in list)
        {
            (columns[next[row]], values[next[row]++]) = (column, value);
            (columns[next[column]], values[next[column]++]) = (row, value);
        }
        return AddSamePlaces(end, columns, values, diagonal);
    }

    // … and add those of the same place.
    private static SparseMatrix AddSamePlaces(int[] end, int[] columns, double[] values, double[] diagonal)
    {
        int size = diagonal.Length, count = 0;
        var rowStart = new int[size + 1];
        var place = new int[size];
        Array.Fill(place, -1);
        for (int i = 0; i < size; i++)
        {
            for (int k = end[i]; k < end[i + 1]; k++)
            {
                int j = columns[k];
                if (place[j] >= rowStart[i])
                {
                    values[place[j]] += values[k];
                    continue;
                }
                place[j] = count;
                (columns[count], values[count++]) = (j, values[k]);
            }
            rowStart[i + 1] = count;
        }
        return new SparseMatrix(rowStart, columns[..count], values[..count], diagonal);
    }

    /// <summary>A diagonal matrix.</summary>
    /// <param name="diagonal">The diagonal.</param>
    public static SparseMatrix FromDiagonal(ReadOnlySpan<double> diagonal) => new(new int[diagonal.Length + 1], [], [], diagonal.ToArray());

    /// <summary>A copy that shares nothing with this matrix.</summary>
    public SparseMatrix Clone() => new((int[])rowStart.Clone(), (int[])columns.Clone(), (double[])values.Clone(), (double[])diagonal.Clone(), IsSymmetric);

    /// <summary>y = A x.</summary>
    /// <param name="x">The vector.</param>
    public double[] Multiply(double[] x)
    {
        var y = new double[Size];
        Multiply(x, y);
        return y;
    }

    /// <summary>y = A x, the rows in parallel.</summary>
    /// <param name="x">The vector.</param>
    /// <param name="y">Receives the product; not the same array as <paramref name="x"/>.</param>
    public void Multiply(double[] x, double[] y)
    {
        CheckLength(x, nameof(x));
        CheckLength(y, nameof(y));
        if (ReferenceEquals(x, y))
            throw new ArgumentException("The product cannot overwrite the vector.", nameof(y));
        Parallelism.ForBlocks(Size, (from, to) =>
        {
            ReadOnlySpan<int> start = rowStart, column = columns;
            ReadOnlySpan<double> value = values;
            for (int i = from; i < to; i++)
            {
                double sum = diagonal[i] * x[i];
                for (int k = start[i]; k < start[i + 1]; k++)
                    sum += value[k] * x[column[k]];
                y[i] = sum;
            }
        });
    }

    /// <summary>xᵀ A x.</summary>
    /// <param name="x">The vector.</param>
    public double QuadraticForm(double[] x)
    {
        double[] y = Multiply(x);
        return Parallelism.SumBlocks(Size, Parallelism.DefaultBlock, (from, to) =>
        {
            double sum = 0;
            for (int i = from; i < to; i++)
                sum += x[i] * y[i];
            return sum;
        });
    }

    /// <summary>factor · A + other; the entries of this matrix come first in each row.</summary>
    /// <param name="factor">Multiplies this matrix.</param>
    /// <param name="other">The matrix added, of the same size.</param>
    public SparseMatrix ScaleAndAdd(double factor, SparseMatrix other)
    {
        ArgumentNullException.ThrowIfNull(other);
        if (other.Size != Size)
            throw new ArgumentException($"A matrix of {other.Size} rows cannot be added to one of {Size}.", nameof(other));

        var sum = new double[Size];
        for (int i = 0; i < sum.Length; i++)
            sum[i] = factor * diagonal[i] + other.diagonal[i];
        var scaled = new double[values.Length];
        for (int k = 0; k < scaled.Length; k++)
            scaled[k] = factor * values[k];
        if (other.columns.Length == 0)
            return new SparseMatrix(rowStart, columns, scaled, sum, IsSymmetric);
        return Merge(other, scaled, sum);
    }

    /// <summary>The rows and columns kept, renumbered in their order.</summary>
    /// <param name="newIndex">Per row its new number, ascending from 0, or −1 to leave it out.</param>
    /// <param name="size">The number of rows kept.</param>
    public SparseMatrix Principal(ReadOnlySpan<int> newIndex, int size)
    {
        if (newIndex.Length != Size)
            throw new ArgumentException($"{newIndex.Length} numbers for {Size} rows.", nameof(newIndex));
        ArgumentOutOfRangeException.ThrowIfNegative(size);
        var oldRow = new int[size];
        int rows = 0;
        for (int i = 0; i < Size; i++)
        {
            if (newIndex[i] < 0)
                continue;
            if (newIndex[i] != rows || rows == size)
                throw new ArgumentException($"Row {i} has the new number {newIndex[i]}, expected {rows} of {size}.", nameof(newIndex));
            oldRow[rows++] = i;
        }
        if (rows != size)
            throw new ArgumentException($"{rows} rows are kept, expected {size}.", nameof(size));
        if (rows == Size)
            return Clone();

        var start = new int[size + 1];
        int[] number = newIndex.ToArray();
        Parallelism.ForBlocks(size, (from, to) =>
        {
            for (int i = from; i < to; i++)
            {
                int count = 0;
                foreach (int j in columns.AsSpan(rowStart[oldRow[i]], rowStart[oldRow[i] + 1] - rowStart[oldRow[i]]))
                    count += number[j] >= 0 ? 1 : 0;
                start[i + 1] = count;
            }
        });
        for (int i = 0; i < size; i++)
            start[i + 1] += start[i];

        var column = new int[start[size]];
        var value = new double[column.Length];
        var kept = new double[size];
        Parallelism.ForBlocks(size, (from, to) =>
        {
            ReadOnlySpan<int> newNumber = number;
            for (int i = from; i < to; i++)
            {
                kept[i] = diagonal[oldRow[i]];
                int at = start[i], first = rowStart[oldRow[i]], count = rowStart[oldRow[i] + 1] - first;
                ReadOnlySpan<int> oldColumns = columns.AsSpan(first, count);
                ReadOnlySpan<double> oldValues = values.AsSpan(first, count);
                for (int k = 0; k < count; k++)
                {
                    int j = newNumber[oldColumns[k]];
                    if (j < 0)
                        continue;
                    column[at] = j;
                    value[at++] = oldValues[k];
                }
            }
        });
        return new SparseMatrix(start, column, value, kept, IsSymmetric);
    }

    internal bool HasPatternOf(int[] otherRowStart, int[] otherColumns) =>
        (ReferenceEquals(rowStart, otherRowStart) || rowStart.AsSpan().SequenceEqual(otherRowStart))
        && (ReferenceEquals(columns, otherColumns) || columns.AsSpan().SequenceEqual(otherColumns));

    private void CheckLength(double[] vector, string name)
    {
        ArgumentNullException.ThrowIfNull(vector, name);
        if (vector.Length != Size)
            throw new ArgumentException($"A vector of {vector.Length} numbers does not fit a matrix of {Size} rows.", name);
    }

    private SparseMatrix Merge(SparseMatrix other, double[] scaled, double[] sum)
    {
        var start = new int[Size + 1];
        var column = new List<int>(columns.Length);
        var value = new List<double>(columns.Length);
        var place = new int[Size];
        Array.Fill(place, -1);
        for (int i = 0; i < Size; i++)
        {
            for (int k = rowStart[i]; k < rowStart[i + 1]; k++)
            {
                place[columns[k]] = column.Count;
                column.Add(columns[k]);
                value.Add(scaled[k]);
            }
            for (int k = other.rowStart[i]; k < other.rowStart[i + 1]; k++)
            {
                int j = other.columns[k];
                if (place[j] >= start[i])
                {
                    value[place[j]] += other.values[k];
                    continue;
                }
                place[j] = column.Count;
                column.Add(j);
                value.Add(other.values[k]);
            }
            start[i + 1] = column.Count;
        }
        return new SparseMatrix(start, [.. column], [.. value], sum, IsSymmetric && other.IsSymmetric);
    }
}
