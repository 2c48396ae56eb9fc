using BenchmarkDotNet.Running;
using MeshLab.Benchmarks.Peers;

// peers MODEL.obj [--ops a,b] [--repeat N]: one line of JSON per operation, to stand beside the same lines of other libraries.
// Anything else: BenchmarkDotNet's own command line.
if (args is ["peers", ..])
    return PeerHost.Run(args[1..]);
BenchmarkSwitcher.FromAssembly(typeof(PeerHost).Assembly).Run(args);
return 0;
