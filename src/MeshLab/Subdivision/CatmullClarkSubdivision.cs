using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Subdivision;

/// <summary>Catmull–Clark 细分: polygons of any degree to quadrilaterals, approximating; bicubic B-splines away from extraordinary vertices. Catmull, Clark 1978.</summary>
/// <remarks>
/// <code>
///     ●────m2────●      face:    f = mean of its vertices
///     │    │     │      edge:    (a + b + f left + f right)/4
///     m3 ──f── m1       vertex:  (F + 2 M + (n − 3) v)/n, F the mean of the faces around, M of the edges' middles
///     │    │     │      boundary: the middle of an edge; 1/8, 3/4, 1/8 along the boundary
///     v ───m0────●
/// </code>
/// Old vertices keep their indices, edges follow, then faces: V + e, V + E + f. Each corner of a face becomes a quadrilateral, in order, beginning at the old vertex.
/// Creases: <see cref="Creases"/>. O(corners).
/// </remarks>
public static class CatmullClarkSubdivision
{
    /// <summary>Subdivides a polygon mesh.</summary>
    /// <param name="mesh">Any faces; it is not changed.</param>
    /// <param name="options">Steps, budget, creases.</param>
    /// <param name="progress">Told the part done.</param>
    /// <param name="cancellationToken">Stops the work; nothing is returned then.</param>
    /// <returns>A new mesh of quadrilaterals with the traits subdivided too.</returns>
    /// <exception cref="ArgumentException">A sharpness is NaN, the result would have more faces than the budget, or the limit is asked for with edges of a finite sharpness left.</exception>
    public static Mesh Subdivide(
        Mesh mesh, SubdivisionOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        options ??= SubdivisionOptions.Default;
        return Stepper.Run(
            mesh,
            options,
            (size, _) => size.CornersToQuads(),
            (coarse, _, token) => Step(coarse, options.UseCreases, token),
            (coarse, finer) => SplitTraits.Cornered(coarse, finer, FaceStarts(coarse)),
            (finest, part, token) => LimitSurface.OfCatmullClark(finest, options.UseCreases, part, token),
            progress,
            cancellationToken);
    }

    /// <summary>Per face, the number of corners before it; one more entry at the end.</summary>
    internal static int[] FaceStarts(Mesh mesh)
    {
        var start = new int[mesh.FaceSlots + 1];
        foreach (int f in mesh.FaceOf)
        {
            if (f >= 0)
                start[f + 1]++;
        }
        for (int f = 1; f < start.Length; f++)
            start[f] += start[f - 1];
        return start;
    }

    internal static Mesh Step(Mesh mesh, bool useCreases, CancellationToken cancellationToken)
    {
        int[] start = FaceStarts(mesh);
        Mesh finer = Connect(mesh, start, cancellationToken);
        PlaceFaces(mesh, finer.positions);
        PlaceEdges(mesh, finer.positions);
        PlaceVertices(mesh, finer.positions);
        if (useCreases)
            Creases.Sharpen(mesh, finer.positions);
        return finer;
    }

    /// <summary>Numbers as in <see cref="Quadrisection"/>; spoke k of a face is edge 2E + start + k: middle of side k → middle of the face, and back.</summary>
    private static Mesh Connect(Mesh mesh, int[] start, CancellationToken cancellationToken)
    {
        int vertices = mesh.VertexSlots, edges = mesh.EdgeSlots, faces = mesh.FaceSlots, corners = start[faces], halfEdges = 4 * edges + 2 * corners;
        var finer = new Mesh(
            new Vector3D[vertices + edges + faces], new int[halfEdges], new int[halfEdges], new int[halfEdges], new int[halfEdges],
            new int[vertices + edges + faces], new int[corners]);
        for (int f = 0; f < faces; f++)
        {
            if (f % Parallelism.BlockSize == 0)
                cancellationToken.ThrowIfCancellationRequested();
            LinkFace(mesh, finer, f, start[f], start[f + 1] - start[f]);
        }
        for (int h = 0; h < mesh.HalfEdgeSlots; h++)
        {
            int middle = vertices + (h >> 1), first = Quadrisection.First(h), second = Quadrisection.Second(h);
            finer.target[first] = middle;
            finer.target[second] = mesh.target[h];
            if (mesh.face[h] >= 0)
            {
                // A boundary half-edge, if there is one, has the last word: it comes first or sets it again.
                if (mesh.face[h ^ 1] >= 0)
                    finer.outgoing[middle] = second;
                continue;
            }
            finer.face[first] = finer.face[second] = -1;
            finer.outgoing[middle] = second;
            finer.next[first] = second;
            finer.previous[second] = first;
            finer.next[second] = Quadrisection.First(mesh.next[h]);
            finer.previous[first] = Quadrisection.Second(mesh.previous[h]);
        }
        for (int v = 0; v < vertices; v++)
        {
            int h = mesh.outgoing[v];
            finer.outgoing[v] = h < 0 ? h : Quadrisection.First(h);
        }
        return finer;
    }

