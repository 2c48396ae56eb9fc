namespace MeshLab.Structure;

/// <summary>Writes a step trace (步骤记录) of the operations on a mesh: one line of JSON each, as they are done, until it is disposed.</summary>
/// <remarks>
/// A line has the number of the step, the operation, what it was called on, what it removed and created, where vertices went, and a hash of all lines so far:
/// <code>{"step":3,"operation":"edgeCollapse","element":12,"removed":["v4","e12","e9","f7"],"created":[],"moved":[[5,0.5,0,0.25]],"hash":"…"}</code>
/// </remarks>
public sealed class OperationTrace : IOperationListener, IDisposable
{
    private readonly Mesh mesh;
    private readonly IOperationListener? outer;
    private readonly StepTrace trace;

    private OperationTrace(Mesh mesh, StepTrace trace)
    {
        this.mesh = mesh;
        this.trace = trace;
        outer = mesh.Listener;
        mesh.Listener = this;
    }

    /// <summary>Starts to write.</summary>
    /// <param name="mesh">The mesh to listen to; a listener that is there already goes on hearing.</param>
    /// <param name="writer">Where the lines go.</param>
    public static OperationTrace Start(Mesh mesh, TextWriter writer)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        ArgumentNullException.ThrowIfNull(writer);
        return new(mesh, StepTrace.Into(writer)!);
    }

    /// <summary>Goes on with a trace, if there is one.</summary>
    internal static OperationTrace? Of(Mesh mesh, StepTrace? trace) => trace is null ? null : new(mesh, trace);

    void IOperationListener.OnOperation(OperationRecord record)
    {
        trace.Operation(record);
        outer?.OnOperation(record);
    }

    /// <summary>Stops writing and gives the mesh back to the listener that was there before.</summary>
    public void Dispose()
    {
        if (ReferenceEquals(mesh.Listener, this))
            mesh.Listener = outer;
    }
}
