using System.Text;

namespace MeshLab.Visualization;

/// <summary>Writes text files: UTF-8 without a mark, lines ended by LF.</summary>
internal static class TextFile
{
    /// <summary>Writes the file; folders on the way are made.</summary>
    public static void Save(string path, string text)
    {
        ArgumentException.ThrowIfNullOrEmpty(path);
        Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(path))!);
        File.WriteAllText(path, text, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false));
    }
}
