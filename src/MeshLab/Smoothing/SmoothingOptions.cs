using MeshLab.LinearAlgebra;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Smoothing;

/// <summary>What smoothing does with boundary vertices.</summary>
public enum SmoothingBoundary
{
    /// <summary>They stay where they are.</summary>
    Fixed,

    /// <summary>Boundary loops are smoothed as curves, without regard to the surface.</summary>
    AlongCurve,

    /// <summary>They move like all others, by the neighbours they have; open surfaces shrink.</summary>
    Free,
}

/// <summary>What all ways of smoothing have in common.</summary>
public abstract record SmoothingOptions
{
    private readonly int steps = 10;

    /// <summary>How many times the surface is smoothed; 10 unless set.</summary>
    public int Steps
    {
        get => steps;
        init
        {
            ArgumentOutOfRangeException.ThrowIfNegative(value);
            steps = value;
        }
    }

    /// <summary>What happens at the boundary; nothing unless set.</summary>
    public SmoothingBoundary Boundary { get; init; } = SmoothingBoundary.Fixed;

    private protected static double Checked(double value, double aboveThis, double most, string name)
    {
        if (!(value > aboveThis && value <= most))
            throw new ArgumentOutOfRangeException(name, value, $"The value must be more than {aboveThis} and at most {most}.");
        return value;
    }
}

/// <summary>What was done.</summary>
/// <param name="Steps">The steps taken.</param>
/// <param name="LargestMove">The longest way that a vertex is now from where it was.</param>
/// <param name="MeanMove">The mean of these ways over the vertices with edges.</param>
public sealed record SmoothingResult(int Steps, double LargestMove, double MeanMove);

/// <summary>Positions on their way; the mesh gets them at the end, so that a cancelled call leaves it as it was.</summary>
internal sealed class MovingPositions
{
    private readonly Mesh mesh;
    private Vector3D[] next;

    public MovingPositions(Mesh mesh)
    {
        this.mesh = mesh;
        Current = mesh.Positions.ToArray();
        next = (Vector3D[])Current.Clone();
    }

    public Vector3D[] Current { get; private set; }

    // The buffers change places; fixed and isolated vertices are never written and so are the same in both.
    /// <summary>Moves every vertex with edges by <paramref name="factor"/> towards the weighted mean of its neighbours.</summary>
    /// <param name="factor">1 moves into the mean; negative moves away.</param>
    /// <param name="weights">Per edge slot, or null for equal weights.</param>
    /// <param name="boundary">The rule for boundary vertices.</param>
    public void Step(double factor, double[]? weights, SmoothingBoundary boundary)
    {
        int[] nextOf = mesh.next, target = mesh.target, outgoing = mesh.outgoing, face = mesh.face;
        Vector3D[] from = Current, to = next;
        Parallelism.ForBlocks(mesh.VertexSlots, (begin, end) =>
        {
            for (int v = begin; v < end; v++)
            {
                int first = outgoing[v];
                if (first < 0)
                    continue;
                // A boundary vertex's first half-edge is a boundary one, and so is the last to come back.
                bool isBoundary = face[first] < 0;
                if (isBoundary && boundary == SmoothingBoundary.Fixed)
                    continue;
                if (isBoundary && boundary == SmoothingBoundary.AlongCurve)
                {
                    Vector3D middle = (from[target[first]] + from[target[mesh.previous[first] ^ 1]]) / 2;
                    to[v] = from[v] + factor * (middle - from[v]);
                    continue;
                }

                Vector3D sum = default;
                double total = 0;
                int h = first;
                do
                {
                    double w = weights is null ? 1 : weights[h >> 1];
                    sum += w * (from[target[h]] - from[v]);
                    total += w;
                    h = nextOf[h ^ 1];
                }
                while (h != first);
                to[v] = total > 0 ? from[v] + factor / total * sum : from[v];
            }
        });
        (Current, next) = (to, from);
    }

    /// <summary>Replaces the positions.</summary>
    public void Replace(Vector3D[] positions) => Current = positions;

    /// <summary>Writes the positions into the mesh.</summary>
    /// <exception cref="ArithmeticException">A coordinate is not finite; the mesh is not changed.</exception>
    public SmoothingResult Finish(int steps)
    {
        double largest = 0, sum = 0;
        int count = 0;
        for (int v = 0; v < Current.Length; v++)
        {
            if (mesh.outgoing[v] < 0)
                continue;
            if (!Current[v].IsFinite)
                throw new ArithmeticException($"Smoothing moved v{v} to {Current[v]}; the mesh is left as it was.");
            double move = Vector3D.Distance(Current[v], mesh.positions[v]);
            largest = Math.Max(largest, move);
            sum += move;
            count++;
        }
        for (int v = 0; v < Current.Length; v++)
        {
            if (mesh.outgoing[v] < 0 || Current[v] == mesh.positions[v])
                continue;
            if (mesh.Listener is null)
                mesh.positions[v] = Current[v];
            else
                mesh.MoveVertex(mesh.Vertices[v], Current[v]);
        }
        return new SmoothingResult(steps, largest, count == 0 ? 0 : sum / count);
    }
}
