using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Morse;

/// <summary>A point of a path on the barycentric subdivision: a vertex, the middle of an edge, or the centre of a face.</summary>
/// <param name="Kind">Vertex, edge or face.</param>
/// <param name="Index">Its index.</param>
public readonly record struct PathPoint(ElementKind Kind, int Index);

/// <summary>An arc (弧) of the Morse complex: the way of steepest change from a saddle to an extremum.</summary>
/// <param name="Saddle">The saddle's vertex.</param>
/// <param name="Extremum">The minimum's or maximum's vertex; none where the arc leaves through the boundary.</param>
/// <param name="IsAscending">Whether it leads up.</param>
/// <param name="Points">The path on the barycentric subdivision, from the middle of the saddle's edge.</param>
/// <param name="Vertices">The path as vertices joined by edges, from the saddle.</param>
public sealed record MorseArc(Vertex Saddle, Vertex Extremum, bool IsAscending, IReadOnlyList<PathPoint> Points, IReadOnlyList<int> Vertices);

/// <summary>§12.4 莫斯复形: the arcs from every saddle down to minima and up to maxima, and the cells that they cut the surface into.</summary>
/// <remarks>
/// From every lower wedge of a saddle one path goes down, from every upper wedge one goes up. Descending paths run along edges of the mesh, ascending ones
/// along the dual, from face centre to face centre across the middles of edges. So on the barycentric subdivision the two use different edges: they may
/// merge with their own kind but never cross. (Steepest ascent along edges of the mesh crosses steepest descent now and then; see <see cref="SteepestPaths"/>.)
/// The nodes, arcs and cells of a closed surface satisfy nodes − arcs + cells = χ. O(V + E + F + length of the arcs).
/// </remarks>
public sealed class MorseComplex
{
    private MorseComplex(DiscreteGradient gradient)
    {
        Gradient = gradient;
        Arcs = Trace();
        MinimumOf = LabelVertices();
        MaximumOf = LabelFaces();
    }

    /// <summary>The gradient whose paths the arcs are, perhaps simplified.</summary>
    public DiscreteGradient Gradient { get; }

    /// <summary>The arcs, by critical edge: two down, then up to two up.</summary>
    public IReadOnlyList<MorseArc> Arcs { get; }

    /// <summary>Ascending manifolds (上升流形): per vertex slot the minimum that it flows down to; −1 for unused vertices.</summary>
    public IReadOnlyList<int> MinimumOf { get; }

    /// <summary>Descending manifolds (下降流形): per face slot the vertex of the maximum that it flows up to; −1 where it leaves through the boundary or is deleted.</summary>
    public IReadOnlyList<int> MaximumOf { get; }

    /// <summary>The complex of a function.</summary>
    public static MorseComplex Of(MorseFunction function) => new(DiscreteGradient.Of(function));

    /// <summary>The complex of a gradient, such as a simplified one.</summary>
    public static MorseComplex Of(DiscreteGradient gradient)
    {
        ArgumentNullException.ThrowIfNull(gradient);
        return new(gradient);
    }

    /// <summary>Where a point of a path lies.</summary>
    public Vector3D PositionOf(PathPoint point)
    {
        Mesh mesh = Gradient.Function.Mesh;
        switch (point.Kind)
        {
            case ElementKind.Vertex:
                return mesh.Vertices[point.Index].Position;
            case ElementKind.Edge:
                Edge e = mesh.Edges[point.Index];
                return (e.Vertex0.Position + e.Vertex1.Position) * 0.5;
            default:
                HalfEdge h = mesh.Faces[point.Index].HalfEdge;
                return (h.Source.Position + h.Target.Position + h.Next.Target.Position) / 3;
        }
    }

    /// <summary>An arc as a line in space.</summary>
    public IReadOnlyList<Vector3D> Polyline(MorseArc arc)
    {
        ArgumentNullException.ThrowIfNull(arc);
        return [.. arc.Points.Select(PositionOf)];
    }

    private List<MorseArc> Trace()
    {
        Mesh mesh = Gradient.Function.Mesh;
        var arcs = new List<MorseArc>();
        foreach (Edge e in Gradient.CriticalEdges)
        {
            foreach (HalfEdge h in (HalfEdge[])[e.HalfEdge0, e.HalfEdge1])
                arcs.Add(Descend(e.Index, h.Target.Index));
            foreach (HalfEdge h in (HalfEdge[])[e.HalfEdge0, e.HalfEdge1])
            {
                if (!h.IsBoundary)
                    arcs.Add(Ascend(e.Index, mesh.FaceOf[h.Index]));
            }
        }
        return arcs;
    }

    private MorseArc Descend(int edge, int v)
    {
        Mesh mesh = Gradient.Function.Mesh;
        int saddle = Gradient.HighestOfEdge(edge);
        List<PathPoint> points = [new(ElementKind.Edge, edge)];
        List<int> vertices = [saddle];
        while (true)
        {
            points.Add(new(ElementKind.Vertex, v));
            if (vertices[^1] != v)
                vertices.Add(v);
            int arrow = Gradient.VertexArrow[v];
            if (arrow < 0)
                break;
            points.Add(new(ElementKind.Edge, arrow >> 1));
            v = mesh.Target[arrow];
        }
        return new(mesh.Vertices[saddle], mesh.Vertices[v], false, points, vertices);
    }

    private MorseArc Ascend(int edge, int f)
    {
        Mesh mesh = Gradient.Function.Mesh;
        int saddle = Gradient.HighestOfEdge(edge);
        List<PathPoint> points = [new(ElementKind.Edge, edge)];
        // The highest vertices of the faces on the way: neighbours of one another, since the edge that is crossed holds the highest of the face before.
        List<int> vertices = [saddle];
        while (f >= 0)
        {
            points.Add(new(ElementKind.Face, f));
            int highest = Gradient.HighestOfFace(f);
            if (vertices[^1] != highest)
                vertices.Add(highest);
            int arrow = Gradient.FaceArrow[f];
            if (arrow < 0)
                return new(mesh.Vertices[saddle], mesh.Vertices[highest], true, points, vertices);
            points.Add(new(ElementKind.Edge, arrow >> 1));
            f = mesh.FaceOf[arrow ^ 1];
        }
        return new(mesh.Vertices[saddle], default, true, points, vertices);
    }

    private int[] LabelVertices()
    {
        Mesh mesh = Gradient.Function.Mesh;
        var pointer = new int[mesh.VertexSlots];
        for (int v = 0; v < pointer.Length; v++)
            pointer[v] = Gradient.VertexArrow[v] >= 0 ? mesh.Target[Gradient.VertexArrow[v]] : Gradient.VertexArrow[v] == -1 ? v : -1;
        return Basins.Labels(pointer, -1);
    }

    private int[] LabelFaces()
    {
        Mesh mesh = Gradient.Function.Mesh;
        var pointer = new int[mesh.FaceSlots];
        for (int f = 0; f < pointer.Length; f++)
            pointer[f] = Gradient.FaceArrow[f] >= 0 ? mesh.FaceOf[Gradient.FaceArrow[f] ^ 1] : Gradient.FaceArrow[f] == -1 ? f : -1;
        int[] label = Basins.Labels(pointer, -1);
        for (int f = 0; f < label.Length; f++)
            label[f] = label[f] < 0 ? -1 : Gradient.HighestOfFace(label[f]);
        return label;
    }
}
