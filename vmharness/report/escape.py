"""Texts of a case in Markdown: whatever they hold, a reader sees them as they are written."""

import re
from urllib.parse import quote

# Characters with a meaning in a line; an underscore within a word has none.
_IN_LINE = re.compile(r"[\\`*\[\]<|$~]|(?<![^\W_])_|_(?![^\W_])|&(?=#?\w+;)")
# What begins a heading, a quotation, a list, a line below a heading.
_AT_START = re.compile(r"[#>]|[-+](?=\s|$|-)|=|\d{1,9}(?=[.)](?:\s|$))")
_ENTITIES = {"<": "&lt;", "&": "&amp;"}
# Characters that are no text: XML does not allow them, and a terminal obeys them.
_CONTROL = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\ufffe\uffff\ud800-\udfff]")


def printable(text: str) -> str:
    r"""The text with a replacement character for each character that cannot be shown.

    >>> printable("a\x1bb")
    'a�b'
    """
    return _CONTROL.sub("\ufffd", text)


def markdown(text: str) -> str:
    r"""One line of Markdown that shows the text, in a paragraph, a list, a heading or the cell of a table.

    >>> print(markdown("<b> | *z_peak* [a](b)"), markdown("# 1"), markdown("2. -0.5"))
    &lt;b> \| \*z_peak\* \[a\](b) \# 1 2\. -0.5
    """
    line = " ".join(printable(text).split())
    line = _IN_LINE.sub(lambda found: _ENTITIES.get(found[0], "\\" + found[0]), line)
    begin = _AT_START.match(line)
    if begin is None:
        return line
    first, rest = line[: begin.end()], line[begin.end() :]
    return f"{first}\\{rest}" if first.isdigit() else f"\\{first}{rest}"


def code(text: str) -> str:
    """A line of Markdown that shows the text as code; not for tables, where a | would end the cell.

    >>> code("*TITLE: a name"), code("a `b` c")
    ('`*TITLE: a name`', '`` a `b` c ``')
    """
    line = " ".join(printable(text).split()) or " "
    if "`" not in line:
        return f"`{line}`"
    fence = "`" * (1 + max(map(len, re.findall("`+", line))))
    return f"{fence} {line} {fence}"


def link(path: str) -> str:
    """A relative path as the address of a link.

    >>> link("../a (1)/deck.k"), link("javascript:x")
    ('../a%20%281%29/deck.k', 'javascript%3Ax')
    """
    return quote(path, errors="replace")
