using System.Globalization;

namespace MeshLab.Cli.Hosting;

/// <summary>One line with a bar that fills; it comes only when the work takes longer than a moment, and goes when it is done.</summary>
internal sealed class ProgressLine(string label, TextWriter terminal, TimeProvider? clock = null) : IProgress<double>
{
    private const int Width = 30;
    private static readonly TimeSpan Moment = TimeSpan.FromMilliseconds(400);
    private readonly TimeProvider clock = clock ?? TimeProvider.System;
    private readonly long start = (clock ?? TimeProvider.System).GetTimestamp();
    private readonly Lock gate = new();
    private int shown = -1;

    public void Report(double value)
    {
        int percent = (int)(Math.Clamp(value, 0, 1) * 100);
        lock (gate)
        {
            bool isShown = shown >= 0;
            if (percent == shown || (!isShown && (percent == 100 || clock.GetElapsedTime(start) < Moment)))
                return;
            shown = percent == 100 ? -1 : percent;
            int filled = percent * Width / 100;
            string bar = new string('█', filled) + new string('░', Width - filled);
            terminal.Write(percent == 100
                ? "\r" + new string(' ', label.Length + Width + 8) + "\r"
                : string.Create(CultureInfo.InvariantCulture, $"\r{label} {bar} {percent,3} %"));
        }
    }
}
