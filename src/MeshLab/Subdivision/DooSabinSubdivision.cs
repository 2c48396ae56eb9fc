using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Subdivision;

/// <summary>Doo–Sabin 细分: polygons, approximating, dual: every corner becomes a vertex; biquadratic B-splines away from extraordinary faces. Doo, Sabin 1978.</summary>
/// <remarks>
/// <code>
///   ●───────────●        corner i of an n-gon:  Σ wⱼ v(i+j),  w0 = (n + 5)/(4n),  wj = (3 + 2 cos 2πj/n)/(4n)
///   │  c3 ─ c2  │        faces: one per face (its corners), one per edge (two corners on either side),
///   │  │    │   │               one per vertex (a corner of each face around)
///   │  c0 ─ c1  │        boundary: points at ¼ and ¾ of each boundary edge take the place of the corners
///   ●───────────●               that are missing there, so that the boundary is Chaikin's curve
/// </code>
/// New vertices: corners face after face, then two per boundary half-edge (in index order, along the loop). New faces: those of the faces, edges, vertices, in order. O(corners).
/// </remarks>
public static class DooSabinSubdivision
{
    /// <inheritdoc cref="CatmullClarkSubdivision.Subdivide"/>
    public static Mesh Subdivide(
        Mesh mesh, SubdivisionOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        int[] start = [], holes = [], parents = [];
        return Stepper.Run(
            mesh,
            options,
            (size, _) => size.Dualized(),
            (coarse, _, token) =>
            {
                token.ThrowIfCancellationRequested();
                start = CatmullClarkSubdivision.FaceStarts(coarse);
                holes = [.. Enumerable.Range(0, coarse.HalfEdgeSlots).Where(h => coarse.face[h] < 0)];
                return Step(coarse, start, holes, out parents);
            },
            (coarse, finer) => SplitTraits.Dualized(coarse, finer, start, holes, parents),
            null,
            progress,
            cancellationToken);
    }

    /// <summary>The weights of a face's vertices for one of its corners, beginning with the vertex at that corner.</summary>
    /// <param name="degree">n, at least 3.</param>
    public static double[] CornerWeights(int degree)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(degree, 3);
        var weights = new double[degree];
        weights[0] = (degree + 5.0) / (4 * degree);
        for (int j = 1; j < degree; j++)
            weights[j] = (3 + 2 * Math.Cos(2 * Math.PI * j / degree)) / (4 * degree);
        return weights;
    }

    private static Mesh Step(Mesh mesh, int[] start, int[] holes, out int[] parents)
    {
        int corners = start[^1];
        var positions = new Vector3D[corners + 2 * holes.Length];
        PlaceCorners(mesh, start, positions);
        // Per half-edge, the new vertex at its source in its face; on the boundary the point nearer to its source.
        int[] point = NumberPoints(mesh, start, holes);
        for (int i = 0; i < holes.Length; i++)
        {
            Vector3D a = mesh.positions[mesh.target[holes[i] ^ 1]], b = mesh.positions[mesh.target[holes[i]]];
            positions[corners + 2 * i] = 0.75 * a + 0.25 * b;
            positions[corners + 2 * i + 1] = 0.25 * a + 0.75 * b;
        }
        var faces = new List<int[]>(mesh.FaceSlots + mesh.EdgeSlots + mesh.VertexSlots);
        var parent = new List<int>(faces.Capacity);
        AddFacesOfFaces(mesh, start, faces, parent);
        AddFacesOfEdges(mesh, point, faces, parent);
        AddFacesOfVertices(mesh, point, faces, parent);
        parents = [.. parent];
        return MeshBuilder.FromSoup(PolygonSoup.From(positions, faces), NonManifoldPolicy.Throw, out _);
    }

    private static void PlaceCorners(Mesh mesh, int[] start, Vector3D[] positions)
    {
        var table = new Dictionary<int, double[]>();
        for (int f = 0; f < mesh.FaceSlots; f++)
        {
            int degree = start[f + 1] - start[f];
            if (!table.TryGetValue(degree, out double[]? weights))
                table[degree] = weights = CornerWeights(degree);
            int h = mesh.halfEdgeOf[f];
            for (int k = 0; k < degree; k++, h = mesh.next[h])
            {
                Vector3D sum = default;
                int g = h;
                foreach (double weight in weights)
                {
                    sum += weight * mesh.positions[mesh.target[g ^ 1]];
                    g = mesh.next[g];
                }
                positions[start[f] + k] = sum;
            }
        }
    }

    private static int[] NumberPoints(Mesh mesh, int[] start, int[] holes)
    {
        var point = new int[mesh.HalfEdgeSlots];
        for (int f = 0; f < mesh.FaceSlots; f++)
        {
            int h = mesh.halfEdgeOf[f];
            for (int c = start[f]; c < start[f + 1]; c++, h = mesh.next[h])
                point[h] = c;
        }
        for (int i = 0; i < holes.Length; i++)
            point[holes[i]] = start[^1] + 2 * i;
        return point;
    }

    private static void AddFacesOfFaces(Mesh mesh, int[] start, List<int[]> faces, List<int> parent)
    {
        for (int f = 0; f < mesh.FaceSlots; f++)
        {
            faces.Add([.. Enumerable.Range(start[f], start[f + 1] - start[f])]);
            parent.Add(f);
        }
    }

    private static void AddFacesOfEdges(Mesh mesh, int[] point, List<int[]> faces, List<int> parent)
    {
        for (int e = 0; e < mesh.EdgeSlots; e++)
        {
            int h = 2 * e, t = h + 1;
            // From the left face's corner at the target, back to its source, and over to the right face.
            faces.Add([AtTarget(h), point[h], AtTarget(t), point[t]]);
            parent.Add(mesh.face[h] >= 0 ? mesh.face[h] : mesh.face[t]);
        }

        int AtTarget(int h) => mesh.face[h] < 0 ? point[h] + 1 : point[mesh.next[h]];
    }

    private static void AddFacesOfVertices(Mesh mesh, int[] point, List<int[]> faces, List<int> parent)
    {
        foreach (Vertex v in mesh.Vertices)
        {
            if (v.IsIsolated)
                continue;
            var around = new List<int>();
            int first = -1;
            foreach (HalfEdge h in v.OutgoingHalfEdges)
            {
                around.Add(point[h.Index]);
                if (h.IsBoundary)
                    around.Add(point[h.Previous.Index] + 1);
                else if (first < 0)
                    first = h.Face.Index;
            }
            faces.Add([.. around]);
            parent.Add(first);
        }
    }
}
