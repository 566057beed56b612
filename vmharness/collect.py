"""The solution of a case that result files hold: what a solver did elsewhere, for the same judgement as a run."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vmharness.case import Case
from vmharness.case.deck import read_deck
from vmharness.deck import Deck
from vmharness.history import History
from vmharness.mesh.view import drawable
from vmharness.result import Solution, Source
from vmharness.results import (
    Format,
    Key,
    Quantities,
    ResultError,
    Series,
    Sum,
    formats,
    join,
    quantities,
    recognise,
)

Array = NDArray[np.float64]
FEWEST = 3  # states that a judgement takes
LATE = 1.5  # intervals before its end at which a finished run may have written its last state


@dataclass(frozen=True)
class Found:
    """A channel as the files give it."""

    series: Series
    values: Array  # (n,) at the instants of the series
    form: Format

    @property
    def digits(self) -> float:
        """Significant decimal digits of a value."""
        return self.series.digits or self.form.DIGITS or 17.0

    @property
    def source(self) -> Source:
        """File, interval and precision."""
        time = self.series.time
        interval = float(np.diff(time).max()) if time.size > 1 else 0.0
        return Source(self.series.file, self.form.NAME, interval, self.digits, self.form.SCHEME)


def collect(case: Case, files: Sequence[Path], columns: Mapping[str, str] | None = None) -> Solution:
    """The channels of the case that the files hold; of those that they do not hold, what is needed.

    `columns` are names of columns by channel, where they differ. What is wrong with a file is the `failure`. Raises
    CaseError and DeckError for what is wrong with the case.
    """
    deck = read_deck(case)
    columns = columns or {}
    asked = {
        name: quantities(columns.get(name, name), channel, deck)
        for name, channel in case.file.channels.items()
    }
    try:
        read = _read(files, {key for each in asked.values() for sum_ in each.sums for key in sum_})
    except (ResultError, OSError) as error:
        return Solution(_names(files), None, str(error), lost=True)
    found = _aligned(
        {name: best for name, each in asked.items() if (best := _best(each.sums, read)) is not None}
    )
    unreported = {name: _why(asked[name], read) for name in asked if name not in found}
    parts = [part for _, series in read for part in series]
    return Solution(
        solver=next((part.solver for part in parts if part.solver), "") or _names(files),
        history=_history(found),
        failure="" if found else f"none of its channels is in {_names(files)}",
        lost=not found,
        facts=_facts(found),
        notes=tuple(dict.fromkeys(note for part in parts for note in part.notes)),
        files=deck.files,
        view=drawable(deck),
        unreported=unreported,
        sources={name: each.source for name, each in found.items()},
        unfinished=_unfinished(deck, found.values()),
    )


def _read(files: Sequence[Path], keys: set[Key]) -> list[tuple[Format, list[Series]]]:
    """What each file holds of the wanted quantities; raises ResultError and OSError."""
    read = []
    for path in files:
        form = recognise(path)
        if form is None:
            known = ", ".join(each.NAME for each in formats())
            raise ResultError(f"{path}: not a result file that is known; there are: {known}")
        wanted = {key for key in keys if form.gives(key)}
        read.append((form, form.read(path, wanted) if wanted else []))
    return read


def _best(sums: Iterable[Sum], read: Sequence[tuple[Format, list[Series]]]) -> Found | None:
    """The channel from the format that has most samples of it, then most digits, then comes first."""
    found = [one for sum_ in sums for one in _each(sum_, read)]
    return max(found, key=lambda one: (one.values.size, one.digits), default=None)


def _each(sum_: Sum, read: Sequence[tuple[Format, list[Series]]]) -> Iterable[Found]:
    """The sum by each format that has all its quantities; files of one format are joined."""
    parts: dict[str, tuple[Format, list[Series]]] = {}
    for form, series in read:
        fitting = [part for part in series if sum_.keys() <= part.columns.keys()]
        if fitting:
            parts.setdefault(form.NAME, (form, []))[1].extend(fitting)
    for form, fitting in parts.values():
        whole = join(fitting, sum_.keys())
        values = np.sum([factor * whole.columns[key] for key, factor in sum_.items()], axis=0)
        yield Found(whole, values, form)


def _why(asked: Quantities, read: Sequence[tuple[Format, list[Series]]]) -> str:
    """Why a channel is not there, and what would give it."""
    if columns := [name for _, series in read for part in series for name in part.offered]:
        return f"is not among the columns {', '.join(columns)}; name its column with --column"
    if asked.reasons:
        return "; ".join(asked.reasons)
    wanted = [key for sum_ in asked.sums for key in sum_ if key.kind != "column"]
    givers = [form for form in formats() if any(form.gives(key) for key in wanted)]
    if not givers:
        return f"is not in any format that is read: {wanted[0]}"
    there = {form.NAME for form, _ in read}
    asking = next((form for form in givers if form.DATABASE), givers[0])
    needs = f"needs {asking.DATABASE} ({' or '.join(form.NAME for form in givers)})"
    lacking = [form.NAME for form in givers if form.NAME in there]
    return f"is not in {lacking[0]}, which has no {wanted[0]}: {needs}" if lacking else needs


def _aligned(found: Mapping[str, Found]) -> dict[str, Found]:
    """The channels, at the best known instants where their own are these but for their printed digits."""
    if not found:
        return {}
    main = _main(found)
    return {
        name: replace(each, series=replace(each.series, time=main.time)) if _same(each.series, main) else each
        for name, each in found.items()
    }


def _main(found: Mapping[str, Found]) -> Series:
    """The series whose instants are best known; of several the longest."""
    return min((each.series for each in found.values()), key=lambda part: (part.resolution, -part.time.size))


def _history(found: Mapping[str, Found]) -> History | None:
    """All channels; those sampled at other instants than the best known ones keep their own."""
    if not found:
        return None
    time = _main(found).time
    own = {name: each.series.time for name, each in found.items() if each.series.time is not time}
    return History(time, {name: each.values for name, each in found.items()}, own)


def _same(one: Series, main: Series) -> bool:
    """Whether the instants differ by no more than their printed digits leave open."""
    if one.time.size != main.time.size:
        return False
    open_ = (one.resolution + main.resolution) * np.abs(main.time)
    closest = np.diff(main.time).min() if main.time.size > 1 else np.inf
    return bool(np.all(np.abs(one.time - main.time) <= np.minimum(open_, 0.25 * closest)))


def _facts(found: Mapping[str, Found]) -> dict[str, str]:
    """Where the channels are from, for the provenance."""
    facts: dict[str, list[str]] = {}
    for name, each in found.items():
        s = each.source
        line = f"{s.file}: every {s.interval:.6g}, {s.digits:g} digits"
        facts.setdefault(line, []).append(name)
    return {f"Read from {line}": ", ".join(names) for line, names in facts.items()}


def _unfinished(deck: Deck, found: Iterable[Found]) -> str:
    """A sentence if the files have few states, end before the deck does, or begin after it."""
    termination = deck.first("CONTROL_TERMINATION")
    if termination is None:
        return ""
    for each in found:
        if each.series.time.size < FEWEST:
            return f"{each.series.file} has only {each.series.time.size} states"
        begin, end = float(each.series.time[0]), float(each.series.time[-1])
        if begin > LATE * each.source.interval:
            return f"{each.series.file} begins at t = {begin:.7g}"
        if end < termination.endtim - LATE * each.source.interval:
            return f"{each.series.file} ends at t = {end:.7g}, the deck at {termination.endtim:.7g}"
    return ""


def _names(files: Iterable[Path]) -> str:
    return ", ".join(dict.fromkeys(path.name for path in files))
