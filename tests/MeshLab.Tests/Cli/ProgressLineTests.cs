using MeshLab.Cli.Hosting;
using Xunit;

namespace MeshLab.Tests.Cli;

/// <summary>The bar on the terminal: only for work that takes longer than a moment, and gone at the end.</summary>
[Trait("Section", "command line")]
public sealed class ProgressLineTests
{
    [Fact]
    public void Report_ShortWork_ShowsNothing()
    {
        using var terminal = new StringWriter();
        var line = new ProgressLine("reading", terminal, new Clock());
        foreach (double part in (double[])[0, 0.25, 0.5, 1])
            line.Report(part);
        Assert.Equal("", terminal.ToString());
    }

    [Fact]
    public void Report_LongWork_FillsTheBarAndClearsIt()
    {
        using var terminal = new StringWriter();
        var clock = new Clock();
        var line = new ProgressLine("reading", terminal, clock);
        line.Report(0.1);
        clock.Seconds = 1;
        line.Report(0.5);
        line.Report(0.5);
        string half = terminal.ToString();
        Assert.Contains("reading", half, StringComparison.Ordinal);
        Assert.Contains(" 50 %", half, StringComparison.Ordinal);
        Assert.Equal(1, half.Count(c => c == '\r'));

        line.Report(1);
        line.Report(1);
        string end = terminal.ToString()[half.Length..];
        Assert.Equal("", end.Trim());
        Assert.True(end.Length >= half.Length);
    }

    private sealed class Clock : TimeProvider
    {
        public double Seconds { get; set; }

        public override long TimestampFrequency => 1000;

        public override long GetTimestamp() => (long)(1000 * Seconds);
    }
}
