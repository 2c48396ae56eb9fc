namespace MeshLab.Generation;

/// <summary>All shapes of chapter 2 by name, with what they take: what <c>mlab generate</c> lists and makes.</summary>
public static class ShapeCatalog
{
    private const double Tiny = 1e-9;
    private const double Huge = 1e9;

    /// <summary>The shapes in the book's order.</summary>
    public static IReadOnlyList<Shape> Shapes { get; } =
    [
        new("polygon", "2.1", "正多边形", "a regular polygon", [Count("n", "corners", 6, 3), Length("radius", 0.5)],
            a => Polygons.Polygon(a.Whole("n"), a.Real("radius"))),
        new("circle", "2.1", "圆", "a disc as a fan of 50 triangles", [Count("n", "corners", 50, 3), Length("radius", 0.5)],
            a => Polygons.Circle(a.Whole("n"), a.Real("radius"))),
        new("annulus", "2.1", "圆环", "a flat ring",
            [Length("inner", 0.25), Length("outer", 0.5), Count("segments", "cells around", 48, 3), Count("rings", "cells across", 4, 1)],
            a => Polygons.Annulus(a.Real("inner"), a.Real("outer"), a.Whole("segments"), a.Whole("rings"))),
        new("pyramid", "2.2", "四棱锥", "the square pyramid", [], _ => Cones.Pyramid()),
        new("tetrahedron", "2.2", "四面体", "the regular tetrahedron as a cone", [], _ => Cones.Tetrahedron()),
        new("cone", "2.2", "圆锥", "a cone with its base",
            [Count("n", "sides", 50, 3), Length("height", Math.Sqrt(0.5)), Length("radius", 0.5)],
            a => Cones.Cone(a.Whole("n"), a.Real("height"), a.Real("radius"))),
        new("cube", "2.3", "立方体", "the cube as a prism, in triangles", [], _ => Prisms.Cube()),
        new("cylinder", "2.3", "圆柱", "a cylinder with caps", [Count("n", "sides", 50, 3), Length("height", 1), Length("radius", 0.5)],
            a => Prisms.Cylinder(a.Whole("n"), a.Real("height"), a.Real("radius"))),
        new("open-cylinder", "2.3", "UV 圆柱面", "a cylinder without caps, with texture coordinates",
            [Count("n", "sides", 50, 3), Count("rings", "cells along the axis", 8, 1), Length("height", 1), Length("radius", 0.5)],
            a => Prisms.OpenCylinder(a.Whole("n"), a.Whole("rings"), a.Real("height"), a.Real("radius"))),
        new("sphere", "2.4", "UV 球面", "a sphere by meridians and parallels", [Count("n", "meridians, and parallels + 1", 32, 3), Length("radius", 1)],
            a => Spheres.UVSphere(a.Whole("n"), a.Real("radius"))),
        new("icosphere", "2.4", "二十面体球面", "the icosahedron subdivided onto the sphere",
            [Whole("level", "how often every triangle is cut into four", 3, 0, 9), Length("radius", 1)],
            a => Spheres.Icosphere(a.Whole("level"), a.Real("radius"))),
        new("ellipsoid", "2.4", "椭球", "an ellipsoid",
            [Length("a", 1), Length("b", 0.75), Length("c", 0.5), Count("n", "meridians, and parallels + 1", 32, 3)],
            a => Spheres.Ellipsoid(a.Real("a"), a.Real("b"), a.Real("c"), a.Whole("n"))),
        new("grid", "2.5", "平面网格", "a flat grid of m × n vertices",
            [Count("m", "vertices along x", 10, 2), Count("n", "vertices along y", 10, 2), Length("width", 1), Length("height", 1), Quads(0)],
            a => Grids.Grid(a.Whole("m"), a.Whole("n"), a.Real("width"), a.Real("height"), Faces(a))),
        new("regular-tetrahedron", "2", "正四面体", "Platonic solid of 4 triangles", [Length("radius", 1)], a => Polyhedra.Tetrahedron(a.Real("radius"))),
        new("regular-cube", "2", "正六面体", "Platonic solid of 6 squares", [Length("radius", 1)], a => Polyhedra.Cube(a.Real("radius"))),
        new("octahedron", "2", "正八面体", "Platonic solid of 8 triangles", [Length("radius", 1)], a => Polyhedra.Octahedron(a.Real("radius"))),
        new("dodecahedron", "2", "正十二面体", "Platonic solid of 12 pentagons", [Length("radius", 1)], a => Polyhedra.Dodecahedron(a.Real("radius"))),
        new("icosahedron", "2", "正二十面体", "Platonic solid of 20 triangles", [Length("radius", 1)], a => Polyhedra.Icosahedron(a.Real("radius"))),
        new("torus", "2", "环面", "a torus, genus 1",
            [Length("major", 1), Length("minor", 0.4), Count("m", "cells around the axis", 48, 3), Count("n", "cells around the tube", 24, 3), Quads(0)],
            a => Tori.Torus(a.Real("major"), a.Real("minor"), a.Whole("m"), a.Whole("n"), Faces(a))),
        new("holed-torus", "2", "多孔环面", "a torus with k holes, genus k",
            [Whole("genus", "holes", 3, 1, 32), Whole("resolution", "lattice cells per unit", 8, 6, 64)],
            a => Tori.KHoled(a.Whole("genus"), a.Whole("resolution"))),
        new("chain", "2", "链", "interlocked tori, one component each",
            [Whole("links", "tori", 5, 1, 1000), Count("m", "cells around a link", 48, 3), Count("n", "cells around a tube", 16, 3)],
            a => Tori.Chain(a.Whole("links"), a.Whole("m"), a.Whole("n"))),
        new("moebius", "2", "莫比乌斯带", "the Möbius strip; not orientable, so it is refused unless conflicts may be split or skipped",
            [Count("segments", "cells around", 64, 3), Count("rows", "cells across", 4, 1), new("width", "width", 0.6, Tiny, 1.9, false)],
            a => MoebiusStrips.Strip(a.Whole("segments"), a.Whole("rows"), a.Real("width"))),
        new("catenoid", "2", "悬链面", "the minimal surface between two rings",
            [Length("c", 0.5), Length("height", 1), Count("segments", "cells around", 64, 3), Count("rings", "cells along the axis", 32, 1)],
            a => Revolutions.Catenoid(a.Real("c"), a.Real("height"), a.Whole("segments"), a.Whole("rings"))),
        new("hyperbolic-paraboloid", "2", "双曲抛物面", "the saddle z = (x² − y²)/a",
            [Count("n", "vertices per side", 33, 2), Length("a", 1), Length("width", 1)],
            a => HeightFields.HyperbolicParaboloid(a.Whole("n"), a.Real("a"), a.Real("width"))),
        new("knot", "2", "纽结", "a tube along the (p, q) torus knot",
            [
                Whole("p", "turns around the axis", 2, 1, 1000), Whole("q", "turns through the hole", 3, 1, 1000),
                Count("segments", "cells along the knot", 240, 3), Count("around", "cells around the tube", 20, 3), Length("tube", 0.25),
            ],
            a => Sweeps.TorusKnot(a.Whole("p"), a.Whole("q"), a.Whole("segments"), a.Whole("around"), a.Real("tube"))),
        new("spring", "2", "弹簧", "a wire swept along a helix",
            [
                Whole("turns", "turns of the helix", 5, 1, 10_000), Whole("segments", "cells per turn", 48, 3, 10_000),
                Count("around", "cells around the wire", 12, 3), Length("wire", 0.1),
            ],
            a => Sweeps.Spring(a.Whole("turns"), a.Whole("segments"), a.Whole("around"), a.Real("wire"))),
        new("terrain", "2", "高度场", "a fractal landscape over the unit square",
            [Count("n", "vertices per side", 96, 2), new("roughness", "height of the mountains", 0.3, 0, Huge, false), Seed()],
            a => HeightFields.Terrain(a.Whole("n"), a.Real("roughness"), a.Whole("seed"))),
        new("perforated-sheet", "2", "带孔曲面", "a wavy sheet with round holes",
            [
                Whole("holes", "holes per side", 3, 1, 16), Whole("resolution", "cells per hole and side", 16, 2, 512),
                new("amplitude", "height of the waves", 0.08, 0, Huge, false),
            ],
            a => HeightFields.PerforatedSheet(a.Whole("holes"), a.Whole("resolution"), a.Real("amplitude"))),
        new("vase", "2", "花瓶", "a surface of revolution, mostly quadrilaterals",
            [Count("segments", "cells around", 48, 3), Count("rings", "cells along the wall", 40, 4)],
            a => Revolutions.Vase(a.Whole("segments"), a.Whole("rings"))),
        new("flange", "2", "法兰", "a machine part with sharp edges and slivers, genus 5", [Whole("segments", "sides of every circle, a multiple of 4", 32, 8, 512)],
            a => CadParts.Flange(a.Whole("segments"))),
        new("bracket", "2", "角铁", "an L-shaped extrusion", [], _ => CadParts.Bracket()),
        new("creature", "2", "小兽", "a beast from melted bones, as a scanner would see it, genus 1",
            [
                Whole("resolution", "lattice cells per unit", 19, 16, 200), new("skin", "height of the skin's bumps", 0.012, 0, 0.3, false),
                new("noise", "deviation of the scanner's noise, in cells", 0.03, 0, 0.3, false), Seed(),
            ],
            a => Creatures.Beast(a.Whole("resolution"), a.Real("skin"), a.Real("noise"), a.Whole("seed"))),
    ];

