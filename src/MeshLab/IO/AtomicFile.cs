namespace MeshLab.IO;

/// <summary>Writes a file as a whole or not at all: into a temporary file beside it, which is then renamed.</summary>
internal static class AtomicFile
{
    public static void Write(string path, Action<Stream> write)
    {
        path = Path.GetFullPath(path);
        if (Directory.Exists(path))
            throw new IOException($"'{path}' is a directory, not a file.");
        // A link stays a link, and a device a device.
        if (File.Exists(path) && File.ResolveLinkTarget(path, returnFinalTarget: true) is { } target)
            path = target.FullName;
        if (path.StartsWith("/dev/", StringComparison.Ordinal))
        {
            using FileStream device = new(path, FileMode.Open, FileAccess.Write);
            write(device);
            return;
        }

        // Renaming would replace a file that may not be written.
        if (File.Exists(path))
            new FileStream(path, FileMode.Open, FileAccess.Write).Dispose();
        string folder = Path.GetDirectoryName(path)!;
        if (!Directory.Exists(folder))
            throw new DirectoryNotFoundException($"'{path}' cannot be written: there is no directory '{folder}'.");
        string temporary = Path.Combine(folder, $".{Path.GetFileName(path)}.{Path.GetRandomFileName()}.tmp");
        bool isWhole = false;
        try
        {
            using (FileStream stream = Create(temporary, path, folder))
                write(stream);
            if (!OperatingSystem.IsWindows() && File.Exists(path))
                File.SetUnixFileMode(temporary, File.GetUnixFileMode(path));
            File.Move(temporary, path, overwrite: true);
            isWhole = true;
        }
        finally
        {
            if (!isWhole)
                File.Delete(temporary);
        }
    }

    /// <summary>Nobody knows the temporary file's name; an error is about the file that was asked for.</summary>
    private static FileStream Create(string temporary, string path, string folder)
    {
        try
        {
            return new FileStream(temporary, FileMode.CreateNew, FileAccess.Write, FileShare.None, bufferSize: 0);
        }
        catch (UnauthorizedAccessException error)
        {
            throw new UnauthorizedAccessException($"'{path}' cannot be written: access to the directory '{folder}' is denied.", error);
        }
    }
}
