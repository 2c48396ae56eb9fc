using MeshLab.Editing;
using MeshLab.Numerics;
using MeshLab.Remeshing;
using MeshLab.Structure;
using MeshLab.Subdivision;
using Xunit;

namespace MeshLab.Tests.Remeshing;

/// <summary>What the guard foretells is what the operations do to the angles of all features.</summary>
[Trait("Section", "L4")]
public class FeatureSharpnessTests
{
    private const double Limit = 1.45;

    private static readonly Mesh Boxes = MakeBoxes();

    // A cube and a box with a hole in its lid.
    private static Mesh MakeBoxes()
    {
        Mesh mesh = Models.Create("cube"), open = Models.Create("cube");
        open.Faces[0].Delete();
        mesh.Append(open);
        mesh.Compact();
        return mesh.Subdivide(SubdivisionScheme.Midpoint, new() { Steps = 2 });
    }

    // The boxes with their corners shaken: features bend by 90° more or less.
    private static RemeshSurface Shaken(int seed)
    {
        var surface = new RemeshSurface(Boxes);
        FeatureLines.Mark(Boxes, surface, 0.7, 1);
        var random = new Random(seed);
        for (int v = 0; v < surface.VertexSlots; v++)
            surface.Positions[v] += 0.08 * new Vector3D(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5);
        return surface;
    }

    [Fact]
    public void AllowsFlip_EveryEdge_AsTheFlipDoes()
    {
        int allowed = 0, refused = 0;
        for (int h = 0; h < Boxes.HalfEdgeSlots; h++)
        {
            RemeshSurface s = Shaken(1);
            if (s.OnLine[h >> 1] || !s.CanFlip(h))
                continue;
            bool foretold = new FeatureSharpness(s, Limit).AllowsFlip(h);
            double[] before = Cosines(s);
            s.Flip(h);
            Assert.Equal(StaySharp(before, Cosines(s)), foretold);
            (allowed, refused) = foretold ? (allowed + 1, refused) : (allowed, refused + 1);
        }
        Assert.True(allowed > 50 && refused > 50, $"{allowed} {refused}");
    }

    [Theory]
    [InlineData(2)]
    [InlineData(4)]
    [InlineData(5)]
    public void AllowsCollapse_EveryHalfEdge_AsTheCollapseDoes(int seed)
    {
        int allowed = 0, refused = 0, merged = 0;
        for (int h = 0; h < Boxes.HalfEdgeSlots; h++)
        {
            RemeshSurface s = Shaken(seed);
            int u = s.Target[h ^ 1], v = s.Target[h];
            bool alongLine = s.OnLine[h >> 1];
            if (!s.CanCollapse(h) || (s.LineCount[u] != 0 && !(alongLine && s.LineCount[u] == 2)))
                continue;
            Vector3D position = s.LineCount[u] == 0 && s.LineCount[v] == 0 ? (s.Positions[u] + s.Positions[v]) * 0.5 : s.Positions[v];
            bool foretold = new FeatureSharpness(s, Limit).AllowsCollapse(h, position);
            double[] before = Cosines(s);
            // Where two sides become one, the one at the source keeps its number and takes over the feature of the other.
            foreach ((int side, int atTarget, int atSource) in new[] { (h, s.Next[h], s.Previous[h]), (h ^ 1, s.Previous[h ^ 1], s.Next[h ^ 1]) })
            {
                if (s.Face[side] < 0 || double.IsNaN(before[atTarget >> 1]))
                    continue;
                merged++;
                int kept = side == h ? atSource : atTarget;
                before[kept >> 1] = before[atTarget >> 1];
            }
            s.Collapse(h, position);
            Assert.Equal(StaySharp(before, Cosines(s)), foretold);
            (allowed, refused) = foretold ? (allowed + 1, refused) : (allowed, refused + 1);
        }
        Assert.True(allowed > 50 && refused > 50 && merged > 50, $"{allowed} {refused} {merged}");
    }

