using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.IO;

/// <summary>Reads the elements <c>face</c> and <c>tristrips</c> of a PLY file.</summary>
/// <param name="vertexCount">How many vertices the header announces; reading the vertices makes sure that they are there.</param>
internal sealed class PlyFaceTable(int vertexCount)
{
    public const string LabelPrefix = "label_";
    private GrowingArray<int> starts = StartsOfNone();
    private GrowingArray<int> corners = new(0);

    public int[] FaceStart => starts.ToArray();

    public int[] Corners => corners.ToArray();

    public Vector2D[]? CornerTextureCoordinates { get; private set; }

    public Vector3D[]? CornerNormals { get; private set; }

    public Color[]? Colors { get; private set; }

    public FaceLabelSet[] Labels { get; private set; } = [];

    /// <summary>Which property of a face means what; −1 for those that are missing.</summary>
    private sealed record Columns(int Indices, int Texture, int Normal, int[] Color, int[] Labels)
    {
        public static Columns Find(PlyElement element, PlyHeader header) => new(
            element.Properties.FindIndex(p => p.IsList && PlyHeader.IsInteger(p.Type) && p.Name is "vertex_indices" or "vertex_index"),
            element.Properties.FindIndex(p => p.IsList && p.Name == "texcoord"),
            element.Properties.FindIndex(p => p.IsList && p.Name == "normal"),
            [
                PlyReader.FindNumber(element, "red", "r", "diffuse_red"), PlyReader.FindNumber(element, "green", "g", "diffuse_green"),
                PlyReader.FindNumber(element, "blue", "b", "diffuse_blue"), PlyReader.FindNumber(element, "alpha", "a"),
            ],
            [.. Enumerable.Range(0, element.Properties.Count).Where(p => IsLabel(element.Properties[p], header))]);

        private static bool IsLabel(PlyProperty property, PlyHeader header) =>
            !property.IsList && PlyHeader.IsInteger(property.Type) && property.Name.StartsWith(LabelPrefix, StringComparison.Ordinal)
            && header.LabelNames.ContainsKey(property.Name[LabelPrefix.Length..])
            && property.Name[LabelPrefix.Length..] is not (TraitNames.Normal or TraitNames.Color or TraitNames.SelectedFlag);
    }

    public void Read(ref PlyCursor cursor, PlyElement element, PlyHeader header, ReadContext context)
    {
        Columns columns = Columns.Find(element, header);
        if (columns.Indices < 0 && element.Count > 0)
            throw cursor.ErrorAtHeader(element, "the property list … vertex_indices of integers");
        bool hasColors = !columns.Color.AsSpan(0, 3).Contains(-1);
        PlyReader.CountIgnored(element, [columns.Indices, columns.Texture, columns.Normal, .. columns.Color, .. columns.Labels], context);

        long capacity = Math.Min(element.Count, cursor.Remaining / Math.Max(1, element.LeastSize(cursor.IsText)) + 1);
        starts = new(capacity + 1);
        starts.Add(0);
        corners = new(Math.Min(3 * capacity, cursor.Remaining));
        GrowingArray<Color> colors = new(hasColors ? capacity : 0);
        GrowingArray<double> texture = new(0), normals = new(0);
        GrowingArray<int>[] labels = [.. columns.Labels.Select(_ => new GrowingArray<int>(capacity))];
        Span<double> channels = [0, 0, 0, 1];
        for (int f = 0; f < element.Count; f++)
        {
            PlyReader.CheckSometimes(f, ref cursor, context);
            cursor.BeginInstance();
            int textureLength = 0, normalLength = 0;
            for (int p = 0; p < element.Properties.Count; p++)
            {
                PlyProperty property = element.Properties[p];
                if (p == columns.Indices)
                    ReadCorners(ref cursor, property);
                else if (p == columns.Texture)
                    textureLength = ReadList(ref cursor, property, ref texture, context);
                else if (p == columns.Normal)
                    normalLength = ReadList(ref cursor, property, ref normals, context);
                else if (Array.IndexOf(columns.Color, p) is int channel and >= 0)
                    channels[channel] = cursor.ReadNumber(property.Type);
                else if (Array.IndexOf(columns.Labels, p) is int set and >= 0)
                    labels[set].Add(ReadLabel(ref cursor, property, header.LabelNames[property.Name[LabelPrefix.Length..]].Count));
                else
                    cursor.SkipProperty(property);
            }

            cursor.EndInstance();
            PadList(ref cursor, ref texture, columns.Texture, textureLength, 2 * corners.Count);
            PadList(ref cursor, ref normals, columns.Normal, normalLength, 3 * corners.Count);
            if (hasColors)
                colors.Add(PlyVertexTable.MakeColor(channels, UnitOf(element, columns.Color[0]), UnitOf(element, columns.Color[3]), context));
        }

        CornerTextureCoordinates = columns.Texture < 0 ? null : ToVectors2D(texture.Span);
        CornerNormals = columns.Normal < 0 ? null : ToVectors3D(normals.Span);
        Colors = hasColors ? colors.ToArray() : null;
        Labels = [.. columns.Labels.Select((p, s) => MakeLabels(element.Properties[p].Name[LabelPrefix.Length..], header, labels[s].ToArray()))];
    }

