using System.Globalization;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Benchmarks.Peers;

/// <summary>The input as every library gets it: triangles (polygons are fanned) without unused vertices.</summary>
internal sealed class PeerModel
{
    private PeerModel(string path, Vector3D[] positions, int[] corners)
    {
        Path = path;
        Positions = positions;
        Corners = corners;
        Name = System.IO.Path.GetFileNameWithoutExtension(path);
    }

    public string Path { get; }

    public string Name { get; set; }

    public Vector3D[] Positions { get; }

    public int[] Corners { get; }

    public int FaceCount => Corners.Length / 3;

    public Mesh NewMesh() => MeshBuilder.FromTriangles(Positions, Corners);

    public Vector3D BoxCenter => BoundingBox.Of(Positions).Center;

    public double Diagonal => BoundingBox.Of(Positions).Diagonal;

    public double MeanEdgeLength
    {
        get
        {
            double sum = 0;
            for (int c = 0; c < Corners.Length; c++)
                sum += Vector3D.Distance(Positions[Corners[c]], Positions[Corners[c % 3 == 2 ? c - 2 : c + 1]]);
            return sum / Corners.Length;
        }
    }

    /// <summary>A plain reader of v and f lines, apart from the library's own, so that the input does not depend on what is measured.</summary>
    public static PeerModel Load(string path)
    {
        var positions = new List<Vector3D>();
        var corners = new List<int>();
        foreach (string line in File.ReadLines(path))
        {
            string[] words = line.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
            if (words is ["v", _, _, _, ..])
            {
                positions.Add(new(Number(words[1]), Number(words[2]), Number(words[3])));
            }
            else if (words is ["f", ..])
            {
                int[] face = [.. words.Skip(1).Select(w => Index(w, positions.Count))];
                for (int i = 2; i < face.Length; i++)
                {
                    if (face[0] != face[i - 1] && face[i - 1] != face[i] && face[i] != face[0])
                        corners.AddRange([face[0], face[i - 1], face[i]]);
                }
            }
        }
        return DropUnused(path, positions, corners);
    }

    private static double Number(string word) => double.Parse(word, CultureInfo.InvariantCulture);

    private static int Index(string word, int vertices)
    {
        int i = int.Parse(word.Split('/')[0], CultureInfo.InvariantCulture);
        return i > 0 ? i - 1 : vertices + i;
    }

    private static PeerModel DropUnused(string path, List<Vector3D> positions, List<int> corners)
    {
        var number = new int[positions.Count];
        foreach (int v in corners)
            number[v] = 1;
        var kept = new List<Vector3D>();
        for (int v = 0; v < number.Length; v++)
        {
            if (number[v] == 0)
                continue;
            number[v] = kept.Count;
            kept.Add(positions[v]);
        }
        return new(path, [.. kept], [.. corners.Select(v => number[v])]);
    }
}
