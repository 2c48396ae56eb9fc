using System.Globalization;
using MeshLab.Numerics;

namespace MeshLab.Simplification;

/// <summary>Writes one line of JSON per contraction: NDJSON.</summary>
internal sealed class TraceLog : CollapseLog
{
    private readonly TextWriter writer;
    private int step;
    private ulong hash = 14695981039346656037;

    private TraceLog(TextWriter writer) => this.writer = writer;

    public static TraceLog? For(TextWriter? writer) => writer is null ? null : new TraceLog(writer);

    public override void BeforeCollapse(WorkingMesh mesh, int h, Vector3D position, Merges merges) =>
        Write(h >> 1, mesh.Rows[h].Target, mesh.Rows[h ^ 1].Target, mesh.Keys[h >> 1] * mesh.Scale * mesh.Scale, mesh.Restored(position));

    /// <summary>Writes a line.</summary>
    /// <param name="edge">The contracted edge.</param>
    /// <param name="kept">The vertex that stays.</param>
    /// <param name="removed">The vertex that goes.</param>
    /// <param name="cost">The cost, in model units.</param>
    /// <param name="position">Where the kept vertex goes.</param>
    public void Write(int edge, int kept, int removed, double cost, Vector3D position)
    {
        Mix((ulong)(uint)edge);
        Mix((ulong)(uint)kept << 32 | (uint)removed);
        Mix(BitConverter.DoubleToUInt64Bits(position.X));
        Mix(BitConverter.DoubleToUInt64Bits(position.Y));
        Mix(BitConverter.DoubleToUInt64Bits(position.Z));
        writer.Write(string.Create(
            CultureInfo.InvariantCulture,
            $"{{\"step\":{step},\"operation\":\"collapse\",\"edge\":{edge},\"kept\":{kept},\"removed\":{removed},\"cost\":{cost:R},\"position\":[{position.X:R},{position.Y:R},{position.Z:R}],\"hash\":\"{hash:x16}\"}}\n"));
        step++;
    }

    /// <summary>FNV-1a over words: the hash of a line depends on all lines before it.</summary>
    private void Mix(ulong word) => hash = (hash ^ word) * 1099511628211;
}
