using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Morse;

/// <summary>The book's base mesh of a Morse complex.</summary>
/// <param name="Mesh">One vertex per critical point that has a face, one face per cell.</param>
/// <param name="CriticalVertex">Per vertex of the base mesh, the vertex of the model that it stands for.</param>
/// <param name="Report">Cells that make no polygon of their own (fewer than three different corners, or a corner twice) were left out, and vertices where faces
/// only touch were split; both are listed here.</param>
public sealed record BaseMeshResult(Mesh Mesh, IReadOnlyList<int> CriticalVertex, BuildReport Report);

/// <summary>§12.6 莫斯基网格: a mesh with one vertex per critical point and one face per cell of the Morse complex.</summary>
/// <remarks>A cell of a Morse complex is a quadrilateral minimum–saddle–maximum–saddle. Where both its saddles are one, or an extremum is met twice, it is no polygon.
/// Simplify the function first to get a small base mesh.</remarks>
public static class BaseMesh
{
    /// <summary>Builds the base mesh.</summary>
    public static BaseMeshResult Of(MorseComplex complex)
    {
        ArgumentNullException.ThrowIfNull(complex);
        Mesh model = complex.Gradient.Function.Mesh;
        var number = new Dictionary<int, int>();
        var positions = new List<Vector3D>();
        var critical = new List<int>();
        var faces = new List<int[]>();
        foreach (MorseCell cell in MorseCells.Of(complex).Cells)
        {
            int[] corners = new int[cell.Corners.Count];
            for (int i = 0; i < corners.Length; i++)
            {
                int v = cell.Corners[i];
                if (!number.TryGetValue(v, out corners[i]))
                {
                    number[v] = corners[i] = positions.Count;
                    positions.Add(model.Vertices[v].Position);
                    critical.Add(v);
                }
            }
            faces.Add(corners);
        }
        PolygonSoup soup = PolygonSoup.From([.. positions], faces);
        Mesh mesh = MeshBuilder.FromPolygons(soup, NonManifoldPolicy.Split, out BuildReport report);
        return new BaseMeshResult(mesh, report.SourceVertices is null ? critical : [.. report.SourceVertices.Select(v => critical[v])], report);
    }
}
