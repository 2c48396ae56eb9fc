using System.Globalization;
using MeshLab.Numerics;

namespace MeshLab.Simplification;

/// <summary>Writes one line of JSON per step: NDJSON.</summary>
internal sealed class TraceLog : CollapseLog
{
    private readonly TextWriter writer;
    private readonly bool areaWeights;
    private int step;
    private ulong hash = 14695981039346656037;

    private TraceLog(TextWriter writer, bool areaWeights)
    {
        this.writer = writer;
        this.areaWeights = areaWeights;
    }

    /// <summary>A log; <see langword="null"/> if there is nowhere to write.</summary>
    /// <param name="writer">Where to write.</param>
    /// <param name="areaWeights">Whether a working mesh's costs are squared distances times areas, rather than squared distances.</param>
    public static TraceLog? For(TextWriter? writer, bool areaWeights = false) => writer is null ? null : new TraceLog(writer, areaWeights);

    public override void BeforeCollapse(WorkingMesh mesh, int h, Vector3D position, Merges merges)
    {
        double square = mesh.Scale * mesh.Scale;
        Write(h >> 1, mesh.Rows[h].Target, mesh.Rows[h ^ 1].Target, mesh.Keys[h >> 1] * square * (areaWeights ? square : 1), mesh.Restored(position));
    }

    /// <summary>Writes the line of a contraction.</summary>
    /// <param name="edge">The contracted edge.</param>
    /// <param name="kept">The vertex that stays.</param>
    /// <param name="removed">The vertex that goes.</param>
    /// <param name="cost">The cost, in model units.</param>
    /// <param name="position">Where the kept vertex goes.</param>
    public void Write(int edge, int kept, int removed, double cost, Vector3D position)
    {
        Mix((ulong)(uint)edge);
        Mix((ulong)(uint)kept << 32 | (uint)removed);
        WriteLine(string.Create(
            CultureInfo.InvariantCulture, $"\"operation\":\"collapse\",\"edge\":{edge},\"kept\":{kept},\"removed\":{removed},\"cost\":{cost:R}"), position);
    }

    /// <summary>Writes the line of a cell whose vertices become one.</summary>
    /// <param name="cell">The number of the cell.</param>
    /// <param name="vertices">How many vertices lie in it.</param>
    /// <param name="position">Where their vertex lies.</param>
    public void WriteCell(int cell, int vertices, Vector3D position)
    {
        Mix((ulong)(uint)cell << 32 | (uint)vertices);
        WriteLine(string.Create(CultureInfo.InvariantCulture, $"\"operation\":\"cluster\",\"cell\":{cell},\"vertices\":{vertices}"), position);
    }

    private void WriteLine(string what, Vector3D position)
    {
        Mix(BitConverter.DoubleToUInt64Bits(position.X));
        Mix(BitConverter.DoubleToUInt64Bits(position.Y));
        Mix(BitConverter.DoubleToUInt64Bits(position.Z));
        writer.Write(string.Create(
            CultureInfo.InvariantCulture,
            $"{{\"step\":{step},{what},\"position\":[{position.X:R},{position.Y:R},{position.Z:R}],\"hash\":\"{hash:x16}\"}}\n"));
        step++;
    }

    /// <summary>FNV-1a over words: the hash of a line depends on all lines before it.</summary>
    private void Mix(ulong word) => hash = (hash ^ word) * 1099511628211;
}
