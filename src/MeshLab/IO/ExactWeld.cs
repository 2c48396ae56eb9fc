using System.Numerics;
using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>Joins points of exactly equal coordinates (0 and −0 are equal). No distance is involved, so the result depends on nothing but the points.</summary>
internal static class ExactWeld
{
    /// <summary>The different points in order of their first appearance.</summary>
    /// <param name="points">The points.</param>
    /// <param name="indices">Receives for each point the index of the one that stands for it.</param>
    public static Vector3D[] Weld(ReadOnlySpan<Vector3D> points, Span<int> indices)
    {
        int[] table = new int[(int)BitOperations.RoundUpToPowerOf2((uint)points.Length * 2 + 2)];
        int mask = table.Length - 1, count = 0;
        GrowingArray<Vector3D> distinct = new(points.Length / 5);
        for (int i = 0; i < points.Length; i++)
        {
            // Adding 0 turns −0 into 0, so that equal numbers have equal bits.
            Vector3D key = new(points[i].X + 0.0, points[i].Y + 0.0, points[i].Z + 0.0);
            int slot = (int)(Hash(key) & (uint)mask);
            while (table[slot] != 0 && distinct[table[slot] - 1] != key)
                slot = (slot + 1) & mask;
            if (table[slot] == 0)
            {
                distinct.Add(points[i]);
                table[slot] = ++count;
            }

            indices[i] = table[slot] - 1;
        }

        return distinct.ToArray();
    }

    private static uint Hash(Vector3D point)
    {
        ulong h = BitConverter.DoubleToUInt64Bits(point.X) * 0x9E3779B97F4A7C15;
        h = (BitOperations.RotateLeft(h, 29) ^ BitConverter.DoubleToUInt64Bits(point.Y)) * 0xBF58476D1CE4E5B9;
        h = (BitOperations.RotateLeft(h, 29) ^ BitConverter.DoubleToUInt64Bits(point.Z)) * 0x94D049BB133111EB;
        return (uint)(h >> 32);
    }
}
