using System.Diagnostics;
using System.Globalization;

namespace MeshLab.Benchmarks.Peers;

/// <summary>Runs one operation several times and prints its line. Preparing and checking are outside the time.</summary>
internal sealed class PeerRun(PeerModel model, string op, int repeat, double budgetSeconds)
{
    private const int WarmUpRounds = 4;
    private const double WarmUpMilliseconds = 600;
    private const int WarmUpCalls = 40;

    public PeerModel Model { get; } = model;

    public string Op { get; } = op;

    /// <summary>Where a result mesh may be written for comparison; <see langword="null"/> for nowhere.</summary>
    public string? DumpDirectory { get; init; }

    /// <summary>Measures an operation that uses its state up.</summary>
    /// <param name="prepare">Makes the state, outside the time.</param>
    /// <param name="work">The operation.</param>
    /// <param name="check">Fills the checksum after the last run.</param>
    public void Measure<TState, TOut>(Func<TState> prepare, Func<TState, TOut> work, Action<TState, TOut, PeerResult> check)
    {
        WarmUp(() => work(prepare()));
        var times = new List<double>();
        double spent = 0;
        while (true)
        {
            // Garbage of earlier runs goes first: what is prepared stays in the caches, as it does in a library without a collector.
            GC.Collect();
            TState state = prepare();
            long start = Stopwatch.GetTimestamp();
            TOut output = work(state);
            times.Add(Stopwatch.GetElapsedTime(start).TotalMilliseconds);
            spent += times[^1] / 1000;
            if (times.Count < repeat && spent <= budgetSeconds)
                continue;
            var result = new PeerResult();
            check(state, output, result);
            Emit(times, result, 1);
            return;
        }
    }

    /// <summary>Measures an operation of microseconds that can go again on the same state: rounds of at least 50 ms, figures per round.</summary>
    public void MeasureRounds<TState>(Func<TState> prepare, Action<TState> work, Action<TState, PeerResult> check)
    {
        TState state = prepare();
        WarmUp(() => work(state));
        long first = Stopwatch.GetTimestamp();
        work(state);
        double one = Stopwatch.GetElapsedTime(first).TotalMilliseconds;
        int rounds = Math.Clamp((int)(50 / Math.Max(one, 1e-3)), 1, 1000);
        var times = new List<double>();
        for (int i = 0; i < repeat; i++)
        {
            long start = Stopwatch.GetTimestamp();
            for (int k = 0; k < rounds; k++)
                work(state);
            times.Add(Stopwatch.GetElapsedTime(start).TotalMilliseconds);
        }
        var result = new PeerResult();
        check(state, result);
        result.Add("rounds", rounds);
        Emit(times, result, rounds);
    }

    /// <summary>Prints a line from times measured otherwise.</summary>
    public void Emit(List<double> times, PeerResult result, double per)
    {
        times.Sort();
        int n = times.Count;
        double median = n % 2 == 1 ? times[n / 2] : (times[n / 2 - 1] + times[n / 2]) / 2;
        Console.WriteLine(string.Create(CultureInfo.InvariantCulture,
            $"{Head()},\"runs\":{n},\"median_ms\":{median / per:G6},\"min_ms\":{times[0] / per:G6},\"max_ms\":{times[^1] / per:G6},\"result\":{result}}}"));
    }

    public void Fail(Exception error) =>
        Console.WriteLine($"{Head()},\"error\":\"{error.Message.Replace('"', ' ').Replace('\\', ' ').ReplaceLineEndings(" ")}\"}}");

    private string Head() => string.Create(CultureInfo.InvariantCulture,
        $"{{\"peer\":\"MeshLab\",\"op\":\"{Op}\",\"model\":\"{Model.Name}\",\"vertices\":{Model.Positions.Length},\"faces\":{Model.FaceCount}");

    /// <summary>Lets the runtime finish: it counts calls only after a pause without new methods, compiles better code in the background, and does so twice.</summary>
    private static void WarmUp(Action action)
    {
        for (int round = 0; round < WarmUpRounds; round++)
        {
            long start = Stopwatch.GetTimestamp();
            for (int i = 0; i < WarmUpCalls && (i == 0 || Stopwatch.GetElapsedTime(start).TotalMilliseconds < WarmUpMilliseconds); i++)
                action();
            if (Stopwatch.GetElapsedTime(start).TotalSeconds > 5)
                return;
            Thread.Sleep(150);
        }
    }
}
