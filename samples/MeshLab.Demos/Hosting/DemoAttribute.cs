namespace MeshLab.Demos.Hosting;

/// <summary>Marks a static class with <c>public static void Run(Mesh mesh, DemoOutput output)</c> as the demo of a section of the book.</summary>
/// <param name="section">The section's number, such as <c>4.7</c>.</param>
/// <param name="chinese">The book's title of the section.</param>
/// <param name="english">The title in English.</param>
[AttributeUsage(AttributeTargets.Class)]
public sealed class DemoAttribute(string section, string chinese, string english) : Attribute
{
    public string Section { get; } = section;

    public string Chinese { get; } = chinese;

    public string English { get; } = english;
}
