using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Spatial;
using MeshLab.Structure;

namespace MeshLab.Remeshing;

/// <summary>L4 各向同性重新网格化 (isotropic remeshing): triangles of nearly equal edges and angles on the same surface.</summary>
/// <remarks>
/// <para>
/// Each pass does four steps, after Botsch, Kobbelt 2004, <em>A remeshing approach to multiresolution modeling</em>, §4: split the edges longer
/// than 1.4 L, collapse those shorter than 0.7 L, flip towards valence 6 (4 on the boundary), move the vertices tangentially towards the middle of
/// their neighbours; then project them to the input's surface. L is 0.93 times the length asked for, so that asking for the input's
/// mean edge length gives about as many faces. Compared with the laboratory's four steps (<see cref="LaboratoryRemeshing"/>): a collapse that turns a face by
/// more than 18° is refused, which keeps thin tips; edges of medium length are collapsed too where valences get better; flips that tie are
/// decided by angles; and the result lies on the input.
/// </para>
/// <para>
/// Boundaries and features (dihedral angle above <see cref="RemeshingOptions.FeatureAngle"/>) stay: their vertices slide along them, their ends,
/// crossings and sharp turns never move. Topology does not change. The same bits on every number of threads.
/// O(n log n) per pass. Traits go along by place (<see cref="TraitTransfer"/>); isolated vertices do not.
/// </para>
/// </remarks>
public static class IsotropicRemeshing
{
    // Edges between 0.7 and 1.4 L are a little longer than L on average, and equal edges cover more than unequal ones: with this share the face
    // count is about that of an irregular mesh of the same mean edge length.
    private const double InnerLength = 0.93;

    // Walks that end farther away than this share of L are checked by the tree.
    private const double TrustedWalk = 0.1;

    // Area weights even out the areas; before the last passes they would only slow down the evening of valences.
    private const int PassesByArea = 2;

    // In long runs one first pass in so many weights by area too: on uneven triangles equal weights pull vertices off small details, and time enough is left
    // to even out the valences.
    private const int LongRun = 8;

    extension(Mesh mesh)
    {
        /// <summary>A new mesh of nearly equilateral triangles on the surface of this one.</summary>
        /// <param name="options">What to do; null for five passes at the mean edge length, without features.</param>
        /// <param name="progress">Told from 0 to 1 how far it is.</param>
        /// <param name="cancellationToken">Ends the work; this mesh is never changed.</param>
        /// <exception cref="ArgumentException">A face is not a triangle (it is named), or the result would have more faces than the budget.</exception>
        /// <exception cref="OperationCanceledException">The work was cancelled.</exception>
        public RemeshingResult RemeshIsotropically(
            RemeshingOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default) =>
            Remesh(mesh, options, progress, cancellationToken);
    }

