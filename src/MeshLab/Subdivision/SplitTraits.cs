using MeshLab.Structure;

namespace MeshLab.Subdivision;

/// <summary>Carries the traits of a mesh to a finer one: vertex and corner values blended as the trait says, labels and face values inherited, edge values kept along the edge.</summary>
internal static class SplitTraits
{
    /// <summary>Where a new vertex comes from.</summary>
    /// <param name="Vertices">Old vertices.</param>
    /// <param name="Weights">Their weights; <see langword="null"/> for equal ones.</param>
    /// <param name="Face">The old face whose corners its corners come from; −1 for the parent of the new corner's face.</param>
    private readonly record struct Origin(int[] Vertices, double[]? Weights, int Face);

    /// <summary>After a quadrisection: vertices V + e, edges 2e and 2e + 1, faces 4f … 4f + 3.</summary>
    public static void Quadrisected(Mesh coarse, Mesh finer) =>
        Carry(coarse, finer, v => OfEdgeOrVertex(coarse, v), f => f / 4, KeptEdge(coarse));

    /// <summary>After a √3 step: new vertices in face order, faces 3f … 3f + 2. Flipped edges get the default value.</summary>
    public static void Trisected(Mesh coarse, Mesh finer)
    {
        int vertices = coarse.VertexSlots;
        if (finer.VertexSlots == vertices + coarse.FaceSlots)
        {
            Carry(coarse, finer, v => v < vertices ? Single(v) : new(CornersOf(coarse, v - vertices), null, v - vertices), f => f / 3, e => KeptBoundary(coarse, e));
            return;
        }
        (int[] hole, int[] point, _) = BoundaryTrisection.NumberPoints(coarse);
        Carry(coarse, finer, OfPoint, f => f / 3, _ => -1);

        Origin OfPoint(int v)
        {
            if (v < vertices)
                return Single(v);
            int f = Array.BinarySearch(point, v);
            if (f < 0)
                f = ~f - 1;
            if (hole[f] < 0)
                return new(CornersOf(coarse, f), null, f);
            int a = coarse.target[hole[f] ^ 1], b = coarse.target[hole[f]];
            return new([a, b], v == point[f] ? [2.0 / 3, 1.0 / 3] : [1.0 / 3, 2.0 / 3], f);
        }
    }

    /// <summary>After Catmull and Clark: vertices V + e, V + E + f; one face per corner, in order.</summary>
    public static void Cornered(Mesh coarse, Mesh finer, int[] faceStart)
    {
        int firstFace = coarse.VertexSlots + coarse.EdgeSlots;
        Carry(
            coarse,
            finer,
            v => v < firstFace ? OfEdgeOrVertex(coarse, v) : new(CornersOf(coarse, v - firstFace), null, v - firstFace),
            f => FaceAt(faceStart, f),
            KeptEdge(coarse));
    }

    /// <summary>After Doo and Sabin: one vertex per corner, then two per boundary edge; faces of faces, edges, vertices.</summary>
    public static void Dualized(Mesh coarse, Mesh finer, int[] faceStart, int[] holes, int[] parents) => Carry(
        coarse,
        finer,
        v =>
        {
            int corners = faceStart[^1];
            if (v < corners)
            {
                int f = FaceAt(faceStart, v), k = v - faceStart[f];
                int[] around = CornersOf(coarse, f);
                double[] mask = DooSabinSubdivision.CornerWeights(around.Length), weights = new double[around.Length];
                for (int i = 0; i < weights.Length; i++)
                    weights[(k + i) % weights.Length] = mask[i];
                return new Origin(around, weights, f);
            }
            int hole = holes[(v - corners) / 2], a = coarse.target[hole ^ 1], b = coarse.target[hole];
            return new Origin([a, b], (v - corners) % 2 == 0 ? [0.75, 0.25] : [0.25, 0.75], coarse.face[hole ^ 1]);
        },
        f => parents[f],
        _ => -1);

    private static int FaceAt(int[] faceStart, int corner)
    {
        int f = Array.BinarySearch(faceStart, corner);
        return f < 0 ? ~f - 1 : f;
    }

    private static Origin Single(int v) => new([v], null, -1);

    private static Origin OfEdgeOrVertex(Mesh coarse, int v)
    {
        int e = v - coarse.VertexSlots;
        return e < 0 ? Single(v) : new([coarse.target[2 * e + 1], coarse.target[2 * e]], null, -1);
    }

