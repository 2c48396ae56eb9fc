using System.CommandLine;
using MeshLab.Cli.Hosting;

namespace MeshLab.Cli.Verbs;

/// <summary>Prints the script that makes a shell complete verbs and options.</summary>
internal sealed class CompletionVerb : Verb
{
    private readonly Argument<string> shell = new("SHELL") { Description = "bash, zsh or pwsh." };

    public override string Name => "completion";

    public override string Summary => "Print the script for completion in a shell; add its output to the shell's start-up file.";

    public override string Example => "completion bash >> ~/.bashrc";

    public override void Configure(Command command)
    {
        shell.AcceptOnlyFromAmong("bash", "zsh", "pwsh");
        command.Arguments.Add(shell);
    }

    public override void Run(VerbContext context)
    {
        string script = context.Get(shell) switch
        {
            "bash" => """
                _mlab_complete() {
                  local IFS=$'\n'
                  COMPREPLY=($(mlab "[suggest:${COMP_POINT}]" "${COMP_LINE}" 2>/dev/null | grep -- "^${COMP_WORDS[COMP_CWORD]}"))
                }
                complete -o default -F _mlab_complete mlab
                """,
            "zsh" => """
                _mlab() {
                  local completions=("${(@f)$(mlab "[suggest:${#BUFFER}]" "$BUFFER" 2>/dev/null)}")
                  compadd -a completions
                  _files
                }
                compdef _mlab mlab
                """,
            _ => """
                Register-ArgumentCompleter -Native -CommandName mlab -ScriptBlock {
                  param($word, $ast, $cursor)
                  mlab "[suggest:$cursor]" "$ast" | Where-Object { $_ -like "$word*" } | ForEach-Object {
                    [System.Management.Automation.CompletionResult]::new($_, $_, 'ParameterValue', $_) }
                }
                """,
        };
        if (context.Json)
        {
            context.Result.Add("script", script);
            return;
        }
        context.StandardOutput.WriteLine(script);
        context.OutputTaken = true;
    }
}
