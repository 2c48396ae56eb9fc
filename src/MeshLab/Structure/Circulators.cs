using System.Collections;
using System.ComponentModel;
using System.Runtime.CompilerServices;

namespace MeshLab.Structure;

/// <summary>A way of turning: where a circulation starts and how it steps from half-edge to half-edge.</summary>
[EditorBrowsable(EditorBrowsableState.Never)]
public interface ITurn
{
    /// <summary>The half-edge to begin with, from the one that the element refers to; a negative number if there is none.</summary>
    static abstract int Start(Mesh mesh, int halfEdge);

    /// <summary>The column that a step reads.</summary>
    static abstract int[] Column(Mesh mesh);

    /// <summary>The half-edge after this one.</summary>
    static abstract int Step(int[] column, int halfEdge);
}

/// <summary>What a circulation shows of each half-edge.</summary>
/// <typeparam name="T">The kind of element shown.</typeparam>
[EditorBrowsable(EditorBrowsableState.Never)]
public interface IView<T>
{
    /// <summary>The column that the view reads.</summary>
    static abstract int[] Column(Mesh mesh);

    /// <summary>Whether the half-edge has something to show.</summary>
    static abstract bool Shows(int[] column, int halfEdge);

    /// <summary>The element shown.</summary>
    static abstract T Of(Mesh mesh, int[] column, int halfEdge);
}

/// <summary>Around a vertex counter-clockwise: h → h.Previous.Twin. At a boundary it starts with the first spoke after the hole.</summary>
public readonly struct CounterClockwise : ITurn
{
    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Start(Mesh mesh, int halfEdge) =>
        halfEdge >= 0 && mesh.face[halfEdge] < 0 ? mesh.previous[halfEdge] ^ 1 : halfEdge;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int[] Column(Mesh mesh) => mesh.previous;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Step(int[] column, int halfEdge) => column[halfEdge] ^ 1;
}

/// <summary>Around a vertex clockwise: h → h.Twin.Next. At a boundary it starts with the boundary half-edge.</summary>
public readonly struct Clockwise : ITurn
{
    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Start(Mesh mesh, int halfEdge) => halfEdge;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int[] Column(Mesh mesh) => mesh.next;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Step(int[] column, int halfEdge) => column[halfEdge ^ 1];
}

/// <summary>Around a face counter-clockwise: h → h.Next.</summary>
public readonly struct AroundFace : ITurn
{
    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Start(Mesh mesh, int halfEdge) => halfEdge;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int[] Column(Mesh mesh) => mesh.next;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Step(int[] column, int halfEdge) => column[halfEdge];
}

/// <summary>Around a face clockwise: h → h.Previous, beginning with the half-edge that ends at the first vertex.</summary>
public readonly struct AroundFaceClockwise : ITurn
{
    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Start(Mesh mesh, int halfEdge) => mesh.previous[halfEdge];

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int[] Column(Mesh mesh) => mesh.previous;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Step(int[] column, int halfEdge) => column[halfEdge];
}

/// <summary>Shows the half-edge itself.</summary>
public readonly struct SelfView : IView<HalfEdge>
{
    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int[] Column(Mesh mesh) => mesh.face;

    /// <inheritdoc/>
    public static bool Shows(int[] column, int halfEdge) => true;

    /// <inheritdoc/>
    public static HalfEdge Of(Mesh mesh, int[] column, int halfEdge) => new(mesh, halfEdge);
}

/// <summary>Shows the half-edge's twin.</summary>
public readonly struct TwinView : IView<HalfEdge>
{
    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int[] Column(Mesh mesh) => mesh.face;

    /// <inheritdoc/>
    public static bool Shows(int[] column, int halfEdge) => true;

    /// <inheritdoc/>
    public static HalfEdge Of(Mesh mesh, int[] column, int halfEdge) => new(mesh, halfEdge ^ 1);
}

/// <summary>Shows the vertex that the half-edge points to.</summary>
public readonly struct TargetView : IView<Vertex>
{
    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int[] Column(Mesh mesh) => mesh.target;

    /// <inheritdoc/>
    public static bool Shows(int[] column, int halfEdge) => true;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vertex Of(Mesh mesh, int[] column, int halfEdge) => new(mesh, column[halfEdge]);
}

/// <summary>Shows the vertex that the half-edge leaves.</summary>
public readonly struct SourceView : IView<Vertex>
{
    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int[] Column(Mesh mesh) => mesh.target;

    /// <inheritdoc/>
    public static bool Shows(int[] column, int halfEdge) => true;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vertex Of(Mesh mesh, int[] column, int halfEdge) => new(mesh, column[halfEdge ^ 1]);
}

/// <summary>Shows the edge.</summary>
public readonly struct EdgeView : IView<Edge>
{
    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int[] Column(Mesh mesh) => mesh.face;

    /// <inheritdoc/>
    public static bool Shows(int[] column, int halfEdge) => true;

    /// <inheritdoc/>
    public static Edge Of(Mesh mesh, int[] column, int halfEdge) => new(mesh, halfEdge >> 1);
}

/// <summary>Shows the face to the left; passes over boundary half-edges.</summary>
public readonly struct FaceView : IView<Face>
{
    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int[] Column(Mesh mesh) => mesh.face;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Shows(int[] column, int halfEdge) => column[halfEdge] >= 0;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Face Of(Mesh mesh, int[] column, int halfEdge) => new(mesh, column[halfEdge]);
}

/// <summary>Shows the face across the edge; passes over boundary edges.</summary>
public readonly struct AcrossView : IView<Face>
{
    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int[] Column(Mesh mesh) => mesh.face;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Shows(int[] column, int halfEdge) => column[halfEdge ^ 1] >= 0;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Face Of(Mesh mesh, int[] column, int halfEdge) => new(mesh, column[halfEdge ^ 1]);
}

