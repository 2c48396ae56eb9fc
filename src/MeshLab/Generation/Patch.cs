using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Generation;

/// <summary>What a rectangle of parameters is filled with.</summary>
public enum PatchFaces
{
    /// <summary>Two triangles each.</summary>
    Triangles,

    /// <summary>One quadrilateral each.</summary>
    Quads,
}

/// <summary>A rectangle of parameters (u, v), cut into columns and rows, mapped into space; opposite sides may be joined.</summary>
/// <remarks>
/// <code>
///   v ↑   d ── c       triangles (a, b, c) and (a, c, d), or the quadrilateral (a, b, c, d):
///     │   │  / │       counter-clockwise seen from the side of ∂u × ∂v
///     └→  a ── b
///     u
/// </code>
/// Vertex (i, j) has the index j · (vertices per row) + i.
/// </remarks>
internal sealed record Patch(int Columns, int Rows, bool JoinU = false, bool JoinV = false, PatchFaces Faces = PatchFaces.Triangles)
{
    public int VerticesPerRow => JoinU ? Columns : Columns + 1;

    public int VertexRows => JoinV ? Rows : Rows + 1;

    /// <summary>Makes the mesh, with texture coordinates (i/columns, j/rows).</summary>
    /// <param name="point">The place of vertex (i, j).</param>
    public Mesh Build(Func<int, int, Vector3D> point)
    {
        var positions = new Vector3D[VerticesPerRow * VertexRows];
        for (int j = 0; j < VertexRows; j++)
        {
            for (int i = 0; i < VerticesPerRow; i++)
                positions[j * VerticesPerRow + i] = point(i, j);
        }
        Mesh mesh = MeshBuilder.FromSoup(new PolygonSoup(positions, FaceStarts(), Corners()), NonManifoldPolicy.Throw, out _);
        SetTextureCoordinates(mesh);
        return mesh;
    }

    public int[] FaceStarts()
    {
        (int faces, int degree) = Faces == PatchFaces.Quads ? (Columns * Rows, 4) : (2 * Columns * Rows, 3);
        var start = new int[faces + 1];
        for (int f = 0; f <= faces; f++)
            start[f] = f * degree;
        return start;
    }

    public int[] Corners()
    {
        var corners = new int[Columns * Rows * CornersPerCell];
        int c = 0;
        ForEachCorner((i, j) => corners[c++] = j % VertexRows * VerticesPerRow + i % VerticesPerRow);
        return corners;
    }

    private int CornersPerCell => Faces == PatchFaces.Quads ? 4 : 6;

    private void SetTextureCoordinates(Mesh mesh)
    {
        if (JoinU || JoinV)
        {
            var corners = new Vector2D[Columns * Rows * CornersPerCell];
            int c = 0;
            ForEachCorner((i, j) => corners[c++] = new((double)i / Columns, (double)j / Rows));
            TextureMapping.SetCorners(mesh, corners);
            return;
        }
        var vertices = new Vector2D[mesh.VertexSlots];
        for (int v = 0; v < vertices.Length; v++)
            vertices[v] = new((double)(v % VerticesPerRow) / Columns, (double)(v / VerticesPerRow) / Rows);
        TextureMapping.SetVertices(mesh, vertices);
    }

    /// <summary>Visits the corners of all faces in order; i and j go up to and including the joined side.</summary>
    private void ForEachCorner(Action<int, int> visit)
    {
        for (int j = 0; j < Rows; j++)
        {
            for (int i = 0; i < Columns; i++)
            {
                visit(i, j);
                visit(i + 1, j);
                visit(i + 1, j + 1);
                if (Faces == PatchFaces.Triangles)
                {
                    visit(i, j);
                    visit(i + 1, j + 1);
                }
                visit(i, j + 1);
            }
        }
    }
}
