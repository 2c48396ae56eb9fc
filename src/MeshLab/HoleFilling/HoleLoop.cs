using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.HoleFilling;

/// <summary>A loop to be filled, numbered 0 … n − 1 along the hole, and what its triangulations need to know of the mesh.</summary>
internal sealed class HoleLoop
{
    private readonly HashSet<long> taken = [];

    public HoleLoop(Mesh mesh, int start)
    {
        Mesh = mesh;
        var halfEdges = new List<int>();
        int h = start;
        do
        {
            halfEdges.Add(h);
            h = mesh.next[h];
        }
        while (h != start);
        HalfEdges = [.. halfEdges];
        Vertices = Array.ConvertAll(HalfEdges, g => mesh.target[g ^ 1]);
        Points = Array.ConvertAll(Vertices, v => mesh.positions[v]);
        RimNormals = Array.ConvertAll(HalfEdges, g => NormalAcross(mesh, g ^ 1));
        FindChordsTaken();
    }

    public Mesh Mesh { get; }

    public int Count => HalfEdges.Length;

    /// <summary>The boundary half-edges: number i goes from vertex i to vertex i + 1.</summary>
    public int[] HalfEdges { get; }

    public int[] Vertices { get; }

    public Vector3D[] Points { get; }

    /// <summary>Per edge of the loop the unit normal of the face on its other side.</summary>
    public Vector3D[] RimNormals { get; }

    /// <summary>Whether two vertices of the loop that do not follow one another have an edge in the mesh already.</summary>
    public bool IsTaken(int i, int j) => taken.Count > 0 && taken.Contains(Key(i, j));

    /// <summary>Whether a triangulation, three numbers per triangle, has chords that are free and different.</summary>
    public bool Accepts(ReadOnlySpan<int> triangles)
    {
        if (taken.Count == 0)
            return true;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            if (IsBlocked(triangles[t], triangles[t + 1]) || IsBlocked(triangles[t + 1], triangles[t + 2]) || IsBlocked(triangles[t + 2], triangles[t]))
                return false;
        }
        return true;
    }

    private bool IsBlocked(int i, int j) => i < Count && j < Count && IsTaken(i, j);

    private void FindChordsTaken()
    {
        var place = new Dictionary<int, int>(Count);
        for (int i = 0; i < Count; i++)
            place[Vertices[i]] = i;
        for (int i = 0; i < Count; i++)
        {
            int start = HalfEdges[i], h = start;
            do
            {
                if (place.TryGetValue(Mesh.target[h], out int j) && j != (i + 1) % Count && i != (j + 1) % Count)
                    taken.Add(Key(i, j));
                h = Mesh.next[h ^ 1];
            }
            while (h != start);
        }
    }

    private long Key(int i, int j) => ((long)Math.Min(i, j) << 32) | (uint)Math.Max(i, j);

    private static Vector3D NormalAcross(Mesh mesh, int h)
    {
        // A polygon's normal by the sum over its fan.
        Vector3D origin = mesh.positions[mesh.target[h ^ 1]], sum = default;
        for (int g = mesh.next[h]; mesh.next[g] != h; g = mesh.next[g])
            sum += Vector3D.Cross(mesh.positions[mesh.target[g ^ 1]] - origin, mesh.positions[mesh.target[g]] - origin);
        if (mesh.next[mesh.next[mesh.next[h]]] != h)
        {
            int last = mesh.previous[h];
            sum += Vector3D.Cross(mesh.positions[mesh.target[last ^ 1]] - origin, mesh.positions[mesh.target[last]] - origin);
        }
        return sum.Normalized();
    }
}
