using System.Globalization;
using System.Text;
using System.Text.Json;
using MeshLab.IO;
using MeshLab.Simplification;
using MeshLab.Structure;

namespace MeshLab.Benchmarks;

/// <summary>Writes the page with the distances of simplified models to their originals, beside the best recorded figure of other programs.</summary>
internal static class AccuracyTable
{
    public const string Usage = "accuracy MODELS_FOLDER LIMITS.json OUT.md";

    public static int Run(string[] args)
    {
        if (args is not [string folder, string limitsFile, string output])
        {
            Console.Error.WriteLine(Usage);
            return 2;
        }
        using JsonDocument limits = JsonDocument.Parse(File.ReadAllText(limitsFile));
        var page = new StringBuilder();
        page.AppendLine("# Accuracy of simplification").AppendLine();
        page.AppendLine("Distance to the original relative to the diagonal of its bounding box: root mean square over 400,000 area-uniform points of either surface, and the");
        page.AppendLine("Hausdorff distance over these and all vertices (`MeshDistance`). *best* is the smallest figure of 25 recorded programs and settings that reach the number of faces");
        page.AppendLine("with a manifold of the same Euler characteristic; the columns *÷* are ours divided by it. The recorded ones were sampled at 100,000 points, which moves rms by 0.3 % on smooth models, 2 % on the horse, 6 % on CAD ones.");
        page.AppendLine("Every result here is a manifold with the input's components, boundary loops and Euler characteristic. *turned*: faces whose normal points against that of the");
        page.AppendLine("nearest original face. Written by `dotnet run -c Release --project tests/MeshLab.Benchmarks -- " + Usage + "`.").AppendLine();
        foreach (QuadricMode mode in (QuadricMode[])[QuadricMode.Accurate, QuadricMode.Fast])
            AddMode(page, folder, limits.RootElement.GetProperty("models"), mode);
        File.WriteAllText(output, page.ToString().ReplaceLineEndings("\n"));
        return 0;
    }

    private static void AddMode(StringBuilder page, string folder, JsonElement models, QuadricMode mode)
    {
        page.AppendLine(CultureInfo.InvariantCulture, $"## {mode} mode").AppendLine();
        page.AppendLine("| model | to | faces | rms | best | ÷ | Hausdorff | best | ÷ | turned |").AppendLine("|---|---|---|---|---|---|---|---|---|---|");
        var rms = new List<double>();
        var hausdorff = new List<double>();
        foreach (JsonProperty model in models.EnumerateObject())
        {
            string? path = Directory.EnumerateFiles(folder, model.Name + ".*").Order(StringComparer.Ordinal).FirstOrDefault();
            if (path is null)
                continue;
            Mesh original = MeshFile.Read(path);
            foreach (JsonProperty to in model.Value.EnumerateObject())
            {
                Mesh mesh = original.Clone();
                mesh.Simplify(new() { TargetFaces = to.Value.GetProperty("target_faces").GetInt32(), Mode = mode });
                MeshDistanceReport report = original.DistanceTo(mesh, new() { Samples = 400_000 });
                double r = report.SymmetricRms / report.Diagonal, h = report.Hausdorff / report.Diagonal;
                double bestR = Best(to.Value, "sampled_rms_clean"), bestH = Best(to.Value, "sampled_hausdorff_clean");
                // The flat assembly at half its faces is exact: its figures are rounding, and stay out of the means.
                if (r > 1e-9)
                {
                    rms.Add(r / bestR);
                    hausdorff.Add(h / bestH);
                }
                page.AppendLine(
                    CultureInfo.InvariantCulture,
                    $"| {model.Name} | {to.Name} | {mesh.Faces.Count} | {r:E2} | {bestR:E2} | {r / bestR:F3} | {h:E2} | {bestH:E2} | {h / bestH:F3} | {CountTurned(original, mesh)} |");
            }
        }
        page.AppendLine().AppendLine(
            CultureInfo.InvariantCulture, $"Geometric means: rms {Mean(rms):F3}, Hausdorff {Mean(hausdorff):F3} (without the case that is exact).").AppendLine();
    }

    private static int CountTurned(Mesh original, Mesh mesh)
    {
        var tree = Spatial.FaceTree.Build(original);
        int turned = 0;
        foreach (Face f in mesh.Faces)
        {
            Numerics.Vector3D center = (f.HalfEdge.Source.Position + f.HalfEdge.Target.Position + f.HalfEdge.Next.Target.Position) / 3;
            Face nearest = original.Faces[tree.FindClosest(center).Face];
            if (Numerics.Vector3D.Dot(Normal(f), Normal(nearest)) < 0)
                turned++;
        }
        return turned;
    }

    private static Numerics.Vector3D Normal(Face f)
    {
        Numerics.Vector3D a = f.HalfEdge.Source.Position;
        return Numerics.Vector3D.Cross(f.HalfEdge.Target.Position - a, f.HalfEdge.Next.Target.Position - a);
    }

    private static double Best(JsonElement limits, string key) => limits.GetProperty(key).GetProperty("value").GetDouble();

    private static double Mean(List<double> values) => Math.Exp(values.Average(Math.Log));
}
