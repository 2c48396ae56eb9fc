using MeshLab.Numerics;

namespace MeshLab.Curvature;

/// <summary>A height z = c + X·x + Y·y + ½XX·x² + XY·xy + ½YY·y² fitted to points by least squares.</summary>
/// <param name="X">∂z/∂x at the origin.</param>
/// <param name="Y">∂z/∂y.</param>
/// <param name="XX">∂²z/∂x².</param>
/// <param name="XY">∂²z/∂x∂y.</param>
/// <param name="YY">∂²z/∂y².</param>
internal readonly record struct QuadricFit(double X, double Y, double XX, double XY, double YY)
{
    /// <summary>The number of unknowns, and so of points that are needed.</summary>
    public const int Unknowns = 6;

    /// <summary>Fits the points around a center in the frame (x, y, normal). False if they do not determine a quadric.</summary>
    public static bool TryFit(Vector3D[] positions, ReadOnlySpan<int> points, int center, TangentFrame frame, Vector3D normal, out QuadricFit fit)
    {
        Vector3D origin = positions[center];
        double size = 0;
        foreach (int p in points)
            size += (positions[p] - origin).Length;
        fit = default;
        // Lengths are measured in mean distances, so that the six columns are of like size and normal equations lose few digits.
        double unit = size / points.Length, scale = 1 / unit;
        Moments sums = default;
        foreach (int p in points)
        {
            Vector3D d = (positions[p] - origin) * scale;
            sums.Add(Vector3D.Dot(d, frame.X), Vector3D.Dot(d, frame.Y), Vector3D.Dot(d, normal));
        }
        Span<double> matrix = stackalloc double[Unknowns * Unknowns], right = stackalloc double[Unknowns];
        sums.ToNormalEquations(points.Length, matrix, right);
        if (!Cholesky(matrix, right))
            return false;
        fit = new(right[1], right[2], 2 * right[3] * scale, right[4] * scale, 2 * right[5] * scale);
        return true;
    }

    /// <summary>Solves in place. False if a pivot is not clearly positive: the points lie on a conic.</summary>
    private static bool Cholesky(Span<double> m, Span<double> right)
    {
        const int N = Unknowns;
        for (int j = 0; j < N; j++)
        {
            double before = m[j * N + j], pivot = before;
            for (int k = 0; k < j; k++)
                pivot -= m[j * N + k] * m[j * N + k];
            if (!(pivot > 1e-11 * before))
                return false;
            double root = Math.Sqrt(pivot), inverse = 1 / root;
            m[j * N + j] = root;
            for (int i = j + 1; i < N; i++)
            {
                double sum = m[i * N + j];
                for (int k = 0; k < j; k++)
                    sum -= m[i * N + k] * m[j * N + k];
                m[i * N + j] = sum * inverse;
            }
        }
        for (int i = 0; i < N; i++)
        {
            double sum = right[i];
            for (int k = 0; k < i; k++)
                sum -= m[i * N + k] * right[k];
            right[i] = sum / m[i * N + i];
        }
        for (int i = N - 1; i >= 0; i--)
        {
            double sum = right[i];
            for (int k = i + 1; k < N; k++)
                sum -= m[k * N + i] * right[k];
            right[i] = sum / m[i * N + i];
        }
        return true;
    }

    /// <summary>The sums of the monomials of degree 1 to 4, of which the normal equations are made, and those with the height.</summary>
    private struct Moments
    {
        private double x, y, xx, xy, yy, xxx, xxy, xyy, yyy, xxxx, xxxy, xxyy, xyyy, yyyy;
        private double z, zx, zy, zxx, zxy, zyy;

        public void Add(double px, double py, double pz)
        {
            double pxx = px * px, pxy = px * py, pyy = py * py;
            x += px;
            y += py;
            xx += pxx;
            xy += pxy;
            yy += pyy;
            xxx += pxx * px;
            xxy += pxx * py;
            xyy += px * pyy;
            yyy += pyy * py;
            xxxx += pxx * pxx;
            xxxy += pxx * pxy;
            xxyy += pxx * pyy;
            xyyy += pxy * pyy;
            yyyy += pyy * pyy;
            z += pz;
            zx += pz * px;
            zy += pz * py;
            zxx += pz * pxx;
            zxy += pz * pxy;
            zyy += pz * pyy;
        }

        /// <summary>The lower triangle, for the monomials 1, x, y, x², xy, y².</summary>
        public readonly void ToNormalEquations(int points, Span<double> m, Span<double> right)
        {
            ReadOnlySpan<double> rows =
            [
                points, 0, 0, 0, 0, 0,
                x, xx, 0, 0, 0, 0,
                y, xy, yy, 0, 0, 0,
                xx, xxx, xxy, xxxx, 0, 0,
                xy, xxy, xyy, xxxy, xxyy, 0,
                yy, xyy, yyy, xxyy, xyyy, yyyy,
            ];
            rows.CopyTo(m);
            ReadOnlySpan<double> heights = [z, zx, zy, zxx, zxy, zyy];
            heights.CopyTo(right);
        }
    }
}
