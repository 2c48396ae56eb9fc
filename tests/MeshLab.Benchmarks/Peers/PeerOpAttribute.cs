namespace MeshLab.Benchmarks.Peers;

/// <summary>Marks a static method <c>void Name(PeerRun run)</c> that measures one operation.</summary>
/// <param name="name">The operation's name, the same for every library.</param>
[AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
internal sealed class PeerOpAttribute(string name) : Attribute
{
    public string Name { get; } = name;

    /// <summary>Whether the operation runs without being asked for by name.</summary>
    public bool OnRequestOnly { get; init; }
}
