using MeshLab.Numerics;

namespace MeshLab.Structure;

/// <summary>Names of the textbook's trait columns, as <see cref="Mesh.TryGetVertexTrait{T}"/> and its like find them.</summary>
public static class TraitNames
{
    /// <summary>Vertex or half-edge or face: <see cref="Vector3D"/>.</summary>
    public const string Normal = "Normal";

    /// <summary>Vertex: <see cref="Vector2D"/>.</summary>
    public const string UV = "UV";

    /// <summary>Vertex, edge or face: <see cref="Numerics.Color"/>.</summary>
    public const string Color = "Color";

    /// <summary>Vertex, edge or face: <see cref="int"/>, selected if not 0.</summary>
    public const string SelectedFlag = "SelectedFlag";

    /// <summary>Half-edge: <see cref="Vector2D"/>.</summary>
    public const string TextureCoordinate = "TextureCoordinate";

    /// <summary>Vertex: <see cref="double"/>.</summary>
    public const string MaxCurvature = "MaxCurvature";

    /// <summary>Vertex: <see cref="double"/>.</summary>
    public const string MinCurvature = "MinCurvature";

    /// <summary>Vertex: <see cref="Vector3D"/>.</summary>
    public const string MaxCurvatureDirection = "MaxCurvatureDirection";

    /// <summary>Vertex: <see cref="Vector3D"/>.</summary>
    public const string MinCurvatureDirection = "MinCurvatureDirection";

    /// <summary>Vertex: <see cref="double"/>.</summary>
    public const string GaussianCurvature = "GaussianCurvature";

    /// <summary>Vertex: <see cref="double"/>.</summary>
    public const string MeanCurvature = "MeanCurvature";
}

/// <summary>The textbook's class VertexTraits (顶点属性) as a view over columns; a column exists from the first value written.</summary>
/// <param name="vertex">The vertex.</param>
public sealed class VertexTraits(Vertex vertex)
{
    /// <summary>The position (位置).</summary>
    public Vector3D Position
    {
        get => vertex.Position;
        set => vertex.Position = value;
    }

    /// <summary>The normal (法向).</summary>
    public Vector3D Normal
    {
        get => Get<Vector3D>(TraitNames.Normal);
        set => vertex.mesh.GetOrAddVertexTrait<Vector3D>(TraitNames.Normal, default, Blend.Direction)[vertex] = value;
    }

    /// <summary>The texture coordinate (纹理坐标).</summary>
    public Vector2D UV
    {
        get => Get<Vector2D>(TraitNames.UV);
        set => vertex.mesh.GetOrAddVertexTrait<Vector2D>(TraitNames.UV, default, Blend.Linear)[vertex] = value;
    }

    /// <summary>The colour (颜色).</summary>
    public Color Color
    {
        get => Get<Color>(TraitNames.Color);
        set => vertex.mesh.GetOrAddVertexTrait<Color>(TraitNames.Color, default, Blend.Linear)[vertex] = value;
    }

    /// <summary>Selected if not 0 (选择标记); also used as a label.</summary>
    public int SelectedFlag
    {
        get => Get<int>(TraitNames.SelectedFlag);
        set => vertex.mesh.GetOrAddVertexTrait<int>(TraitNames.SelectedFlag, 0, Blend.Nearest)[vertex] = value;
    }

    /// <summary>The larger principal curvature (最大主曲率).</summary>
    public double MaxCurvature
    {
        get => Get<double>(TraitNames.MaxCurvature);
        set => vertex.mesh.GetOrAddVertexTrait<double>(TraitNames.MaxCurvature, 0, Blend.Linear)[vertex] = value;
    }

    /// <summary>The smaller principal curvature (最小主曲率).</summary>
    public double MinCurvature
    {
        get => Get<double>(TraitNames.MinCurvature);
        set => vertex.mesh.GetOrAddVertexTrait<double>(TraitNames.MinCurvature, 0, Blend.Linear)[vertex] = value;
    }

    /// <summary>The direction of the larger principal curvature (最大主曲率方向).</summary>
    public Vector3D MaxCurvatureDirection
    {
        get => Get<Vector3D>(TraitNames.MaxCurvatureDirection);
        set => vertex.mesh.GetOrAddVertexTrait<Vector3D>(TraitNames.MaxCurvatureDirection, default, Blend.Nearest)[vertex] = value;
    }

    /// <summary>The direction of the smaller principal curvature (最小主曲率方向).</summary>
    public Vector3D MinCurvatureDirection
    {
        get => Get<Vector3D>(TraitNames.MinCurvatureDirection);
        set => vertex.mesh.GetOrAddVertexTrait<Vector3D>(TraitNames.MinCurvatureDirection, default, Blend.Nearest)[vertex] = value;
    }

    /// <summary>The Gaussian curvature (高斯曲率).</summary>
    public double GaussianCurvature
    {
        get => Get<double>(TraitNames.GaussianCurvature);
        set => vertex.mesh.GetOrAddVertexTrait<double>(TraitNames.GaussianCurvature, 0, Blend.Linear)[vertex] = value;
    }

