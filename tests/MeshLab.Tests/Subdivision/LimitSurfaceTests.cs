using MeshLab.Generation;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Subdivision;
using MeshLab.Tests.Generation;
using Xunit;

namespace MeshLab.Tests.Subdivision;

[Trait("Section", "8.1")]
public class LimitSurfaceTests
{
    public static TheoryData<int> Valences => new(Enumerable.Range(3, 10));

    /// <summary>A small bumpy disc around a vertex: closed ring of n triangles, or a fan of n − 1 at the boundary, with two more rings so that the outside does not matter.</summary>
    private static Mesh Disc(int n, bool boundary)
    {
        var random = new Random(n);
        var builder = new MeshBuilder();
        builder.AddVertex(new(0, 0, 0.3));
        int perRing = n;
        for (int ring = 1; ring <= 3; ring++)
        {
            for (int i = 0; i < perRing; i++)
            {
                double angle = boundary ? Math.PI * i / (perRing - 1) : 2 * Math.PI * i / perRing;
                builder.AddVertex(new(ring * Math.Cos(angle), ring * Math.Sin(angle), 0.3 * random.NextDouble()));
            }
        }
        int sectors = boundary ? perRing - 1 : perRing;
        for (int i = 0; i < sectors; i++)
        {
            int j = (i + 1) % perRing;
            builder.AddFace(0, 1 + i, 1 + j);
            for (int ring = 1; ring < 3; ring++)
            {
                int a = 1 + (ring - 1) * perRing + i, b = 1 + (ring - 1) * perRing + j;
                builder.AddFace(a, a + perRing, b + perRing);
                builder.AddFace(a, b + perRing, b);
            }
        }
        return builder.Build();
    }

    /// <summary>Ten steps on the two-ring of vertex 0 only: faces farther away cannot reach it any more.</summary>
    private static Mesh TenSteps(Mesh mesh, Func<Mesh, Mesh> step)
    {
        for (int k = 0; k < 10; k++)
            mesh = Neighborhood(step(mesh));
        return mesh;
    }

    private static Mesh Neighborhood(Mesh mesh)
    {
        var near = new HashSet<int> { 0 };
        for (int ring = 0; ring < 2; ring++)
        {
            foreach (int v in near.ToArray())
            {
                foreach (Face f in mesh.Vertices[v].Faces)
                    near.UnionWith(f.Vertices.ToArray().Select(w => w.Index));
            }
        }
        int[] kept = [.. near.Order()];
        var number = kept.Select((v, i) => (v, i)).ToDictionary(pair => pair.v, pair => pair.i);
        int[][] faces = [.. mesh.Faces.Select(f => f.Vertices.ToArray().Select(v => v.Index).ToArray()).Where(f => f.All(near.Contains))
            .Select(f => f.Select(v => number[v]).ToArray())];
        return MeshBuilder.FromPolygons([.. kept.Select(v => mesh.Positions[v])], faces);
    }

    private static Vector3D NormalAtZero(Mesh mesh)
    {
        Vector3D sum = default;
        foreach (Face f in mesh.Vertices[0].Faces)
            sum += Measure.VectorArea(f);
        return sum.Normalized();
    }

    [Theory]
    [MemberData(nameof(Valences))]
    public void OfLoop_Interior_AgreesWithTenSteps(int n)
    {
        foreach (LoopWeights weights in Enum.GetValues<LoopWeights>())
        {
            Mesh mesh = Disc(n, boundary: false);
            LimitPoints limit = LimitSurface.OfLoop(mesh, weights);
            Mesh fine = TenSteps(mesh, m => LoopSubdivision.Subdivide(m, new SubdivisionOptions { Weights = weights }));

            AssertAgrees(limit, LimitSurface.OfLoop(fine, weights), fine);
        }
    }

    [Theory]
    [MemberData(nameof(Valences))]
    public void OfLoop_Boundary_AgreesWithTenSteps(int n)
    {
        Mesh mesh = Disc(n - 1, boundary: true);
        Mesh fine = TenSteps(mesh, m => LoopSubdivision.Subdivide(m));

        AssertAgrees(LimitSurface.OfLoop(mesh), LimitSurface.OfLoop(fine), fine, slow: n > 7);
    }

