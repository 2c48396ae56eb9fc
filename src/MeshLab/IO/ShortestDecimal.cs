using System.Buffers.Binary;
using System.Globalization;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace MeshLab.IO;

/// <summary>Writes doubles as the shortest decimal text that reads back as the same double: the runtime's digits in a fraction of its time, and right for the few powers of two that it gets wrong.</summary>
/// <remarks>
/// A double is c·2^q. All numbers that round to it lie between (4c − 2)·2^(q−2) and (4c + 2)·2^(q−2). Scaled by 10^−k, with k such that the interval is between 1 and
/// 10 wide, the integers in it are the candidates: first multiples of ten, then the others; of two, the nearer. The three products are taken with a
/// 128-bit power of ten and rounded to odd, which is enough to compare them exactly. Giulietti 2020, "The Schubfach way to render doubles", figure 4.
/// Far exponents go to the runtime.
/// </remarks>
internal static class ShortestDecimal
{
    private const int MinPower = -64, MaxPower = 64;
    private const int MantissaBits = 52, ExponentBias = 1075;

    private static readonly UInt128[] PowersOfTen = MakePowersOfTen();

    /// <summary>Writes the number.</summary>
    /// <param name="value">The number.</param>
    /// <param name="destination">At least 32 bytes.</param>
    /// <returns>The number of bytes written.</returns>
    public static int Format(double value, Span<byte> destination)
    {
        ulong bits = BitConverter.DoubleToUInt64Bits(value);
        if (!TryFindDigits(bits & ~(1UL << 63), out ulong digits, out int exponent))
        {
            return FormatByRuntime(value, destination);
        }

        int sign = (int)(bits >> 63);
        if (sign != 0)
            destination[0] = (byte)'-';
        return sign + Write(digits, exponent, destination[sign..]);
    }

    /// <summary>Writes an integer.</summary>
    /// <param name="value">The number.</param>
    /// <param name="destination">At least 11 bytes.</param>
    /// <returns>The number of bytes written.</returns>
    public static int Format(int value, Span<byte> destination)
    {
        int sign = value < 0 ? 1 : 0;
        if (sign != 0)
            destination[0] = (byte)'-';
        ulong magnitude = (ulong)Math.Abs((long)value);
        int count = CountDigits(magnitude);
        WriteDigits(magnitude, destination.Slice(sign, count));
        return sign + count;
    }

    private static int FormatByRuntime(double value, Span<byte> destination)
    {
        value.TryFormat(destination, out int length, default, CultureInfo.InvariantCulture);
        // The runtime's shortest text of a few powers of two (2⁻²⁵ is one) reads back as their neighbour; 17 digits never do.
        double again = double.Parse(destination[..length], NumberStyles.Float, CultureInfo.InvariantCulture);
        if (BitConverter.DoubleToInt64Bits(again) != BitConverter.DoubleToInt64Bits(value) && double.IsFinite(value))
            value.TryFormat(destination, out length, "E16", CultureInfo.InvariantCulture);
        return length;
    }

    /// <summary>The shortest digits·10^exponent, without zeros at the end.</summary>
    private static bool TryFindDigits(ulong bits, out ulong digits, out int exponent)
    {
        ulong fraction = bits & ((1UL << MantissaBits) - 1);
        int biased = (int)(bits >> MantissaBits), q = biased - ExponentBias;
        ulong c = fraction | (1UL << MantissaBits);
        digits = 0;
        exponent = 0;
        if (biased is 0 or 0x7FF)
            return bits == 0;
        if (q is <= 0 and > -53 && (c & ((1UL << -q) - 1)) == 0)
        {
            digits = c >> -q; // an integer
            StripZeros(ref digits, ref exponent);
            return true;
        }

        // At a power of two the numbers below lie twice as close.
        bool isCloserBelow = fraction == 0 && biased > 1;
        int k = (q * 1262611 - (isCloserBelow ? 524031 : 0)) >> 22;
        if (-k is < MinPower or > MaxPower)
            return false;
        int shift = q + ((-k * 1741647) >> 19) + 1;
        UInt128 power = PowersOfTen[-k - MinPower];
        ulong outside = c & 1; // the ends of the interval round to even numbers only
        ulong lower = MultiplyToOdd(power, (4 * c - 2 + (isCloserBelow ? 1UL : 0)) << shift) + outside;
        ulong middle = MultiplyToOdd(power, (4 * c) << shift);
        ulong upper = MultiplyToOdd(power, (4 * c + 2) << shift) - outside;

        ulong s = middle / 4, tens = s / 10;
        bool isTenBelowInside = lower <= 40 * tens, isTenAboveInside = 40 * tens + 40 <= upper;
        if (s >= 10 && isTenBelowInside != isTenAboveInside)
        {
            digits = tens + (isTenAboveInside ? 1UL : 0);
            exponent = k + 1;
            StripZeros(ref digits, ref exponent);
            return true;
        }

        bool isBelowInside = lower <= 4 * s, isAboveInside = 4 * s + 4 <= upper;
        bool isNearerAbove = middle > 4 * s + 2 || (middle == 4 * s + 2 && (s & 1) != 0);
        digits = s + (isBelowInside != isAboveInside ? (isAboveInside ? 1UL : 0) : (isNearerAbove ? 1UL : 0));
        exponent = k;
        StripZeros(ref digits, ref exponent);
        return true;
    }

