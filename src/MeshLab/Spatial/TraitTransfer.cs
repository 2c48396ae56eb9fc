using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Spatial;

/// <summary>Carries the traits of a triangle mesh to another mesh of the same surface, by place: for algorithms that make all elements anew.</summary>
/// <remarks>
/// A vertex gets the blend of the values at the three corners of the face that it is closest to; so does a corner, but of a face on its own side, so that
/// seams stay sharp; a face gets the value of the face closest to its centroid, labels included; an edge that lies along an old one gets its value, any other the
/// default. O(n log n), nothing if there are no traits. The same bits on every number of threads.
/// </remarks>
public static class TraitTransfer
{
    // A corner is looked up so far towards its face's centroid.
    private const double Inward = 1e-4;

    // An edge lies along an old one if it is within this part of its length, and turned by less than 15°.
    private const double AlongDistance = 0.05;
    private static readonly double AlongCosine = Math.Cos(15 * Math.PI / 180);

    extension(Mesh mesh)
    {
        /// <summary>Adds every trait of another mesh to this one, which has none of these names, with values by place.</summary>
        /// <param name="source">Triangles, on about the same surface.</param>
        /// <param name="cancellationToken">Ends the work.</param>
        /// <exception cref="ArgumentException">A face of the source is not a triangle, or a trait is here already.</exception>
        public void TakeTraitsFrom(Mesh source, CancellationToken cancellationToken = default)
        {
            ArgumentNullException.ThrowIfNull(source);
            foreach (Trait theirs in source.AllTraits)
            {
                if (mesh.TraitsOf(theirs.Kind).Exists(trait => trait.Name == theirs.Name))
                    throw new ArgumentException($"The mesh has a {theirs.Kind} trait of the name \"{theirs.Name}\" already.", nameof(source));
            }
            if (!source.AllTraits.Any())
                return;
            source.RequireTriangles(nameof(source));
            if (source.Faces.Count > 0)
                new Transfer(source, mesh, cancellationToken).Run();
        }
    }

    private sealed class Transfer(Mesh source, Mesh mesh, CancellationToken cancellationToken)
    {
        private readonly FaceTree tree = FaceTree.Build(source);

        public void Run()
        {
            ToVertices();
            ToCorners();
            if (source.FaceTraits.Count > 0)
                mesh.DeriveTraits(source, ElementKind.Face, SourceFaces());
            if (source.EdgeTraits.Count > 0)
                mesh.DeriveTraits(source, ElementKind.Edge, SourceEdges());
        }

        private void ToVertices()
        {
            List<(Trait From, Trait To)> columns = Columns(ElementKind.Vertex);
            if (columns.Count == 0)
                return;
            ClosestPoint[] found = Find(mesh.VertexSlots, v => mesh.Outgoing[v] < 0 ? null : mesh.Positions[v]);
            for (int v = 0; v < found.Length; v++)
            {
                if (!found[v].IsNone)
                    Blend(columns, v, CornersOf(found[v].Face), found[v].Barycentric, h => source.Target[h]);
            }
        }

        private void ToCorners()
        {
            List<(Trait From, Trait To)> columns = Columns(ElementKind.HalfEdge);
            if (columns.Count == 0)
                return;
            ClosestPoint[] found = Find(mesh.HalfEdgeSlots, h => IsCorner(h) ? Vector3D.Lerp(mesh.Positions[mesh.Target[h]], Center(mesh.FaceOf[h]), Inward) : null);
            for (int h = 0; h < found.Length; h++)
            {
                if (found[h].IsNone)
                    continue;
                (int A, int B, int C) corners = CornersOf(found[h].Face);
                TriangleMath.ClosestDistanceSquared(mesh.Positions[mesh.Target[h]], At(corners.A), At(corners.B), At(corners.C), out Vector3D weights);
                Blend(columns, h, corners, weights, corner => corner);
            }
        }

        private bool IsCorner(int h) => !mesh.IsDeletedEdge(h >> 1) && mesh.FaceOf[h] >= 0;

        private int[] SourceFaces() => [.. Find(mesh.FaceSlots, f => mesh.IsDeletedFace(f) ? null : Center(f)).Select(found => found.Face)];