    [Theory]
    [MemberData(nameof(Valences))]
    public void OfCatmullClark_InteriorAndBoundary_AgreeWithTenSteps(int n)
    {
        foreach (bool boundary in new[] { false, true })
        {
            Mesh mesh = Disc(boundary ? n - 1 : n, boundary);
            Mesh fine = TenSteps(mesh, m => CatmullClarkSubdivision.Subdivide(m));

            AssertAgrees(LimitSurface.OfCatmullClark(mesh), LimitSurface.OfCatmullClark(fine), fine, slow: boundary && n > 5);
        }
    }

    /// <summary>The limit does not change from step to step; and after ten steps the mesh itself is there.</summary>
    /// <param name="slow">At a boundary vertex of many faces two eigenvalues are close together, and the faces turn too slowly to their limit for ten steps.</param>
    private static void AssertAgrees(LimitPoints limit, LimitPoints later, Mesh fine, bool slow = false)
    {
        Assert.True(Vector3D.Distance(limit.Positions[0], later.Positions[0]) < 1e-12);
        Assert.True(Vector3D.Distance(limit.Positions[0], fine.Positions[0]) < 1e-3, $"{limit.Positions[0]} {fine.Positions[0]}");
        Assert.True(Vector3D.Angle(limit.Normals[0], later.Normals[0]) < 1e-7, $"{limit.Normals[0]} {later.Normals[0]}");
        Assert.True(Vector3D.Angle(limit.Normals[0], NormalAtZero(fine)) < (slow ? 0.3 : 0.05), $"{limit.Normals[0]} {NormalAtZero(fine)}");
        Assert.Equal(1, limit.Normals[0].Length, 1e-12);
    }

    /// <summary>
    /// A vertex at the border of many faces: the surface turns to its normal by the ratio of two eigenvalues close together. A hundred steps, moved and enlarged in
    /// between, lead there.
    /// </summary>
    [Theory]
    [InlineData(SubdivisionScheme.Loop, 7)]
    [InlineData(SubdivisionScheme.Loop, 8)]
    [InlineData(SubdivisionScheme.Loop, 10)]
    [InlineData(SubdivisionScheme.CatmullClark, 5)]
    [InlineData(SubdivisionScheme.CatmullClark, 6)]
    [InlineData(SubdivisionScheme.CatmullClark, 9)]
    public void Limit_BoundaryOfManyFaces_HasTheNormalOfAHundredSteps(SubdivisionScheme scheme, int faces)
    {
        Mesh mesh = Disc(faces + 1, boundary: true);
        Vector3D normal = (scheme == SubdivisionScheme.Loop ? LimitSurface.OfLoop(mesh) : LimitSurface.OfCatmullClark(mesh)).Normals[0];
        for (int step = 0; step < 100; step++)
        {
            mesh = Neighborhood(mesh.Subdivide(scheme));
            Vector3D center = mesh.Positions[0];
            foreach (ref Vector3D p in mesh.Positions)
                p = (p - center) * 1.8;
        }
        Assert.True(Vector3D.Angle(normal, NormalAtZero(mesh)) < 0.01, $"{normal} {NormalAtZero(mesh)}");
    }

    /// <summary>A crease somewhere changes nothing elsewhere: not at the border, and not where it ends.</summary>
    [Fact]
    public void Limits_BesideACrease_AreSmooth()
    {
        Mesh mesh = Disc(6, boundary: true);
        LimitPoints[] smooth = [LimitSurface.OfLoop(mesh), LimitSurface.OfCatmullClark(mesh)];
        Vertex end = mesh.Vertices.First(v => !v.IsBoundary), other = end.Neighbors.First(v => !v.IsBoundary);
        Creases.Set(mesh, [mesh.FindEdge(end, other)]);
        LimitPoints[] creased = [LimitSurface.OfLoop(mesh), LimitSurface.OfCatmullClark(mesh)];
        Assert.Equal(smooth[0].Positions, creased[0].Positions);
        Assert.Equal(smooth[0].Normals, creased[0].Normals);
        // Catmull and Clark's limit is taken after a step, in which the middle of the edge is a crease vertex.
        foreach (Vertex v in mesh.Vertices)
        {
            if (v == end || v == other || v.IsNeighborOf(end) || v.IsNeighborOf(other))
                continue;
            Assert.Equal((smooth[1].Positions[v.Index], smooth[1].Normals[v.Index]), (creased[1].Positions[v.Index], creased[1].Normals[v.Index]));
            Assert.Equal(1, creased[1].Normals[v.Index].Length, 1e-12);
        }
    }

