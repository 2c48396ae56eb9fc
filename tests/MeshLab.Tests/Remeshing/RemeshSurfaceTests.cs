using MeshLab.Numerics;
using MeshLab.Remeshing;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Remeshing;

/// <summary>The working copy: whatever is done to it, its columns say what is there.</summary>
[Trait("Section", "L4")]
public class RemeshSurfaceTests
{
    public static TheoryData<string, int> Cases
    {
        get
        {
            var cases = new TheoryData<string, int>();
            foreach (string name in new[] { "cube", "octahedron", "tetrahedron", "torus", "open-fan", "one-triangle", "holes", "annulus", "genus-2" })
            {
                cases.Add(name, 1);
                cases.Add(name, 2);
            }
            return cases;
        }
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void Operations_AtRandom_KeepTheColumnsAndTheTopology(string name, int seed)
    {
        Mesh mesh = Models.Create(name);
        RemeshSurface s = RemeshSurfaces.Of(mesh, 1, 0.7).Surface;
        int euler = Euler(mesh), loops = Topology(mesh);
        var random = new Random(seed);
        int splits = 0, collapses = 0, flips = 0;
        for (int i = 0; i < 1500; i++)
        {
            int h = random.Next(s.HalfEdgeSlots);
            if (s.IsFreeEdge(h & ~1))
                continue;
            int u = s.Target[h ^ 1], v = s.Target[h];
            // More splits for a while, then more collapses: down to the least that there is.
            switch (random.Next(i % 500 < 200 ? 3 : 6))
            {
                case 0:
                    s.Size[u] = random.NextDouble();
                    double wanted = (s.Size[u] + s.Size[v]) / 2;
                    int m = s.Split(h, (s.Positions[u] + s.Positions[v]) * 0.5);
                    Assert.False(s.IsCorner[m]);
                    Assert.Equal(wanted, s.Size[m]);
                    splits++;
                    break;
                case 1 when !s.OnLine[h >> 1] && s.CanFlip(h):
                    s.Flip(h);
                    flips++;
                    break;
                case > 1 when s.CanCollapse(h):
                    s.Collapse(h, s.Positions[v]);
                    collapses++;
                    break;
            }
            if (i % 50 == 0 || i > 1480)
                AssertColumns(s);
        }
        Assert.True(splits > 50 && collapses > 50, $"{splits} {collapses} {flips}");
        Mesh result = s.ToMesh();
        Assert.Empty(result.Validate());
        Assert.Equal((euler, loops), (Euler(result), Topology(result)));
    }

    private static void AssertColumns(RemeshSurface s)
    {
        int[] valence = new int[s.VertexSlots], lines = new int[s.VertexSlots];
        var onBoundary = new bool[s.VertexSlots];
        for (int h = 0; h < s.HalfEdgeSlots; h++)
        {
            if (s.IsFreeEdge(h & ~1))
                continue;
            int v = s.Target[h];
            valence[v]++;
            lines[v] += s.OnLine[h >> 1] ? 1 : 0;
            Assert.Equal(h, s.Previous[s.Next[h]]);
            Assert.Equal(s.Face[h], s.Face[s.Next[h]]);
            Assert.Equal(v, s.Target[s.Next[h] ^ 1]);
            if (s.Face[h] >= 0)
                Assert.Equal(h, s.Next[s.Next[s.Next[h]]]);
            else
                onBoundary[v] = true;
        }
        for (int v = 0; v < s.VertexSlots; v++)
        {
            if (!s.IsLiveVertex(v))
                continue;
            Assert.Equal((v, valence[v], lines[v]), (v, s.Valence[v], s.LineCount[v]));
            Assert.Equal(v, s.Target[s.Outgoing[v] ^ 1]);
            Assert.Equal(onBoundary[v], s.IsOnBoundary(v));
            Assert.True(valence[v] >= (onBoundary[v] ? 2 : 3));
        }
        Assert.Empty(s.ToMesh().Validate());
    }

    /// <summary>A collapse that the surface allows is one that the mesh takes, and the other way round; only vertices of two edges at a boundary are not made.</summary>
    [Theory]
    [MemberData(nameof(Models.TriangleMeshes), MemberType = typeof(Models))]
    public void CanCollapse_EveryHalfEdge_AsTheMeshSays(string name)
    {
        Mesh mesh = Models.Create(name);
        if (mesh.HalfEdgeSlots > 2000)
            return;
        var s = new RemeshSurface(mesh);
        for (int h = 0; h < mesh.HalfEdgeSlots; h++)
        {
            Mesh copy = mesh.Clone();
            bool allowed = MeshLab.Editing.EdgeCollapse.TryCollapse(copy.HalfEdges[h], out _);
            if (s.CanCollapse(h))
                Assert.True(allowed, $"h{h}");
            else if (allowed)
                Assert.Contains(copy.Vertices, v => !v.IsIsolated && v.Valence == 2);
        }
    }

    /// <summary>A triangle at the border with a vertex inside: its outer corner may not go there, which would leave that vertex with two edges.</summary>
    [Fact]
    public void CanCollapse_TipOntoTheVertexInside_IsRefused()
    {
        Mesh mesh = MeshBuilder.FromTriangles([new(0, 0, 0), new(1, 1, 0), new(0, 3, 0), new(2, 3, 0), new(1, 5, 0)], [0, 3, 1, 0, 1, 2, 1, 3, 2, 2, 3, 4]);
        RemeshSurface s = RemeshSurfaces.Of(mesh).Surface;
        Assert.False(s.CanCollapse(RemeshSurfaces.HalfEdge(s, 0, 1)));
        Assert.False(s.CanCollapse(RemeshSurfaces.HalfEdge(s, 1, 0)));
        Assert.True(s.CanCollapse(RemeshSurfaces.HalfEdge(s, 1, 2)));
    }

    private static int Euler(Mesh mesh) => mesh.Vertices.Count(v => !v.IsIsolated) - mesh.Edges.Count + mesh.Faces.Count;

    private static int Topology(Mesh mesh) => 100 * MeshLab.Tests.Generation.Measure.BoundaryLoops(mesh) + MeshLab.Tests.Generation.Measure.Components(mesh);
}
