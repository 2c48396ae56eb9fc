namespace MeshLab.LinearAlgebra;

/// <summary>A symmetric matrix has no Cholesky factor: a pivot came out zero or negative.</summary>
/// <remarks>
/// A zero pivot of a Laplacian usually means that a component of the mesh has no fixed vertex; a negative one that cotangent weights are
/// negative and too large, or that the matrix is not the one intended.
/// </remarks>
public sealed class NotPositiveDefiniteException : ArithmeticException
{
    /// <summary>Creates the exception.</summary>
    /// <param name="row">The row of the matrix, as the caller numbers it, whose pivot failed.</param>
    /// <param name="pivot">The pivot.</param>
    public NotPositiveDefiniteException(int row, double pivot)
        : base(FormattableString.Invariant($"The matrix is not positive definite: the pivot of row {row} is {pivot:R}."))
    {
        Row = row;
        Pivot = pivot;
    }

    /// <summary>The row of the matrix, as the caller numbers it, whose pivot failed.</summary>
    public int Row { get; }

    /// <summary>What is left of the diagonal entry after the rows eliminated before.</summary>
    public double Pivot { get; }
}
