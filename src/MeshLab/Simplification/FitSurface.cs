using System.Runtime.CompilerServices;
using MeshLab.Numerics;
using MeshLab.Spatial;

namespace MeshLab.Simplification;

/// <summary>The simplified surface while it is fitted: its triangles as rows of three vertices, and closest points on them.</summary>
internal sealed class FitSurface
{
    private const int MaxSteps = 12;

    public FitSurface(CompactResult result)
    {
        Positions = result.Positions;
        Next = result.Next;
        Previous = result.Previous;
        Target = result.Target;
        Face = result.Face;
        Outgoing = result.Outgoing;
        HalfEdgeOf = result.HalfEdgeOf;
        Corners = new (int, int, int)[HalfEdgeOf.Length];
        for (int f = 0; f < Corners.Length; f++)
        {
            int h = HalfEdgeOf[f];
            Corners[f] = (Target[h], Target[Next[h]], Target[Previous[h]]);
        }
        Normals = new Vector3D[Corners.Length];
    }

    public UncheckedArray<Vector3D> Positions { get; }

    public UncheckedArray<int> Next { get; }

    public UncheckedArray<int> Previous { get; }

    public UncheckedArray<int> Target { get; }

    public UncheckedArray<int> Face { get; }

    public UncheckedArray<int> Outgoing { get; }

    public UncheckedArray<int> HalfEdgeOf { get; }

    /// <summary>Per face its vertices, beginning with the target of its half-edge.</summary>
    public UncheckedArray<(int A, int B, int C)> Corners { get; }

    /// <summary>Per face its unit normal, as of the last <see cref="UpdateNormals"/>.</summary>
    public UncheckedArray<Vector3D> Normals { get; }

    public int FaceCount => Corners.Length;

    public int VertexCount => Positions.Length;

    public bool IsBoundary(int vertex) => Face[Outgoing[vertex]] < 0;

    public void UpdateNormals() => Parallelism.ForBlocks(FaceCount, (first, end) =>
    {
        for (int f = first; f < end; f++)
        {
            Vector3D normal = DoubledArea(f);
            double length = normal.Length;
            Normals[f] = length > 0 ? normal * (1 / length) : default;
        }
    });

    /// <summary>A tree over the faces as they are now.</summary>
    public FaceTree BuildTree()
    {
        int[] corners = new int[3 * FaceCount];
        for (int f = 0; f < FaceCount; f++)
            (corners[3 * f], corners[3 * f + 1], corners[3 * f + 2]) = Corners[f];
        return FaceTree.Build(Positions.Items, corners);
    }

    /// <summary>The cross product of two edges of a face.</summary>
    public Vector3D DoubledArea(int face)
    {
        var (a, b, c) = Corners[face];
        return Vector3D.Cross(Positions[b] - Positions[a], Positions[c] - Positions[a]);
    }

    /// <summary>The squared distance of a point from a face, and the weights of the closest point at the corners.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double DistanceSquared(int face, Vector3D point, out Vector3D weights)
    {
        var (a, b, c) = Corners[face];
        return PointOnTriangle.Closest(point, Positions[a], Positions[b], Positions[c], out weights);
    }

    /// <summary>Makes a face around a vertex the closest one, if it is closer than the best so far.</summary>
    public void SearchRing(int vertex, Vector3D point, ref double distance, ref int face)
    {
        int start = Outgoing[vertex], g = start;
        do
        {
            int candidate = Face[g];
            if (candidate >= 0)
            {
                double d = DistanceSquared(candidate, point, out _);
                if (d < distance)
                    (distance, face) = (d, candidate);
            }
            g = Next[g ^ 1];
        }
        while (g != start);
    }

    /// <summary>Walks from a face downhill to the one that is closest to a point: over an edge if the closest point lies on an edge, around a vertex if on a
    /// vertex, until it lies inside or nothing is closer.</summary>
    public double Walk(Vector3D point, ref int face, out Vector3D weights)
    {
        double distance = DistanceSquared(face, point, out weights);
        for (int step = 0; step < MaxSteps; step++)
        {
            if (weights.X > 0 && weights.Y > 0 && weights.Z > 0)
                break;
            int best = face, h = HalfEdgeOf[face];
            int zeros = (weights.X == 0 ? 1 : 0) + (weights.Y == 0 ? 1 : 0) + (weights.Z == 0 ? 1 : 0);
            if (zeros == 1)
            {
                int edge = weights.X == 0 ? Previous[h] : weights.Y == 0 ? h : Next[h];
                Try(Face[edge ^ 1], point, ref distance, ref best, ref weights);
            }
            else
            {
                int start = Outgoing[weights.X > 0 ? Target[h] : weights.Y > 0 ? Target[Next[h]] : Target[Previous[h]]], g = start;
                do
                {
                    if (Face[g] != face)
                        Try(Face[g], point, ref distance, ref best, ref weights);
                    g = Next[g ^ 1];
                }
                while (g != start);
            }
            if (best == face)
                break;
            face = best;
        }
        return distance;
    }

    private void Try(int candidate, Vector3D point, ref double distance, ref int best, ref Vector3D weights)
    {
        if (candidate < 0)
            return;
        double d = DistanceSquared(candidate, point, out Vector3D w);
        if (d < distance)
            (distance, best, weights) = (d, candidate, w);
    }
}

/// <summary>The closest point of a triangle by regions (Ericson 2005, §5.1.5): weights on the border are exactly zero.</summary>
internal static class PointOnTriangle
{
    public static double Closest(Vector3D p, Vector3D a, Vector3D b, Vector3D c, out Vector3D weights)
    {
        Vector3D ab = b - a, ac = c - a, ap = p - a;
        double d1 = Vector3D.Dot(ab, ap), d2 = Vector3D.Dot(ac, ap);
        if (d1 <= 0 && d2 <= 0)
        {
            weights = new(1, 0, 0);
            return ap.LengthSquared;
        }
        Vector3D bp = p - b;
        double d3 = Vector3D.Dot(ab, bp), d4 = Vector3D.Dot(ac, bp);
        if (d3 >= 0 && d4 <= d3)
        {
            weights = new(0, 1, 0);
            return bp.LengthSquared;
        }
        double vc = d1 * d4 - d3 * d2;
        if (vc <= 0 && d1 >= 0 && d3 <= 0)
        {
            double t = d1 / (d1 - d3);
            weights = new(1 - t, t, 0);
            return (ap - ab * t).LengthSquared;
        }
        Vector3D cp = p - c;
        double d5 = Vector3D.Dot(ab, cp), d6 = Vector3D.Dot(ac, cp);
        if (d6 >= 0 && d5 <= d6)
        {
            weights = new(0, 0, 1);
            return cp.LengthSquared;
        }
        double vb = d5 * d2 - d1 * d6;
        if (vb <= 0 && d2 >= 0 && d6 <= 0)
        {
            double t = d2 / (d2 - d6);
            weights = new(1 - t, 0, t);
            return (ap - ac * t).LengthSquared;
        }
        double va = d3 * d6 - d5 * d4;
        if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
        {
            double t = (d4 - d3) / (d4 - d3 + (d5 - d6));
            weights = new(0, 1 - t, t);
            return (bp - (c - b) * t).LengthSquared;
        }
        double scale = 1 / (va + vb + vc), v = vb * scale, w = vc * scale;
        weights = new(1 - v - w, v, w);
        return (ap - ab * v - ac * w).LengthSquared;
    }
}
