using System.Globalization;
using MeshLab.Demos.Hosting;
using MeshLab.Representations;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter01;

/// <summary>§1.3 数组结构: the model in every array structure of the book: what it takes, and what a query costs.</summary>
[Demo("1.3", "数组结构", "Array structures")]
public static class Section_1_3
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        output.Table(
            "memory and the cost of queries (d = size of the answer)",
            ["structure", "", "MB", "bytes per face", "F–V", "F–F", "V–F", "V–V", "E–F"],
            RepresentationComparison.Of(mesh).Select(row => new object[]
            {
                row.Name, row.ChineseName,
                row.Bytes < 0 ? "triangles only" : (row.Bytes / 1e6).ToString("F2", CultureInfo.InvariantCulture),
                row.Bytes < 0 ? "–" : ((double)row.Bytes / mesh.Faces.Count).ToString("F1", CultureInfo.InvariantCulture),
                row.FaceVertices, row.FacesBeside, row.FacesAround, row.Neighbors, row.EdgeFaces,
            }));

        Mesh figure = MeshBuilder.FromTriangles([new(0, 1, 0), new(0, 0, 0), new(1, 1, 0), new(1, 0, 0)], [0, 1, 2, 2, 1, 3]);
        CornerTable corners = CornerTable.FromMesh(figure);
        output.Table(
            "the corner table of two triangles",
            ["c", "C.T", "C.V", "C.N", "C.P", "C.O", "C.R", "C.L"],
            Enumerable.Range(0, 6).Select(i => corners[i]).Select(c => new object[] { c, c.T, c.V, c.N, c.P, c.O, c.R, c.L }));
        output.Line($"their adjacency matrix: {AdjacencyMatrix.FromMesh(figure).ToString().TrimEnd().ReplaceLineEndings(" | ")}");
    }
}
