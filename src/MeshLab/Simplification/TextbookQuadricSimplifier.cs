using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Simplification;

/// <summary>§7.2 二次误差度量 as the book has it: quadrics per vertex, a heap of edges, one collapse after the other through <see cref="EdgeCollapse"/>.</summary>
/// <remarks>Written to be read beside Garland and Heckbert 1997, §4. The other modes give the same kind of result some thirty times faster.</remarks>
internal sealed class TextbookQuadricSimplifier
{
    private const double LeastTurnCosine = 0.05;
    private readonly Mesh mesh;
    private readonly QuadricOptions options;
    private readonly TraceLog? trace;
    private readonly Vector3D origin;
    private readonly double maxMeanSquare;
    private readonly bool[] isFixed;
    private readonly Quadric[] quadrics;
    private readonly Vector3D[] placements;
    private readonly IndexedHeap queue;
    private readonly byte[] refusals;

    public TextbookQuadricSimplifier(Mesh mesh, QuadricOptions options)
    {
        this.mesh = mesh;
        this.options = options;
        trace = TraceLog.For(options.Trace);
        origin = mesh.BoundingBox.Center;
        maxMeanSquare = options.MaxError is double e ? e * e : double.PositiveInfinity;
        isFixed = FixedVertices(mesh, options);
        quadrics = new Quadric[mesh.VertexSlots];
        placements = new Vector3D[mesh.EdgeSlots];
        queue = new IndexedHeap(mesh.EdgeSlots);
        refusals = new byte[mesh.EdgeSlots];
    }

    public SimplificationResult Run(int targetFaces, IProgress<double>? progress, CancellationToken cancellationToken)
    {
        int before = mesh.Faces.Count, collapses = 0, collapsesAtRefill = 0;
        double largest = 0;

        // 1. A quadric for every vertex: the planes of its faces.
        foreach (Vertex v in mesh.Vertices)
            quadrics[v.Index] = QuadricOf(v);

        // 2. A cost and a place for every edge.
        foreach (Edge e in mesh.Edges)
            Evaluate(e);

        while (mesh.Faces.Count > targetFaces)
        {
            cancellationToken.ThrowIfCancellationRequested();
            if (queue.Count == 0)
            {
                // What was refused may be possible now; if nothing changed since it was tried, it is not.
                if (collapses == collapsesAtRefill)
                    break;
                collapsesAtRefill = collapses;
                foreach (Edge e in mesh.Edges)
                    Evaluate(e);
            }

            // 3. The cheapest edge first.
            double cost = queue.KeyOf(queue.Top);
            Edge edge = mesh.Edges[queue.Pop()];
            HalfEdge h = edge.HalfEdge0;
            Vertex kept = h.Target, removed = h.Source;
            Quadric sum = quadrics[removed.Index] + quadrics[kept.Index];
            double meanSquare = sum.Weight > 0 ? cost / sum.Weight : 0;
            refusals[edge.Index] = Examine(h, meanSquare);
            if (refusals[edge.Index] != EdgeState.Clean)
                continue;

            // 4. Contract it. The kept vertex stands for the planes of both.
            trace?.Write(edge.Index, kept.Index, removed.Index, cost, placements[edge.Index]);
            ForgetSidesAt(removed, h);
            h.Collapse(placements[edge.Index]);
            quadrics[kept.Index] = sum;
            isFixed[kept.Index] |= isFixed[removed.Index];
            largest = Math.Max(largest, meanSquare);
            if (++collapses % 256 == 0)
                progress?.Report((double)(before - mesh.Faces.Count) / before);

            // 5. Its edges have new costs.
            foreach (Edge e in kept.Edges)
                Evaluate(e);
        }
        RefusalCounts counts = CountRefusals();
        if (mesh.Listener is null)
            mesh.Compact();
        StopReason reason = mesh.Faces.Count <= targetFaces ? StopReason.TargetReached
            : counts.Error > 0 ? StopReason.MaxErrorReached
            : StopReason.NothingCollapsible;
        return new(reason, before, mesh.Faces.Count, collapses, Math.Sqrt(largest), counts);
    }

    /// <summary>Q(v) = Σ w ppᵀ over the planes p of the faces around v, and over planes that hold its boundary edges.</summary>
    private Quadric QuadricOf(Vertex v)
    {
        Quadric sum = default;
        foreach (HalfEdge h in v.OutgoingHalfEdges)
        {
            if (!h.IsBoundary)
                AddFacePlane(ref sum, h);
            if (h.Edge.IsBoundary && options.Boundary != BoundaryTreatment.Free)
                AddBoundaryPlane(ref sum, h.IsBoundary ? h.Twin : h);
        }
        return sum;
    }

    private void AddFacePlane(ref Quadric sum, HalfEdge h)
    {
        Vector3D normal = FaceNormal(h);
        double doubledArea = normal.Length;
        if (!(doubledArea > 0))
            return;
        normal /= doubledArea;
        sum.AddPlane(normal, -Vector3D.Dot(normal, h.Target.Position - origin), options.AreaWeights ? doubledArea / 2 : 1);
    }

