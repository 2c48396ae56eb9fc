using System.Reflection;
using MeshLab.Cli.Hosting;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Cli.Values;

/// <summary>What a value may depend on beside the mesh.</summary>
/// <param name="From">The vertex that distances start from; −1 if not given.</param>
/// <param name="Fixed">Vertices with given values, for harmonic functions; empty if not given.</param>
/// <param name="SharpAngle">Edges that bend by more than this bound regions (radians).</param>
internal sealed record ValueOptions(int From, IReadOnlyList<(int Vertex, double Value)> Fixed, double SharpAngle)
{

    /// <summary>The start of distances: the option's, else the first live vertex with edges.</summary>
    public int Start(Mesh mesh)
    {
        if (From >= mesh.VertexSlots || From < -1)
            throw new UsageException($"--from {From}: the mesh has vertices 0 to {mesh.VertexSlots - 1}");
        if (From >= 0)
            return From;
        // Negative entries stand for isolated and deleted vertices.
        int first = mesh.Outgoing.IndexOfAnyInRange(0, int.MaxValue);
        return first >= 0 ? first : throw new RefusedException("the mesh has no vertex with edges");
    }
}

/// <summary>A named value per element, as the command line offers it.</summary>
internal sealed class MeshValue
{
    private readonly Func<Mesh, ValueOptions, double[]>? scalars;
    private readonly Func<Mesh, ValueOptions, Vector3D[]>? vectors;

    private MeshValue(MeshValueAttribute mark, MethodInfo method)
    {
        Mark = mark;
        if (method.ReturnType == typeof(double[]))
            scalars = method.CreateDelegate<Func<Mesh, ValueOptions, double[]>>();
        else
            vectors = method.CreateDelegate<Func<Mesh, ValueOptions, Vector3D[]>>();
    }

    public MeshValueAttribute Mark { get; }

    public int Components => scalars is null ? 3 : 1;

    public double[] Scalars(Mesh mesh, ValueOptions options) => scalars!(mesh, options);

    public Vector3D[] Vectors(Mesh mesh, ValueOptions options) => vectors!(mesh, options);

    /// <summary>All values by name.</summary>
    public static SortedDictionary<string, MeshValue> All { get; } = Discover();

    /// <exception cref="UsageException">There is no value of the name.</exception>
    public static MeshValue Named(string name) =>
        All.TryGetValue(name, out MeshValue? value) ? value : throw new UsageException($"there is no value '{name}'; there are {string.Join(" ", All.Keys)}");

    private static SortedDictionary<string, MeshValue> Discover()
    {
        var all = new SortedDictionary<string, MeshValue>(StringComparer.Ordinal);
        foreach (Type type in typeof(MeshValue).Assembly.GetTypes())
        {
            foreach (MethodInfo method in type.GetMethods(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic))
            {
                if (method.GetCustomAttribute<MeshValueAttribute>() is { } mark)
                    all.Add(mark.Name, new MeshValue(mark, method));
            }
        }
        return all;
    }
}
