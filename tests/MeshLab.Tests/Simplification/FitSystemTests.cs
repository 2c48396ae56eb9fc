using MathNet.Numerics.LinearAlgebra;
using MeshLab.Numerics;
using MeshLab.Simplification;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.Simplification;

[Trait("Section", "7.2")]
public class FitSystemTests
{
    private const double Damping = 0.005;

    /// <summary>What samples everywhere on the faces add up to that lie by a height above them: ∫ b bᵀ and h ∫ b, times a density.</summary>
    private static FaceSums[] Lifted(FitSurface surface, double height, double density) => [.. Enumerable.Range(0, surface.FaceCount).Select(f =>
    {
        double area = density * surface.DoubledArea(f).Length / 2, own = area / 6, other = area / 12, gradient = height * area / 3;
        return new FaceSums { M00 = own, M01 = other, M02 = other, M11 = own, M12 = other, M22 = own, G0 = gradient, G1 = gradient, G2 = gradient };
    })];

    /// <summary>Samples scattered over the faces, at random heights.</summary>
    private static FaceSums[] Scattered(FitSurface surface)
    {
        var random = new Random(12);
        var sums = new FaceSums[surface.FaceCount];
        for (int f = 0; f < sums.Length; f++)
        {
            double weight = surface.DoubledArea(f).Length / 10;
            for (int i = 0; i < 5; i++)
            {
                double s = Math.Sqrt(random.NextDouble()), r = random.NextDouble();
                sums[f].Add(weight, random.NextDouble() - 0.3, 0, new(1 - s, s * (1 - r), s * r));
            }
        }
        return sums;
    }

    /// <summary>The matrix Σ w b bᵀ ⊗ n nᵀ + μ I and the right side Σ w r b ⊗ n as the formulas say, and 1 on the diagonal for fixed vertices.</summary>
    private static (Matrix<double> Matrix, Vector<double> Right) Dense(FitSurface surface, FaceSums[] sums, bool[] isFixed)
    {
        int n = surface.VertexCount;
        Matrix<double> matrix = Matrix<double>.Build.Dense(3 * n, 3 * n);
        Vector<double> right = Vector<double>.Build.Dense(3 * n);
        double[] share = new double[n], got = new double[n];
        for (int f = 0; f < sums.Length; f++)
        {
            FaceSums s = sums[f];
            int[] corners = [surface.Corners[f].A, surface.Corners[f].B, surface.Corners[f].C];
            double[,] mass = { { s.M00, s.M01, s.M02 }, { s.M01, s.M11, s.M12 }, { s.M02, s.M12, s.M22 } };
            double[] gradient = [s.G0, s.G1, s.G2], normal = [surface.Normals[f].X, surface.Normals[f].Y, surface.Normals[f].Z];
            for (int i = 0; i < 3; i++)
            {
                share[corners[i]] += surface.DoubledArea(f).Length / 12;
                got[corners[i]] += mass[i, i];
                for (int x = 0; x < 3; x++)
                {
                    right[3 * corners[i] + x] += gradient[i] * normal[x];
                    for (int j = 0; j < 3; j++)
                    {
                        for (int y = 0; y < 3; y++)
                            matrix[3 * corners[i] + x, 3 * corners[j] + y] += mass[i, j] * normal[x] * normal[y];
                    }
                }
            }
        }
        for (int i = 0; i < 3 * n; i++)
        {
            int v = i / 3;
            matrix[i, i] += Damping * share[v] + Math.Max(0, share[v] - got[v]);
            if (!isFixed[v])
                continue;
            matrix.ClearRow(i);
            matrix.ClearColumn(i);
            (matrix[i, i], right[i]) = (1, 0);
        }
        return (matrix, right);
    }

    /// <summary>All want the same: every vertex moves by that height, but for the damping. With half as many samples as the area asks for, it is held more strongly.</summary>
    [Theory]
    [InlineData(1, Damping / 2)]
    [InlineData(0.5, Damping + 0.5)]
    public void Solve_SamplesAboveAFlatSheet_LiftsAllVerticesAlike(double density, double held)
    {
        FitSurface surface = FitSurfaceTests.SurfaceOf(Shapes.Moved(Shapes.Sheet(3), p => new(p.X + 0.1 * p.Y * p.X, p.Y, 0)));
        const double Height = 0.01;

        UncheckedArray<Vector3D> moves = new FitSystem(surface, new bool[surface.VertexCount]).Solve(Lifted(surface, Height, density));

        double expected = Height / (1 + held);
        for (int v = 0; v < surface.VertexCount; v++)
            Assert.Equal(0, Vector3D.Distance(new(0, 0, expected), moves[v]), 1e-15);
    }

    /// <summary>Alone, a vertex is a system of three equations, which its block solves.</summary>
    [Fact]
    public void Solve_OneFreeVertex_IsExactAndMovesNoOther()
    {
        Mesh mesh = Shapes.Moved(Models.Create("octahedron"), p => new(p.X + 0.2 * p.Y, 1.3 * p.Y + 0.3 * p.Z, p.Z - 0.4 * p.X));
        FitSurface surface = FitSurfaceTests.SurfaceOf(mesh);
        FaceSums[] sums = Scattered(surface);
        for (int free = 0; free < surface.VertexCount; free++)
        {
            var isFixed = new bool[surface.VertexCount];
            Array.Fill(isFixed, true);
            isFixed[free] = false;
            (Matrix<double> matrix, Vector<double> right) = Dense(surface, sums, isFixed);
            Vector<double> expected = matrix.Solve(right);

            UncheckedArray<Vector3D> moves = new FitSystem(surface, isFixed).Solve(sums);

            for (int v = 0; v < surface.VertexCount; v++)
                Assert.Equal(0, Vector3D.Distance(new(expected[3 * v], expected[3 * v + 1], expected[3 * v + 2]), moves[v]), 1e-12);
        }
    }

    /// <summary>Six iterations are enough for a few ten-thousandths of the error that standing still has.</summary>
    [Fact]
    public void Solve_ManyVertices_ComesCloseToTheSolution()
    {
        FitSurface surface = FitSurfaceTests.SurfaceOf(Shapes.Torus(12, 8));
        FaceSums[] sums = Scattered(surface);
        var isFixed = new bool[surface.VertexCount];
        for (int v = 0; v < isFixed.Length; v += 9)
            isFixed[v] = true;
        (Matrix<double> matrix, Vector<double> right) = Dense(surface, sums, isFixed);
        Vector<double> solution = matrix.Solve(right);
        var system = new FitSystem(surface, isFixed);

        // A system of an earlier sweep leaves nothing behind.
        system.Solve(Lifted(surface, 1, 2));
        UncheckedArray<Vector3D> moves = system.Solve(sums);

        Vector<double> error = solution - Vector<double>.Build.Dense([.. moves.Items.SelectMany(m => new[] { m.X, m.Y, m.Z })]);
        Assert.InRange(error * (matrix * error) / (solution * (matrix * solution)), 0, 3e-4);
        Assert.All(Enumerable.Range(0, isFixed.Length).Where(v => isFixed[v]), v => Assert.Equal(default, moves[v]));
    }
}