    /// <summary>Strips: every three successive vertices are a triangle, every second one turned round; −1 begins a new strip.</summary>
    public void ReadStrips(ref PlyCursor cursor, PlyElement element, ReadContext context)
    {
        int column = element.Properties.FindIndex(p => p.IsList && PlyHeader.IsInteger(p.Type) && p.Name is "vertex_indices" or "vertex_index");
        if (column < 0 && element.Count > 0)
            throw cursor.ErrorAtHeader(element, "the property list … vertex_indices of integers");
        if (Colors is not null || CornerTextureCoordinates is not null || CornerNormals is not null || Labels.Length > 0)
            throw cursor.ErrorAtHeader(element, "faces with attributes in one element only");
        for (int s = 0; s < element.Count; s++)
        {
            PlyReader.CheckSometimes(s, ref cursor, context);
            cursor.BeginInstance();
            for (int p = 0; p < element.Properties.Count; p++)
            {
                if (p == column)
                    ReadStrip(ref cursor, element.Properties[p], context);
                else
                    cursor.SkipProperty(element.Properties[p]);
            }

            cursor.EndInstance();
        }
    }

    private void ReadStrip(ref PlyCursor cursor, PlyProperty property, ReadContext context)
    {
        int length = cursor.ReadLength(property.LengthType!.Value);
        int a = -1, b = -1, inStrip = 0;
        for (int k = 0; k < length; k++)
        {
            long index = cursor.ReadInteger(property.Type);
            // −1 of an unsigned type reads as its largest value.
            if (index is -1 or uint.MaxValue)
            {
                inStrip = 0;
                continue;
            }

            int c = CheckIndex(ref cursor, index);
            if (++inStrip >= 3)
                AddStripTriangle(a, b, c, isOdd: inStrip % 2 == 0, context);
            (a, b) = (b, c);
        }
    }

    private void AddStripTriangle(int a, int b, int c, bool isOdd, ReadContext context)
    {
        if (a == b || b == c || c == a)
        {
            // A repeated vertex is how strips turn round a corner; it means no triangle.
            context.CountIgnored("strip triangle with a repeated vertex");
            return;
        }

        corners.Add(isOdd ? b : a);
        corners.Add(isOdd ? a : b);
        corners.Add(c);
        starts.Add(corners.Count);
    }

    private void ReadCorners(ref PlyCursor cursor, PlyProperty property)
    {
        int degree = cursor.ReadLength(property.LengthType!.Value);
        if (degree < 3)
            throw cursor.ErrorAtNumber($"a face of {degree} corners", "a face of three or more corners");
        for (int k = 0; k < degree; k++)
            corners.Add(CheckIndex(ref cursor, cursor.ReadInteger(property.Type)));
        starts.Add(corners.Count);
    }

    private int CheckIndex(ref PlyCursor cursor, long index) => index >= 0 && index < vertexCount
        ? (int)index
        : throw cursor.ErrorAtNumber($"vertex index {index}", $"a vertex index from 0 to {vertexCount - 1}");

    private static int ReadLabel(ref PlyCursor cursor, PlyProperty property, int count)
    {
        long label = cursor.ReadInteger(property.Type);
        return label >= -1 && label < count ? (int)label : throw cursor.ErrorAtNumber($"label {label}", $"a label from -1 to {count - 1}");
    }

    private static int ReadList(ref PlyCursor cursor, PlyProperty property, ref GrowingArray<double> values, ReadContext context)
    {
        int length = cursor.ReadLength(property.LengthType!.Value);
        for (int k = 0; k < length; k++)
        {
            double value = cursor.ReadNumber(property.Type);
            if (!double.IsFinite(value))
            {
                context.ReplacedAttributes++;
                value = 0;
            }

            values.Add(value);
        }

        return length;
    }

    /// <summary>A face may leave its list of corner values empty; then they are zero.</summary>
    private static void PadList(ref PlyCursor cursor, ref GrowingArray<double> values, int column, int length, int total)
    {
        if (column < 0 || values.Count == total)
            return;
        if (length != 0)
            throw cursor.ErrorAtNumber($"a list of {length} numbers per corner", "as many values as the face has corners");
        values.PadTo(total, 0);
    }

    private static float UnitOf(PlyElement element, int column) => column < 0 ? 1 : PlyReader.ColorUnit(element.Properties[column].Type);

    private static FaceLabelSet MakeLabels(string kind, PlyHeader header, int[] labels) => new(kind, header.LabelNames[kind], labels);

    private static Vector2D[] ToVectors2D(ReadOnlySpan<double> numbers)
    {
        Vector2D[] vectors = new Vector2D[numbers.Length / 2];
        for (int i = 0; i < vectors.Length; i++)
            vectors[i] = new Vector2D(numbers[2 * i], numbers[2 * i + 1]);
        return vectors;
    }

    private static Vector3D[] ToVectors3D(ReadOnlySpan<double> numbers)
    {
        Vector3D[] vectors = new Vector3D[numbers.Length / 3];
        for (int i = 0; i < vectors.Length; i++)
            vectors[i] = new Vector3D(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
        return vectors;
    }

    private static GrowingArray<int> StartsOfNone()
    {
        GrowingArray<int> none = new(0);
        none.Add(0);
        return none;
    }
}
