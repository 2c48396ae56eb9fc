using System.Globalization;
using System.Reflection;

namespace MeshLab.Benchmarks.Peers;

/// <summary>The plain mode of the benchmarks: one line of JSON per operation.</summary>
internal static class PeerHost
{
    private const string Usage = "peers MODEL.obj [MODEL.obj ...] [--ops a,b,c] [--repeat N] [--budget SECONDS] [--name NAME] [--dump DIR] | peers --list";

    public static int Run(string[] args)
    {
        var models = new List<string>();
        string[]? wanted = null;
        string? name = null, dump = null;
        int repeat = 5;
        double budget = 60;
        SortedDictionary<string, (PeerOpAttribute Op, Action<PeerRun> Measure)> ops = Discover();
        for (int i = 0; i < args.Length; i++)
        {
            string Value() => i + 1 < args.Length ? args[++i] : throw new ArgumentException($"{args[i]} needs a value. {Usage}", nameof(args));
            switch (args[i])
            {
                case "--ops":
                    wanted = Value().Split(',', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
                    break;
                case "--repeat":
                    repeat = Math.Max(1, int.Parse(Value(), CultureInfo.InvariantCulture));
                    break;
                case "--budget":
                    budget = double.Parse(Value(), CultureInfo.InvariantCulture);
                    break;
                case "--name":
                    name = Value();
                    break;
                case "--dump":
                    dump = Value();
                    break;
                case "--list":
                    foreach (string op in ops.Keys)
                        Console.WriteLine(op);
                    return 0;
                default:
                    models.Add(args[i]);
                    break;
            }
        }
        if (models.Count == 0)
        {
            Console.Error.WriteLine(Usage);
            return 2;
        }
        foreach (string path in models)
        {
            PeerModel model = PeerModel.Load(path);
            model.Name = name ?? model.Name;
            foreach (var (op, (attribute, measure)) in ops)
            {
                if (IsWanted(op, attribute, wanted))
                    MeasureOne(new PeerRun(model, op, repeat, budget) { DumpDirectory = dump }, measure);
            }
        }
        return 0;
    }

    private static void MeasureOne(PeerRun run, Action<PeerRun> measure)
    {
        try
        {
            measure(run);
        }
#pragma warning disable CA1031 // One operation that fails is a line with "error"; the others still run.
        catch (Exception error)
#pragma warning restore CA1031
        {
            run.Fail(error);
        }
    }

    private static bool IsWanted(string op, PeerOpAttribute attribute, string[]? wanted) => wanted is null
        ? !attribute.OnRequestOnly
        : wanted.Any(w => w == op || (w.EndsWith('*') && op.StartsWith(w[..^1], StringComparison.Ordinal)));

    private static SortedDictionary<string, (PeerOpAttribute, Action<PeerRun>)> Discover()
    {
        var ops = new SortedDictionary<string, (PeerOpAttribute, Action<PeerRun>)>(StringComparer.Ordinal);
        foreach (Type type in typeof(PeerHost).Assembly.GetTypes())
        {
            foreach (MethodInfo method in type.GetMethods(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic))
            {
                foreach (PeerOpAttribute op in method.GetCustomAttributes<PeerOpAttribute>())
                    ops.Add(op.Name, (op, method.CreateDelegate<Action<PeerRun>>()));
            }
        }
        return ops;
    }
}
