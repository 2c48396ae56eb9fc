using System.CommandLine;
using MeshLab.Cli.Hosting;
using MeshLab.Dual;
using MeshLab.Structure;

namespace MeshLab.Cli.Verbs;

internal sealed class DualVerb : Verb
{
    private static readonly string[] Centers = ["barycenter", "circumcenter", "circumcenter-if-acute"];
    private static readonly string[] Forms = ["pure", "cells"];
    private static readonly string[] Boundaries = ["closed", "omitted"];

    private readonly Argument<string> input = InputArgument();
    private readonly Argument<string> output = OutputArgument();
    private readonly Option<string> center = Words("--center", "Where the vertex of a face lies.", Centers);
    private readonly Option<string> form = Words("--form", "Face centres only, or with edge midpoints as in the textbook.", Forms);
    private readonly Option<string> boundary = Words("--boundary", "Whether boundary vertices have a cell, closed through the vertex itself.", Boundaries);

    public override string Name => "dual";

    public override string Summary => "Make the dual: a vertex for every face, a face for every vertex.";

    public override string Example => "dual models/creature.obj creature-dual.obj --center circumcenter-if-acute";

    public override void Configure(Command command)
    {
        command.Arguments.Add(input);
        command.Arguments.Add(output);
        command.Options.Add(center);
        command.Options.Add(form);
        command.Options.Add(boundary);
    }

    public override void Run(VerbContext context)
    {
        Mesh mesh = context.ReadMesh(context.Get(input));
        var options = new DualOptions
        {
            Center = (DualCenter)Array.IndexOf(Centers, context.Get(center)),
            Form = (DualForm)Array.IndexOf(Forms, context.Get(form)),
            Boundary = (DualBoundary)Array.IndexOf(Boundaries, context.Get(boundary)),
        };
        DualResult dual = context.Time(() => mesh.ComputeDual(options));
        context.WriteMesh(dual.Mesh, context.Get(output));
    }

    private static Option<string> Words(string name, string description, string[] words)
    {
        var option = new Option<string>(name) { Description = $"{description} {string.Join(", ", words)}.", DefaultValueFactory = _ => words[0] };
        option.AcceptOnlyFromAmong(words);
        return option;
    }
}
