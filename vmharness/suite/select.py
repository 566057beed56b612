"""Selection of cases by id, pattern, path, words and tags; only titles and tags are read."""

import difflib
import os
import tomllib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from pathlib import Path
from typing import TYPE_CHECKING

import vmharness
from vmharness.toml import text_of

if TYPE_CHECKING:
    from vmharness.case import Case

FILE = "case.toml"


class SelectError(ValueError):
    """A selection that is wrong."""


@dataclass(frozen=True)
class Entry:
    """A case folder, before it is read and checked."""

    folder: Path
    title: str = ""
    tags: tuple[str, ...] = ()

    @property
    def id(self) -> str:
        """The folder's name, as text."""
        return printable(self.folder.name)


def printable(name: str) -> str:
    r"""A name of a file or folder as text: what is not, for example bytes that are not UTF-8, as escapes.

    >>> print(printable("caf\udce9"), printable("VM-061"))
    caf\udce9 VM-061
    """
    return name if name.isprintable() else ascii(name)[1:-1]


def cases_folder(chosen: Path | None = None) -> Path:
    """The folder of the cases: `chosen`, else ./cases if there is one, else that of the package.

    A folder ./cases without a case is chosen, too: to run other cases in its place would pass what was never run.
    """
    if chosen is not None:
        if not chosen.is_dir():
            raise SelectError(f"no folder {chosen}")
        return chosen
    package = Path(vmharness.__file__).parent
    places = [Path("cases"), package / "cases", package.parent / "cases"]  # the last: installed with pip -e
    found = [place for place in places if place.is_dir()]
    if not found:
        raise SelectError("no folder cases here, and no cases installed; name a folder with --cases")
    return found[0]


def entries(folder: Path) -> list[Entry]:
    """The cases in a folder, by id."""
    found = (entry(path) for path in folder.iterdir() if os.path.lexists(path / FILE))
    return sorted(found, key=lambda found: found.id)


def entry(folder: Path) -> Entry:
    """Title and tags of a case; empty for a file that is not TOML, which is an error when the case is read."""
    try:
        table = tomllib.loads(text_of(folder / FILE))
    except (OSError, ValueError, RecursionError, MemoryError):
        table = {}
    tags = table.get("tags", ())
    known = tuple(map(str, tags)) if isinstance(tags, list) else ()
    return Entry(folder, str(table.get("title", "")), known)


def read_case(case: Entry) -> "Case":
    """Read and check a case; raises CaseError for whatever is wrong, so that it is the outcome of this case alone."""
    from vmharness.case import CaseError, read

    if case.id != case.folder.name:
        raise CaseError(f"{case.id}: the name of the folder is not text in UTF-8; rename it")
    try:
        return read(case.folder)
    except CaseError:
        raise
    except Exception as error:
        raise CaseError(f"{case.id}: cannot be read: {type(error).__name__}: {error}") from error


def select(
    folder: Path, selectors: Sequence[str], words: str = "", tags: Sequence[str] = ()
) -> tuple[list[Entry], dict[str, str]]:
    """The cases of any of `selectors` (all cases, without any) that match `words` and have all `tags`.

    Returns them, and for each selector that means no case a sentence that says so. Raises SelectError.
    """
    known = entries(folder)
    found: dict[Path, Entry] = {} if selectors else {case.folder: case for case in known}
    unknown = {}
    for selector in selectors:
        meant = _meant(selector, known)
        found.update((case.folder, case) for case in meant)
        if not meant:
            unknown[selector] = _no_case(selector, known)
    wanted = [case for case in found.values() if matches(words, case) and set(tags) <= set(case.tags)]
    _check_unique(wanted)
    return wanted, unknown


def matches(words: str, case: Entry) -> bool:
    """Whether id, title or tags contain the words of an expression: `impact and not shell or VM-061`.

    `not` binds strongest, then `and`, then `or`; upper and lower case are the same. Raises SelectError.

    >>> ball = Entry(Path("VM-061"), "Ball on a surface", ("contact",))
    >>> matches("ball and not shell", ball), matches("beam or contact", ball), matches("vm-062", ball)
    (True, True, False)
    """
    if not words.strip():
        return True
    text = " ".join([case.id, case.title, *case.tags]).lower()
    terms = [
        [_term(term, words) for term in _split(part, "and")] for part in _split(words.lower().split(), "or")
    ]
    return any(all((phrase in text) == wanted for phrase, wanted in part) for part in terms)


def _term(term: list[str], words: str) -> tuple[str, bool]:
    """The phrase of a term, and whether it is wanted or, with `not` before it, unwanted."""
    wanted = term[:1] != ["not"]
    phrase = term if wanted else term[1:]
    if not phrase or "not" in phrase:
        raise SelectError(f"-k {words!r}: write words with and, or, not between them")
    return " ".join(phrase), wanted


def _split(words: list[str], at: str) -> list[list[str]]:
    """The runs of words between the words `at`."""
    parts: list[list[str]] = [[]]
    for word in words:
        if word == at:
            parts.append([])
        else:
            parts[-1].append(word)
    return parts


def _meant(selector: str, known: Iterable[Entry]) -> list[Entry]:
    """By id, then by pattern, then by an id in other letters of case, then by path.

    The path comes last, so that a folder of the same name here does not hide a case.
    """
    known = list(known)
    found = (
        [case for case in known if case.id == selector]
        or [case for case in known if fnmatchcase(case.id, selector)]
        or [case for case in known if case.id.lower() == selector.lower()]
    )
    if not found and (Path(selector) / FILE).is_file():
        found = [entry(Path(selector).resolve())]
    return found


def _no_case(selector: str, known: Sequence[Entry]) -> str:
    by_lower = {case.id.lower(): case.id for case in known}
    near = [by_lower[name] for name in difflib.get_close_matches(selector.lower(), by_lower, n=3)]
    there = f"did you mean {' or '.join(near)}?" if near else "`vm list` shows those that there are"
    return f"no case {selector}; {there}"


def _check_unique(cases: Sequence[Entry]) -> None:
    """Two cases of one id would write each other's report."""
    seen: dict[str, Path] = {}
    for case in cases:
        if case.id in seen:
            raise SelectError(f"two cases are called {case.id}: {seen[case.id]} and {case.folder}")
        seen[case.id] = case.folder