    [Theory]
    [InlineData(1e-9)]
    [InlineData(0.5)]
    [InlineData(1)]
    [InlineData(7)]
    public void Limits_FiniteSharpness_IsRefusedWithTheEdge(double sharpness)
    {
        Mesh mesh = Disc(6, boundary: false);
        Creases.Set(mesh, [mesh.Edges[3]], sharpness);
        Assert.StartsWith("e3 ", Assert.Throws<ArgumentException>("mesh", () => LimitSurface.OfLoop(mesh)).Message, StringComparison.Ordinal);
        Assert.StartsWith("e3 ", Assert.Throws<ArgumentException>("mesh", () => LimitSurface.OfCatmullClark(mesh)).Message, StringComparison.Ordinal);
        Creases.Set(mesh, [mesh.Edges[3]], 0);
        Assert.Equal(LimitSurface.OfLoop(Disc(6, boundary: false)).Normals, LimitSurface.OfLoop(mesh).Normals);
    }

    [Fact]
    public void Limits_LargeMesh_TellProgressOnTheWay()
    {
        Mesh mesh = Grids.Grid(100, 100);
        foreach (Action<IProgress<double>> limit in new Action<IProgress<double>>[] { p => LimitSurface.OfLoop(mesh, progress: p), p => LimitSurface.OfCatmullClark(mesh, p) })
        {
            var told = new List<double>();
            limit(new Simplification.ProgressTeller(told.Add));
            Assert.Equal([0, 0.4096, 0.8192, 1], told);
        }
    }

    [Fact]
    public void OfLoop_OnCreases_IsTheCurvesLimit()
    {
        Mesh mesh = Disc(6, boundary: false);
        HalfEdge h = mesh.FindHalfEdge(mesh.Vertices[0], mesh.Vertices[1]);
        HalfEdge opposite = mesh.FindHalfEdge(mesh.Vertices[0], mesh.Vertices[4]);
        Creases.Set(mesh, [h.Edge, opposite.Edge]);

        LimitPoints limit = LimitSurface.OfLoop(mesh);

        Vector3D expected = 2.0 / 3 * mesh.Positions[0] + 1.0 / 6 * (mesh.Positions[1] + mesh.Positions[4]);
        Assert.True(Vector3D.Distance(expected, limit.Positions[0]) < 1e-15);
        Assert.Equal(default, limit.Normals[0]);
        Creases.Set(mesh, [h.Edge], 1.5);
        Assert.Throws<ArgumentException>(() => LimitSurface.OfLoop(mesh));
    }

    public static TheoryData<SubdivisionScheme, LoopWeights> SchemesWithLimits => new()
    {
        { SubdivisionScheme.Loop, LoopWeights.Loop1987 },
        { SubdivisionScheme.Loop, LoopWeights.Warren },
        { SubdivisionScheme.CatmullClark, LoopWeights.Loop1987 },
    };

    private static Mesh Patch()
    {
        Mesh mesh = Disc(5, boundary: false);
        Creases.Set(mesh, [mesh.FindEdge(mesh.Vertices[0], mesh.Vertices[1]), mesh.FindEdge(mesh.Vertices[0], mesh.Vertices[3])]);
        return mesh;
    }

