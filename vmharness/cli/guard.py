"""No traceback for what a user can do; a defect says so, and how to see more of it."""

import shlex
import signal
import sys
import traceback
from collections.abc import Sequence

import click

from vmharness.cli.group import vm
from vmharness.cli.say import complain
from vmharness.execution.garbage import collect_rarely

INTERRUPTED, DEFECT, USAGE = 2, 3, 4


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
    except Exception as error:
        return _defect(error, given)


def _defect(error: Exception, given: list[str]) -> int:
    complain(f"defect in vmharness, not in a case or solver: {type(error).__name__}: {error}")
    if "--debug" in given:
        complain(traceback.format_exc())
    else:
        complain(f"to see where: {shlex.join(['vm', '--debug', *given])}")
    return DEFECT
