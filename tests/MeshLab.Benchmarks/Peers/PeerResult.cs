using System.Globalization;
using System.Text;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Benchmarks.Peers;

/// <summary>The checksum of an operation: what shows that the work was done, and done the same.</summary>
internal sealed class PeerResult
{
    private readonly StringBuilder json = new();

    public PeerResult Add(string key, double value)
    {
        string text = !double.IsFinite(value) ? "null"
            : value == Math.Floor(value) && Math.Abs(value) < 1e15 ? value.ToString("F0", CultureInfo.InvariantCulture)
            : value.ToString("G9", CultureInfo.InvariantCulture);
        return Append(key, text);
    }

    public PeerResult Add(string key, string value) => Append(key, $"\"{value}\"");

    /// <summary>Counts, area, signed volume and the sum of all coordinates of a triangle mesh.</summary>
    public PeerResult Measure(Mesh mesh)
    {
        double area = 0, volume = 0, sum = 0;
        foreach (Face f in mesh.Faces)
        {
            HalfEdge h = f.HalfEdge;
            Vector3D a = h.Source.Position;
            for (HalfEdge k = h.Next; k.Next != h; k = k.Next)
            {
                Vector3D b = k.Source.Position, c = k.Target.Position, n = Vector3D.Cross(b - a, c - a);
                area += 0.5 * n.Length;
                volume += Vector3D.Dot(a, n) / 6;
            }
        }
        foreach (Vertex v in mesh.Vertices)
            sum += v.Position.X + v.Position.Y + v.Position.Z;
        return Add("vertices", mesh.Vertices.Count).Add("faces", mesh.Faces.Count).Add("area", area).Add("volume", volume).Add("possum", sum);
    }

    public override string ToString() => $"{{{json}}}";

    private PeerResult Append(string key, string text)
    {
        json.Append(json.Length == 0 ? "" : ",").Append('"').Append(key).Append("\":").Append(text);
        return this;
    }
}
