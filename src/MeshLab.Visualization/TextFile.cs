using System.Text;
using MeshLab.IO;

namespace MeshLab.Visualization;

/// <summary>Writes text files: UTF-8 without a mark, lines ended by LF.</summary>
internal static class TextFile
{
    /// <summary>Writes the file; folders on the way are made.</summary>
    public static void Save(string path, string text)
    {
        ArgumentException.ThrowIfNullOrEmpty(path);
        Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(path))!);
        byte[] bytes = Encoding.UTF8.GetBytes(text);
        AtomicFile.Write(path, stream => stream.Write(bytes));
    }
}