    /// <summary>The upper 64 of 192 bits of the product; the last one is set if anything below it is.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static ulong MultiplyToOdd(UInt128 power, ulong factor)
    {
        ulong carry = Math.BigMul((ulong)power, factor, out _);
        ulong high = Math.BigMul((ulong)(power >> 64), factor, out ulong low);
        low += carry;
        if (low < carry)
            high++;
        return high | (low > 1 ? 1UL : 0);
    }

    private static void StripZeros(ref ulong digits, ref int exponent)
    {
        if (digits == 0)
            return;
        while (digits % 100_000_000 == 0)
        {
            digits /= 100_000_000;
            exponent += 8;
        }

        while (digits % 10 == 0)
        {
            digits /= 10;
            exponent++;
        }
    }

    private static int Write(ulong digits, int exponent, Span<byte> destination)
    {
        int count = CountDigits(digits), point = count + exponent;
        if (point < -3 || point > Math.Max(count, 15))
            return WriteScientific(digits, count, point - 1, destination);
        if (point <= 0)
        {
            destination[..(2 - point)].Fill((byte)'0');
            destination[1] = (byte)'.';
            WriteDigits(digits, destination.Slice(2 - point, count));
            return 2 - point + count;
        }

        if (exponent >= 0)
        {
            WriteDigits(digits, destination[..count]);
            destination.Slice(count, exponent).Fill((byte)'0');
            return point;
        }

        WriteDigits(digits, destination.Slice(1, count));
        destination.Slice(1, point).CopyTo(destination);
        destination[point] = (byte)'.';
        return count + 1;
    }

    private static int WriteScientific(ulong digits, int count, int power, Span<byte> destination)
    {
        int length = count == 1 ? 1 : count + 1;
        WriteDigits(digits, destination.Slice(length - count, count));
        if (count > 1)
        {
            destination[0] = destination[1];
            destination[1] = (byte)'.';
        }

        destination[length++] = (byte)'E';
        destination[length++] = power < 0 ? (byte)'-' : (byte)'+';
        int magnitude = Math.Abs(power), places = magnitude < 100 ? 2 : 3;
        WriteDigits((ulong)magnitude, destination.Slice(length, places));
        return length + places;
    }

    /// <summary>log₁₀ from log₂: right or one too large, as a comparison with the power of ten tells.</summary>
    private static int CountDigits(ulong digits)
    {
        int guess = ((BitOperations.Log2(digits | 1) + 1) * 1233) >> 12;
        return guess + (digits >= SmallPowersOfTen[guess] ? 1 : 0) + (digits == 0 ? 1 : 0);
    }

    private static ReadOnlySpan<ulong> SmallPowersOfTen =>
    [
        1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000, 1_000_000_000, 10_000_000_000, 100_000_000_000, 1_000_000_000_000, 10_000_000_000_000,
        100_000_000_000_000, 1_000_000_000_000_000, 10_000_000_000_000_000, 100_000_000_000_000_000, 1_000_000_000_000_000_000, 10_000_000_000_000_000_000,
    ];

    private static void WriteDigits(ulong digits, Span<byte> destination)
    {
        int i = destination.Length;
        while (i > 8)
        {
            ulong rest = digits / 100_000_000;
            i -= 8;
            BinaryPrimitives.WriteUInt64LittleEndian(destination[i..], EightDigits((uint)(digits - 100_000_000 * rest)));
            digits = rest;
        }

        ReadOnlySpan<byte> pairs =
            "0001020304050607080910111213141516171819202122232425262728293031323334353637383940414243444546474849"u8 +
            "5051525354555657585960616263646566676869707172737475767778798081828384858687888990919293949596979899"u8;
        uint head = (uint)digits;
        while (i >= 2)
        {
            uint rest = head / 100;
            int pair = 2 * (int)(head - 100 * rest);
            destination[--i] = pairs[pair + 1];
            destination[--i] = pairs[pair];
            head = rest;
        }

        if (i == 1)
            destination[0] = (byte)('0' + head);
    }

    /// <summary>Eight digits as text, the first one in the lowest byte. The number is halved into parts of four, two and one digits, all parts at once.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static ulong EightDigits(uint number)
    {
        // In every lane x/100 is x·10486 ≫ 20 for x < 10⁴, and x/10 is x·103 ≫ 10 for x < 100.
        ulong fours = number / 10_000 + ((ulong)(number % 10_000) << 32);
        ulong hundreds = ((fours * 10486) >> 20) & 0x0000007F_0000007F;
        ulong twos = hundreds + ((fours - 100 * hundreds) << 16);
        ulong tens = ((twos * 103) >> 10) & 0x000F000F_000F000F;
        return tens + ((twos - 10 * tens) << 8) + 0x30303030_30303030;
    }

    /// <summary>10^p scaled by a power of two into [2¹²⁷, 2¹²⁸) and rounded up.</summary>
    private static UInt128[] MakePowersOfTen()
    {
        UInt128[] table = new UInt128[MaxPower - MinPower + 1];
        for (int p = MinPower; p <= MaxPower; p++)
        {
            BigInteger power = BigInteger.Pow(10, Math.Abs(p));
            int scale = 127 - ((p * 1741647) >> 19);
            BigInteger numerator = p < 0 ? BigInteger.One << scale : scale >= 0 ? power << scale : power;
            BigInteger denominator = p < 0 ? power : scale >= 0 ? BigInteger.One : BigInteger.One << -scale;
            table[p - MinPower] = (UInt128)((numerator + denominator - 1) / denominator);
        }

        return table;
    }
}
