using System.Collections;
using System.Globalization;
using System.Text.Json;
using MeshLab.IO;
using MeshLab.Numerics;

namespace MeshLab.Cli.Hosting;

/// <summary>Named values in order: what becomes a JSON object.</summary>
internal sealed class ResultFields : IEnumerable<KeyValuePair<string, object?>>
{
    private readonly List<KeyValuePair<string, object?>> fields = [];

    /// <summary>Adds a value: number, text, truth, vector, array, list, other fields, or nothing.</summary>
    public ResultFields Add(string name, object? value)
    {
        fields.Add(new(name, value));
        return this;
    }

    public IEnumerator<KeyValuePair<string, object?>> GetEnumerator() => fields.GetEnumerator();

    IEnumerator IEnumerable.GetEnumerator() => fields.GetEnumerator();

    public void WriteTo(Utf8JsonWriter json)
    {
        json.WriteStartObject();
        foreach ((string name, object? value) in fields)
        {
            json.WritePropertyName(name);
            Write(json, value);
        }
        json.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter json, object? value)
    {
        switch (value)
        {
            case null:
                json.WriteNullValue();
                break;
            case bool truth:
                json.WriteBooleanValue(truth);
                break;
            case int number:
                json.WriteNumberValue(number);
                break;
            case long number:
                json.WriteNumberValue(number);
                break;
            case ulong number:
                json.WriteNumberValue(number);
                break;
            case double number:
                Write(json, number);
                break;
            case float number:
                Write(json, (double)number);
                break;
            case string text:
                json.WriteStringValue(text);
                break;
            case Enum name:
                json.WriteStringValue(name.ToString().ToLowerInvariant());
                break;
            case Vector3D vector:
                json.WriteStartArray();
                Write(json, vector.X);
                Write(json, vector.Y);
                Write(json, vector.Z);
                json.WriteEndArray();
                break;
            case ResultFields nested:
                nested.WriteTo(json);
                break;
            case double[] numbers:
                json.WriteStartArray();
                foreach (double number in numbers)
                    Write(json, number);
                json.WriteEndArray();
                break;
            case int[] numbers:
                json.WriteStartArray();
                foreach (int number in numbers)
                    json.WriteNumberValue(number);
                json.WriteEndArray();
                break;
            case IEnumerable items:
                json.WriteStartArray();
                foreach (object? item in items)
                    Write(json, item);
                json.WriteEndArray();
                break;
            default:
                throw new InvalidOperationException($"A result of type {value.GetType()} cannot be written as JSON.");
        }
    }

    /// <summary>Shortest decimals that read back as the same number; what JSON has no numbers for becomes text.</summary>
    private static void Write(Utf8JsonWriter json, double number)
    {
        if (!double.IsFinite(number))
        {
            json.WriteStringValue(number.ToString(CultureInfo.InvariantCulture));
            return;
        }
        Span<byte> text = stackalloc byte[32];
        json.WriteRawValue(text[..ShortestDecimal.Format(number, text)], skipInputValidation: true);
    }
}
