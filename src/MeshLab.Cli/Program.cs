using MeshLab.Cli.Hosting;

using var cancellation = new CancellationTokenSource();
Console.CancelKeyPress += (_, press) =>
{
    // The verb stops by itself, so that it can clean up behind it.
    press.Cancel = true;
    cancellation.Cancel();
};
return MlabApp.Run(args, Console.Out, Console.Error, cancellation.Token);
