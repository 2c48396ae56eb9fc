using System.Runtime.InteropServices;
using MeshLab.Numerics;

namespace MeshLab.Structure;

/// <summary>Makes a mesh from positions and polygons, and checks once that it is an oriented 2-manifold.</summary>
/// <remarks>
/// Vertices, faces and the first vertex of each face keep their order; edges are numbered by first appearance.
/// Linear in the size of the input, whatever the input.
/// </remarks>
public sealed class MeshBuilder
{
    private readonly List<Vector3D> positions = [];
    private readonly List<int> faceStart = [0];
    private readonly List<int> corners = [];

    /// <summary>What is done with faces that would not make a manifold.</summary>
    public NonManifoldPolicy Policy { get; init; } = NonManifoldPolicy.Throw;

    /// <summary>The number of vertices so far.</summary>
    public int VertexCount => positions.Count;

    /// <summary>The number of faces so far.</summary>
    public int FaceCount => faceStart.Count - 1;

    /// <summary>Adds a vertex.</summary>
    /// <returns>Its index.</returns>
    public int AddVertex(Vector3D position)
    {
        positions.Add(position);
        return positions.Count - 1;
    }

    /// <summary>Adds a face; it is checked when the mesh is built.</summary>
    /// <param name="vertices">Vertex indices, counter-clockwise seen from outside.</param>
    /// <returns>Its index.</returns>
    public int AddFace(params ReadOnlySpan<int> vertices)
    {
        corners.AddRange(vertices);
        faceStart.Add(corners.Count);
        return FaceCount - 1;
    }

    /// <summary>Makes the mesh.</summary>
    /// <inheritdoc cref="FromPolygons(PolygonSoup, NonManifoldPolicy, out BuildReport)"/>
    public Mesh Build(out BuildReport report) =>
        FromSoup(new PolygonSoup([.. positions], [.. faceStart], [.. corners]), Policy, out report);

    /// <summary>Makes the mesh.</summary>
    /// <inheritdoc cref="FromPolygons(PolygonSoup, NonManifoldPolicy, out BuildReport)"/>
    public Mesh Build() => Build(out _);

