"""The command `vm`: its list of commands, and the exit code; wrong input never gives a traceback."""

import difflib
import shlex
import signal
import sys
import traceback
from collections.abc import Sequence

import click

from vmharness import plugins
from vmharness.backends import BackendError
from vmharness.cli.say import complain
from vmharness.execution.garbage import collect_rarely
from vmharness.suite.outcome import EXIT_CODES, Status

COMMANDS = "vmharness.cli.commands"
INTERRUPTED, DEFECT, USAGE = 2, 3, 4


class Folder(click.Group):
    """The commands of the folder `commands`: `command` of the module `run` is `vm run`."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """The names of the commands."""
        return plugins.names(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """The command of that name; raises UsageError with similar names if there is none."""
        names = self.list_commands(ctx)
        if cmd_name not in names:
            near = difflib.get_close_matches(cmd_name, names, n=2)
            there = f"did you mean {' or '.join(near)}?" if near else f"there are: {', '.join(names)}"
            raise click.UsageError(f"no command {cmd_name}; {there}", ctx)
        command: click.Command = plugins.module(COMMANDS, cmd_name).command
        return command


@click.group(cls=Folder, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name="vmharness", prog_name="vm", message="vmharness %(version)s")
@click.option("--debug", is_flag=True, help="Show the traceback of a defect of vmharness.")
def vm(debug: bool) -> None:
    """Run verification cases of explicit dynamics, and write the pages of the manual.

    Exit codes: 0 all pass; 1 a result is out of tolerance; 2 interrupted; 3 defect of vmharness;
    4 wrong usage or an error in a case; 5 nothing selected; 6 could not be judged.
    """


def guarded(arguments: Sequence[str] | None) -> int:
    """Run a command and return its exit code; None stands for the arguments of the process."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    if "--debug" in given:  # also after the command
        given = ["--debug", *(word for word in given if word != "--debug")]
    collect_rarely()
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # a request to end is an interrupt
    try:
        code = vm.main(given, prog_name="vm", standalone_mode=False, obj=given)
        return int(code or 0)
    except click.ClickException as error:
        error.show()
        return USAGE
    except (click.Abort, KeyboardInterrupt):
        complain("interrupted")
        return INTERRUPTED
    except BackendError as error:
        complain(str(error))
        return EXIT_CODES[Status.UNJUDGED]
    except Exception as error:
        return _defect(error, given)


def _defect(error: Exception, given: list[str]) -> int:
    complain(f"defect in vmharness, not in a case or solver: {type(error).__name__}: {error}")
    if "--debug" in given:
        complain(traceback.format_exc())
    else:
        complain(f"to see where: {shlex.join(['vm', '--debug', *given])}")
    return DEFECT
