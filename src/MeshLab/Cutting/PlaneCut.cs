using MeshLab.Structure;

namespace MeshLab.Cutting;

/// <summary>A side of a plane.</summary>
public enum PlaneSide
{
    /// <summary>Where the normal points.</summary>
    Above,

    /// <summary>The other side.</summary>
    Below,
}

/// <summary>How a mesh is cut by a plane.</summary>
public sealed record PlaneCutOptions
{
    /// <summary>Vertices within this distance of the plane count as on it, in model units; nothing moves.</summary>
    public double Tolerance
    {
        get;
        init => field = value >= 0 && double.IsFinite(value) ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "The tolerance must be finite and not negative.");
    }

    /// <summary>Whether the cut is closed by flat caps (封盖); closed meshes then stay closed.</summary>
    public bool Cap { get; init; }
}

/// <summary>One side of a mesh cut by a plane.</summary>
/// <param name="Part">The mesh and its maps. Cut points follow the old vertices; faces of caps follow all others and have the source −1.</param>
/// <param name="CapFaces">The number of faces in caps.</param>
/// <param name="CapLoops">The number of outlines and holes that were capped.</param>
/// <param name="FannedLoops">Of these, how many cross themselves, because the mesh does, and were capped by a fan around a new vertex.</param>
/// <param name="OpenChains">Lines of the cut that end at the mesh's own boundary; they cannot be capped.</param>
public sealed record PlaneCutResult(MeshPart Part, int CapFaces, int CapLoops, int FannedLoops, int OpenChains);

/// <summary>§6.2 沿平面切割: cuts a triangle mesh by a plane, and closes the cut with flat caps if wanted.</summary>
/// <remarks>
/// <code>
///        a                    a
///      ╱   ╲                ╱ | ╲          a face with one vertex on the side kept leaves a triangle,
///   ─ p ─── q ─   ⟶       p ─── q          one with two a quadrilateral, cut along its shorter diagonal
///    ╱       ╲
///   b ─────── c
/// </code>
/// Vertices on the plane are outside of both halves for the tests, and the cut runs through them as they are; where a half touches the plane in a vertex
/// or an edge alone, each fan gets its own copy, so that the result is a manifold. Faces in the plane: without caps they belong to the part above; with caps the caps
/// take their place in both halves. Caps follow the direction of the cut's lines: outlines run counter-clockwise around the solid and holes clockwise, so holes
/// within outlines, and several of each, need no further rule. O(V + F), plus the triangulation of the caps. The mesh given is not changed.
/// </remarks>
public static class PlaneCut
{
    extension(Mesh mesh)
    {
        /// <summary>Keeps one side.</summary>
        /// <param name="plane">The plane.</param>
        /// <param name="side">Which side stays.</param>
        /// <param name="options">Tolerance and caps.</param>
        /// <exception cref="ArgumentException">A face is not a triangle, or the plane has no normal.</exception>
        public PlaneCutResult Clip(CuttingPlane plane, PlaneSide side, PlaneCutOptions? options = null)
        {
            options ??= new();
            PlaneCrossings.Check(mesh, plane, options.Tolerance);
            double[] distance = PlaneCrossings.Distances(mesh, plane, options.Tolerance);
            return new PlaneCutter(mesh, plane, distance, side).Cut(options.Cap);
        }

        /// <summary>Keeps both sides, as two meshes.</summary>
        /// <inheritdoc cref="Clip"/>
        public (PlaneCutResult Above, PlaneCutResult Below) Split(CuttingPlane plane, PlaneCutOptions? options = null)
        {
            options ??= new();
            PlaneCrossings.Check(mesh, plane, options.Tolerance);
            double[] distance = PlaneCrossings.Distances(mesh, plane, options.Tolerance);
            return (new PlaneCutter(mesh, plane, distance, PlaneSide.Above).Cut(options.Cap),
                new PlaneCutter(mesh, plane, distance, PlaneSide.Below).Cut(options.Cap));
        }
    }
}