    private static Func<int, int> KeptEdge(Mesh coarse) => e => e < 2 * coarse.EdgeSlots ? e / 2 : -1;

    private static int KeptBoundary(Mesh coarse, int e) => e < coarse.EdgeSlots && (coarse.face[2 * e] | coarse.face[2 * e + 1]) < 0 ? e : -1;

    private static int[] CornersOf(Mesh coarse, int f)
    {
        var vertices = new List<int>(4);
        int h = coarse.halfEdgeOf[f];
        do
        {
            vertices.Add(coarse.target[h ^ 1]);
            h = coarse.next[h];
        }
        while (h != coarse.halfEdgeOf[f]);
        return [.. vertices];
    }

    private static void Carry(Mesh coarse, Mesh finer, Func<int, Origin> vertexOrigin, Func<int, int> faceParent, Func<int, int> edgeParent)
    {
        if (!coarse.AllTraits.Any())
            return;
        foreach (FaceLabels labels in coarse.FaceLabels)
        {
            FaceLabels copy = finer.GetOrAddFaceLabels(labels.Sort);
            foreach (string name in labels.Names)
                copy.Number(name);
        }
        List<(Trait From, Trait To)> vertex = Columns(coarse, finer, ElementKind.Vertex), corner = Columns(coarse, finer, ElementKind.HalfEdge);
        List<(Trait From, Trait To)> edge = Columns(coarse, finer, ElementKind.Edge), face = Columns(coarse, finer, ElementKind.Face);

        if (vertex.Count > 0)
        {
            for (int v = 0; v < finer.VertexSlots; v++)
            {
                Origin origin = vertexOrigin(v);
                foreach ((Trait from, Trait to) in vertex)
                    to.TakeMix(v, from, origin.Vertices, origin.Weights);
            }
        }
        CarryPlain(face, finer.FaceSlots, faceParent);
        CarryPlain(edge, finer.EdgeSlots, edgeParent);
        if (corner.Count > 0)
            CarryCorners(coarse, finer, corner, vertexOrigin, faceParent);
        if (finer.TryGetEdgeTrait(Creases.TraitName, out EdgeTrait<double>? sharpness))
        {
            foreach (ref double s in sharpness.Values)
                s = Creases.AfterAStep(s);
        }
    }

    private static List<(Trait From, Trait To)> Columns(Mesh coarse, Mesh finer, ElementKind kind)
    {
        var columns = new List<(Trait From, Trait To)>();
        foreach (Trait from in coarse.TraitsOf(kind))
        {
            Trait? to = finer.TraitsOf(kind).Find(trait => trait.Name == from.Name);
            if (to is null)
            {
                to = from.CloneEmptyFor(finer);
                finer.TraitsOf(kind).Add(to);
            }
            columns.Add((from, to));
        }
        return columns;
    }

    private static void CarryPlain(List<(Trait From, Trait To)> columns, int count, Func<int, int> parentOf)
    {
        if (columns.Count == 0)
            return;
        Span<int> parent = stackalloc int[1];
        for (int i = 0; i < count; i++)
        {
            parent[0] = parentOf(i);
            if (parent[0] < 0)
                continue;
            foreach ((Trait from, Trait to) in columns)
                to.TakeMix(i, from, parent, null);
        }
    }

    private static void CarryCorners(
        Mesh coarse, Mesh finer, List<(Trait From, Trait To)> columns, Func<int, Origin> vertexOrigin, Func<int, int> faceParent)
    {
        for (int h = 0; h < finer.HalfEdgeSlots; h++)
        {
            if (finer.face[h] < 0)
                continue;
            Origin origin = vertexOrigin(finer.target[h]);
            int face = origin.Face >= 0 ? origin.Face : faceParent(finer.face[h]);
            var corners = new int[origin.Vertices.Length];
            for (int i = 0; i < corners.Length; i++)
                corners[i] = CornerAt(coarse, face, origin.Vertices[i]);
            foreach ((Trait from, Trait to) in columns)
                to.TakeMix(h, from, corners, origin.Weights);
        }
    }

    /// <summary>The half-edge of a face that ends at a vertex.</summary>
    private static int CornerAt(Mesh coarse, int face, int vertex)
    {
        int h = coarse.halfEdgeOf[face];
        while (coarse.target[h] != vertex)
            h = coarse.next[h];
        return h;
    }
}
