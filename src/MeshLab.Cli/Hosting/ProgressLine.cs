using System.Globalization;

namespace MeshLab.Cli.Hosting;

/// <summary>One line with a bar that fills; it goes when the work is done.</summary>
internal sealed class ProgressLine(string label, TextWriter terminal) : IProgress<double>
{
    private const int Width = 30;
    private readonly Lock gate = new();
    private int shown = -1;

    public void Report(double value)
    {
        int percent = (int)(Math.Clamp(value, 0, 1) * 100);
        lock (gate)
        {
            if (percent == shown)
                return;
            shown = percent;
            int filled = percent * Width / 100;
            string bar = new string('█', filled) + new string('░', Width - filled);
            terminal.Write(percent == 100
                ? "\r" + new string(' ', label.Length + Width + 8) + "\r"
                : string.Create(CultureInfo.InvariantCulture, $"\r{label} {bar} {percent,3} %"));
        }
    }
}
