using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Visualization;

/// <summary>What the renderer and the viewer need of a mesh: triangles for drawing, real edges, live vertices.</summary>
internal sealed class RenderGeometry
{
    /// <summary>Position of each vertex slot.</summary>
    public required Vector3D[] Positions { get; init; }

    /// <summary>Three vertices per triangle, counter-clockwise from outside.</summary>
    public required int[] Triangles { get; init; }

    /// <summary>The face slot of each triangle.</summary>
    public required int[] FaceOfTriangle { get; init; }

    /// <summary>Two vertices per edge slot; (−1, −1) for a deleted edge.</summary>
    public required int[] Edges { get; init; }

    /// <summary>Number of face slots.</summary>
    public required int FaceSlots { get; init; }

    /// <summary>Vertex slots that are live, ascending; includes isolated vertices.</summary>
    public required int[] LiveVertices { get; init; }

    /// <summary>Number of triangles.</summary>
    public int TriangleCount => FaceOfTriangle.Length;

    /// <summary>The diagonal of the box of the live vertices.</summary>
    public double Size
    {
        get
        {
            BoundingBox box = BoundingBox.Empty;
            foreach (int v in LiveVertices)
                box = box.Including(Positions[v]);
            return box.Diagonal;
        }
    }

    /// <summary>Throws if the options do not fit this geometry.</summary>
    public void CheckFor(RenderOptions options)
    {
        options.Coloring.Check(Positions.Length, FaceSlots, nameof(options));
        foreach (int v in LiveVertices)
        {
            if (!Positions[v].IsFinite)
                throw new ArgumentException($"The position of v{v} is not finite.", nameof(options));
        }
        foreach (EdgeMarks marks in options.HighlightedEdges)
        {
            foreach (int e in marks.Edges)
                ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)e, (uint)(Edges.Length / 2), nameof(options));
        }
        foreach (Vector3D p in options.Polylines.SelectMany(line => line.Points).Concat(options.Points.SelectMany(marks => marks.Points)))
        {
            if (!p.IsFinite)
                throw new ArgumentException("A point of a polyline or mark is not finite.", nameof(options));
        }
    }

    /// <summary>From polygons: face f has the corners from <c>faceStart[f]</c> to before <c>faceStart[f + 1]</c>.</summary>
    public static RenderGeometry FromPolygons(Vector3D[] positions, ReadOnlySpan<int> faceStart, ReadOnlySpan<int> corners)
    {
        var triangles = new List<int>(corners.Length * 3);
        var faceOf = new List<int>(corners.Length);
        var keys = new List<long>(corners.Length);
        int faces = Math.Max(faceStart.Length - 1, 0);
        for (int f = 0; f < faces; f++)
        {
            ReadOnlySpan<int> face = corners[faceStart[f]..faceStart[f + 1]];
            AddFace(positions, face, f, triangles, faceOf);
            for (int i = 0; i < face.Length; i++)
            {
                int a = face[i], b = face[(i + 1) % face.Length];
                keys.Add(((long)Math.Min(a, b) << 32) | (uint)Math.Max(a, b));
            }
        }
        keys.Sort();
        var edges = new List<int>(keys.Count);
        for (int i = 0; i < keys.Count; i++)
        {
            if (i > 0 && keys[i] == keys[i - 1])
                continue;
            edges.Add((int)(keys[i] >> 32));
            edges.Add((int)keys[i]);
        }
        return new()
        {
            Positions = positions,
            Triangles = [.. triangles],
            FaceOfTriangle = [.. faceOf],
            Edges = [.. edges],
            FaceSlots = faces,
            LiveVertices = [.. Enumerable.Range(0, positions.Length)],
        };
    }

    /// <summary>From a mesh; deleted elements are left out, slots keep their numbers.</summary>
    public static RenderGeometry FromMesh(Mesh mesh)
    {
        ReadOnlySpan<int> next = mesh.Next, target = mesh.Target, halfEdgeOf = mesh.HalfEdgeOf;
        Vector3D[] positions = mesh.Positions.ToArray();
        var triangles = new List<int>(mesh.Faces.Count * 3);
        var faceOf = new List<int>(mesh.Faces.Count);
        var corners = new List<int>();
        for (int f = 0; f < halfEdgeOf.Length; f++)
        {
            int first = halfEdgeOf[f];
            if (first < 0)
                continue;
            corners.Clear();
            int h = first;
            do
            {
                corners.Add(target[h]);
                h = next[h];
            }
            while (h != first);
            AddFace(positions, System.Runtime.InteropServices.CollectionsMarshal.AsSpan(corners), f, triangles, faceOf);
        }
        var edges = new int[mesh.HalfEdgeSlots];
        for (int e = 0; e < mesh.EdgeSlots; e++)
        {
            bool live = next[2 * e] >= 0;
            edges[2 * e] = live ? target[2 * e + 1] : -1;
            edges[2 * e + 1] = live ? target[2 * e] : -1;
        }
        return new()
        {
            Positions = positions,
            Triangles = [.. triangles],
            FaceOfTriangle = [.. faceOf],
            Edges = edges,
            FaceSlots = mesh.FaceSlots,
            LiveVertices = [.. Enumerable.Range(0, mesh.VertexSlots).Where(v => !mesh.IsDeletedVertex(v))],
        };
    }

    /// <summary>Adds the triangles of one face.</summary>
    internal static void AddFace(ReadOnlySpan<Vector3D> positions, ReadOnlySpan<int> face, int index, List<int> triangles, List<int> faceOf)
    {
        int before = triangles.Count;
        PolygonTriangulation.Triangulate(positions, face, triangles);
        for (int t = before; t < triangles.Count; t += 3)
            faceOf.Add(index);
    }
}
