"""Of which case and by what the record of a study was made, and whether it would be made so again."""

from dataclasses import dataclass
from pathlib import Path

import msgspec

from vmharness.studies.maker import Maker

DIGITS = 8  # of a hash, where a reader is to tell two apart


@dataclass(frozen=True)
class Stamp:
    """What every record says, whichever study left it."""

    case_sha256: str | None = None  # of the inputs of the case
    made_by: Maker | None = None

    @property
    def says(self) -> str:
        """What made it, as a sentence.

        >>> Stamp(made_by=Maker("vmharness 0.1.0", "3f2a9c1d" + 56 * "0")).says
        'Made by vmharness 0.1.0, sources 3f2a9c1d.'
        """
        if self.made_by is None:
            return "What made it is not recorded."
        return f"Made by {self.made_by.solver or 'no solver'}, sources {self.made_by.sources[:DIGITS]}."


def stale(studies: Path, case_sha256: str, sources: str) -> list[str]:
    """Of the records in a folder those that are not of this case and of these `sources`: a sentence for each reason.

    `case_sha256` is of the inputs of the case.
    """
    found: dict[str, list[str]] = {}
    for path in sorted(studies.glob("*.json")):
        for reason in _reasons(path, case_sha256, sources):
            found.setdefault(reason, []).append(path.stem)
    return [f"study {', '.join(names)}: {reason}" for reason, names in found.items()]


def _reasons(path: Path, case_sha256: str, sources: str) -> list[str]:
    try:
        stamp = msgspec.json.decode(path.read_bytes(), type=Stamp)
    except (OSError, msgspec.MsgspecError):
        return ["the record cannot be read"]
    reasons = [] if stamp.case_sha256 == case_sha256 else ["the case was changed after it"]
    if stamp.made_by is None:
        reasons.append("what made it is not recorded")
    elif stamp.made_by.sources != sources:
        made, now = stamp.made_by.sources[:DIGITS], sources[:DIGITS]
        reasons.append(f"made by sources {made}, which are now {now}")
    return reasons
