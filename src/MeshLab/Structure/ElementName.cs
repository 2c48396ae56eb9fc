using System.Diagnostics.CodeAnalysis;
using System.Runtime.CompilerServices;
using System.Globalization;

namespace MeshLab.Structure;

/// <summary>How elements are named in messages, reports and traces: <c>v12 h3 e4 f5</c>.</summary>
public static class ElementName
{
    /// <summary><c>v12</c>.</summary>
    public static string Vertex(int index) => string.Create(CultureInfo.InvariantCulture, $"v{index}");

    /// <summary><c>h3</c>.</summary>
    public static string HalfEdge(int index) => string.Create(CultureInfo.InvariantCulture, $"h{index}");

    /// <summary><c>e4</c>.</summary>
    public static string Edge(int index) => string.Create(CultureInfo.InvariantCulture, $"e{index}");

    /// <summary><c>f5</c>.</summary>
    public static string Face(int index) => string.Create(CultureInfo.InvariantCulture, $"f{index}");
}

/// <summary>The error for a handle that is none or of a deleted element, kept out of the hot paths.</summary>
internal static class DeadElement
{
    // One statement that throws: that is how the compiler sees that callers need not keep anything for afterwards.
    [DoesNotReturn]
    public static void Throw<THandle>(THandle handle)
        where THandle : struct => throw Error(handle);

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static ArgumentException Error<THandle>(THandle handle)
        where THandle : struct
    {
        string name = handle.ToString()!;
        return new ArgumentException(name == "none" ? "The handle is none: it stands for no element." : $"{name} is deleted.");
    }
}
