using System.Numerics;
using MeshLab.Numerics;

namespace MeshLab.Visualization;

/// <summary>
/// A pinhole camera that just sees all points given: for each of the four sides of its pyramid the extreme point is found, which gives
/// the nearest place exactly. Nothing is ever behind it, so no clipping is needed.
/// </summary>
internal sealed class Camera
{
    private Camera(Vector3D right, Vector3D up, Vector3D back, Vector3D position, double focal, double centerX, double centerY)
    {
        Right = right;
        Up = up;
        Back = back;
        Position = position;
        Focal = focal;
        CenterX = centerX;
        CenterY = centerY;
    }

    /// <summary>Unit vector to the right of the picture.</summary>
    public Vector3D Right { get; }

    /// <summary>Unit vector to the top of the picture.</summary>
    public Vector3D Up { get; }

    /// <summary>Unit vector from the model to the viewer.</summary>
    public Vector3D Back { get; }

    /// <summary>Where the viewer is.</summary>
    public Vector3D Position { get; }

    /// <summary>Samples per unit of size at distance 1.</summary>
    public double Focal { get; }

    /// <summary>Column of the viewing axis, in samples.</summary>
    public double CenterX { get; }

    /// <summary>Row of the viewing axis, in samples.</summary>
    public double CenterY { get; }

    /// <summary>The model's up direction.</summary>
    public static Vector3D WorldUp(View view) => view.Up == UpAxis.Z ? Vector3D.UnitZ : Vector3D.UnitY;

    /// <summary>The camera for the points, into the left part of a picture of the given size in samples.</summary>
    public static Camera Frame(View view, Vector3D[] points, double width, double height, double margin)
    {
        var (right, up, back) = Basis(view);
        double usableX = Math.Max(width - 2 * margin, 1), usableY = Math.Max(height - 2 * margin, 1);
        double tan = Math.Tan(view.FieldOfView * Math.PI / 360);
        double largest = Math.Max(usableX, usableY);
        double tx = tan * usableX / largest, ty = tan * usableY / largest;

        double a = double.NegativeInfinity, b = a, c = a, d = a, nearest = a;
        foreach (Vector3D p in points)
        {
            double x = Vector3D.Dot(p, right), y = Vector3D.Dot(p, up), z = Vector3D.Dot(p, back);
            a = Math.Max(a, x + z * tx);
            b = Math.Max(b, -x + z * tx);
            c = Math.Max(c, y + z * ty);
            d = Math.Max(d, -y + z * ty);
            nearest = Math.Max(nearest, z);
        }
        if (points.Length == 0)
            (a, b, c, d, nearest) = (1, 1, 1, 1, 0);
        double scale = BoundingBox.Of(points).Diagonal;
        if (!(scale > 0))
            scale = Math.Max(1e-6, 1e-6 * Math.Abs(nearest));
        double distance = Math.Max(Math.Max((a + b) / (2 * tx), (c + d) / (2 * ty)), nearest + 0.05 * scale);
        Vector3D position = right * ((a - b) / 2) + up * ((c - d) / 2) + back * distance;
        double focal = largest / 2 / tan * view.Zoom;
        return new(right, up, back, position, focal, width / 2, height / 2);
    }

    /// <summary>The point in the axes right, up, towards the viewer, the camera at the origin: z is minus the distance.</summary>
    public Vector3 ToView(Vector3D p)
    {
        Vector3D d = p - Position;
        return new((float)Vector3D.Dot(d, Right), (float)Vector3D.Dot(d, Up), (float)Vector3D.Dot(d, Back));
    }

    /// <summary>Column and row (in samples, rows downward) and distance.</summary>
    public (double X, double Y, double Distance) Project(Vector3D p)
    {
        Vector3D d = p - Position;
        double z = -Vector3D.Dot(d, Back);
        return (CenterX + Focal * Vector3D.Dot(d, Right) / z, CenterY - Focal * Vector3D.Dot(d, Up) / z, z);
    }

    /// <summary>A direction in the axes right, up, towards the viewer.</summary>
    public Vector3 DirectionToView(Vector3D d) => new((float)Vector3D.Dot(d, Right), (float)Vector3D.Dot(d, Up), (float)Vector3D.Dot(d, Back));

    private static (Vector3D Right, Vector3D Up, Vector3D Back) Basis(View view)
    {
        var (sa, ca) = Math.SinCos(view.Azimuth * Math.PI / 180);
        var (se, ce) = Math.SinCos(view.Elevation * Math.PI / 180);
        // Written for z up; the front is −y there and +z with y up.
        Vector3D right = new(ca, sa, 0), back = new(sa * ce, -ca * ce, se), up = new(-sa * se, ca * se, ce);
        return view.Up == UpAxis.Z ? (right, up, back) : (Turn(right), Turn(up), Turn(back));

        static Vector3D Turn(Vector3D v) => new(v.X, v.Z, -v.Y);
    }
}
