using MeshLab.Numerics;

namespace MeshLab.Generation;

/// <summary>Smooth noise: pseudo-random values at the integer points, blended by the quintic 6t⁵ − 15t⁴ + 10t³. Values in [−1, 1].</summary>
internal sealed class ValueNoise(int seed)
{
    public double At(Vector3D p)
    {
        long x = (long)Math.Floor(p.X), y = (long)Math.Floor(p.Y), z = (long)Math.Floor(p.Z);
        double u = Fade(p.X - x), v = Fade(p.Y - y), w = Fade(p.Z - z);
        return Mix(
            Mix(Mix(Corner(x, y, z), Corner(x + 1, y, z), u), Mix(Corner(x, y + 1, z), Corner(x + 1, y + 1, z), u), v),
            Mix(Mix(Corner(x, y, z + 1), Corner(x + 1, y, z + 1), u), Mix(Corner(x, y + 1, z + 1), Corner(x + 1, y + 1, z + 1), u), v),
            w);
    }

    /// <summary>The sum of octaves, each of twice the frequency and half the height of the one before.</summary>
    public double Fractal(Vector3D p, int octaves)
    {
        double sum = 0, height = 1;
        for (int octave = 0; octave < octaves; octave++)
        {
            sum += height * At(p);
            p *= 2;
            height /= 2;
        }
        return sum;
    }

    private double Corner(long x, long y, long z)
    {
        ulong h = (ulong)x * 0x9E3779B97F4A7C15 ^ (ulong)y * 0xC2B2AE3D27D4EB4F ^ (ulong)z * 0x165667B19E3779F9 ^ (ulong)(uint)seed * 0xD6E8FEB86659FD93;
        h ^= h >> 32;
        h *= 0xFF51AFD7ED558CCD;
        h ^= h >> 29;
        h *= 0xC4CEB9FE1A85EC53;
        h ^= h >> 32;
        return (h >> 11) * (2.0 / (1UL << 53)) - 1;
    }

    private static double Fade(double t) => t * t * t * (t * (6 * t - 15) + 10);

    private static double Mix(double a, double b, double t) => a + (b - a) * t;
}
