using MeshLab.HoleFilling;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Benchmarks.Peers;

/// <summary>The four-ring of an interior vertex is cut out, then every loop is filled, those of the input too.</summary>
internal static class HoleOps
{
    private const int Rings = 4;

    // The same kind of filling as the other libraries': by the largest bend, then the area.
    private static readonly HoleFillingOptions Liepa = new() { Method = HoleFillingMethod.MinimumWeight, Weight = HoleWeight.BendThenArea };

    [PeerOp("hole-fill")]
    public static void Fill(PeerRun run) => Measure(run, Liepa);

    [PeerOp("hole-fill-total-bend")]
    public static void FillTotalBend(PeerRun run) => Measure(run, Liepa with { Weight = HoleWeight.TotalBend });

    [PeerOp("hole-fill-fair")]
    public static void FillFair(PeerRun run) => Measure(run, Liepa with { Refine = true, Fair = true });

    private static void Measure(PeerRun run, HoleFillingOptions options)
    {
        Mesh holed = Punch(run.Model);
        int filled = 0;
        run.Measure(
            holed.Clone,
            mesh =>
            {
                filled = mesh.FillHoles(options).Filled;
                return mesh;
            },
            (_, mesh, result) => result.Measure(mesh).Add("loops_filled", filled));
    }

    /// <summary>The faces within four rings of the first vertex from the middle on whose rings do not touch the boundary, taken out.</summary>
    private static Mesh Punch(PeerModel model)
    {
        Mesh mesh = model.NewMesh();
        for (int start = mesh.VertexSlots / 2; start < mesh.VertexSlots; start++)
        {
            HashSet<int>? faces = RingFaces(mesh, start);
            if (faces is null)
                continue;
            var number = new int[mesh.VertexSlots];
            Array.Fill(number, -1);
            var builder = new List<int>();
            foreach (Face f in mesh.Faces)
            {
                if (!faces.Contains(f.Index))
                    builder.AddRange(f.Vertices.Select(v => v.Index));
            }
            foreach (int v in builder)
                number[v] = 0;
            var positions = new List<Vector3D>();
            for (int v = 0; v < number.Length; v++)
            {
                if (number[v] < 0)
                    continue;
                number[v] = positions.Count;
                positions.Add(mesh.Positions[v]);
            }
            try
            {
                return MeshBuilder.FromTriangles([.. positions], [.. builder.Select(v => number[v])]);
            }
            catch (TopologyException)
            {
                // The ring pinches the surface: the next vertex.
                continue;
            }
        }
        throw new NotSupportedException("no interior vertex for the hole");
    }

    private static HashSet<int>? RingFaces(Mesh mesh, int start)
    {
        if (mesh.Vertices[start].IsBoundary)
            return null;
        var faces = new HashSet<int>();
        var seen = new HashSet<int> { start };
        List<int> ring = [start];
        for (int r = 0; r < Rings; r++)
        {
            var next = new List<int>();
            foreach (int v in ring)
            {
                foreach (Face f in mesh.Vertices[v].Faces)
                {
                    faces.Add(f.Index);
                    foreach (Vertex w in f.Vertices)
                    {
                        if (w.IsBoundary)
                            return null;
                        if (seen.Add(w.Index))
                            next.Add(w.Index);
                    }
                }
            }
            ring = next;
        }
        return faces;
    }
}
