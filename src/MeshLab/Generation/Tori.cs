using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Generation;

/// <summary>The torus (环面), the torus with k holes (genus k, 亏格) and a chain of tori.</summary>
public static class Tori
{
    /// <summary>A torus around the z axis: genus 1, V = mn, F = 2mn; area 4π²Rr and volume 2π²Rr² in the limit.</summary>
    /// <param name="major">R: the distance of the tube's centre from the axis.</param>
    /// <param name="minor">r: the radius of the tube, below R.</param>
    /// <param name="m">Cells around the axis, at least 3.</param>
    /// <param name="n">Cells around the tube, at least 3.</param>
    /// <param name="faces">Triangles or quadrilaterals.</param>
    /// <exception cref="ArgumentOutOfRangeException">A count is below 3, a radius is not positive, or r is not below R.</exception>
    public static Mesh Torus(double major = 1, double minor = 0.4, int m = 48, int n = 24, PatchFaces faces = PatchFaces.Triangles)
    {
        Check.Positive(major);
        Check.Positive(minor);
        if (minor >= major)
            throw new ArgumentOutOfRangeException(nameof(minor), minor, $"The tube's radius must be below the ring's, {major}.");
        Check.Count(m, 3);
        Check.Count(n, 3);
        Check.Elements(m, n, nameof(m));
        return new Patch(m, n, JoinU: true, JoinV: true, faces).Build((i, j) =>
        {
            Vector2D tube = UnitCircle.At(j, n);
            return Polygons.OnCircle(i, m, major + minor * tube.X, minor * tube.Y);
        });
    }

    /// <summary>k tori side by side, melted into one surface: closed, one component, genus k, χ = 2 − 2k.</summary>
    /// <param name="genus">k, from 1 to 32.</param>
    /// <param name="resolution">Cells of the marched lattice per unit of length (a hole's ring has radius 1), from 6 to 64.</param>
    /// <exception cref="ArgumentOutOfRangeException">A parameter is out of range.</exception>
    public static Mesh KHoled(int genus = 2, int resolution = 8)
    {
        Check.Count(genus, 1, 32);
        Check.Count(resolution, 6, 64);
        const double tube = 0.42, spacing = 1.9, sharpness = 10;
        double half = (genus - 1) * spacing / 2;
        var box = new BoundingBox(new(-half - 1.7, -1.7, -0.7), new(half + 1.7, 1.7, 0.7));
        return ImplicitSurfaces.March(Distance, box, 1.0 / resolution, smoothing: 6);

        double Distance(Vector3D p)
        {
            double sum = 0;
            for (int k = 0; k < genus; k++)
            {
                double x = p.X - (k * spacing - half), ring = Math.Sqrt(x * x + p.Y * p.Y) - 1;
                sum += Math.Exp(-sharpness * Math.Sqrt(ring * ring + p.Z * p.Z));
            }
            return -Math.Log(sum) / sharpness - tube;
        }
    }

    /// <summary>A chain of interlocked tori (链): as many components as links, each of genus 1.</summary>
    /// <param name="links">The number of links, from 1 to 1000.</param>
    /// <param name="m">Cells around each link, at least 3.</param>
    /// <param name="n">Cells around each tube, at least 3.</param>
    /// <exception cref="ArgumentOutOfRangeException">A count is out of range.</exception>
    public static Mesh Chain(int links = 5, int m = 48, int n = 16)
    {
        Check.Count(links, 1, 1000);
        var chain = new Mesh();
        for (int k = 0; k < links; k++)
        {
            Mesh link = Torus(0.5, 0.12, m, n);
            foreach (ref Vector3D p in link.Positions)
            {
                // Long links, every other one a quarter turned about the chain's axis.
                Vector3D q = new(p.X + 0.25 * Math.Sign(p.X) + 1.1 * k, p.Y, p.Z);
                p = k % 2 == 0 ? q : new(q.X, -q.Z, q.Y);
            }
            chain.Append(link);
        }
        return chain;
    }
}
