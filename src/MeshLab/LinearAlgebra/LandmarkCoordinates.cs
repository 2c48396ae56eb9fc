using MeshLab.Numerics;

namespace MeshLab.LinearAlgebra;

/// <summary>Positions for the rows of a matrix that has none: distances in the graph of the matrix to four far-apart landmarks.</summary>
/// <remarks>
/// Rows near each other in the graph get positions near each other, which is all that <see cref="NestedDissection"/> needs. The landmarks are
/// found by farthest-point search from the end of a breadth-first search. Cost: five searches, O(entries).
/// </remarks>
internal static class LandmarkCoordinates
{
    private const int Landmarks = 4;

    public static Vector3D[] Of(SparseMatrix matrix)
    {
        int n = matrix.Size;
        var distance = new int[Landmarks][];
        var nearest = new int[n];
        Array.Fill(nearest, int.MaxValue);
        var queue = new int[n];
        int from = n == 0 ? -1 : BreadthFirst(matrix, 0, new int[n], queue);
        for (int l = 0; l < Landmarks; l++)
        {
            distance[l] = new int[n];
            if (n > 0)
                BreadthFirst(matrix, from, distance[l], queue);
            from = Farthest(distance[l], nearest);
        }

        var position = new Vector3D[n];
        for (int i = 0; i < n; i++)
            position[i] = new Vector3D(distance[0][i] - 0.5 * distance[1][i], distance[2][i], distance[3][i]);
        return position;
    }

    // Writes the distances (−1 where not reached) and returns the row reached last.
    private static int BreadthFirst(SparseMatrix matrix, int start, int[] distance, int[] queue)
    {
        ReadOnlySpan<int> rowStart = matrix.RowStart, columns = matrix.Columns;
        Array.Fill(distance, -1);
        distance[start] = 0;
        queue[0] = start;
        int head = 0, tail = 1;
        while (head < tail)
        {
            int i = queue[head++];
            foreach (int j in columns[rowStart[i]..rowStart[i + 1]])
            {
                if (distance[j] >= 0)
                    continue;
                distance[j] = distance[i] + 1;
                queue[tail++] = j;
            }
        }
        return queue[tail - 1];
    }

    // Rows in another component count as near, so that the landmarks stay in the first row's component.
    private static int Farthest(int[] distance, int[] nearest)
    {
        int farthest = 0, largest = -1;
        for (int i = 0; i < distance.Length; i++)
        {
            nearest[i] = Math.Min(nearest[i], Math.Max(distance[i], 0));
            if (nearest[i] <= largest)
                continue;
            largest = nearest[i];
            farthest = i;
        }
        return farthest;
    }
}
