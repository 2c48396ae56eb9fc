using System.Runtime.CompilerServices;
using MeshLab.Numerics;

namespace MeshLab.Simplification;

/// <summary>The quadric of a vertex: the planes of its faces, and planes that hold borders, features and seams in place.</summary>
/// <param name="mesh">The mesh.</param>
/// <param name="areaWeights">Whether a plane weighs as much as its face's area, else 1.</param>
/// <param name="borderWeight">Weight of a border's plane by squared edge length; 0 for none.</param>
/// <param name="holdBoundary">Whether boundary edges have such planes too.</param>
internal sealed class VertexQuadrics(WorkingMesh mesh, bool areaWeights, double borderWeight, bool holdBoundary)
{
    /// <summary>The quadrics of all vertices.</summary>
    public UncheckedArray<Quadric> GatherAll()
    {
        UncheckedArray<Quadric> quadrics = UncheckedArray<Quadric>.Uninitialized(mesh.Positions.Length);
        Parallelism.ForBlocks(quadrics.Length, (first, end) =>
        {
            for (int v = first; v < end; v++)
            {
                if (mesh.Outgoing[v] >= 0)
                    Gather(v, out quadrics[v]);
            }
        });
        return quadrics;
    }

    /// <summary>The quadric of one vertex, from the faces around it as they are now.</summary>
    public void Gather(int vertex, out Quadric sum)
    {
        sum = default;
        UncheckedArray<HalfEdgeRow> rows = mesh.Rows;
        int start = mesh.Outgoing[vertex], g = start;
        do
        {
            ref HalfEdgeRow row = ref rows[g];
            if (row.Face >= 0)
                AddFace(ref sum, vertex, row.Target, rows[row.Next].Target, 1);
            int otherFace = rows[g ^ 1].Face;
            if (borderWeight > 0 && IsHeld(g, row.Face, otherFace))
                AddBorder(ref sum, vertex, row.Target, rows[row.Face >= 0 ? row.Next : rows[g ^ 1].Next].Target);
            g = rows[g ^ 1].Next;
        }
        while (g != start);
    }

    /// <summary>Adds the plane of the triangle of three vertices, or with sign −1 takes it away.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AddFace(ref Quadric sum, int i, int j, int k, double sign)
    {
        // Always the same corner first, so that a plane has the same bits from wherever it is seen, and taking it away leaves nothing.
        if (j < i)
            (i, j, k) = j < k ? (j, k, i) : (k, i, j);
        else if (k < i)
            (i, j, k) = (k, i, j);
        Vector3D p = mesh.Positions[i], a = mesh.Positions[j], b = mesh.Positions[k];
        Vector3D normal = Vector3D.Cross(a - p, b - p);
        double length = normal.Length;
        if (!(length > 0))
            return;
        normal *= 1 / length;
        // The offset is the mean over the corners: rounding then does not prefer one of them.
        double offset = -(Vector3D.Dot(normal, p) + Vector3D.Dot(normal, a) + Vector3D.Dot(normal, b)) * (1 / 3.0);
        sum.AddPlane(normal, offset, sign * (areaWeights ? 0.5 * length : 1));
    }

    private bool IsHeld(int halfEdge, int face, int otherFace) =>
        (face | otherFace) < 0 ? holdBoundary : mesh.Constraints is { } constraints && constraints.IsSpecial(halfEdge >> 1);

    /// <summary>Adds the plane through the edge from i to j, perpendicular to the triangle (i, j, k).</summary>
    private void AddBorder(ref Quadric sum, int i, int j, int k)
    {
        Vector3D p = mesh.Positions[i], edge = mesh.Positions[j] - p;
        Vector3D normal = Vector3D.Cross(edge, Vector3D.Cross(edge, mesh.Positions[k] - p));
        double squared = edge.LengthSquared, length = normal.Length;
        if (squared > 0 && length > 0)
        {
            normal *= 1 / length;
            sum.AddPlane(normal, -Vector3D.Dot(normal, p), borderWeight * squared);
        }
    }
}
