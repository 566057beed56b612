"""A fault of the solver or of the reading of its results: one text of one module, and the faulty text in its place."""

import hashlib
from dataclasses import dataclass


class PlantError(Exception):
    """A fault that cannot be planted: it is unknown, its text is no longer there, or its module is imported."""


@dataclass(frozen=True)
class SolverFault:
    """A fault: its module, the sound text and the faulty text."""

    name: str  # that the records of studies refer to
    text: str  # what is wrong, in words
    kind: str  # physics, integration, or reading
    module: str
    sound: str
    faulty: str
    keywords: tuple[str, ...] = ()  # a deck without a keyword that begins with one of these cannot show it

    @property
    def digest(self) -> str:
        """Name and hash, which differ from those of every other fault and of an earlier form of this one."""
        content = "\0".join((self.name, self.module, self.sound, self.faulty))
        return f"{self.name}-{hashlib.sha256(content.encode()).hexdigest()[:16]}"

    def planted(self, source: str) -> str:
        """The `source` of its module with the fault in it; PlantError unless the sound text is there just once."""
        if (found := source.count(self.sound)) != 1:
            times = f"{found} times" if found else "nowhere"
            raise PlantError(
                f"{self.name}: {self.sound!r} stands {times} in {self.module}: bring the fault up to date"
            )
        return source.replace(self.sound, self.faulty)
