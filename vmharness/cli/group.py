"""`vm` and its commands; the folder `commands` is the list of them, each imported only when it is asked for."""

import difflib

import click

from vmharness import plugins

COMMANDS = "vmharness.cli.commands"


class Folder(click.Group):
    """The commands in the folder: module `run` holds `command`, which is `vm run`."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Names of the commands."""
        return plugins.names(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """The command of that name; UsageError with near names where there is none."""
        names = self.list_commands(ctx)
        if cmd_name not in names:
            near = difflib.get_close_matches(cmd_name, names, n=2)
            there = f"did you mean {' or '.join(near)}?" if near else f"there are: {', '.join(names)}"
            raise click.UsageError(f"no command {cmd_name}; {there}", ctx)
        command: click.Command = plugins.module(COMMANDS, cmd_name).command
        return command


@click.group(cls=Folder, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name="vmharness", prog_name="vm", message="vmharness %(version)s")
@click.option("--debug", is_flag=True, help="Show where a defect of the harness lies.")
def vm(debug: bool) -> None:
    """Run verification cases of explicit dynamics: deck in, judged results and manual page out.

    Exit codes: 0 all pass; 1 a result is out of tolerance; 2 interrupted; 3 defect in the harness;
    4 usage or case error; 5 nothing selected; 6 could not be judged.
    """
