using MeshLab.Numerics;

namespace MeshLab.IO;

/// <summary>Reads the element <c>vertex</c> of a PLY file.</summary>
internal sealed class PlyVertexTable
{
    // The places of the numbers of a vertex; missing ones are read as the last.
    private const int X = 0, Nx = 3, U = 6, R = 8, A = 11, Places = 12;

    public Vector3D[] Positions { get; private set; } = [];

    public Vector3D[]? Normals { get; private set; }

    public Vector2D[]? TextureCoordinates { get; private set; }

    public Color[]? Colors { get; private set; }

    public void Read(ref PlyCursor cursor, PlyElement element, ReadContext context)
    {
        int[] columns = FindColumns(element);
        if (element.Count > 0 && columns.AsSpan(X, 3).Contains(-1))
            throw cursor.ErrorAtHeader(element, "the properties x, y and z");
        bool hasNormals = !columns.AsSpan(Nx, 3).Contains(-1), hasTexture = !columns.AsSpan(U, 2).Contains(-1), hasColors = !columns.AsSpan(R, 3).Contains(-1);
        PlyReader.CountIgnored(element, columns, context);

        long capacity = Math.Min(element.Count, cursor.Remaining / Math.Max(1, element.LeastSize(cursor.IsText)) + 1);
        GrowingArray<Vector3D> positions = new(capacity), normals = new(hasNormals ? capacity : 0);
        GrowingArray<Vector2D> texture = new(hasTexture ? capacity : 0);
        GrowingArray<Color> colors = new(hasColors ? capacity : 0);
        int[] places = PlaceOfProperty(element, columns);
        float unit = hasColors ? PlyReader.ColorUnit(element.Properties[columns[R]].Type) : 1;
        float alphaUnit = columns[A] >= 0 ? PlyReader.ColorUnit(element.Properties[columns[A]].Type) : 1;
        Span<double> numbers = stackalloc double[Places];
        numbers.Clear();
        numbers[A] = 1;
        for (int v = 0; v < element.Count; v++)
        {
            PlyReader.CheckSometimes(v, ref cursor, context);
            ReadInstance(ref cursor, element, places, numbers, context);
            positions.Add(new Vector3D(numbers[X], numbers[X + 1], numbers[X + 2]));
            if (hasNormals)
                normals.Add(new Vector3D(numbers[Nx], numbers[Nx + 1], numbers[Nx + 2]));
            if (hasTexture)
                texture.Add(new Vector2D(numbers[U], numbers[U + 1]));
            if (hasColors)
                colors.Add(MakeColor(numbers[R..], unit, alphaUnit, context));
        }

        Positions = positions.ToArray();
        Normals = hasNormals ? normals.ToArray() : null;
        TextureCoordinates = hasTexture ? texture.ToArray() : null;
        Colors = hasColors ? colors.ToArray() : null;
    }

    /// <summary>A colour of four numbers; white if one is not finite.</summary>
    public static Color MakeColor(ReadOnlySpan<double> channels, float unit, float alphaUnit, ReadContext context)
    {
        if (double.IsFinite(channels[0]) && double.IsFinite(channels[1]) && double.IsFinite(channels[2]) && double.IsFinite(channels[3]))
            return new Color((float)channels[0] / unit, (float)channels[1] / unit, (float)channels[2] / unit, (float)channels[3] / alphaUnit);
        context.ReplacedAttributes++;
        return Color.White;
    }

    private static int[] FindColumns(PlyElement element) =>
    [
        PlyReader.FindNumber(element, "x"), PlyReader.FindNumber(element, "y"), PlyReader.FindNumber(element, "z"),
        PlyReader.FindNumber(element, "nx"), PlyReader.FindNumber(element, "ny"), PlyReader.FindNumber(element, "nz"),
        PlyReader.FindNumber(element, "s", "u", "texture_u"), PlyReader.FindNumber(element, "t", "v", "texture_v"),
        PlyReader.FindNumber(element, "red", "r", "diffuse_red"), PlyReader.FindNumber(element, "green", "g", "diffuse_green"),
        PlyReader.FindNumber(element, "blue", "b", "diffuse_blue"), PlyReader.FindNumber(element, "alpha", "a"),
    ];

    private static int[] PlaceOfProperty(PlyElement element, int[] columns)
    {
        int[] places = new int[element.Properties.Count];
        for (int p = 0; p < places.Length; p++)
            places[p] = Array.IndexOf(columns, p);
        return places;
    }

    private static void ReadInstance(ref PlyCursor cursor, PlyElement element, int[] places, scoped Span<double> numbers, ReadContext context)
    {
        cursor.BeginInstance();
        for (int p = 0; p < places.Length; p++)
        {
            PlyProperty property = element.Properties[p];
            int place = places[p];
            if (place < 0)
            {
                cursor.SkipProperty(property);
                continue;
            }

            double number = cursor.ReadNumber(property.Type);
            if (place < Nx && !double.IsFinite(number))
                throw cursor.ErrorAtNumber($"the coordinate {number}", "a finite coordinate");
            if (place is >= Nx and < R && !double.IsFinite(number))
            {
                context.ReplacedAttributes++;
                number = 0;
            }

            numbers[place] = number;
        }

        cursor.EndInstance();
    }
}
