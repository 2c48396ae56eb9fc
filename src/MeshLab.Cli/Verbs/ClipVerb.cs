using System.CommandLine;
using MeshLab.Cli.Hosting;
using MeshLab.Cutting;
using MeshLab.Geometry;
using MeshLab.Structure;

namespace MeshLab.Cli.Verbs;

internal sealed class ClipVerb : Verb
{
    private readonly Argument<string> input = InputArgument();
    private readonly Argument<string> output = OutputArgument();
    private readonly Option<string> plane = PlaneArgument.Option();
    private readonly Option<string> keep = new("--keep") { Description = "Which side stays: above, below, both (as one mesh of two parts).", DefaultValueFactory = _ => "above" };
    private readonly Option<bool> cap = new("--cap") { Description = "Close the cut with flat caps." };
    private readonly Option<double> tolerance = new("--tolerance") { Description = "Vertices within this distance count as on the plane." };

    public override string Name => "clip";

    public override string Summary => "Cut a mesh by a plane and keep one side or both.";

    public override string Example => "clip models/creature.obj creature-half.obj --plane 0,0,1,0.1 --keep above --cap";

    public override void Configure(Command command)
    {
        keep.AcceptOnlyFromAmong("above", "below", "both");
        command.Arguments.Add(input);
        command.Arguments.Add(output);
        command.Options.Add(plane);
        command.Options.Add(keep);
        command.Options.Add(cap);
        command.Options.Add(tolerance);
    }

    public override void Run(VerbContext context)
    {
        CuttingPlane cut = PlaneArgument.Parse(context.Get(plane));
        if (context.Get(tolerance) < 0)
            throw new UsageException("--tolerance must not be negative");
        Mesh mesh = PlaneArgument.Triangles(context.ReadMesh(context.Get(input)));
        var options = new PlaneCutOptions { Cap = context.Get(cap), Tolerance = context.Get(tolerance) };
        string kept = context.Get(keep);
        (PlaneCutResult? above, PlaneCutResult? below) = context.Time(() => kept switch
        {
            "above" => (mesh.Clip(cut, PlaneSide.Above, options), null),
            "below" => ((PlaneCutResult?)null, (PlaneCutResult?)mesh.Clip(cut, PlaneSide.Below, options)),
            _ => mesh.Split(cut, options),
        });
        Mesh result = above?.Part.Mesh ?? below!.Part.Mesh;
        if (above is not null && below is not null)
            result.Append(below.Part.Mesh);
        // Measures first: with both, the one mesh holds the two parts.
        ResultFields[] parts = [.. Parts(above, below)];
        context.WriteMesh(result, context.Get(output));
        context.Result.Add("area", result.Faces.Count == 0 ? 0 : result.Area).Add("volume", VolumeOf(result)).Add("parts", parts);
    }

    private static IEnumerable<ResultFields> Parts(PlaneCutResult? above, PlaneCutResult? below)
    {
        bool both = above is not null && below is not null;
        foreach ((string side, PlaneCutResult? part) in ((string, PlaneCutResult?)[])[("above", above), ("below", below)])
        {
            if (part is null)
                continue;
            Mesh mesh = part.Part.Mesh;
            // The lower part was appended to the upper one, whose own faces come first.
            IEnumerable<Face> faces = both && side == "above" ? mesh.Faces.Take(part.Part.SourceFace.Length) : mesh.Faces;
            double area = 0, volume = 0;
            foreach (Face f in faces)
            {
                Triangle t = f.Triangle;
                area += t.Area;
                volume += Numerics.Vector3D.Determinant(t.A, t.B, t.C) / 6;
            }
            yield return new ResultFields().Add("side", side).Add("area", area).Add("volume", volume)
                .Add("capFaces", part.CapFaces).Add("capLoops", part.CapLoops).Add("openChains", part.OpenChains);
        }
    }

    private static double VolumeOf(Mesh mesh) => mesh.Faces.Count == 0 ? 0 : mesh.Volume;
}
