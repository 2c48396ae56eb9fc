using BenchmarkDotNet.Attributes;
using MeshLab.Generation;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Benchmarks.Suites;

/// <summary>Building and walking, on a generated sphere of about 80,000 faces.</summary>
[MemoryDiagnoser]
public class StructureBenchmarks
{
    private Mesh mesh = new();
    private Vector3D[] positions = [];
    private int[] corners = [];

    [GlobalSetup]
    public void Setup()
    {
        mesh = Spheres.Icosphere(6);
        PolygonSoup soup = PolygonSoup.From(mesh);
        (positions, corners) = (soup.Positions, soup.Corners);
    }

    [Benchmark]
    public Mesh Build() => MeshBuilder.FromTriangles(positions, corners);

    [Benchmark]
    public long CirculateWithHandles()
    {
        long sum = 0;
        foreach (Vertex v in mesh.Vertices)
        {
            foreach (Face f in v.Faces)
                sum += f.Index;
        }
        return sum;
    }

    [Benchmark]
    public Mesh Clone() => mesh.Clone();
}