        private int[] SourceEdges()
        {
            ClosestPoint[] found = Find(mesh.EdgeSlots, e => mesh.IsDeletedEdge(e) ? null : Middle(mesh, e));
            var edges = new int[found.Length];
            for (int e = 0; e < edges.Length; e++)
                edges[e] = found[e].IsNone ? -1 : EdgeAlong(e, found[e].Face);
            return edges;
        }

        /// <summary>The edge of a face of the source that an edge lies along, or −1.</summary>
        private int EdgeAlong(int e, int face)
        {
            (Vector3D a, Vector3D b) = (mesh.Positions[mesh.Target[2 * e + 1]], mesh.Positions[mesh.Target[2 * e]]);
            Vector3D middle = (a + b) * 0.5, way = b - a;
            int best = -1;
            double least = AlongDistance * AlongDistance * way.LengthSquared;
            int h = source.HalfEdgeOf[face];
            for (int k = 0; k < 3; k++, h = source.Next[h])
            {
                Vector3D p = At(h ^ 1), q = At(h), other = q - p;
                double squared = TriangleMath.ClosestDistanceSquared(middle, p, q, q, out _);
                if (squared > least || (squared == least && best >= 0) || Math.Abs(Vector3D.Dot(way, other)) < AlongCosine * way.Length * other.Length)
                    continue;
                (best, least) = (h >> 1, squared);
            }
            return best;
        }

        private ClosestPoint[] Find(int count, Func<int, Vector3D?> place)
        {
            const int BlockSize = 256;
            var found = new ClosestPoint[count];
            Parallelism.ForBlocks(count, BlockSize, (first, end) =>
            {
                cancellationToken.ThrowIfCancellationRequested();
                for (int i = first; i < end; i++)
                    found[i] = place(i) is { } p ? tree.FindClosest(p) : ClosestPoint.None;
            });
            return found;
        }

        /// <summary>The half-edges that end at the corners, in the order of the tree's weights.</summary>
        private (int A, int B, int C) CornersOf(int face)
        {
            int h = source.HalfEdgeOf[face];
            return (source.Previous[h], h, source.Next[h]);
        }

        // The corner with the largest weight comes first, so that blends that take the nearest take that one.
        private static void Blend(List<(Trait From, Trait To)> columns, int to, (int A, int B, int C) corners, Vector3D weights, Func<int, int> element)
        {
            Span<(double Weight, int Corner)> parts = [(-weights.X, corners.A), (-weights.Y, corners.B), (-weights.Z, corners.C)];
            if (parts[1].Weight < parts[0].Weight)
                (parts[0], parts[1]) = (parts[1], parts[0]);
            if (parts[2].Weight < parts[0].Weight)
                (parts[0], parts[2]) = (parts[2], parts[0]);
            Span<int> from = stackalloc int[3];
            Span<double> shares = stackalloc double[3];
            int count = 0;
            foreach ((double weight, int corner) in parts)
            {
                if (weight < 0)
                    (from[count], shares[count++]) = (element(corner), -weight);
            }
            foreach ((Trait source, Trait target) in columns)
                target.TakeMix(to, source, from[..count], shares[..count]);
        }

        private List<(Trait From, Trait To)> Columns(ElementKind kind)
        {
            var columns = new List<(Trait, Trait)>();
            foreach (Trait from in source.TraitsOf(kind))
            {
                Trait to = from.CloneEmptyFor(mesh);
                mesh.TraitsOf(kind).Add(to);
                columns.Add((from, to));
            }
            return columns;
        }

        private Vector3D At(int h) => source.Positions[source.Target[h]];

        private static Vector3D Middle(Mesh mesh, int e) => (mesh.Positions[mesh.Target[2 * e]] + mesh.Positions[mesh.Target[2 * e + 1]]) * 0.5;

        private Vector3D Center(int f)
        {
            int h = mesh.HalfEdgeOf[f];
            return (mesh.Positions[mesh.Target[h]] + mesh.Positions[mesh.Target[mesh.Next[h]]] + mesh.Positions[mesh.Target[mesh.Previous[h]]]) / 3;
        }
    }
}
