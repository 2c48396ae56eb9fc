using BenchmarkDotNet.Attributes;
using MeshLab.Curvature;
using MeshLab.Geometry;
using MeshLab.Morse;
using MeshLab.Spatial;
using MeshLab.Structure;

namespace MeshLab.Benchmarks.Suites;

/// <summary>One operation per chapter, on a generated sphere of about 80,000 faces.</summary>
[MemoryDiagnoser]
public class AlgorithmBenchmarks
{
    private Mesh mesh = new();

    [GlobalSetup]
    public void Setup() => mesh = Generation.Spheres.Icosphere(6);

    [Benchmark]
    public object Normals() => mesh.ComputeNormals();

    [Benchmark]
    public object Curvatures() => mesh.ComputeCurvatures();

    [Benchmark]
    public object Tree() => FaceTree.Build(mesh);

    [Benchmark]
    public object Persistence() => PersistencePairs.Of(mesh.CoordinateFunction(2));
}