    /// <summary>The mean curvature (平均曲率).</summary>
    public double MeanCurvature
    {
        get => Get<double>(TraitNames.MeanCurvature);
        set => vertex.mesh.GetOrAddVertexTrait<double>(TraitNames.MeanCurvature, 0, Blend.Linear)[vertex] = value;
    }

    private T Get<T>(string name)
        where T : struct => vertex.mesh.TryGetVertexTrait(name, out VertexTrait<T>? trait) ? trait[vertex] : default;
}

/// <summary>The textbook's class HalfEdgeTraits (半边属性) as a view over columns: the corner at the half-edge's target.</summary>
/// <param name="halfEdge">The half-edge.</param>
public sealed class HalfEdgeTraits(HalfEdge halfEdge)
{
    /// <summary>The corner's texture coordinate (纹理坐标).</summary>
    public Vector2D TextureCoordinate
    {
        get => Get<Vector2D>(TraitNames.TextureCoordinate);
        set => halfEdge.mesh.GetOrAddHalfEdgeTrait<Vector2D>(TraitNames.TextureCoordinate, default, Blend.Linear)[halfEdge] = value;
    }

    /// <summary>The corner's normal (法向).</summary>
    public Vector3D Normal
    {
        get => Get<Vector3D>(TraitNames.Normal);
        set => halfEdge.mesh.GetOrAddHalfEdgeTrait<Vector3D>(TraitNames.Normal, default, Blend.Direction)[halfEdge] = value;
    }

    private T Get<T>(string name)
        where T : struct => halfEdge.mesh.TryGetHalfEdgeTrait(name, out HalfEdgeTrait<T>? trait) ? trait[halfEdge] : default;
}

/// <summary>The textbook's class EdgeTraits (边属性) as a view over columns.</summary>
/// <param name="edge">The edge.</param>
public sealed class EdgeTraits(Edge edge)
{
    /// <summary>The colour (颜色).</summary>
    public Color Color
    {
        get => edge.mesh.TryGetEdgeTrait(TraitNames.Color, out EdgeTrait<Color>? trait) ? trait[edge] : default;
        set => edge.mesh.GetOrAddEdgeTrait<Color>(TraitNames.Color, default, Blend.Linear)[edge] = value;
    }

    /// <summary>Selected if not 0 (选择标记).</summary>
    public int SelectedFlag
    {
        get => edge.mesh.TryGetEdgeTrait(TraitNames.SelectedFlag, out EdgeTrait<int>? trait) ? trait[edge] : 0;
        set => edge.mesh.GetOrAddEdgeTrait<int>(TraitNames.SelectedFlag, 0, Blend.Largest)[edge] = value;
    }
}

/// <summary>The textbook's class FaceTraits (面属性) as a view over columns.</summary>
/// <param name="face">The face.</param>
public sealed class FaceTraits(Face face)
{
    /// <summary>The normal (法向).</summary>
    public Vector3D Normal
    {
        get => face.mesh.TryGetFaceTrait(TraitNames.Normal, out FaceTrait<Vector3D>? trait) ? trait[face] : default;
        set => face.mesh.GetOrAddFaceTrait<Vector3D>(TraitNames.Normal, default, Blend.Direction)[face] = value;
    }

    /// <summary>The colour (颜色).</summary>
    public Color Color
    {
        get => face.mesh.TryGetFaceTrait(TraitNames.Color, out FaceTrait<Color>? trait) ? trait[face] : default;
        set => face.mesh.GetOrAddFaceTrait<Color>(TraitNames.Color, default, Blend.Linear)[face] = value;
    }

    /// <summary>Selected if not 0 (选择标记); also used as a label.</summary>
    public int SelectedFlag
    {
        get => face.mesh.TryGetFaceTrait(TraitNames.SelectedFlag, out FaceTrait<int>? trait) ? trait[face] : 0;
        set => face.mesh.GetOrAddFaceTrait<int>(TraitNames.SelectedFlag, 0, Blend.Nearest)[face] = value;
    }
}

/// <summary>The textbook's class MeshTraits (模型属性): computed from the positions when asked. O(V).</summary>
/// <param name="mesh">The mesh.</param>
public sealed class MeshTraits(Mesh mesh)
{
    /// <summary>The axis-parallel box (包围盒).</summary>
    public BoundingBox BoundingBox => mesh.BoundingBox;

    /// <summary>The sphere around the centre of the box that holds every vertex (包围球): centre and radius.</summary>
    public (Vector3D Center, double Radius) BoundingSphere
    {
        get
        {
            Vector3D center = mesh.BoundingBox.Center;
            double squared = 0;
            foreach (Vertex v in mesh.Vertices)
                squared = Math.Max(squared, (v.Position - center).LengthSquared);
            return (center, Math.Sqrt(squared));
        }
    }
}
