using System.Text.Json;
using MeshLab.Cutting;
using MeshLab.HoleFilling;
using MeshLab.Numerics;
using MeshLab.Spatial;
using MeshLab.Structure;
using MeshLab.Tests.Simplification;
using MeshLab.Topology;
using Xunit;
using Xunit.Abstractions;

namespace MeshLab.Tests.HoleFilling;

/// <summary>Holes cut into public models and filled again, against what other programs reach, by the very samples that measured those.</summary>
[Trait("Section", "6.1")]
public class HoleAccuracyTests(ITestOutputHelper output)
{
    private const int Samples = 20_000;

    private static readonly HoleFillingOptions[] Settings =
    [
        new(),
        new() { Method = HoleFillingMethod.MinimumWeight },
        new() { Refine = true, Fair = true },
        new() { Refine = true, Fair = true, Continuity = 2 },
    ];

    [SkippableFact]
    public void FillHoles_PublicModels_IsAsNearAsTheBestPeer()
    {
        int cases = 0, asGood = 0, asGoodByDefault = 0;
        double worst = 0, worstByDefault = 0;
        foreach (string name in ReferenceData.PublicModels)
        {
            Mesh original = ReferenceData.Load(name);
            if (original.Faces.Count > 80_000)
                continue;
            int[] corners = [.. original.Faces.SelectMany(f => f.Vertices.Select(v => v.Index))];
            FaceTree tree = FaceTree.Build(original);
            Vector3D[] sample = Sample(original.Positions, corners);
            foreach (JsonProperty testCase in ReferenceData.Json(name, "holes").RootElement.GetProperty("cases").EnumerateObject())
            {
                double best = BestPeer(testCase.Value, out string peer);
                bool[] removed = Removed(original, testCase.Name);
                double own = double.PositiveInfinity, byDefault = double.PositiveInfinity;
                foreach (HoleFillingOptions options in Settings)
                {
                    Mesh mesh = original.Clone();
                    mesh.Detach(mesh.Faces.Where(f => removed[f.Index]));
                    int firstNew = mesh.FaceSlots;
                    Assert.Equal(testCase.Value.GetProperty("open_mesh").GetProperty("F").GetInt32(), mesh.Faces.Count);
                    int loops = mesh.ComputeTopology().BoundaryLoops, euler = mesh.EulerCharacteristic;
                    mesh.FillHoles(options);
                    Assert.Empty(mesh.Validate());
                    Assert.True(mesh.IsClosed);
                    Assert.Equal(euler + loops, mesh.EulerCharacteristic);
                    if (double.IsPositiveInfinity(best))
                        continue;
                    double rms = Distance(original, tree, sample, mesh, corners, removed, firstNew);
                    own = Math.Min(own, rms);
                    if (options == Settings[0])
                        byDefault = rms;
                }
                if (double.IsPositiveInfinity(best))
                    continue;
                cases++;
                double ratio = own / best, defaultRatio = byDefault / best;
                output.WriteLine($"{name} {testCase.Name}: {ratio:F3}, by default {defaultRatio:F3}, of {best:E3} by {peer}");
                asGood += ratio <= 1 ? 1 : 0;
                asGoodByDefault += defaultRatio <= 1 ? 1 : 0;
                worst = Math.Max(worst, ratio);
                worstByDefault = Math.Max(worstByDefault, defaultRatio);
            }
        }
        output.WriteLine($"{asGood} of {cases} no worse, worst ratio {worst:F3}; by default {asGoodByDefault}, {worstByDefault:F3}");
        Assert.True(3 * asGood >= 2 * cases, $"{asGood} of {cases}");
        Assert.True(3 * asGoodByDefault >= 2 * cases, $"by default {asGoodByDefault} of {cases}");
        Assert.True(worst <= 1.3, $"{worst}");
        Assert.True(worstByDefault <= 1.3, $"by default {worstByDefault}");
    }