    private void AddBoundaryPlane(ref Quadric sum, HalfEdge h)
    {
        Vector3D edge = h.Target.Position - h.Source.Position, normal = Vector3D.Cross(edge, FaceNormal(h)).Normalized();
        sum.AddPlane(normal, -Vector3D.Dot(normal, h.Target.Position - origin), options.BoundaryWeight * edge.LengthSquared);
    }

    private static Vector3D FaceNormal(HalfEdge h)
    {
        Vector3D a = h.Source.Position;
        return Vector3D.Cross(h.Target.Position - a, h.Next.Target.Position - a);
    }

    /// <summary>Finds where the edge's vertex would go and what that costs, and puts the edge into the queue.</summary>
    private void Evaluate(Edge edge)
    {
        HalfEdge h = edge.HalfEdge0;
        Vertex u = h.Source, v = h.Target;
        refusals[edge.Index] = EdgeState.Clean;
        Quadric sum = quadrics[u.Index] + quadrics[v.Index];
        Vector3D place = Place(in sum, u, v);
        placements[edge.Index] = place + origin;
        // A place at an end keeps that end's bits.
        if (place == u.Position - origin)
            placements[edge.Index] = u.Position;
        else if (place == v.Position - origin)
            placements[edge.Index] = v.Position;
        queue.Set(edge.Index, Math.Max(0, sum.At(place)));
    }

    private Vector3D Place(ref readonly Quadric sum, Vertex u, Vertex v)
    {
        Vector3D a = u.Position - origin, b = v.Position - origin;
        if (isFixed[u.Index] != isFixed[v.Index])
            return isFixed[u.Index] ? a : b;
        if (options.Placement == VertexPlacement.Endpoint)
            return sum.At(a) < sum.At(b) ? a : b;
        if (options.Placement == VertexPlacement.Segment)
        {
            double t = sum.MinimizeOnSegment(a, b);
            return t == 0 ? a : t == 1 ? b : Vector3D.Lerp(a, b, t);
        }
        return sum.TryMinimize(out Vector3D best, out _) ? best : BestOf(in sum, (a + b) / 2, a, b);
    }

    private static Vector3D BestOf(ref readonly Quadric sum, Vector3D first, Vector3D second, Vector3D third)
    {
        if (sum.At(second) < sum.At(first))
            first = second;
        return sum.At(third) < sum.At(first) ? third : first;
    }

    /// <summary>Why the edge may not be contracted now; <see cref="EdgeState.Clean"/> if it may.</summary>
    private byte Examine(HalfEdge h, double meanSquare)
    {
        if (isFixed[h.Source.Index] && isFixed[h.Target.Index])
            return EdgeState.RefusedByConstraint;
        if (!h.CanCollapse(out _))
            return EdgeState.RefusedByTopology;
        if (meanSquare > maxMeanSquare)
            return EdgeState.RefusedByError;
        return !options.AllowFlips && h.CollapseFlips(placements[h.Edge.Index], LeastTurnCosine) ? EdgeState.RefusedByFlip : EdgeState.Clean;
    }

    /// <summary>The sides of the vanishing triangles at the removed vertex vanish too.</summary>
    private void ForgetSidesAt(Vertex removed, HalfEdge h)
    {
        foreach (Edge e in removed.Edges)
        {
            Vertex other = e.Vertex0 == removed ? e.Vertex1 : e.Vertex0;
            if ((!h.IsBoundary && other == h.Next.Target) || (!h.Twin.IsBoundary && other == h.Twin.Next.Target))
                queue.Remove(e.Index);
        }
    }

    private RefusalCounts CountRefusals()
    {
        var counts = new int[EdgeState.RefusedByError + 1];
        foreach (Edge e in mesh.Edges)
            counts[refusals[e.Index]]++;
        return new(counts[EdgeState.RefusedByTopology], counts[EdgeState.RefusedByConstraint], counts[EdgeState.RefusedByFlip], counts[EdgeState.RefusedByError]);
    }

    /// <summary>Per vertex slot, whether it may neither move nor vanish: on a locked boundary, a feature, a seam or a border of labels.</summary>
    private static bool[] FixedVertices(Mesh mesh, QuadricOptions options)
    {
        var isFixed = new bool[mesh.VertexSlots];
        bool[]? special = SpecialEdges.Find(mesh, options);
        foreach (Edge e in mesh.Edges)
        {
            if (special is not null && special[e.Index])
                isFixed[e.Vertex0.Index] = isFixed[e.Vertex1.Index] = true;
        }
        foreach (Vertex v in mesh.Vertices)
            isFixed[v.Index] |= options.Boundary == BoundaryTreatment.Locked && v.IsBoundary;
        return isFixed;
    }
}
