using MeshLab.Generation;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Subdivision;
using Xunit;

namespace MeshLab.Tests.Subdivision;

[Trait("Section", "8.1")]
public class CreasesTests
{
    [Theory]
    [InlineData(SubdivisionScheme.Loop)]
    [InlineData(SubdivisionScheme.CatmullClark)]
    public void Subdivide_CubeWithAllEdgesSharp_StaysTheCube(SubdivisionScheme scheme)
    {
        Mesh cube = Prisms.Cube();
        Assert.Equal(12, Creases.SetByAngle(cube, 0.5));

        Mesh finer = cube.Subdivide(scheme, new SubdivisionOptions { Steps = 3 });

        Assert.Equal(Measure(cube), Measure(finer), 1e-12);
        Assert.Equal(12 * 8, finer.Edges.Count(e => double.IsPositiveInfinity(Creases.Of(e))));
        Assert.True(Measure(cube.Subdivide(scheme, new SubdivisionOptions { Steps = 3, UseCreases = false })) < 0.6 * Measure(cube));
        Assert.Empty(finer.Validate());
    }

    [Theory]
    [InlineData(SubdivisionScheme.Loop)]
    [InlineData(SubdivisionScheme.CatmullClark)]
    public void Subdivide_ClosedCrease_IsTheBoundaryCurve(SubdivisionScheme scheme)
    {
        // The equator of an octahedron as a crease moves as the boundary of its upper half would.
        Mesh whole = Polyhedra.Octahedron();
        Creases.Set(whole, whole.Edges.Where(e => e.Vertex0.Position.Z == 0 && e.Vertex1.Position.Z == 0));
        Mesh half = MeshBuilder.FromPolygons(whole.Positions[..5], [0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4]);
        var options = new SubdivisionOptions { Steps = 3 };

        Mesh fineWhole = whole.Subdivide(scheme, options), fineHalf = half.Subdivide(scheme, options);

        HashSet<Vector3D> upper = [.. fineWhole.Vertices.Where(v => v.Position.Z > -1e-9).Select(v => Rounded(v.Position))];
        Assert.True(upper.SetEquals(fineHalf.Vertices.Select(v => Rounded(v.Position))));

        static Vector3D Rounded(Vector3D p) => new(Math.Round(p.X, 9) + 0.0, Math.Round(p.Y, 9) + 0.0, Math.Round(p.Z, 9) + 0.0);
    }

    [Fact]
    public void Subdivide_FiniteSharpness_LiesBetweenSmoothAndSharp()
    {
        Mesh cube = Prisms.Cube();
        double before = double.NegativeInfinity;
        foreach (double sharpness in new[] { 0, 0.5, 1, 1.5, 3, double.PositiveInfinity })
        {
            Mesh copy = cube.Clone();
            Creases.SetByAngle(copy, 0.5, sharpness);
            double volume = Measure(LoopSubdivision.Subdivide(copy, new SubdivisionOptions { Steps = 4 }));
            Assert.True(volume > before + 1e-3 || double.IsPositiveInfinity(sharpness), $"{sharpness}: {volume} after {before}");
            before = volume;
        }
        Assert.Throws<ArgumentOutOfRangeException>(() => Creases.Set(cube, cube.Edges, -1));
        Assert.Throws<ArgumentOutOfRangeException>(() => Creases.Set(cube, cube.Edges, double.NaN));
        Assert.Throws<ArgumentOutOfRangeException>(() => Creases.SetByAngle(cube, double.NaN));
        Assert.Throws<ArgumentOutOfRangeException>(() => Creases.SetByAngle(cube, -0.1));
        Assert.Throws<ArgumentException>(() => Creases.Set(cube, Prisms.Cube().Edges));
    }

    [Fact]
    public void Subdivide_Sharpness_LosesOnePerStepDownToZero()
    {
        Mesh mesh = Polyhedra.Octahedron();
        double[] sharpness = [0.25, 1, 1.75, 3, double.PositiveInfinity];
        for (int i = 0; i < sharpness.Length; i++)
            Creases.Set(mesh, [mesh.Edges[i]], sharpness[i]);
        foreach (SubdivisionScheme scheme in new[] { SubdivisionScheme.Loop, SubdivisionScheme.CatmullClark })
        {
            double[] left = [.. mesh.Subdivide(scheme, new() { Steps = 2 }).Edges.Select(Creases.Of)];
            Assert.Equal([0, 1, double.PositiveInfinity], left.Distinct().Order());
            Assert.Equal((4, 4), (left.Count(s => s == 1), left.Count(double.IsPositiveInfinity)));
        }
    }