    [Fact]
    public void TakeBackMoves_RandomPlaces_KeepsWhatStaysSharp()
    {
        RemeshSurface s = Shaken(3);
        var random = new Random(3);
        Vector3D[] places = [.. s.Positions];
        for (int v = 0; v < s.VertexSlots; v++)
            places[v] += 0.06 * new Vector3D(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5);
        Vector3D[] wanted = [.. places], old = [.. s.Positions];
        double[] before = Cosines(s);

        new FeatureSharpness(s, Limit).TakeBackMoves(places);

        Assert.All(Enumerable.Range(0, s.VertexSlots), v => Assert.True(places[v] == wanted[v] || places[v] == old[v]));
        int back = Enumerable.Range(0, s.VertexSlots).Count(v => places[v] == old[v]);
        Assert.InRange(back, 10, s.VertexSlots - 10);
        // Away from features nothing is taken back.
        for (int v = 0; v < s.VertexSlots; v++)
        {
            if (s.LineCount[v] == 0 && !Around(s, v).Any(w => s.LineCount[w] != 0))
                Assert.Equal(wanted[v], places[v]);
        }
        s.Positions = wanted;
        Assert.False(StaySharp(before, Cosines(s)));
        s.Positions = places;
        Assert.True(StaySharp(before, Cosines(s)));
    }

    /// <summary>Folds hardly sharper than the feature angle, on a rough sheet: with the guard no step makes one flatter than that; without it some do.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Steps_FoldsAtTheFeatureAngle_StaySharp(bool flips)
    {
        const double Angle = 0.25;
        int flattened = 0;
        for (int seed = 0; seed < 8; seed++)
        {
            Mesh sheet = RemeshSurfaces.Sheet(12, seed, 0.4, x => 0.4 * Math.Max(0, Math.Abs(x - 6) - 2));
            var random = new Random(seed);
            foreach (Vertex v in sheet.Vertices)
                v.Position += new Vector3D(0, 0, (flips ? 0.2 : 0.1) * random.NextDouble());
            foreach (bool guard in new[] { true, false })
            {
                (RemeshSurface s, FeatureLines lines) = RemeshSurfaces.Of(sheet, 1.6, Angle);
                FeatureSharpness? sharpness = guard ? new FeatureSharpness(s, Angle) : null;
                Assert.True(lines.FeatureEdges > 20);
                int done;
                if (flips)
                {
                    var step = new ValenceFlips(s, sharpness);
                    step.Run();
                    done = step.Flips;
                }
                else
                {
                    var step = new LengthSteps(s, lines, sharpness);
                    step.CollapseShort();
                    done = step.Collapses;
                }
                Assert.True(done > 0);
                int flat = Cosines(s).Count(c => c >= Math.Cos(Angle));
                flattened += guard ? 0 : flat;
                Assert.True(flat == 0 || !guard, $"{flat}");
            }
        }
        Assert.True(flattened > 0);
    }

    private static IEnumerable<int> Around(RemeshSurface s, int v) =>
        Enumerable.Range(0, s.HalfEdgeSlots).Where(h => s.Target[h ^ 1] == v).Select(h => s.Target[h]);

    private static bool StaySharp(double[] before, double[] after) => !after.Where((c, e) => c >= Math.Cos(Limit) && c > before[e] + 1e-12).Any();

    // Per edge the cosine between the normals beside it; NaN if it is no feature.
    private static double[] Cosines(RemeshSurface s)
    {
        var cosines = new double[s.HalfEdgeSlots / 2];
        Array.Fill(cosines, double.NaN);
        for (int h = 0; h < s.HalfEdgeSlots; h += 2)
        {
            if (!s.IsFreeEdge(h) && s.OnLine[h >> 1] && s.Face[h] >= 0 && s.Face[h + 1] >= 0)
                cosines[h >> 1] = Vector3D.Dot(Normal(s, h), Normal(s, h + 1));
        }
        return cosines;
    }

    private static Vector3D Normal(RemeshSurface s, int h)
    {
        Vector3D a = s.Positions[s.Target[h ^ 1]];
        return Vector3D.Cross(s.Positions[s.Target[h]] - a, s.Positions[s.Target[s.Next[h]]] - a).Normalized();
    }
}