    [Theory]
    [MemberData(nameof(SchemesWithLimits))]
    public void Subdivide_ToLimit_MovesEveryVertexThere(SubdivisionScheme scheme, LoopWeights weights)
    {
        foreach (bool useCreases in new[] { true, false })
        {
            foreach (int steps in new[] { 0, 2 })
            {
                Mesh mesh = Patch();
                ulong before = mesh.StateHash();
                var options = new SubdivisionOptions { Steps = steps, Weights = weights, UseCreases = useCreases };

                Mesh moved = mesh.Subdivide(scheme, options with { ToLimit = true }, out SubdivisionReport report), finer = mesh.Subdivide(scheme, options);

                if (!useCreases)
                    finer.RemoveTrait(finer.GetOrAddEdgeTrait<double>(Creases.TraitName, 0));
                LimitPoints limit = scheme == SubdivisionScheme.Loop ? LimitSurface.OfLoop(finer, weights) : LimitSurface.OfCatmullClark(finer);
                Assert.Equal(limit.Positions, moved.Positions.ToArray());
                Assert.Equal(finer.Target.ToArray(), moved.Target.ToArray());
                Assert.Equal((SubdivisionStop.StepsDone, steps), (report.StopReason, report.Steps));
                Assert.Equal(before, mesh.StateHash());
                Assert.Empty(moved.Validate());
            }
        }
    }

    [Theory]
    [MemberData(nameof(SchemesWithLimits))]
    public void Subdivide_ToLimit_IsTracedAndTellsProgress(SubdivisionScheme scheme, LoopWeights weights)
    {
        using StringWriter trace = new(), plain = new();
        var told = new List<double>();
        var options = new SubdivisionOptions { Steps = 2, Weights = weights, ToLimit = true, Trace = trace };

        Mesh moved = Patch().Subdivide(scheme, options, new Simplification.ProgressTeller(told.Add));
        Patch().Subdivide(scheme, options with { ToLimit = false, Trace = plain });

        string[] lines = trace.ToString().Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal(3, lines.Length);
        Assert.StartsWith(plain.ToString(), trace.ToString(), StringComparison.Ordinal);
        Assert.StartsWith($"{{\"step\":2,\"operation\":\"limit\",\"vertices\":{moved.Vertices.Count},\"hash\":", lines[2], StringComparison.Ordinal);
        Assert.True(told.Count > 3);
        Assert.Equal(told.Order(), told);
        Assert.Equal(1, told[^1]);
        Assert.All(told.Take(2), value => Assert.InRange(value, 0, 0.99));
    }

    [Theory]
    [MemberData(nameof(SchemesWithLimits))]
    public void Subdivide_ToLimitCancelled_ThrowsAfterTheSteps(SubdivisionScheme scheme, LoopWeights weights)
    {
        Mesh mesh = Patch();
        ulong before = mesh.StateHash();
        using var source = new CancellationTokenSource();
        using var trace = new StringWriter();
        int told = 0;
        var options = new SubdivisionOptions { Steps = 2, Weights = weights, ToLimit = true, Trace = trace };

        Assert.Throws<OperationCanceledException>(() => mesh.Subdivide(scheme, options, new Simplification.ProgressTeller(_ =>
        {
            if (++told == 2)
                source.Cancel();
        }), source.Token));

        Assert.DoesNotContain("limit", trace.ToString(), StringComparison.Ordinal);
        Assert.Equal(before, mesh.StateHash());
        Assert.Throws<OperationCanceledException>(() => LimitSurface.OfLoop(mesh, weights, null, new CancellationToken(true)));
        Assert.Throws<OperationCanceledException>(() => LimitSurface.OfCatmullClark(mesh, null, new CancellationToken(true)));
    }

