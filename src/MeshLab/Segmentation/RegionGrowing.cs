using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Segmentation;

/// <summary>How regions grow.</summary>
public sealed record RegionGrowingOptions
{
    /// <summary>What a candidate is compared with.</summary>
    public GrowingReference Reference { get; init; } = GrowingReference.Parent;

    /// <summary>The threshold t; <see langword="null"/> for the book's: 0.896 by vertices, 0.449 by faces.</summary>
    public double? Threshold
    {
        get;
        init => field = value is null || double.IsFinite(value.Value)
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "A threshold is finite.");
    }

    /// <summary>Where regions begin, in this order; what they do not reach is seeded automatically by the lowest index.</summary>
    public IReadOnlyList<int> Seeds { get; init; } = [];
}

/// <summary>§13.2 区域增长: regions grow from seeds over neighbours that are alike, breadth first, until everything has a label.</summary>
/// <remarks>
/// By vertices: v joins if |A(ref) − A(v)| &lt; t·A(ref), with A the area of the one-ring. By faces: f joins if n(ref)·n(f) &gt; t; 0.449 is about 63°,
/// 0.898 about 26°. A face without area has no normal and joins the region that reaches it first. O(V) or O(F).
/// </remarks>
public static class RegionGrowing
{
    /// <summary>The book's threshold by vertices.</summary>
    public const double VertexThreshold = 0.896;

    /// <summary>The book's threshold by faces: the cosine of about 63°.</summary>
    public const double FaceThreshold = 0.449;

    /// <summary>Grows regions of vertices by the area of their one-rings. A face gets the label that two of its corners have, else its lowest.</summary>
    /// <returns>The segmentation of the faces.</returns>
    /// <exception cref="ArgumentException">A seed is no live vertex, or is given twice.</exception>
    public static FaceSegmentation ByVertices(Mesh mesh, RegionGrowingOptions? options = null)
    {
        int[] vertexLabels = VertexLabels(mesh, options);
        var labels = new int[mesh.FaceSlots];
        Array.Fill(labels, -1);
        foreach (Face f in mesh.Faces)
            labels[f.Index] = Majority([.. f.Vertices.Select(v => vertexLabels[v.Index])]);
        return new FaceSegmentation(labels, Relabeling.Compact(labels), double.NaN, 0, SegmentationStop.Complete);
    }

    /// <summary>Grows regions of vertices by the area of their one-rings.</summary>
    /// <returns>Per vertex slot its region; −1 for deleted and isolated vertices.</returns>
    /// <exception cref="ArgumentException">A seed is no live vertex, or is given twice.</exception>
    public static int[] VertexLabels(Mesh mesh, RegionGrowingOptions? options = null)
    {
        options ??= new RegionGrowingOptions();
        double t = options.Threshold ?? VertexThreshold;
        var geometry = new FaceGeometry(mesh);
        var ring = new double[mesh.VertexSlots];
        foreach (Vertex v in mesh.Vertices)
        {
            foreach (Face f in v.Faces)
                ring[v.Index] += geometry.Areas[f.Index];
        }
        var labels = new int[mesh.VertexSlots];
        Array.Fill(labels, -1);
        int[] seeds = Seeds(options.Seeds, labels.Length, i => mesh.Outgoing[i] >= 0, "vertex");
        int regions = 0;
        foreach (int seed in seeds)
        {
            if (labels[seed] >= 0)
                continue;
            double sum = ring[seed];
            int count = 1;
            Grow(seed, regions++, labels, v => mesh.Vertices[v].Neighbors.Select(w => w.Index), (parent, v) =>
            {
                double reference = options.Reference switch
                {
                    GrowingReference.Parent => ring[parent],
                    GrowingReference.Seed => ring[seed],
                    _ => sum / count,
                };
                if (!(Math.Abs(reference - ring[v]) < t * reference))
                    return false;
                sum += ring[v];
                count++;
                return true;
            });
        }
        return labels;
    }

    /// <summary>Grows regions of faces by their normals.</summary>
    /// <exception cref="ArgumentException">A seed is no live face, or is given twice.</exception>
    public static FaceSegmentation ByFaces(Mesh mesh, RegionGrowingOptions? options = null)
    {
        options ??= new RegionGrowingOptions();
        double t = options.Threshold ?? FaceThreshold;
        var geometry = new FaceGeometry(mesh);
        Vector3D[] normals = geometry.Normals;
        var labels = new int[mesh.FaceSlots];
        Array.Fill(labels, -1);
        int[] seeds = Seeds(options.Seeds, labels.Length, i => !mesh.IsDeletedFace(i), "face");
        int regions = 0;
        foreach (int seed in seeds)
        {
            if (labels[seed] >= 0)
                continue;
            Vector3D sum = normals[seed] * geometry.Areas[seed];
            Grow(seed, regions++, labels, f => mesh.Faces[f].Neighbors.Select(g => g.Index), (parent, f) =>
            {
                Vector3D reference = options.Reference switch
                {
                    GrowingReference.Parent => normals[parent],
                    GrowingReference.Seed => normals[seed],
                    _ => sum.Normalized(),
                };
                bool degenerate = normals[f] == Vector3D.Zero || reference == Vector3D.Zero;
                if (!degenerate && !(Vector3D.Dot(reference, normals[f]) > t))
                    return false;
                sum += normals[f] * geometry.Areas[f];
                return true;
            });
        }
        return new FaceSegmentation(labels, Relabeling.Compact(labels), double.NaN, 0, SegmentationStop.Complete);
    }

    /// <summary>Breadth first from a seed; neighbours are asked in their order around the element.</summary>
    private static void Grow(int seed, int region, int[] labels, Func<int, IEnumerable<int>> neighbors, Func<int, int, bool> joins)
    {
        var queue = new Queue<int>();
        labels[seed] = region;
        queue.Enqueue(seed);
        while (queue.TryDequeue(out int parent))
        {
            foreach (int next in neighbors(parent))
            {
                if (labels[next] >= 0 || !joins(parent, next))
                    continue;
                labels[next] = region;
                queue.Enqueue(next);
            }
        }
    }

    /// <summary>The given seeds, then every live element by index.</summary>
    private static int[] Seeds(IReadOnlyList<int> given, int slots, Func<int, bool> isLive, string what)
    {
        var seen = new HashSet<int>();
        foreach (int seed in given)
        {
            if (seed < 0 || seed >= slots || !isLive(seed))
                throw new ArgumentException($"The seed {seed} is no live {what}.", nameof(given));
            if (!seen.Add(seed))
                throw new ArgumentException($"The seed {seed} is given twice.", nameof(given));
        }
        return [.. given, .. Enumerable.Range(0, slots).Where(i => isLive(i) && !seen.Contains(i))];
    }

    private static int Majority(int[] corners)
    {
        for (int i = 0; i < corners.Length; i++)
        {
            if (corners.Count(label => label == corners[i]) * 2 > corners.Length)
                return corners[i];
        }
        return corners.Min();
    }
}