    /// <summary>A mesh of connectivity only, all positions zero: for examples and tests of topology.</summary>
    /// <param name="vertexCount">The number of vertices.</param>
    /// <param name="faces">Vertex indices per face.</param>
    /// <exception cref="TopologyException">The faces do not make an oriented 2-manifold.</exception>
    public static Mesh FromFaces(int vertexCount, params int[][] faces)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(vertexCount);
        return FromSoup(PolygonSoup.From(new Vector3D[vertexCount], faces), NonManifoldPolicy.Throw, out _);
    }

    /// <summary>A mesh from triangles; the arrays are copied.</summary>
    /// <param name="positions">Per vertex; finite.</param>
    /// <param name="corners">Three vertex indices per triangle, counter-clockwise seen from outside.</param>
    /// <exception cref="ArgumentException">A position is not finite, an index is out of range, or the corners are not triples.</exception>
    /// <exception cref="TopologyException">The faces do not make an oriented 2-manifold; the elements are named.</exception>
    public static Mesh FromTriangles(ReadOnlySpan<Vector3D> positions, ReadOnlySpan<int> corners) =>
        FromSoup(PolygonSoup.FromTriangles(positions, corners), NonManifoldPolicy.Throw, out _);

    /// <summary>A mesh from polygons; the arrays are copied.</summary>
    /// <inheritdoc cref="FromPolygons(PolygonSoup, NonManifoldPolicy, out BuildReport)"/>
    public static Mesh FromPolygons(ReadOnlySpan<Vector3D> positions, params int[][] faces) =>
        FromSoup(PolygonSoup.From(positions, faces), NonManifoldPolicy.Throw, out _);

    /// <inheritdoc cref="FromPolygons(PolygonSoup, NonManifoldPolicy, out BuildReport)"/>
    public static Mesh FromPolygons(PolygonSoup soup) => FromPolygons(soup, NonManifoldPolicy.Throw, out _);

    /// <summary>A mesh from polygons; the positions are copied.</summary>
    /// <param name="soup">Positions and polygons.</param>
    /// <param name="policy">What is done with faces that would not make a manifold.</param>
    /// <param name="report">What was done.</param>
    /// <exception cref="ArgumentException">A position is not finite or an index is out of range.</exception>
    /// <exception cref="TopologyException">The policy is to throw, and the faces do not make an oriented 2-manifold; the elements are named.</exception>
    public static Mesh FromPolygons(PolygonSoup soup, NonManifoldPolicy policy, out BuildReport report)
    {
        ArgumentNullException.ThrowIfNull(soup);
        return FromSoup(new PolygonSoup([.. soup.Positions], soup.FaceStart, soup.Corners), policy, out report);
    }

    /// <summary>As <see cref="FromPolygons(PolygonSoup, NonManifoldPolicy, out BuildReport)"/>, but the mesh takes over the array of positions.</summary>
    internal static Mesh FromSoup(PolygonSoup soup, NonManifoldPolicy policy, out BuildReport report)
    {
        CheckPositions(soup.Positions);
        bool sound = CheckFaces(soup);
        Mesh? mesh = sound ? Connect(soup) : null;
        if (mesh is not null)
        {
            report = new([], null, null, CountIsolated(mesh));
            return mesh;
        }
        if (policy == NonManifoldPolicy.Throw)
            throw SoupDiagnosis.Explain(soup);
        BuildReport repairs;
        if (policy == NonManifoldPolicy.Skip)
        {
            mesh = SoupRepair.Skip(soup, Connect, out repairs);
        }
        else
        {
            (PolygonSoup repaired, repairs) = SoupRepair.Split(soup);
            mesh = Connect(repaired) ?? throw SoupDiagnosis.Explain(repaired);
        }
        report = repairs with { IsolatedVertices = CountIsolated(mesh) };
        return mesh;
    }

    private static void CheckPositions(Vector3D[] positions)
    {
        // x − x is 0 for finite x and NaN otherwise, so one sum tells of all.
        double sum = 0;
        foreach (double x in MemoryMarshal.Cast<Vector3D, double>(positions.AsSpan()))
            sum += x - x;
        if (sum == 0)
            return;
        for (int v = 0; v < positions.Length; v++)
        {
            if (!positions[v].IsFinite)
                throw new ArgumentException($"The position of v{v} is {positions[v]}, which is not finite.", nameof(positions));
        }
    }

    /// <summary>Throws for indices out of range; returns whether every face has three or more distinct vertices.</summary>
    private static bool CheckFaces(PolygonSoup soup)
    {
        int[] corners = soup.Corners, start = soup.FaceStart;
        uint vertices = (uint)soup.VertexCount;
        for (int c = 0; c < corners.Length; c++)
        {
            if ((uint)corners[c] >= vertices)
                throw OutOfRange(soup, c);
        }
        for (int f = 0; f + 1 < start.Length; f++)
        {
            int a = start[f], degree = start[f + 1] - a;
            if (degree == 3)
            {
                if (corners[a] == corners[a + 1] || corners[a + 1] == corners[a + 2] || corners[a + 2] == corners[a])
                    return false;
            }
            else if (degree < 3 || SoupDiagnosis.RepeatedVertex(soup.Face(f)) >= 0)
            {
                return false;
            }
        }
        return true;
    }

    private static ArgumentOutOfRangeException OutOfRange(PolygonSoup soup, int corner)
    {
        int f = Array.BinarySearch(soup.FaceStart, corner);
        if (f < 0)
            f = ~f - 1;
        return new ArgumentOutOfRangeException(
            nameof(soup), soup.Corners[corner], $"f{f} refers to a vertex that does not exist; there are {soup.VertexCount}.");
    }

    /// <summary>Links the faces into half-edges, or returns null if they are not an oriented 2-manifold.</summary>
    private static Mesh? Connect(PolygonSoup soup)
    {
        int[] corners = soup.Corners, start = soup.FaceStart;
        int[]? halfEdge = EdgeMatching.Match(soup, out int edges);
        if (halfEdge is null)
            return null;

        int halfEdges = 2 * edges;
        int[] next = GC.AllocateUninitializedArray<int>(halfEdges), previous = GC.AllocateUninitializedArray<int>(halfEdges);
        int[] target = GC.AllocateUninitializedArray<int>(halfEdges), face = GC.AllocateUninitializedArray<int>(halfEdges);
        int[] outgoing = GC.AllocateUninitializedArray<int>(soup.VertexCount), halfEdgeOf = GC.AllocateUninitializedArray<int>(soup.FaceCount);
        Array.Fill(face, -1);
        Array.Fill(outgoing, Mesh.Isolated);

        for (int f = 0; f + 1 < start.Length; f++)
        {
            int first = start[f], end = start[f + 1];
            int before = halfEdge[end - 1];
            halfEdgeOf[f] = halfEdge[first];
            for (int c = first; c < end; c++)
            {
                int h = halfEdge[c], v = corners[c];
                next[before] = h;
                previous[h] = before;
                target[before] = v;
                face[h] = f;
                outgoing[v] = h;
                before = h;
            }
        }
        LinkBoundary(next, previous, target, face, outgoing);
        if (!EveryVertexIsAFan(corners, next, face, outgoing))
            return null;
        return new Mesh(soup.Positions, next, previous, target, face, outgoing, halfEdgeOf);
    }

    /// <summary>Gives the half-edges without a face their neighbours along the hole. Only odd ones can be such: an edge is born with a face.</summary>
    private static void LinkBoundary(int[] next, int[] previous, int[] target, int[] face, int[] outgoing)
    {
        for (int h = 1; h < face.Length; h += 2)
        {
            if (face[h] < 0)
                target[h] = target[previous[h ^ 1]];
        }
        for (int h = 1; h < face.Length; h += 2)
        {
            if (face[h] >= 0)
                continue;
            // Turn around the target through its faces until the other side of the hole.
            int g = h ^ 1;
            do
            {
                g = previous[g] ^ 1;
            }
            while (face[g] >= 0);
            next[h] = g;
            previous[g] = h;
            outgoing[target[h]] = g;
        }
    }

    /// <summary>Whether all corners at a vertex are reached from its outgoing half-edge: no bow-ties (蝴蝶结点).</summary>
    private static bool EveryVertexIsAFan(int[] corners, int[] next, int[] face, int[] outgoing)
    {
        var faces = new int[outgoing.Length];
        foreach (int v in corners)
            faces[v]++;
        for (int v = 0; v < outgoing.Length; v++)
        {
            int h0 = outgoing[v];
            if (h0 < 0)
                continue;
            int reached = 0, h = h0;
            do
            {
                if (face[h] >= 0)
                    reached++;
                h = next[h ^ 1];
            }
            while (h != h0);
            if (reached != faces[v])
                return false;
        }
        return true;
    }

    private static int CountIsolated(Mesh mesh)
    {
        int isolated = 0;
        foreach (int h in mesh.Outgoing)
        {
            if (h < 0)
                isolated++;
        }
        return isolated;
    }
}
