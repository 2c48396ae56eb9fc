using System.CommandLine;
using System.Globalization;
using MeshLab.Cli.Hosting;
using MeshLab.Cutting;
using MeshLab.Geometry;
using MeshLab.Structure;

namespace MeshLab.Cli.Verbs;

/// <summary>The option <c>--plane nx,ny,nz,d</c>.</summary>
internal static class PlaneArgument
{
    public static Option<string> Option() => new("--plane") { Description = "nx,ny,nz,d: the plane n·x = d; above is where n points.", Required = true };

    public static CuttingPlane Parse(string text)
    {
        string[] words = text.Split(',');
        var numbers = new double[4];
        bool good = words.Length == 4;
        for (int i = 0; i < 4 && good; i++)
            good = double.TryParse(words[i], NumberStyles.Float, CultureInfo.InvariantCulture, out numbers[i]);
        if (!good)
            throw new UsageException($"--plane {text}: expected four numbers nx,ny,nz,d");
        try
        {
            return new(new(numbers[0], numbers[1], numbers[2]), numbers[3]);
        }
        catch (ArgumentException error)
        {
            throw new UsageException($"--plane {text}: {error.Message}");
        }
    }

    /// <summary>Polygons are cut into triangles first: a plane may cross them more than twice.</summary>
    public static Mesh Triangles(Mesh mesh) => mesh.IsTriangleMesh ? mesh : Triangulation.Triangulate(mesh).Mesh;
}
