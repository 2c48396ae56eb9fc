using System.Numerics;

namespace MeshLab.Tests;

/// <summary>The generator PCG64 (O'Neill 2014, XSL-RR 128/64) with the seeding that the reference values were sampled by.</summary>
internal sealed class PermutedCongruential
{
    private static readonly UInt128 Multiplier = new(0x2360ED051FC65DA4, 0x4385DF649FCCF645);

    private readonly UInt128 increment;
    private UInt128 state;

    public PermutedCongruential(uint seed)
    {
        uint[] words = Spread(seed);
        ulong Word(int i) => words[2 * i] | ((ulong)words[2 * i + 1] << 32);
        increment = (new UInt128(Word(2), Word(3)) << 1) | 1;
        state = increment + new UInt128(Word(0), Word(1));
        state = state * Multiplier + increment;
    }

    /// <summary>Numbers in [0, 1).</summary>
    public double[] NextDoubles(int count)
    {
        var numbers = new double[count];
        for (int i = 0; i < count; i++)
            numbers[i] = NextDouble();
        return numbers;
    }

    private double NextDouble()
    {
        state = state * Multiplier + increment;
        ulong high = (ulong)(state >> 64), mixed = BitOperations.RotateRight(high ^ (ulong)state, (int)(high >> 58));
        return (mixed >> 11) * (1.0 / (1UL << 53));
    }

    /// <summary>Makes eight well-mixed words of a seed.</summary>
    private static uint[] Spread(uint seed)
    {
        uint constant = 0x43B0D7E5;
        var pool = new uint[4];
        for (int i = 0; i < 4; i++)
            pool[i] = Hash(i == 0 ? seed : 0, 0x931E8875, ref constant);
        for (int from = 0; from < 4; from++)
        {
            for (int to = 0; to < 4; to++)
            {
                if (from == to)
                    continue;
                uint mixed = 0xCA01F9DD * pool[to] - 0x4973F715 * Hash(pool[from], 0x931E8875, ref constant);
                pool[to] = mixed ^ (mixed >> 16);
            }
        }
        constant = 0x8B51F9DD;
        var words = new uint[8];
        for (int i = 0; i < 8; i++)
            words[i] = Hash(pool[i % 4], 0x58F38DED, ref constant);
        return words;
    }

    private static uint Hash(uint value, uint multiplier, ref uint constant)
    {
        value ^= constant;
        constant *= multiplier;
        value *= constant;
        return value ^ (value >> 16);
    }
}
