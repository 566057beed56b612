"""Templates of the pages."""

from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from jinja2 import Environment


def render(template: str, filters: Mapping[str, Callable[..., str]], **context: Any) -> str:
    """Render a template with its context; `.html.j2` templates escape their values."""
    environment = _environment(template.partition(".")[2])
    environment.filters.update(filters)
    return environment.get_template(template).render(**context)


@cache
def _environment(kind: str) -> "Environment":
    """The environment of one kind of page, with its own filters; it keeps compiled templates."""
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    return Environment(
        loader=FileSystemLoader(Path(__file__).parent),
        autoescape=kind.startswith("html"),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
