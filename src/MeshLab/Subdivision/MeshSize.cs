using MeshLab.Structure;

namespace MeshLab.Subdivision;

/// <summary>The counts of a mesh, in numbers that do not overflow: what a step makes of them is known before it is done.</summary>
internal readonly record struct MeshSize(long Vertices, long Edges, long Faces, long Corners, long BoundaryEdges)
{
    public static MeshSize Of(Mesh mesh)
    {
        long corners = 0;
        foreach (int f in mesh.FaceOf)
        {
            if (f >= 0)
                corners++;
        }
        return new(mesh.Vertices.Count, mesh.Edges.Count, mesh.Faces.Count, corners, 2L * mesh.Edges.Count - corners);
    }

    /// <summary>Each triangle into four.</summary>
    public MeshSize Quadrisected() => new(Vertices + Edges, 2 * Edges + Corners, 4 * Faces, 4 * Corners, 2 * BoundaryEdges);

    /// <summary>Each triangle into three.</summary>
    public MeshSize Trisected(bool boundary)
    {
        long points = boundary ? Faces + BoundaryEdges : Faces, loops = boundary ? 3 * BoundaryEdges : BoundaryEdges;
        return new(Vertices + points, (9 * Faces + loops) / 2, 3 * Faces, 9 * Faces, loops);
    }

    /// <summary>Each corner becomes a quadrilateral.</summary>
    public MeshSize CornersToQuads() => new(Vertices + Edges + Faces, 2 * Edges + Corners, Corners, 4 * Corners, 2 * BoundaryEdges);

    /// <summary>Each corner becomes a vertex; each face, edge and vertex a face.</summary>
    public MeshSize Dualized()
    {
        long corners = Corners + 4 * Edges + Corners + 2 * BoundaryEdges;
        return new(Corners + 2 * BoundaryEdges, (corners + 2 * BoundaryEdges) / 2, Faces + Edges + Vertices, corners, 2 * BoundaryEdges);
    }

    /// <summary>Throws if this, after so many steps, is more than the budget allows or arrays can hold.</summary>
    public void Check(SubdivisionOptions options, int step)
    {
        if (Faces > options.FaceBudget || 2 * Edges > Array.MaxLength)
        {
            string steps = step < options.Steps ? $"{step} of {options.Steps} steps" : $"{step} steps";
            throw new ArgumentException(
                $"{steps} would make {Vertices} vertices, {Edges} edges and {Faces} faces; the budget is {Math.Min(options.FaceBudget, Array.MaxLength / 3)} faces.",
                nameof(options));
        }
    }
}
