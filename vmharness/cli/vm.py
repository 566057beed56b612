"""`vm`: its commands, and the exit code of one; no traceback for what a user can do."""

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


def guarded(arguments: Sequence[str] | None) -> int:
    """The exit code of the command with these arguments (those of the process, without any)."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    collect_rarely()
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # to be asked to end is to be interrupted
    try:
        code = vm.main(given, prog_name="vm", standalone_mode=False)
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
