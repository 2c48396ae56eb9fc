using System.CommandLine;
using MeshLab.Cli.Hosting;
using MeshLab.Cli.Values;
using MeshLab.Morse;
using MeshLab.Numerics;
using MeshLab.Segmentation;
using MeshLab.Structure;

namespace MeshLab.Cli.Verbs;

internal sealed class SegmentVerb : Verb
{
    private readonly Argument<string> input = InputArgument();
    private readonly Argument<string> output = OutputArgument();
    private readonly Option<string> method = new("--method") { Description = "How.", DefaultValueFactory = _ => "face-growing" };
    private readonly Option<int?> segments = new("--segments") { Description = "How many segments (k-means, variational, watershed); 8 if not given." };
    private readonly Option<double?> threshold = new("--threshold")
    {
        Description = "Growing: the book's t. Variational: merge across borders flatter than this many degrees. Watershed: persistence.",
    };

    private readonly Option<string> reference = new("--reference") { Description = "Growing: what a candidate is compared with.", DefaultValueFactory = _ => "parent" };
    private readonly Option<string> form = new("--form") { Description = "Watershed: limbs and body, hills of maxima, or basins of minima.", DefaultValueFactory = _ => "limbs" };
    private readonly Option<double> normalWeight = new("--normal-weight") { Description = "K-means: weight of the normals beside the places.", DefaultValueFactory = _ => 0.0 };
    private readonly Option<bool> connect = new("--connect") { Description = "K-means: make every cluster connected." };
    private readonly Option<bool> smooth = new("--smooth") { Description = "Straighten the borders." };

    public override string Name => "segment";

    public override string Summary => "Divide the faces into segments.";

    public override string Example => "segment models/creature.obj segments.obj --method watershed --segments 8 --json";

    public override void Configure(Command command)
    {
        command.Arguments.Add(input);
        command.Arguments.Add(output);
        method.AcceptOnlyFromAmong("vertex-growing", "face-growing", "k-means", "variational", "watershed");
        reference.AcceptOnlyFromAmong("parent", "seed", "mean");
        form.AcceptOnlyFromAmong("limbs", "hills", "basins");
        foreach (Option option in new Option[] { method, segments, threshold, reference, form, normalWeight, connect, smooth, ValueArguments.From })
            command.Options.Add(option);
    }

    public override void Run(VerbContext context)
    {
        Mesh mesh = context.ReadMesh(context.Get(input));
        FaceSegmentation result = context.Time(() =>
        {
            FaceSegmentation found = Segment(context, mesh);
            return context.Get(smooth) ? BorderSmoothing.Smooth(mesh, found) : found;
        });
        Paint(mesh, result);
        context.WriteMesh(mesh, context.Get(output));
        context.Result
            .Add("segments", result.Count)
            .Add("labels", mesh.Faces.Select(f => result.Labels[f.Index]).ToArray())
            .Add("sizes", result.Sizes)
            .Add("objective", double.IsNaN(result.Objective) ? null : result.Objective);
    }

    private FaceSegmentation Segment(VerbContext context, Mesh mesh)
    {
        double? t = context.Get(threshold);
        int count = context.Get(segments) ?? 8;
        switch (context.Get(method))
        {
            case "vertex-growing":
                return RegionGrowing.ByVertices(mesh, Growing(context, t));
            case "face-growing":
                return RegionGrowing.ByFaces(mesh, Growing(context, t));
            case "k-means":
                var kMeans = new KMeansOptions
                {
                    Seeding = context.Has(CommonOptions.Seed) ? SeedingMethod.PlusPlus : SeedingMethod.FarthestPoint,
                    RandomSeed = context.Seed,
                    NormalWeight = context.Get(normalWeight),
                    Connect = context.Get(connect),
                };
                return KMeans.Segment(mesh, count, kMeans, context.Progress("k-means"), context.CancellationToken);
            case "variational":
                var variational = new VariationalOptions { MergeAngle = (t ?? 0) * Math.PI / 180 };
                return VariationalApproximation.Segment(mesh, count, variational, context.Progress("regions"), context.CancellationToken).Segmentation;
            default:
                var watershed = new WatershedOptions
                {
                    Form = Enum.Parse<WatershedForm>(context.Get(form), ignoreCase: true),
                    Persistence = t ?? 0,
                    Segments = t is null ? count : null,
                };
                return Watershed.Segment(mesh.GeodesicFunction(mesh.Vertices[Start(context, mesh)]), watershed);
        }
    }

    private RegionGrowingOptions Growing(VerbContext context, double? t) => new()
    {
        Threshold = t,
        Reference = context.Get(reference) switch
        {
            "seed" => GrowingReference.Seed,
            "mean" => GrowingReference.RegionMean,
            _ => GrowingReference.Parent,
        },
    };

    /// <summary>Where distances of the watershed start: the vertex given, else the one nearest to the mean of all, which on a creature lies on its body.</summary>
    private static int Start(VerbContext context, Mesh mesh)
    {
        ValueOptions options = ValueArguments.Parse(context);
        if (options.From >= 0)
            return options.Start(mesh);
        Vector3D mean = mesh.Vertices.Aggregate(default(Vector3D), (sum, v) => sum + v.Position) / Math.Max(1, mesh.Vertices.Count);
        Vertex nearest = mesh.Vertices.Where(v => !v.IsIsolated).MinBy(v => (v.Position - mean).LengthSquared);
        return nearest.IsNone ? throw new RefusedException("the mesh has no vertex with edges") : nearest.Index;
    }

    /// <summary>The segments go into the file as groups and as colours, where its format has either.</summary>
    private static void Paint(Mesh mesh, FaceSegmentation result)
    {
        FaceLabels groups = mesh.GetOrAddFaceLabels("group");
        foreach (Face f in mesh.Faces)
        {
            int label = result.Labels[f.Index];
            groups.Labels[f] = groups.Number($"segment{label}");
            FaceTraits traits = f.Traits;
            traits.Color = Visualization.Palette.Categorical(label);
        }
    }
}
