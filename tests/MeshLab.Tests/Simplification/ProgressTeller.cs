namespace MeshLab.Tests.Simplification;

/// <summary>Hears progress at once, on the thread that tells it.</summary>
internal sealed class ProgressTeller(Action<double> tell) : IProgress<double>
{
    public void Report(double value) => tell(value);

    /// <summary>One that cancels as soon as so much is done.</summary>
    public static ProgressTeller CancelAt(CancellationTokenSource source, double at) => new(value =>
    {
        if (value >= at)
            source.Cancel();
    });
}