    [Fact]
    public void SetByAngle_Cube_TakesWhatIsSharperOnly()
    {
        Assert.Equal(0, Creases.SetByAngle(Prisms.Cube(), Math.PI / 2));
        Assert.Equal(12, Creases.SetByAngle(Prisms.Cube(), Math.BitDecrement(Math.PI / 2)));
    }

    private static double Measure(Mesh mesh) => MeshLab.Tests.Generation.Measure.Volume(mesh);
}

[Trait("Section", "8")]
public class SubdividedTraitTests
{
    public static TheoryData<SubdivisionScheme> Schemes => new(Enum.GetValues<SubdivisionScheme>());

    [Theory]
    [MemberData(nameof(Schemes))]
    public void Subdivide_WithTraits_BlendsInheritsAndKeepsTheSeam(SubdivisionScheme scheme)
    {
        // Corner coordinates of the cylinder are linear in the height and, up to the seam, in the angle.
        Mesh mesh = Prisms.OpenCylinder(8, 6);
        VertexTrait<double> height = mesh.AddVertexTrait<double>("height", 0, Blend.Linear);
        foreach (Vertex v in mesh.Vertices)
            height[v] = v.Index / 8;
        FaceLabels material = mesh.GetOrAddFaceLabels("material");
        foreach (Face f in mesh.Faces)
            material.Labels[f] = material.Number(f.Index < 48 ? "lower" : "upper");
        FaceTrait<int> origin = mesh.AddFaceTrait("origin", -1);
        foreach (Face f in mesh.Faces)
            origin[f] = f.Index;

        Mesh finer = mesh.Subdivide(scheme, new SubdivisionOptions { Steps = 2 });

        Assert.True(finer.TryGetVertexTrait("height", out VertexTrait<double>? fineHeight));
        Assert.True(finer.TryGetFaceTrait("origin", out FaceTrait<int>? fineOrigin));
        Assert.True(finer.TryGetHalfEdgeTrait(TraitNames.TextureCoordinate, out HalfEdgeTrait<Vector2D>? uv));
        FaceLabels fineMaterial = Assert.Single(finer.FaceLabels);
        Assert.Equal(material.Names, fineMaterial.Names);
        foreach (Face f in finer.Faces)
        {
            Assert.InRange(fineOrigin[f], 0, 95);
            Assert.Equal(fineOrigin[f] < 48 ? "lower" : "upper", fineMaterial.NameOf(f));
            foreach (HalfEdge h in f.HalfEdges)
            {
                // Both were blended with the same weights, and v = height/6 to begin with.
                Assert.Equal(fineHeight[h.Target] / 6, uv[h].Y, 1e-12);
                Assert.InRange(uv[h].X, -1e-12, 1 + 1e-12);
            }
            // No face runs from one end of the texture to the other, but where √3 flips an edge of the seam or Doo and Sabin's faces lie on it.
            if (scheme is not (SubdivisionScheme.Sqrt3 or SubdivisionScheme.DooSabin))
                Assert.True(f.HalfEdges.ToArray().Max(h => uv[h].X) - f.HalfEdges.ToArray().Min(h => uv[h].X) < 0.2);
        }
        Assert.Empty(finer.Validate());
    }

    [Fact]
    public void Subdivide_EdgeTraits_GoToTheHalves()
    {
        Mesh mesh = Cones.Tetrahedron();
        EdgeTrait<int> mark = mesh.AddEdgeTrait("mark", -1);
        foreach (Edge e in mesh.Edges)
            mark[e] = e.Index;

        Mesh finer = LoopSubdivision.Subdivide(mesh);

        Assert.True(finer.TryGetEdgeTrait("mark", out EdgeTrait<int>? fine));
        foreach (Edge e in finer.Edges)
        {
            int old = e.Vertex0.Index < 4 ? e.Vertex1.Index - 4 : e.Vertex1.Index < 4 ? e.Vertex0.Index - 4 : -1;
            Assert.Equal(old, fine[e]);
        }
    }
}
