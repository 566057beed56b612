"""Checks of case.toml, entry by entry: each entry may use only names above it; formulas and dimensions are kept."""

import re
from collections.abc import Iterable, Mapping
from decimal import Decimal
from pathlib import Path

from vmharness.case.decode import FILE
from vmharness.case.error import CaseError, near
from vmharness.case.format import ELEMENTS, EVENTS, OWNERS, CaseFile, Event, Result, as_line
from vmharness.case.settings import CHANGE, HOW
from vmharness.case.tautology import tautology
from vmharness.case.template import SUFFIX
from vmharness.formula import Dimension, Formula, FormulaError, Unit, UnitError, UnitSystem

DIGITS = 17  # of a published number: more than doubles have
NUMBER = r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?"


class Checks:
    """Checks of all tables in their order, and the formulas and dimensions found in them."""

    def __init__(self, folder: Path, file: CaseFile, units: UnitSystem) -> None:
        self.folder, self.file, self.units = folder, file, units
        self.values: dict[str, float] = {}
        self.formulas: dict[str, Formula] = {}
        self.dimensions: dict[str, Dimension] = {}
        self.keys: list[str] = []

    def all(self) -> None:
        """Raise CaseError for the first error."""
        self.given()
        self.theory()
        self.channels()
        self.events()
        self.results()
        self.curves()
        self.parameters()
        self.files()
        self.budget()
        self.published()
        self.faults()

    def wrong(self, place: str, what: object) -> CaseError:
        return CaseError(f"{self.folder.name}/{FILE}: {place}: {what}")

    def unit(self, place: str, text: str, dimension: Dimension | None = None) -> Unit:
        try:
            unit = Unit(text)
        except UnitError as error:
            raise self.wrong(place, error) from None
        if dimension is not None and unit.dimension != dimension:
            is_ = self.units.name(dimension) or "a plain number"
            raise self.wrong(place, f"unit {text or 'none'} does not fit: the formula is in {is_}")
        return unit

    def formula(
        self, place: str, name: str, text: str, extra: Mapping[str, Dimension] | None = None
    ) -> Dimension:
        """Parse a formula, check its units, and keep it as `name`."""
        known = {**self.dimensions, **extra} if extra else self.dimensions
        try:
            formula = Formula(text)
            for free in sorted(formula.names - known.keys()):
                raise self.wrong(place, f"{free} is not defined here{near(free, known)}")
            dimension = formula.dimension(known)
        except FormulaError as error:
            raise self.wrong(place, error) from None
        self.formulas[name] = formula
        return dimension

    def known(self, place: str, name: str, table: Iterable[str], what: str) -> None:
        if name not in table:
            raise self.wrong(place, f"there is no {what} {name}{near(name, table)}")

    def given(self) -> None:
        for name, given in self.file.given.items():
            self._define(f"[given] {name}", name)
            unit = self.unit(f"[given] {name}", given.unit)
            self.values[name] = given.value * self.units.factor(unit)
            self.dimensions[name] = unit.dimension

    def theory(self) -> None:
        for name, line in self.file.theory.items():
            place = f"[theory] {name}"
            self._define(place, name)
            dimension = self.formula(place, name, as_line(line).formula)
            if (unit := as_line(line).unit) is not None:
                self.unit(place, unit, dimension)
            self.dimensions[name] = dimension

    def _define(self, place: str, name: str) -> None:
        if name in self.dimensions:
            raise self.wrong(place, "defined twice")
        if name == "t":
            raise self.wrong(place, "t is the time of curves; choose another name")

    def channels(self) -> None:
        for name, channel in self.file.channels.items():
            place = f"[channels] {name}"
            if name == "time":
                raise self.wrong(place, "the channel time always exists; choose another name")
            of = [key for key in OWNERS if getattr(channel, key) is not None]
            if len(of) != 1 and of != ["node", "contact"]:
                raise self.wrong(place, f"needs just one of {', '.join(OWNERS)}")
            if channel.part is not None and of != ["energy"]:
                raise self.wrong(place, "part is allowed with energy only")
            if channel.point is not None and of[0] not in ELEMENTS:
                raise self.wrong(place, "point is allowed with an element only")
            if (channel.component is None) != (of == ["energy"]):
                raise self.wrong(place, "needs a component, such as z-displacement, unless it is an energy")

    def events(self) -> None:
        for name, event in self.file.events.items():
            self._event(f"[events] {name}", name, event)

    def _event(self, place: str, name: str, event: Event) -> None:
        kinds = [kind for kind in EVENTS if getattr(event, kind) is not None]
        if len(kinds) != 1:
            raise self.wrong(place, f"needs just one of {', '.join(EVENTS)}")
        if event.at is not None:
            dimension = self.formula(place, f"at {name}", event.at)
            if dimension != Unit(self.file.units.time).dimension:
                raise self.wrong(
                    place,
                    f"at = {event.at}: a time is expected, but the unit is {self.units.name(dimension)}",
                )
        else:
            self.known(place, getattr(event, kinds[0]), self.file.channels, "channel")
        crossing = kinds == ["crossing_of"]
        if crossing != (event.level is not None) or crossing != (event.direction is not None):
            raise self.wrong(
                place, "level and direction belong to crossing_of: give both with it, and neither without it"
            )
        if event.level is not None:
            self.formula(place, f"level {name}", event.level)
        if event.pick > event.times:
            raise self.wrong(place, f"pick = {event.pick}, but the event happens only {event.times} times")

    def results(self) -> None:
        for number, result in enumerate(self.file.results, 1):
            place = f"[results] {number}"
            if result.key in self.keys:
                raise self.wrong(place, f"key {result.key} is used twice")
            self.keys.append(result.key)
            self.known(place, result.event, self.file.events, "event")
            self.known(place, result.channel, ["time", *self.file.channels], "channel")
            self._can_disagree(place, result)
            dimension = self.formula(f"{place}: target", f"target {result.key}", result.target)
            self.unit(place, result.unit, dimension)
            if result.tolerance.relative == result.tolerance.absolute == 0.0:
                raise self.wrong(place, "the tolerance is zero: give relative or absolute")

    def _can_disagree(self, place: str, result: Result) -> None:
        """The event must not give the value of the result."""
        event = self.file.events[result.event]
        if result.channel == "time" and event.at is not None:
            raise self.wrong(place, f"the time of {result.event} is given, so it cannot be a result")
        seen, read = self.file.channels.get(event.of), self.file.channels.get(result.channel)
        if seen is not None and read is not None and (why := tautology(event, seen, read)):
            place = f"{place}: {result.channel} at {result.event} ({event.of})"
            raise self.wrong(place, f"{why}: this result cannot disagree with its target")

    def curves(self) -> None:
        time = Unit(self.file.units.time).dimension
        for name, curve in self.file.curves.items():
            line, place = as_line(curve), f"[curves] {name}"
            self.known(place, name, self.file.channels, "channel")
            dimension = self.formula(place, f"curve {name}", line.formula, {"t": time})
            if line.unit is not None:
                self.unit(place, line.unit, dimension)

    def parameters(self) -> None:
        for name, text in self.file.deck.parameters.items():
            self.formula(f"[deck.parameters] {name}", f"parameter {name}", text)
        for name, text in self.file.deck.mesh.items():
            self.formula(f"[deck.mesh] {name}", f"mesh {name}", text)
        for name in self.file.deck.rounded:
            self.known("[deck.rounded]", name, self.file.deck.parameters, "parameter")
        if self.file.deck.mesh and not self.file.deck.file.endswith(SUFFIX):
            raise self.wrong(
                "[deck.mesh]", f"only a template, such as deck.k{SUFFIX}, can have mesh parameters"
            )

    def files(self) -> None:
        for name in [self.file.deck.file, *self.file.files]:
            if not (self.folder / name).resolve().is_relative_to(self.folder.resolve()):
                raise self.wrong(name, "lies outside the case's folder")
            if not (self.folder / name).is_file():
                raise self.wrong(name, "there is no such file in the case's folder")

    def budget(self) -> None:
        for number, line in enumerate(self.file.budget, 1):
            for key, value in line.relative.items():
                place = f"[budget] {number}: {key}"
                self.known(place, key, self.keys, "result")
                self.unit(place, "", self.formula(place, f"budget {number} {key}", str(value)))

    def published(self) -> None:
        for number, column in enumerate(self.file.published, 1):
            for key in [*column.values, *column.errors_percent, *column.exactly_at]:
                self.known(f"[published] {number}", key, self.keys, "result")
            for key, text in column.values.items():
                if not re.fullmatch(NUMBER, text):
                    raise self.wrong(f"[published] {number}", f"{key} = {text!r} is not a number")
                if not _can_be_compared(text):
                    what = f"{key} = {text}: at most {DIGITS} digits and a size from 1e-300 to 1e300 can be compared"
                    raise self.wrong(f"[published] {number}", what)

    def faults(self) -> None:
        for number, fault in enumerate(self.file.faults, 1):
            place = f"[faults] {number}"
            for name, change in fault.change.items():
                self.known(place, name, self.file.given, "given datum")
                if not re.fullmatch(CHANGE, change):
                    raise self.wrong(place, f'{name} = "{change}": {HOW}')
            for key in fault.must_fail:
                self.known(place, key, self.keys, "result")


def _can_be_compared(text: str) -> bool:
    """Whether a number that is written so is a double, with no more digits than one has."""
    number = Decimal(text)
    return not number or (len(number.as_tuple().digits) <= DIGITS and -300 <= number.adjusted() <= 300)
