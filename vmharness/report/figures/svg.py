"""SVG text of a matplotlib figure, the same on every machine and in every run."""

import hashlib
import io
import re
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from vmharness.report.escape import printable

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STYLE: dict[Any, object] = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans", "Helvetica", "Arial"],
    "font.size": 9.0,
    "axes.edgecolor": "#5b6670",
    "axes.linewidth": 0.8,
    "axes.labelcolor": "#1b2733",
    "xtick.color": "#5b6670",
    "ytick.color": "#5b6670",
    "xtick.labelcolor": "#1b2733",
    "ytick.labelcolor": "#1b2733",
    "grid.color": "#e3e7ea",
    "grid.linewidth": 0.6,
    "axes.unicode_minus": True,
    "text.parse_math": False,  # a dollar in a label is a dollar
    "svg.fonttype": "none",  # text stays text: searchable, and no outline depends on a font's version
}
_TAG = re.compile(r"<[^<>]*>")
METADATA = dict.fromkeys(["Date", "Creator", "Format", "Type"])


@contextmanager
def style(name: str) -> Iterator[None]:
    """Context with the style of the figures; settings of the user have no effect.

    Identifiers follow from `name`, so that several figures can share a page.
    """
    import matplotlib

    with matplotlib.rc_context(), warnings.catch_warnings():
        # The drawing names its fonts; a browser has others for letters that these do not have.
        warnings.filterwarnings("ignore", message="Glyph .* missing from font")
        # matplotlib.rcdefaults() does the same, and imports 50 ms of style sheets first.
        defaults = {key: value for key, value in matplotlib.rcParamsDefault.items() if "backend" not in key}
        matplotlib.rcParams.update({**defaults, **STYLE, "svg.hashsalt": name})
        yield


def text(figure: "Figure", description: str) -> str:
    """The figure as an <svg> element with a description for screen readers."""
    from matplotlib import rcParams

    buffer = io.StringIO()
    figure.savefig(buffer, format="svg", metadata=METADATA)
    drawn = buffer.getvalue()
    drawn = drawn[drawn.index("<svg") :]
    drawn = re.sub(r" *<metadata>.*?</metadata>\n", "", drawn, flags=re.DOTALL)
    drawn = re.sub(r'<g id="[A-Za-z]+[\w.]*_\d+">', "<g>", drawn)  # groups that nothing refers to
    drawn = re.sub(r"<!--.*?-->\n?", "", drawn, flags=re.DOTALL)
    drawn = _TAG.sub(lambda tag: _rounded(tag[0]), drawn)
    drawn = re.sub(r"[ \t]+\n", "\n", drawn)
    drawn = _numbered(drawn, str(rcParams["svg.hashsalt"]))
    drawn = drawn.replace("<svg ", f'<svg role="img" aria-label="{_attribute(description)}" ', 1)
    return printable(drawn)


def _numbered(drawn: str, name: str) -> str:
    """The drawing with its identifiers numbered: matplotlib's are hashes of coordinates in all their digits."""
    prefix = f"i{hashlib.sha256(name.encode()).hexdigest()[:8]}"
    names = dict.fromkeys(found for tag in _TAG.findall(drawn) for found in re.findall(r' id="([^"]+)"', tag))
    new = {old: f"{prefix}-{number}" for number, old in enumerate(names, 1)}
    refer = re.compile(r'( id="|url\(#|href="#)([^")]+)')
    return _TAG.sub(lambda tag: refer.sub(lambda found: found[1] + new[found[2]], tag[0]), drawn)


def _rounded(tag: str) -> str:
    """A tag with its coordinates in hundredths of a point; of text in tenths, for versions of its font differ."""
    places = 1 if tag.startswith("<text") else 2
    return re.sub(r"-?\d+\.\d+", lambda number: f"{round(float(number[0]), places) + 0.0:g}", tag)


def _attribute(value: str) -> str:
    for character, entity in (("&", "&amp;"), ("<", "&lt;"), ('"', "&quot;")):
        value = value.replace(character, entity)
    return value
