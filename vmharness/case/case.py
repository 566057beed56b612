"""A case: its file, its data and the theory evaluated for them."""

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from vmharness.case.decode import FILE
from vmharness.case.digest import inputs
from vmharness.case.error import CaseError
from vmharness.case.format import CaseFile, Published, Result
from vmharness.case.template import MOST, SUFFIX, render
from vmharness.formula import Dimension, Formula, FormulaError, UnitSystem

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Case:
    """A verification case with one set of data; all numbers are in its consistent units.

    The theory uses the data of the case, never those of the deck, so that a wrong deck fails.
    """

    id: str
    folder: Path
    file: CaseFile
    units: UnitSystem
    given: Mapping[str, float]
    formulas: Mapping[str, Formula]  # by name: theory, curves as "curve z", targets as "target z_peak", ...
    dimensions: Mapping[str, Dimension]  # of data and theory
    theory: Mapping[str, float]
    changed: frozenset[str] = frozenset()  # data that are not those of the file
    overrides: dict[str, float] = field(default_factory=dict)  # parameters of the deck in place of the case's
    mesh_overrides: dict[str, float] = field(
        default_factory=dict
    )  # mesh parameters of its template, likewise
    deck_text: str = ""  # a complete deck to run in place of that of the folder
    _evaluated: dict[str, float] = field(default_factory=dict, init=False, repr=False, compare=False)

    @property
    def values(self) -> dict[str, float]:
        """Data and theory together, by name."""
        return {**self.given, **self.theory}

    @property
    def deck_path(self) -> Path:
        """The path of the deck, or of its template, in the folder."""
        return self.folder / self.file.deck.file

    @property
    def deck_name(self) -> str:
        """The name of the deck that runs, without the suffix of a template."""
        return self.file.deck.file.removesuffix(SUFFIX)

    @property
    def input_files(self) -> list[str]:
        """Names of the other input files: further files, a template, case.toml."""
        template = [] if self.deck_name == self.file.deck.file else [self.file.deck.file]
        return [*self.file.files, *template, "case.toml"]

    def deck_source(self, most: float = MOST) -> str:
        """The deck that runs in place of that of the folder: one that was set, or rendered from a template; else "".

        Raises CaseError if the template is wrong, or makes a deck of more than `most` characters.
        """
        if self.deck_text or not self.file.deck.file.endswith(SUFFIX):
            return self.deck_text
        return self._rendered if most == MOST else render(self.deck_path, self.mesh_parameters(), most)

    @cached_property
    def _rendered(self) -> str:
        """The deck that the template makes."""
        return render(self.deck_path, self.mesh_parameters())

    @property
    def sha256(self) -> str:
        """Hash of case.toml."""
        return hashlib.sha256((self.folder / FILE).read_bytes()).hexdigest()

    @property
    def inputs_sha256(self) -> str:
        """Hash of all files of the folder except prose and pictures."""
        return inputs(self.folder)

    @property
    def published(self) -> list[Published]:
        """Published columns; none for other data than those of the file."""
        return [] if self.changed else self.file.published

    def datum(self, name: str) -> float:
        """A given datum in its own unit; a changed one to 15 digits."""
        given = self.file.given[name]
        if name not in self.changed:
            return given.value
        return float(f"{self.given[name] / self.units.factor(given.unit):.15g}")

    def result(self, key: str) -> Result:
        """The result with the key `key`."""
        return next(result for result in self.file.results if result.key == key)

    def target(self, key: str) -> float:
        """The target of the result `key`, by theory."""
        return self.evaluate(f"target {key}")

    def curve(self, name: str, t: Array) -> Array:
        """Theory of the channel `name` at the times `t` (m,)."""
        values = self.formulas[f"curve {name}"].evaluate({**self.values, "t": t})
        return np.broadcast_to(np.asarray(values, float), t.shape)

    def evaluate(self, name: str) -> float:
        """The value of the formula `name`, evaluated once; raises CaseError if it has none for these data."""
        if name not in self._evaluated:
            try:
                self._evaluated[name] = float(self.formulas[name].evaluate(self.values))
            except FormulaError as error:
                raise CaseError(f"{self.id}: {name}: {error}") from None
        return self._evaluated[name]

    def with_given(self, changes: Mapping[str, float]) -> "Case":
        """The case with other data: theory and parameters of the deck follow."""
        for name in changes:
            self.check_can_be_set(name)
        given = {**self.given, **changes}
        theory = evaluate_theory(self.id, self.file, given, self.formulas)
        changed = self.changed | {name for name in changes if changes[name] != self.given[name]}
        return replace(self, given=given, theory=theory, changed=changed)

    def check_can_be_set(self, datum: str) -> None:
        """Raise CaseError if there is no such datum, or nothing in the deck depends on it."""
        if datum not in self.given:
            raise CaseError(f"{self.id}: no given datum {datum}; there are: {', '.join(self.given)}")
        if not self.moves_deck(datum):
            raise CaseError(f"{self.id}: {datum} cannot be set: nothing in the deck depends on it")

    def deck_parameters(self) -> dict[str, float]:
        """All parameters of the deck if data were changed; only `overrides` if not.

        All of them, so that the deck keeps no rounded number of the file when the theory has other data.
        """
        if self.deck_text:
            return {}
        if not self.changed:
            return dict(self.overrides)
        return {
            name: self.evaluate(f"parameter {name}") for name in self.file.deck.parameters
        } | self.overrides

    def mesh_parameters(self) -> dict[str, float]:
        """The mesh parameters of the template; none without a template."""
        return {name: self.evaluate(f"mesh {name}") for name in self.file.deck.mesh} | self.mesh_overrides

    def with_deck_of(self, changes: Mapping[str, float]) -> "Case":
        """The case with the deck of other data but its own theory: a fault on purpose."""
        other = self.with_given(changes)
        return replace(self, overrides=other.deck_parameters(), mesh_overrides=other.mesh_parameters())

    def with_deck(self, text: str) -> "Case":
        """The case with the complete deck `text` in place of its own."""
        return replace(self, deck_text=text)

    def moves_deck(self, datum: str) -> bool:
        """Whether a parameter of the deck depends on a given datum, so that the datum can be set."""
        follow = [f"parameter {name}" for name in self.file.deck.parameters]
        follow += [f"mesh {name}" for name in self.file.deck.mesh]
        return any(datum in self.origins(name) for name in follow)

    def origins(self, formula: str) -> frozenset[str]:
        """The given data on which a formula depends, directly or through the theory."""
        return frozenset[str]().union(*(self._origins[name] for name in self.formulas[formula].names))

    @cached_property
    def _origins(self) -> dict[str, frozenset[str]]:
        """The given data on which each datum and each line of the theory depends; a line uses lines above it only."""
        found = {name: frozenset({name}) for name in self.given}
        for line in self.file.theory:
            found[line] = frozenset[str]().union(*(found[name] for name in self.formulas[line].names))
        return found


def evaluate_theory(
    case: str, file: CaseFile, given: Mapping[str, float], formulas: Mapping[str, Formula]
) -> dict[str, float]:
    """Evaluate the lines of the theory in order; raises CaseError with the line that has no value."""
    values = dict(given)
    for name in file.theory:
        try:
            values[name] = float(formulas[name].evaluate(values))
        except FormulaError as error:
            raise CaseError(f"{case}: [theory] {name}: {error}") from None
    return {name: values[name] for name in file.theory}
