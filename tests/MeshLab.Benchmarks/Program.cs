using BenchmarkDotNet.Running;
using MeshLab.Benchmarks;
using MeshLab.Benchmarks.Peers;

// peers MODEL.obj [--ops a,b] [--repeat N]: one line of JSON per operation, to stand beside the same lines of other libraries.
// Anything else: BenchmarkDotNet's own command line.
// accuracy MODELS LIMITS OUT.md: the page with the accuracy of simplification.
if (args is ["accuracy", ..])
    return AccuracyTable.Run(args[1..]);
if (args is ["peers", ..])
    return PeerHost.Run(args[1..]);
BenchmarkSwitcher.FromAssembly(typeof(PeerHost).Assembly).Run(args);
return 0;