    /// <summary>A new mesh of nearly equilateral triangles on the surface of another.</summary>
    /// <param name="mesh">The input; it is not changed.</param>
    /// <param name="options">What to do; null for five passes at the mean edge length, without features.</param>
    /// <param name="progress">Told from 0 to 1 how far it is.</param>
    /// <param name="cancellationToken">Ends the work.</param>
    /// <exception cref="ArgumentException">A face is not a triangle (it is named), or the result would have more faces than the budget.</exception>
    /// <exception cref="OperationCanceledException">The work was cancelled.</exception>
    public static RemeshingResult Remesh(
        Mesh mesh, RemeshingOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        options ??= new();
        mesh.RequireTriangles(nameof(mesh));
        Mesh input = mesh;
        if (!mesh.IsCompact)
        {
            input = mesh.Clone();
            input.Compact();
        }
        double asked = options.EdgeLength ?? options.RelativeLength * input.MeanEdgeLength;
        if (input.Faces.Count == 0 || !(asked > 0))
            return new(input.Clone(), RemeshingStop.NothingToDo, asked, 0, 0, 0, 0, 0, 0);

        if (RemeshingOptions.BeyondBudget(input, asked, options.FaceBudget) is { } beyond)
            throw new ArgumentException(beyond, nameof(options));
        Mesh model = input;
        var frame = UnitFrame.Of(model);
        input = frame.ToUnit(model);
        double length = options.EdgeLength is double given ? given / frame.Scale : options.RelativeLength * input.MeanEdgeLength;
        var surface = new RemeshSurface(input) { Trace = StepTrace.Into(options.Trace, frame.FromUnit) };
        FeatureLines lines = FeatureLines.Mark(input, surface, options.FeatureAngle, length);
        StartOnInput(surface, input);
        double[] sizes = SizingField.Of(input, options, length * InnerLength);
        sizes.CopyTo(surface.Size, 0);
        FeatureSharpness? sharpness = lines.FeatureEdges > 0 ? new FeatureSharpness(surface, options.FeatureAngle) : null;
        var lengths = new LengthSteps(surface, lines, sharpness);
        var flips = new ValenceFlips(surface, sharpness);
        SurfaceProjection? projection = options.Projection
            ? new SurfaceProjection(input, options.HighQuality ? 0 : TrustedWalk * length * InnerLength)
            : null;

        Vector3D[] places = [];
        for (int pass = 0; pass < options.Passes; pass++)
        {
            lengths.SplitLong();
            Next(0.25);
            lengths.CollapseShort();
            Next(0.5);
            flips.Run();
            Next(0.75);
            if (places.Length < surface.Positions.Length)
                places = new Vector3D[surface.Positions.Length];
            bool byArea = options.HighQuality || pass >= options.Passes - PassesByArea || pass < options.Passes / LongRun;
            Move(surface, places, byArea, projection, lines);
            sharpness?.TakeBackMoves(places);
            (surface.Positions, places) = (places, surface.Positions);
            surface.Trace?.Move("smooth", surface.Positions.AsSpan(0, surface.VertexSlots));
            if (options.CurvatureTolerance is not null)
                TakeSizes(surface, input, sizes);
            Next(1);

            void Next(double share)
            {
                cancellationToken.ThrowIfCancellationRequested();
                progress?.Report((pass + share) / options.Passes);
            }
        }
        Mesh result = surface.ToMesh((place, vertex) => frame.FromUnit(place, model, vertex));
        result.TakeTraitsFrom(model, cancellationToken);
        return new(result, RemeshingStop.PassesDone, asked, options.Passes, lengths.Splits, lengths.Collapses, flips.Flips, lines.FeatureEdges, lines.Corners);
    }

    // Smooth, then back to the surface or the line: reads the old positions, writes new ones.
    private static void Move(RemeshSurface surface, Vector3D[] places, bool byArea, SurfaceProjection? projection, FeatureLines lines) =>
        Parallelism.ForBlocks(surface.VertexSlots, (from, to) =>
        {
            TangentialSmoothing.Run(surface, places, from, to, byArea);
            if (projection is null)
                return;
            for (int v = from; v < to; v++)
            {
                if (!surface.IsLiveVertex(v) || surface.IsCorner[v])
                    continue;
                places[v] = surface.LineCount[v] != 0
                    ? lines.Slide(surface, v, places[v])
                    : projection.Project(places[v], ref surface.InputFace[v]);
            }
        });

    // Every vertex starts on one of its own faces.
    private static void StartOnInput(RemeshSurface surface, Mesh input)
    {
        ReadOnlySpan<int> target = input.Target, face = input.FaceOf;
        for (int h = target.Length - 1; h >= 0; h--)
        {
            if (face[h] >= 0)
                surface.InputFace[target[h]] = face[h];
        }
    }

    private static void TakeSizes(RemeshSurface surface, Mesh input, double[] sizes)
    {
        ReadOnlySpan<int> first = input.HalfEdgeOf, next = input.Next, target = input.Target;
        for (int v = 0; v < surface.VertexSlots; v++)
        {
            if (!surface.IsLiveVertex(v) || surface.LineCount[v] != 0)
                continue;
            int h = first[surface.InputFace[v]];
            surface.Size[v] = (sizes[target[h]] + sizes[target[next[h]]] + sizes[target[next[next[h]]]]) / 3;
        }
    }
}
