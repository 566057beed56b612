"""A matplotlib figure to SVG text that is the same wherever and whenever it is drawn."""

import io
import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STYLE = {
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
    "svg.fonttype": "none",  # text stays text: searchable, and no outline depends on a font's version
}
METADATA = dict.fromkeys(["Date", "Creator", "Format", "Type"])


def text(figure: "Figure", name: str, description: str) -> str:
    """The figure as an <svg> element, described for those who do not see it.

    Identifiers follow from `name` and what is drawn, so that several figures can share a page.
    """
    import matplotlib

    buffer = io.StringIO()
    with matplotlib.rc_context({**STYLE, "svg.hashsalt": name}):
        figure.savefig(buffer, format="svg", metadata=METADATA)
    drawn = buffer.getvalue()
    drawn = drawn[drawn.index("<svg") :]
    drawn = re.sub(r" *<metadata>.*?</metadata>\n", "", drawn, flags=re.DOTALL)
    drawn = re.sub(r'<g id="[a-z]+[\w.]*_\d+">', "<g>", drawn)  # groups that nothing refers to
    drawn = re.sub(r"<!--.*?-->\n?", "", drawn, flags=re.DOTALL)
    drawn = re.sub(r"[ \t]+\n", "\n", drawn)
    return drawn.replace("<svg ", f'<svg role="img" aria-label="{_attribute(description)}" ', 1)


def _attribute(value: str) -> str:
    for character, entity in (("&", "&amp;"), ("<", "&lt;"), ('"', "&quot;")):
        value = value.replace(character, entity)
    return value
