"""Command lines that run cases again, as they were run."""

import shlex
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from vmharness.cli.options import SOLVER, TIMEOUT
from vmharness.suite.select import Entry


def rerun_commands(found: Sequence[Entry], options: Mapping[str, Any]) -> dict[str, str]:
    """The command for each case by its id, with the options that change a result; a case given by path keeps it.

    >>> rerun_commands([Entry(Path("/x/VM-061"))], {"cases": Path("/x"), "data": {"m": 0.4}})
    {'VM-061': 'vm run VM-061 --cases /x --set m=0.4'}
    """
    return {case.id: shlex.join(["vm", "run", _selector(case, options), *_given(options)]) for case in found}


def _selector(case: Entry, options: Mapping[str, Any]) -> str:
    by_path = any(Path(selector).resolve() == case.folder for selector in options.get("selectors", ()))
    return str(case.folder) if by_path else case.id


def _given(options: Mapping[str, Any]) -> list[str]:
    words = []
    if options.get("cases"):
        words += ["--cases", str(options["cases"])]
    if options.get("solver", SOLVER) != SOLVER:
        words += ["--solver", options["solver"]]
    for name, value in options.get("data", {}).items():
        words += ["--set", f"{name}={value!r}".removesuffix(".0")]
    if options.get("timeout", TIMEOUT) != TIMEOUT:
        words += ["--timeout", f"{options['timeout']:g}"]
    return words
