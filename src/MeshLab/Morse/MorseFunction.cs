using MeshLab.Structure;

namespace MeshLab.Morse;

/// <summary>§12.1 莫斯函数: a value at every vertex of a triangle mesh, and the order of the vertices that it makes.</summary>
/// <remarks>Equal values are told apart by the index (simulation of simplicity), or by a rank of their own where an algorithm returns one with the values.
/// So every function, a constant one too, has no two equal vertices, and Morse's theorem holds for it.</remarks>
public sealed class MorseFunction
{
    /// <summary>Takes values per vertex slot; they are copied.</summary>
    /// <param name="mesh">A mesh of triangles.</param>
    /// <param name="values">Finite, one per vertex slot; those of isolated or deleted vertices are not looked at.</param>
    /// <exception cref="ArgumentException">The number of values is wrong, one of a used vertex is not finite (it is named), or a face is not a triangle.</exception>
    public MorseFunction(Mesh mesh, IReadOnlyList<double> values)
        : this(mesh, [.. values ?? throw new ArgumentNullException(nameof(values))], null)
    {
    }

    internal MorseFunction(Mesh mesh, double[] values, int[]? ranks)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        if (values.Length != mesh.VertexSlots)
            throw new ArgumentException($"There are {values.Length} values for {mesh.VertexSlots} vertices.", nameof(values));
        CheckTriangles(mesh);
        ReadOnlySpan<int> outgoing = mesh.Outgoing;
        for (int v = 0; v < values.Length; v++)
        {
            // −0 and 0 are equal values but differ in bits; adding 0 makes them the same.
            values[v] += 0.0;
            if (outgoing[v] >= 0 && !double.IsFinite(values[v]))
                throw new ArgumentException($"The value at v{v} is {values[v]}; a Morse function is finite everywhere.", nameof(values));
        }
        Mesh = mesh;
        Data = values;
        Ranks = ranks;
    }

    /// <summary>The mesh.</summary>
    public Mesh Mesh { get; }

    /// <summary>The values per vertex slot.</summary>
    public IReadOnlyList<double> Values => Data;

    /// <summary>The value of a vertex.</summary>
    public double this[Vertex vertex] => Data[vertex.Index];

    internal double[] Data { get; }

    /// <summary>Per vertex its place in the order, if that is not the one by value and index.</summary>
    internal int[]? Ranks { get; }

    /// <summary>Whether the first vertex comes before the second in the order of the function.</summary>
    public bool IsLower(Vertex first, Vertex second) => IsLower(first.Index, second.Index);

    internal bool IsLower(int a, int b) => Ranks is null ? new ByValue(Data).Less(a, b) : Ranks[a] < Ranks[b];

    /// <summary>The used vertices from lowest to highest.</summary>
    internal int[] Sorted()
    {
        ReadOnlySpan<int> outgoing = Mesh.Outgoing;
        var vertices = new List<int>(outgoing.Length);
        for (int v = 0; v < outgoing.Length; v++)
        {
            if (outgoing[v] >= 0)
                vertices.Add(v);
        }
        int[] sorted = [.. vertices];
        if (Ranks is null)
            Array.Sort(sorted, new OrderComparer<ByValue>(new ByValue(Data)));
        else
            Array.Sort(sorted, new OrderComparer<ByRank>(new ByRank(Ranks)));
        return sorted;
    }

    private static void CheckTriangles(Mesh mesh)
    {
        if (mesh.IsTriangleMesh)
            return;
        foreach (Face f in mesh.Faces)
        {
            if (!f.IsTriangle)
                throw new ArgumentException($"{f} has {f.Degree} vertices; Morse theory is done on triangles. Triangulate the mesh first.", nameof(mesh));
        }
    }
}