    [Theory]
    [InlineData(SubdivisionScheme.ModifiedButterfly)]
    [InlineData(SubdivisionScheme.Sqrt3)]
    [InlineData(SubdivisionScheme.DooSabin)]
    [InlineData(SubdivisionScheme.Midpoint)]
    public void Subdivide_ToLimitThatIsNotKnown_IsRefused(SubdivisionScheme scheme)
    {
        ArgumentException error = Assert.Throws<ArgumentException>("options", () => Patch().Subdivide(scheme, new SubdivisionOptions { ToLimit = true }));
        Assert.Contains("ToLimit", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Limits_OfDeletedAndIsolatedVertices_StayInPlace()
    {
        Mesh mesh = Cones.Tetrahedron();
        mesh.DeleteVertexSlot(mesh.AddVertex(new(5, 5, 5)).Index);
        Vertex isolated = mesh.AddVertex(new(6, 6, 6));
        foreach (LimitPoints limit in new[] { LimitSurface.OfLoop(mesh), LimitSurface.OfCatmullClark(mesh) })
        {
            Assert.Equal(isolated.Position, limit.Positions[isolated.Index]);
            Assert.True(limit.Positions[0].Length < mesh.Positions[0].Length);
        }
    }
}

/// <summary>C¹ of the limit by the eigenvalues of the subdivision matrix around a vertex: 1 &gt; λ = λ &gt; the rest, and a characteristic map without folds.</summary>
[Trait("Section", "8")]
public class EigenanalysisTests
{
    public static TheoryData<SubdivisionScheme, int> Cases
    {
        get
        {
            var cases = new TheoryData<SubdivisionScheme, int>();
            foreach (SubdivisionScheme scheme in new[] { SubdivisionScheme.Loop, SubdivisionScheme.ModifiedButterfly, SubdivisionScheme.Sqrt3, SubdivisionScheme.CatmullClark })
            {
                for (int n = 3; n <= 12; n++)
                    cases.Add(scheme, n);
            }
            return cases;
        }
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void SubdivisionMatrix_OfAValence_HasTheEigenvaluesOfC1(SubdivisionScheme scheme, int n)
    {
        // √3 turns the mesh; two steps of it turn it back.
        var options = new SubdivisionOptions { Steps = scheme == SubdivisionScheme.Sqrt3 ? 2 : 1 };
        Mesh mesh = scheme == SubdivisionScheme.CatmullClark ? QuadDisc(n, 4) : TriangleDisc(n, 5);
        int size = scheme == SubdivisionScheme.CatmullClark ? 1 + n * 6 : 1 + n * (1 + 2 + 3);
        double[,] matrix = Matrix(mesh, size, scheme, options);

        var decomposition = MathNet.Numerics.LinearAlgebra.Matrix<double>.Build.DenseOfArray(matrix).Evd();
        int[] byMagnitude = [.. Enumerable.Range(0, size).OrderByDescending(i => decomposition.EigenValues[i].Magnitude)];
        System.Numerics.Complex[] values = [.. byMagnitude.Select(i => decomposition.EigenValues[i])];

        Assert.Equal(1, values[0].Real, 1e-9);
        Assert.Equal(values[1].Magnitude, values[2].Magnitude, 1e-8);
        // Two √3 steps number the spokes from another one, which turns the eigenvectors.
        if (scheme != SubdivisionScheme.Sqrt3)
            Assert.Equal(0, values[1].Imaginary, 1e-8);
        Assert.True(values[1].Magnitude is > 0.1 and < 1);
        Assert.True(values[3].Magnitude < values[1].Magnitude - 1e-6, $"{values[1]} {values[3]}");
        // The columns of a complex pair are its real and its imaginary part.
        AssertNoFolds(mesh, Order(mesh, size), decomposition.EigenVectors.Column(byMagnitude[1]), decomposition.EigenVectors.Column(byMagnitude[2]));
    }

    /// <summary>The characteristic map: the mesh with the two eigenvectors as coordinates. All its faces turn the same way.</summary>
    private static void AssertNoFolds(Mesh mesh, int[] order, IList<double> x, IList<double> y)
    {
        var place = new Dictionary<int, Vector3D>();
        for (int i = 0; i < order.Length; i++)
            place[order[i]] = new(x[i], y[i], 0);
        double[] areas = [.. mesh.Faces.Where(f => f.Vertices.All(v => place.ContainsKey(v.Index))).Select(SignedArea)];
        Assert.NotEmpty(areas);
        Assert.True(areas.All(area => area > 0) || areas.All(area => area < 0), string.Join(' ', areas));

        double SignedArea(Face f)
        {
            Vector3D[] p = [.. f.Vertices.Select(v => place[v.Index])];
            double sum = 0;
            for (int i = 0; i < p.Length; i++)
                sum += Vector3D.Cross(p[i], p[(i + 1) % p.Length]).Z;
            return sum;
        }
    }

    /// <summary>Row i: what the old points give to the new point at the place of old point i. Old points are moved one by one.</summary>
    private static double[,] Matrix(Mesh mesh, int size, SubdivisionScheme scheme, SubdivisionOptions options)
    {
        int[] order = Order(mesh, size);
        int[] newOrder = Order(mesh.Subdivide(scheme, options), size);
        var matrix = new double[size, size];
        mesh.Positions.Clear();
        for (int column = 0; column < size; column++)
        {
            mesh.Positions[order[column]] = new(1, 0, 0);
            Mesh finer = mesh.Subdivide(scheme, options);
            for (int row = 0; row < size; row++)
                matrix[row, column] = finer.Positions[newOrder[row]].X;
            mesh.Positions[order[column]] = default;
        }
        return matrix;
    }

    /// <summary>Vertices ring by ring around vertex 0, each ring in turn from the first spoke: the same walk before and after.</summary>
    private static int[] Order(Mesh mesh, int size)
    {
        var order = new List<int> { 0 };
        var seen = new HashSet<int> { 0 };
        HalfEdge first = mesh.Vertices[0].Outgoing;
        var queue = new Queue<HalfEdge>();
        HalfEdge h = first;
        do
        {
            Visit(h);
            h = h.Previous.Twin;
        }
        while (h != first);
        while (order.Count < size)
        {
            // Turn around the vertex from where it was reached.
            HalfEdge reached = queue.Dequeue(), g = reached.Twin;
            do
            {
                Visit(g);
                g = g.Previous.Twin;
            }
            while (g != reached.Twin);
        }
        return [.. order.Take(size)];

        void Visit(HalfEdge edge)
        {
            if (!seen.Add(edge.Target.Index))
                return;
            order.Add(edge.Target.Index);
            queue.Enqueue(edge);
        }
    }

    private static Mesh TriangleDisc(int n, int rings)
    {
        var builder = new MeshBuilder();
        builder.AddVertex(default);
        for (int k = 1; k <= rings; k++)
        {
            for (int i = 0; i < n * k; i++)
                builder.AddVertex(default);
        }
        for (int k = 1; k <= rings; k++)
        {
            for (int sector = 0; sector < n; sector++)
            {
                for (int i = 0; i < k; i++)
                {
                    builder.AddFace(At(k - 1, sector * (k - 1) + i), At(k, sector * k + i), At(k, sector * k + i + 1));
                    if (i + 1 < k)
                        builder.AddFace(At(k - 1, sector * (k - 1) + i), At(k, sector * k + i + 1), At(k - 1, sector * (k - 1) + i + 1));
                }
            }
        }
        return builder.Build();

        int At(int ring, int i) => ring == 0 ? 0 : 1 + n * ring * (ring - 1) / 2 + i % (n * ring);
    }

    private static Mesh QuadDisc(int n, int rings)
    {
        var number = new Dictionary<(int Sector, int I, int J), int>();
        var builder = new MeshBuilder();
        At(0, 0, 0);
        for (int sector = 0; sector < n; sector++)
        {
            for (int i = 0; i < rings; i++)
            {
                for (int j = 0; j < rings; j++)
                    builder.AddFace(At(sector, i, j), At(sector, i + 1, j), At(sector, i + 1, j + 1), At(sector, i, j + 1));
            }
        }
        return builder.Build();

        // Sector s lies between spokes s (j = 0) and s + 1 (i = 0).
        int At(int sector, int i, int j)
        {
            (int, int, int) key = (i, j) == (0, 0) ? (0, 0, 0) : i == 0 ? ((sector + 1) % n, j, 0) : (sector, i, j);
            if (!number.TryGetValue(key, out int vertex))
                number[key] = vertex = builder.AddVertex(default);
            return vertex;
        }
    }
}
