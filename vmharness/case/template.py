"""Template of a deck: Jinja2 in a sandbox, which makes the mesh from mesh parameters."""

import math
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from vmharness.case.error import CaseError

SUFFIX = ".j2"


def render(path: Path, values: Mapping[str, float], most: float = math.inf) -> str:
    """The deck that the template makes of `values`; whole numbers become integers.

    Raises CaseError with the line for an error in the template or an undefined name, and if the deck has more than
    `most` characters.
    """
    from jinja2 import StrictUndefined, TemplateError, TemplateSyntaxError
    from jinja2.sandbox import SandboxedEnvironment

    environment = SandboxedEnvironment(
        undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True, keep_trailing_newline=True
    )
    place = f"{path.parent.name}/{path.name}"
    numbers = {name: int(value) if value.is_integer() else value for name, value in values.items()}
    try:
        pieces = environment.from_string(path.read_text(encoding="utf-8")).generate(numbers)
        return "".join(_up_to(most, pieces, place))
    except TemplateSyntaxError as error:
        raise CaseError(f"{place}:{error.lineno}: {error.message}") from None
    except (TemplateError, ArithmeticError, TypeError, ValueError) as error:
        raise CaseError(f"{place}: {error}") from None


def _up_to(most: float, pieces: Iterable[str], place: str) -> Iterator[str]:
    """The pieces of a text; raises CaseError once they have more than `most` characters together."""
    length = 0
    for piece in pieces:
        length += len(piece)
        if length > most:
            raise CaseError(f"{place}: the deck has more than {most:g} characters: its mesh is too fine")
        yield piece