/// <summary>The elements around a vertex or a face, one after the other, without allocation. Do not edit the mesh while walking.</summary>
/// <typeparam name="T">The kind of element.</typeparam>
/// <typeparam name="TTurn">The way of turning.</typeparam>
/// <typeparam name="TView">What is shown of each half-edge.</typeparam>
public readonly struct Circulation<T, TTurn, TView> : IEnumerable<T>
    where TTurn : struct, ITurn
    where TView : struct, IView<T>
{
    private readonly Mesh mesh;
    private readonly int start;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal Circulation(Mesh mesh, int halfEdge)
    {
        this.mesh = mesh;
        start = TTurn.Start(mesh, halfEdge);
    }

    private Circulation(int start, Mesh mesh)
    {
        this.mesh = mesh;
        this.start = start;
    }

    internal static Circulation<T, TTurn, TView> From(Mesh mesh, int halfEdge) => new(halfEdge, mesh);

    /// <summary>Starts the walk.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Enumerator GetEnumerator() => new(mesh, start);

    IEnumerator<T> IEnumerable<T>.GetEnumerator()
    {
        foreach (T element in this)
            yield return element;
    }

    IEnumerator IEnumerable.GetEnumerator() => ((IEnumerable<T>)this).GetEnumerator();

    /// <summary>The walk.</summary>
    /// <remarks>
    /// One comparison a step: the walk ends where <c>following</c> meets <c>stop</c>, and <c>stop</c> becomes the start with the first step only.
    /// An isolated vertex starts at −1, where it also stops. The columns are taken once, so they stay in registers.
    /// </remarks>
    public struct Enumerator
    {
        private readonly Mesh mesh;
        private readonly int[] steps;
        private readonly int[] shown;
        private readonly int start;
        private int stop;
        private int current;
        private int following;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        internal Enumerator(Mesh mesh, int start)
        {
            this.mesh = mesh;
            this.start = start;
            steps = TTurn.Column(mesh);
            shown = TView.Column(mesh);
            following = start;
            stop = -1;
        }

        /// <summary>The element.</summary>
        public readonly T Current
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get => TView.Of(mesh, shown, current);
        }

        /// <summary>Goes to the next element, if there is one.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public bool MoveNext()
        {
            do
            {
                int h = following;
                if (h == stop)
                    return false;
                stop = start;
                following = TTurn.Step(steps, h);
                current = h;
            }
            while (!TView.Shows(shown, current));
            return true;
        }
    }
}

/// <summary>Up to two elements, without allocation.</summary>
/// <typeparam name="T">The kind of element.</typeparam>
public readonly struct ElementPair<T> : IReadOnlyList<T>
{
    private readonly T first;
    private readonly T second;

    internal ElementPair(T first, T second, int count)
    {
        this.first = first;
        this.second = second;
        Count = count;
    }

    /// <summary>How many there are: 0, 1 or 2.</summary>
    public int Count { get; }

    /// <summary>The element at the place.</summary>
    public T this[int index] => (uint)index < (uint)Count
        ? index == 0 ? first : second
        : throw new ArgumentOutOfRangeException(nameof(index), index, "There are not so many elements.");

    /// <summary>Starts the walk.</summary>
    public Enumerator GetEnumerator() => new(this);

    IEnumerator<T> IEnumerable<T>.GetEnumerator()
    {
        for (int i = 0; i < Count; i++)
            yield return this[i];
    }

    IEnumerator IEnumerable.GetEnumerator() => ((IEnumerable<T>)this).GetEnumerator();

    /// <summary>The walk.</summary>
    public struct Enumerator
    {
        private readonly ElementPair<T> pair;
        private int place;

        internal Enumerator(ElementPair<T> pair)
        {
            this.pair = pair;
            place = -1;
        }

        /// <summary>The element.</summary>
        public readonly T Current => place == 0 ? pair.first : pair.second;

        /// <summary>Goes to the next element, if there is one.</summary>
        public bool MoveNext() => ++place < pair.Count;
    }
}

/// <summary>The edges that share a vertex with an edge, without allocation.</summary>
public readonly struct EdgeNeighbors : IEnumerable<Edge>
{
    private readonly Mesh mesh;
    private readonly int edge;

    internal EdgeNeighbors(Mesh mesh, int edge)
    {
        this.mesh = mesh;
        this.edge = edge;
    }

    /// <summary>Starts the walk.</summary>
    public Enumerator GetEnumerator() => new(mesh, edge);

    IEnumerator<Edge> IEnumerable<Edge>.GetEnumerator()
    {
        foreach (Edge e in this)
            yield return e;
    }

    IEnumerator IEnumerable.GetEnumerator() => ((IEnumerable<Edge>)this).GetEnumerator();

    /// <summary>The walk.</summary>
    public struct Enumerator
    {
        private readonly Mesh mesh;
        private int spoke;
        private int current;

        internal Enumerator(Mesh mesh, int edge)
        {
            this.mesh = mesh;
            // Half-edge 2e leaves Vertex0, 2e + 1 leaves Vertex1.
            spoke = current = 2 * edge;
        }

        /// <summary>The edge.</summary>
        public readonly Edge Current => new(mesh, current >> 1);

        /// <summary>Goes to the next edge, if there is one.</summary>
        public bool MoveNext()
        {
            current = mesh.previous[current] ^ 1;
            if (current != spoke)
                return true;
            if ((spoke & 1) != 0)
                return false;
            spoke++;
            current = mesh.previous[spoke] ^ 1;
            return current != spoke;
        }
    }
}
