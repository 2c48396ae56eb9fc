using System.Globalization;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace MeshLab.IO;

/// <summary>Reads decimal numbers from UTF-8 text: always the double nearest to what is written, as <see cref="double.Parse(string)"/> finds it, but several times faster.</summary>
/// <remarks>
/// The digits are gathered in a 64-bit integer w, the exponent in q, so that the number is w·10^q. Then the first way that is certain to be exact:
/// <list type="number">
/// <item>w ≤ 2⁵³ and |q| ≤ 22: both w and 10^|q| are doubles, so one multiplication or division rounds once (Clinger 1990);</item>
/// <item>w times the 128-bit power of five of the table, unless the product lies too near a tie to tell (Lemire 2021, "Number parsing at a gigabyte per second", algorithm 1);</item>
/// <item>more than 19 digits, far exponents and doubtful ties: the runtime's own parser.</item>
/// </list>
/// The words <c>nan</c> and <c>inf</c>, which the runtime would take, are not numbers here.
/// </remarks>
internal static class DecimalParser
{
    private const int MinPower = -64, MaxPower = 64;

    private static readonly double[] PowersOfTen =
    [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
    ];

    private static readonly UInt128[] PowersOfFive = MakePowersOfFive();

    /// <summary>Reads the number at the start of the text.</summary>
    /// <param name="text">The text; it may go on after the number.</param>
    /// <param name="value">The number; infinite if it is larger than any double.</param>
    /// <param name="length">How many bytes it takes.</param>
    /// <returns>False if no number stands there, or if something other than white space, a backslash or the end follows it.</returns>
    public static bool TryParse(ReadOnlySpan<byte> text, out double value, out int length)
    {
        int i = 0;
        bool negative = false;
        if (text.Length > 0 && text[0] is (byte)'-' or (byte)'+')
        {
            negative = text[0] == '-';
            i = 1;
        }

        ulong w = 0;
        int start = i;
        while ((uint)i < (uint)text.Length && (uint)(text[i] - '0') <= 9)
            w = w * 10 + (uint)(text[i++] - '0');
        int digits = i - start, q = 0;

        if ((uint)i < (uint)text.Length && text[i] == '.')
        {
            int point = ++i;
            while ((uint)i < (uint)text.Length && (uint)(text[i] - '0') <= 9)
                w = w * 10 + (uint)(text[i++] - '0');
            q = point - i;
            digits += i - point;
        }

        value = 0;
        length = i;
        if (digits == 0)
            return false;
        if ((uint)i < (uint)text.Length && (text[i] | 0x20) == 'e')
        {
            if (!TryParseExponent(text, ref i, ref q))
                return false;
            length = i;
        }

        if ((uint)i < (uint)text.Length && text[i] > ' ' && text[i] != '\\')
            return false;
        // More digits may have overflowed w; leading zeros count here too, which only costs time.
        if (digits > 19 || !TryScale(w, q, out value))
            return TryParseSlowly(text[..i], out value);
        if (negative)
            value = -value;
        return true;
    }

    private static bool TryParseExponent(ReadOnlySpan<byte> text, ref int i, ref int q)
    {
        int j = i + 1;
        bool negative = false;
        if (j < text.Length && text[j] is (byte)'-' or (byte)'+')
            negative = text[j++] == '-';
        int start = j, exponent = 0;
        for (; j < text.Length && (uint)(text[j] - '0') <= 9; j++)
        {
            if (exponent < 100_000)
                exponent = exponent * 10 + (text[j] - '0');
        }

        q += negative ? -exponent : exponent;
        i = j;
        return j > start;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool TryScale(ulong w, int q, out double value)
    {
        if (w <= 1UL << 53 && q is >= -22 and <= 22)
        {
            value = (long)w;
            value = q < 0 ? value / PowersOfTen[-q] : value * PowersOfTen[q];
            return true;
        }

        return TryScaleByTable(w, q, out value);
    }

    /// <summary>w·10^q = w·5^q·2^q with 5^q from the table; false where the rounding is in doubt or the result is not a normal number.</summary>
    private static bool TryScaleByTable(ulong w, int q, out double value)
    {
        value = 0;
        if (w == 0)
            return true;
        if (q is < MinPower or > MaxPower)
            return false;

        int leadingZeros = BitOperations.LeadingZeroCount(w);
        w <<= leadingZeros;
        UInt128 power = PowersOfFive[q - MinPower];
        ulong high = Math.BigMul(w, (ulong)(power >> 64), out ulong low);
        if ((high & 0x1FF) == 0x1FF)
        {
            // The 55 bits that count end in ones: the lower half of the power may still carry into them.
            ulong carry = Math.BigMul(w, (ulong)power, out _);
            low += carry;
            if (low < carry)
                high++;
        }

        if (low == ulong.MaxValue && q is < -27 or > 55)
            return false;

        int upperBit = (int)(high >> 63);
        int shift = upperBit + 64 - 52 - 3;
        ulong mantissa = high >> shift;
        int exponent = (int)(((152170L + 65536) * q) >> 16) + 63 + upperBit - leadingZeros + 1023;
        if (exponent <= 0)
            return false;
        if (low <= 1 && q is >= -4 and <= 23 && (mantissa & 3) == 1 && mantissa << shift == high)
            mantissa &= ~1UL; // exactly between two doubles: to the even one
        mantissa += mantissa & 1;
        mantissa >>= 1;
        if (mantissa >= 2UL << 52)
        {
            mantissa = 1UL << 52;
            exponent++;
        }

        if (exponent >= 0x7FF)
            return false;
        value = BitConverter.UInt64BitsToDouble((mantissa & ~(1UL << 52)) | ((ulong)exponent << 52));
        return true;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static bool TryParseSlowly(ReadOnlySpan<byte> number, out double value) =>
        double.TryParse(number, NumberStyles.Float, CultureInfo.InvariantCulture, out value);

    /// <summary>5^q for every q of the table, scaled by a power of two into [2¹²⁷, 2¹²⁸) and cut off; down to 5⁻²⁷ the reciprocals are rounded up (as the proof asks).</summary>
    private static UInt128[] MakePowersOfFive()
    {
        UInt128[] table = new UInt128[MaxPower - MinPower + 1];
        for (int q = MinPower; q <= MaxPower; q++)
        {
            BigInteger power = BigInteger.Pow(5, Math.Abs(q));
            int bits = (int)power.GetBitLength();
            if (q < -27)
                power = (BigInteger.One << (2 * bits + 128)) / power + 1;
            else if (q < 0)
                power = (BigInteger.One << (bits + 127)) / power + 1;
            else
                power <<= Math.Max(0, 128 - bits);
            table[q - MinPower] = (UInt128)(power >> (int)(power.GetBitLength() - 128));
        }

        return table;
    }
}
