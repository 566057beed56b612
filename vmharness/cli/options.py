"""Options of a run, with their checks; solvers and reports are not imported for them."""

import functools
import math
import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from pkgutil import iter_modules
from typing import Any, TypeVar

import click

import vmharness
from vmharness.cli.say import File

Command = TypeVar("Command", bound=Callable[..., Any])

SOLVER = "builtin"
TIMEOUT = 600.0  # seconds
READING = 60.0  # seconds, where a case is only read and checked
TITLES = {"junit": "JUnit XML"}  # of export formats, where it is not the name in capitals
FILE = File()
FOLDER = click.Path(file_okay=False, path_type=Path)


@dataclass(frozen=True)
class How:
    """How the variants of a study are run: number of processes, time limit, solver."""

    jobs: int = 1
    timeout: float = TIMEOUT
    solver: str = SOLVER


def running(command: Command) -> Command:
    """Add -j, --solver, --set and --timeout."""
    data = click.option(
        "--set",
        "data",
        multiple=True,
        metavar="NAME=VALUE",
        callback=_data,
        help="Change a datum in theory and deck; repeat the option for several data. Reports go to runs/.",
    )
    for option in (
        timeout_option(TIMEOUT, "run"),
        data,
        solver_option(),
        _jobs_option("1", "Number of worker processes; auto: one for each core.  [default: 1]"),
    ):
        command = option(command)
    return command


def studying(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add -j, --solver and --timeout, joined as `how`, and --out and --json."""

    @functools.wraps(command)
    def together(jobs: int, timeout: float, solver: str, **others: Any) -> Any:
        return command(how=How(jobs, timeout, solver), **others)

    options = (
        click.option("--json", type=FILE, metavar="FILE", help="Also write the record as JSON."),
        click.option(
            "--out",
            type=FOLDER,
            default=Path("reports"),
            metavar="DIR",
            help="Folder for the reports.  [default: reports]",
        ),
        timeout_option(TIMEOUT, "run"),
        solver_option(),
        _jobs_option("auto", "Number of worker processes.  [default: auto, one for each core]"),
    )
    for option in options:
        together = option(together)
    return together


def timeout_option(default: float, of: str = "case") -> Callable[[Command], Command]:
    """Add --timeout."""
    return click.option(
        "--timeout",
        type=click.FloatRange(0, min_open=True),
        default=default,
        metavar="SECONDS",
        callback=_number,
        help=f"Time limit of each {of}.  [default: {default:g}]",
    )


def solver_option() -> Callable[[Command], Command]:
    """Add --solver."""
    return click.option(
        "--solver",
        default=SOLVER,
        metavar="NAME",
        callback=_solver,
        help=f"Solver to use; `vm doctor` lists them.  [default: {SOLVER}]",
    )


def _jobs_option(default: str, help: str) -> Callable[[Command], Command]:
    return click.option("-j", "--jobs", default=default, metavar="N", callback=_jobs, help=help)


def formats(command: Command) -> Command:
    """Add an option --FORMAT FILE for each export format; `files` returns those that were given."""
    for name in reversed(_folder("report/exports")):
        command = click.option(
            f"--{name}",
            type=FILE,
            metavar="FILE",
            expose_value=False,
            callback=_remember,
            help=f"Also write the results as {TITLES.get(name, name.upper())}.",
        )(command)
    return command


def files(ctx: click.Context) -> dict[str, Path]:
    """The file to write for each export format that was given."""
    return {name: path for name, path in ctx.meta.items() if name in _folder("report/exports")}


def _jobs(ctx: click.Context, parameter: click.Parameter, value: str) -> int:
    if value == "auto":
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if not value.isdecimal() or int(value) < 1:
        raise click.BadParameter(f"{value} is not a number of workers; write a number from 1 on, or auto")
    return int(value)


def _number(ctx: click.Context, parameter: click.Parameter, value: float) -> float:
    """A number of seconds: of NaN no comparison with 0 holds."""
    if math.isnan(value):
        raise click.BadParameter("nan is not a number of seconds")
    return value


def _solver(ctx: click.Context, parameter: click.Parameter, value: str) -> str:
    from vmharness.backends import names

    if value != SOLVER and value not in names():
        raise click.BadParameter(f"no solver {value}; there are: {', '.join(names())}")
    return value


def _data(ctx: click.Context, parameter: click.Parameter, values: tuple[str, ...]) -> dict[str, float]:
    from vmharness.case import settings

    try:
        return settings.parse(values)
    except settings.SettingError as error:
        raise click.BadParameter(str(error)) from None


def _remember(ctx: click.Context, parameter: click.Parameter, value: Path | None) -> None:
    if value is not None:
        ctx.meta[str(parameter.name)] = value


def _folder(path: str) -> list[str]:
    """The modules of a folder of drop-ins, by name, without an import of the package around it."""
    modules = iter_modules([str(Path(vmharness.__file__).parent / path)])
    return sorted(module.name.replace("_", "-") for module in modules)