    private static double BestPeer(JsonElement testCase, out string name)
    {
        double best = double.PositiveInfinity;
        name = "";
        foreach (JsonProperty peer in testCase.GetProperty("peers").EnumerateObject())
        {
            if (peer.Value.TryGetProperty("rms_rel_diag", out JsonElement rms) && ReferenceData.Number(rms) < best)
                (best, name) = (ReferenceData.Number(rms), peer.Name);
        }
        return best;
    }

    /// <summary>The root mean square over the samples of both surfaces, relative to the original's diagonal.</summary>
    private static double Distance(Mesh original, FaceTree tree, Vector3D[] sample, Mesh filled, int[] corners, bool[] removed, int firstNew)
    {
        // The faces that stayed, with the corners in the order of the file, then the new ones.
        var all = new List<int>(corners.Length);
        for (int f = 0; f < removed.Length; f++)
        {
            if (!removed[f])
                all.AddRange(corners.AsSpan(3 * f, 3));
        }
        foreach (Face face in filled.Faces)
        {
            if (face.Index >= firstNew)
                all.AddRange(face.Vertices.Select(v => v.Index));
        }
        int[] filledCorners = [.. all];
        FaceTree filledTree = FaceTree.Build(filled.Positions, filledCorners);
        double squares = 0;
        foreach (Vector3D p in sample)
            squares += filledTree.FindClosest(p).DistanceSquared;
        foreach (Vector3D p in Sample(filled.Positions, filledCorners))
            squares += tree.FindClosest(p).DistanceSquared;
        return Math.Sqrt(squares / (2 * Samples)) / original.BoundingBox.Diagonal;
    }

    /// <summary>Points spread evenly over the area, the same ones as the reference took.</summary>
    private static Vector3D[] Sample(ReadOnlySpan<Vector3D> positions, int[] corners)
    {
        var upTo = new double[corners.Length / 3];
        double total = 0;
        for (int f = 0; f < upTo.Length; f++)
        {
            Vector3D a = positions[corners[3 * f]];
            total += Vector3D.Cross(positions[corners[3 * f + 1]] - a, positions[corners[3 * f + 2]] - a).Length / 2;
            upTo[f] = total;
        }
        var random = new ReferenceDistance.NumpyRandom(12345);
        double[] r = Draw(), u = Draw(), v = Draw();
        var points = new Vector3D[Samples];
        for (int i = 0; i < points.Length; i++)
        {
            int found = Array.BinarySearch(upTo, r[i] * total);
            int f = Math.Min(found >= 0 ? found + 1 : ~found, upTo.Length - 1);
            double s = Math.Sqrt(u[i]);
            points[i] = positions[corners[3 * f]] * (1 - s) + positions[corners[3 * f + 1]] * (s * (1 - v[i])) + positions[corners[3 * f + 2]] * (s * v[i]);
        }
        return points;

        double[] Draw() => [.. Enumerable.Range(0, Samples).Select(_ => random.NextDouble())];
    }

    private static bool[] Removed(Mesh mesh, string testCase)
    {
        var hit = new bool[mesh.VertexSlots];
        if (testCase == "radius")
        {
            double radius = 0.05 * mesh.BoundingBox.Diagonal;
            Vector3D center = mesh.Positions[mesh.VertexSlots / 2];
            for (int v = 0; v < hit.Length; v++)
                hit[v] = Vector3D.Distance(mesh.Positions[v], center) <= radius;
        }
        else if (testCase == "two_ring")
        {
            Vertex center = mesh.Vertices[mesh.VertexSlots / 3];
            hit[center.Index] = true;
            foreach (Vertex v in center.Neighbors)
                hit[v.Index] = true;
        }
        var removed = new bool[mesh.FaceSlots];
        foreach (Face f in mesh.Faces)
            removed[f.Index] = f.Vertices.Any(v => hit[v.Index]);
        return removed;
    }
}