    /// <summary>The shape of a name.</summary>
    /// <exception cref="ArgumentException">There is none; the message lists those that there are.</exception>
    public static Shape Find(string name)
    {
        ArgumentNullException.ThrowIfNull(name);
        return Shapes.FirstOrDefault(shape => shape.Name == name)
            ?? throw new ArgumentException($"There is no shape \"{name}\"; there are {string.Join(", ", Shapes.Select(shape => shape.Name))}.", nameof(name));
    }

    private static ShapeParameter Count(string name, string description, int value, int least) =>
        Whole(name, description, value, least, Check.MostSegments);

    private static ShapeParameter Whole(string name, string description, int value, int least, int most) =>
        new(name, description, value, least, most, IsInteger: true);

    private static ShapeParameter Length(string name, double value) => new(name, "length", value, Tiny, Huge, IsInteger: false);

    private static ShapeParameter Quads(int value) => new("quads", "1 for quadrilaterals, 0 for triangles", value, 0, 1, IsInteger: true);

    private static ShapeParameter Seed() => new("seed", "another seed, another shape", 1, 0, int.MaxValue, IsInteger: true);

    private static PatchFaces Faces(ShapeArguments a) => a.Whole("quads") == 1 ? PatchFaces.Quads : PatchFaces.Triangles;
}
