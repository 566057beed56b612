"""Templates of the pages. Every value that a template prints is escaped for its kind of page, unless it says `safe`."""

from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from vmharness.report.escape import markdown, printable

if TYPE_CHECKING:
    from jinja2 import Environment


def render(template: str, filters: Mapping[str, Callable[..., str]], **context: Any) -> str:
    """Render a template with its context."""
    environment = _environment(template.partition(".")[2])
    environment.filters.update(filters)
    return printable(environment.get_template(template).render(**context))


@cache
def _environment(kind: str) -> "Environment":
    """The environment of one kind of page, with its own filters; it keeps compiled templates."""
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    return Environment(
        loader=FileSystemLoader(Path(__file__).parent),
        autoescape=True,
        finalize=_markdown if kind.startswith("md") else None,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )


def _markdown(value: Any) -> Any:
    """A printed value as Markdown; what is marked as safe is Markdown already, as is the text that a macro gives."""
    from markupsafe import Markup

    return value if hasattr(value, "__html__") else Markup(markdown(str(value)))