    private static void LinkFace(Mesh mesh, Mesh finer, int f, int start, int degree)
    {
        int center = mesh.VertexSlots + mesh.EdgeSlots + f, firstSpoke = 4 * mesh.EdgeSlots + 2 * start;
        int before = mesh.previous[mesh.halfEdgeOf[f]], h = mesh.halfEdgeOf[f];
        finer.outgoing[center] = firstSpoke + 1;
        for (int k = 0; k < degree; k++)
        {
            // v → middle, → centre, → middle of the side before, → v.
            int a = Quadrisection.First(h), b = firstSpoke + 2 * k, c = firstSpoke + 2 * (k == 0 ? degree - 1 : k - 1) + 1, d = Quadrisection.Second(before);
            finer.target[b] = center;
            finer.target[c] = mesh.VertexSlots + (before >> 1);
            Link(finer, a, b, start + k);
            Link(finer, b, c, start + k);
            Link(finer, c, d, start + k);
            Link(finer, d, a, start + k);
            finer.halfEdgeOf[start + k] = a;
            before = h;
            h = mesh.next[h];
        }
    }

    private static void Link(Mesh finer, int h, int after, int face)
    {
        finer.next[h] = after;
        finer.previous[after] = h;
        finer.face[h] = face;
    }

    private static void PlaceFaces(Mesh mesh, Vector3D[] placed)
    {
        int first = mesh.VertexSlots + mesh.EdgeSlots;
        Parallelism.ForBlocks(mesh.FaceSlots, (from, to) =>
        {
            for (int f = from; f < to; f++)
            {
                Vector3D sum = default;
                int degree = 0, h = mesh.halfEdgeOf[f];
                do
                {
                    sum += mesh.positions[mesh.target[h ^ 1]];
                    degree++;
                    h = mesh.next[h];
                }
                while (h != mesh.halfEdgeOf[f]);
                placed[first + f] = sum / degree;
            }
        });
    }

    private static void PlaceEdges(Mesh mesh, Vector3D[] placed)
    {
        int vertices = mesh.VertexSlots, firstFace = vertices + mesh.EdgeSlots;
        Parallelism.ForBlocks(mesh.EdgeSlots, (from, to) =>
        {
            for (int e = from; e < to; e++)
            {
                Vector3D ends = mesh.positions[mesh.target[2 * e]] + mesh.positions[mesh.target[2 * e + 1]];
                int left = mesh.face[2 * e], right = mesh.face[2 * e + 1];
                placed[vertices + e] = (left | right) < 0 ? 0.5 * ends : 0.25 * (ends + placed[firstFace + left] + placed[firstFace + right]);
            }
        });
    }

    private static void PlaceVertices(Mesh mesh, Vector3D[] placed)
    {
        int firstFace = mesh.VertexSlots + mesh.EdgeSlots;
        Parallelism.ForBlocks(mesh.VertexSlots, (from, to) =>
        {
            int[] next = mesh.next, target = mesh.target, face = mesh.face;
            Vector3D[] old = mesh.positions;
            for (int v = from; v < to; v++)
            {
                int start = mesh.outgoing[v], h = start;
                if (start < 0)
                {
                    placed[v] = old[v];
                    continue;
                }
                if (face[start] < 0)
                {
                    placed[v] = 0.75 * old[v] + 0.125 * (old[target[start]] + old[target[mesh.previous[start] ^ 1]]);
                    continue;
                }
                Vector3D faces = default, ends = default;
                int n = 0;
                do
                {
                    faces += placed[firstFace + face[h]];
                    ends += old[target[h]];
                    n++;
                    h = next[h ^ 1];
                }
                while (h != start);
                // The edges' middles are half of v and half of the other ends.
                placed[v] = (faces / n + ends / n + (n - 2) * old[v]) / n;
            }
        });
    }
}
