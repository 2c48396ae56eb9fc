using System.CommandLine;

namespace MeshLab.Cli.Hosting;

/// <summary>One verb of the command line. Every non-abstract class of this kind in the program is listed and can be called.</summary>
/// <remarks>Declare arguments and options as fields, add them in <see cref="Configure"/>, read them in <see cref="Run"/> by <c>context.Get(option)</c>.</remarks>
internal abstract class Verb
{
    /// <summary>The word after <c>mlab</c>.</summary>
    public abstract string Name { get; }

    /// <summary>One line of help.</summary>
    public abstract string Summary { get; }

    /// <summary>A call that works on a model of the project, without the <c>mlab</c> in front.</summary>
    public abstract string Example { get; }

    /// <summary>Adds the verb's arguments and options.</summary>
    public abstract void Configure(Command command);

    /// <summary>Does the work and fills the context's result.</summary>
    public abstract void Run(VerbContext context);

    /// <summary>The argument for the mesh that is read.</summary>
    protected static Argument<string> InputArgument(string name = "INPUT") =>
        new(name) { Description = "The mesh to read (.obj .off .stl .ply, also .gz), or - for standard input." };

    /// <summary>The argument for the file that is written.</summary>
    protected static Argument<string> OutputArgument(string name = "OUTPUT") =>
        new(name) { Description = "The file to write (.obj .off .stl .ply .glb), or - for standard output." };
}
