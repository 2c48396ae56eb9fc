using MeshLab.Structure;

namespace MeshLab.LinearAlgebra;

/// <summary>§12.5 调和函数 (harmonic function) in one call; <see cref="DirichletProblem"/> keeps the factor for more.</summary>
public static class HarmonicFunction
{
    extension(Mesh mesh)
    {
        /// <summary>The function that is harmonic everywhere but at some vertices with given values.</summary>
        /// <param name="fixedValues">Vertices and their values.</param>
        /// <param name="options">The weights, and what is an error.</param>
        /// <param name="cancellationToken">Stops the work.</param>
        /// <returns>The function per vertex slot; NaN at isolated and deleted vertices.</returns>
        /// <exception cref="ArgumentException">See <see cref="DirichletProblem"/>.</exception>
        public double[] ComputeHarmonicFunction(
            IReadOnlyCollection<(Vertex Vertex, double Value)> fixedValues, HarmonicOptions? options = null, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(fixedValues);
            return new DirichletProblem(mesh, [.. fixedValues.Select(f => f.Vertex)], options, cancellationToken)
                .Solve([.. fixedValues.Select(f => f.Value)]);
        }

        /// <summary>The harmonic function from the lowest to the highest vertex of the largest component (most vertices; of equal ones the first).</summary>
        /// <remarks>The vertex of least z is 0 and the one of greatest z is 1, of several the one of lowest index.</remarks>
        /// <param name="options">The weights.</param>
        /// <param name="cancellationToken">Stops the work.</param>
        /// <returns>The function per vertex slot; NaN outside the component.</returns>
        /// <exception cref="ArgumentException">No vertex has edges, or all of them have the same z.</exception>
        public double[] ComputeHarmonicHeight(HarmonicOptions? options = null, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            (Vertex low, Vertex high) = FindPoles(mesh);
            return mesh.ComputeHarmonicFunction([(low, 0), (high, 1)], (options ?? new HarmonicOptions()) with { AllowUndetermined = true }, cancellationToken);
        }
    }

    private static (Vertex Low, Vertex High) FindPoles(Mesh mesh)
    {
        int[] component = VertexComponents.Of(mesh);
        var size = new int[mesh.VertexSlots];
        int largest = -1;
        foreach (int c in component)
        {
            if (c >= 0)
                size[c]++;
        }
        for (int c = 0; c < size.Length; c++)
        {
            if (size[c] > (largest < 0 ? 0 : size[largest]))
                largest = c;
        }
        int low = -1, high = -1;
        for (int v = 0; v < component.Length; v++)
        {
            if (component[v] != largest || largest < 0)
                continue;
            if (low < 0 || mesh.positions[v].Z < mesh.positions[low].Z)
                low = v;
            if (high < 0 || mesh.positions[v].Z > mesh.positions[high].Z)
                high = v;
        }
        if (low == high)
            throw new ArgumentException("All vertices of the largest component have the same z, so none is lowest and another highest; name the fixed vertices.", nameof(mesh));
        return (mesh.Vertices[low], mesh.Vertices[high]);
    }
}
