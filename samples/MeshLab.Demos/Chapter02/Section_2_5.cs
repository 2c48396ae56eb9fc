using MeshLab.Demos.Hosting;
using MeshLab.Generation;
using MeshLab.Structure;

namespace MeshLab.Demos.Chapter02;

/// <summary>§2.5 平面网格: a centred grid, and what becomes of it under a map.</summary>
[Demo("2.5", "平面网格", "Planar grids, and surfaces over them")]
public static class Section_2_5
{
    public static void Run(Mesh mesh, DemoOutput output)
    {
        ShapeTable.Show(
            output,
            "grids",
            ("grid", Grids.Grid(10, 8)),
            ("quads", Grids.Grid(10, 8, faces: PatchFaces.Quads)),
            ("saddle", HeightFields.HyperbolicParaboloid(17)),
            ("terrain", HeightFields.Terrain(48)),
            ("torus", Tori.Torus(m: 32, n: 16)),
            ("knot", Sweeps.TorusKnot(segments: 120, around: 12)));
    }
}
