"""Prose of a case: the sections of its README.md, as Markdown and as HTML.

A page shows drawings of the folder and links to the web. A block of the prose with anything else (HTML, other links) is
shown line by line as it is written.
"""

import base64
import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import unquote

from vmharness.case import Case
from vmharness.case.prose import FILE, read_prose
from vmharness.report import drawing
from vmharness.report.escape import markdown, printable

if TYPE_CHECKING:
    from markdown_it import MarkdownIt
    from markdown_it.token import Token

KIND = "image/svg+xml"
_WEB = re.compile(r"https?://|mailto:|#")
_TAG = r'<img src="([^"]*)" alt="([^"]*)"[^>]*>'


def sections(case: Case) -> dict[str, str]:
    """Markdown of each section by title, in order; the text before the first heading of level 2 is left out."""
    found: dict[str, list[str]] = {}
    title = None
    drawn = pictures(case)
    for tokens, source in _blocks(read_prose(case.folder)):
        if tokens and tokens[0].type == "heading_open" and tokens[0].tag == "h2":
            title = tokens[1].content
            found.setdefault(title, [])
        elif title is not None:
            found[title].append(_shown(tokens, source, drawn))
    return {title: _whole("\n".join(parts).strip()) for title, parts in found.items()}


def _whole(body: str) -> str:
    """The body of a section; as code where it has, without the other sections, what a page cannot show."""
    return as_written(body) if any(why for tokens, _ in _blocks(body) for why in _faults(tokens)) else body


def pictures(case: Case) -> dict[str, Path]:
    """The drawings (SVG) in the case folder that the prose shows, by name."""
    names = sorted({name for tokens, _ in _blocks(read_prose(case.folder)) for name in _images(tokens)})
    return {name: case.folder / name for name in names if not _not_shown(case.folder, name)}


def review(case: Case) -> list[str]:
    """Sentences on missing prose, and on whatever in it a page cannot show."""
    if not (case.folder / FILE).is_file():
        return [f"{FILE}: there is no such file in the case's folder"]
    drawn = pictures(case)
    wrong = []
    for tokens, _ in _blocks(read_prose(case.folder)):
        wrong += [f"{name}: {_not_shown(case.folder, name)}" for name in _images(tokens) if name not in drawn]
        wrong += [f"{why}; a page shows this block as it is written" for why in _faults(tokens)]
    return [f"{FILE}: {sentence}" for sentence in dict.fromkeys(wrong)]


def _not_shown(folder: Path, name: str) -> str:
    """Why an image of the prose is not shown; "" if it is."""
    if Path(name).name != name or not name.endswith(".svg") or not (folder / name).is_file():
        return "no drawing (.svg) in the case's folder"
    return drawing.fault(folder / name)


def _shown(tokens: "Sequence[Token]", source: str, drawn: Mapping[str, Path]) -> str:
    """The source of a block, or what a page shows in its place."""
    lost = [name for name in _images(tokens) if name not in drawn]
    if not lost and not any(_faults(tokens)):
        return source
    inline = [token for token in tokens if token.type == "inline"]
    if tokens[0].type == "paragraph_open" and [child.type for child in inline[0].children or ()] == ["image"]:
        return f"*{markdown(inline[0].children[0].content)}* (this drawing cannot be shown)\n"  # type: ignore[index]
    return as_written(source)


def as_written(source: str) -> str:
    """Markdown that shows the lines of a source as they are written."""
    paragraphs = re.split(r"\n\s*\n", source.strip())
    return "\n" + "\n\n".join("\\\n".join(map(markdown, text.split("\n"))) for text in paragraphs) + "\n"


def _blocks(text: str) -> "Iterator[tuple[list[Token], str]]":
    """The blocks of a Markdown text: their tokens and their source, with the lines up to the next block."""
    text = printable(text.replace("\r\n", "\n").replace("\r", "\n")).rstrip("\n") + "\n"
    lines = text.split("\n")
    tokens = _parser().parse(text)
    starts = [i for i, token in enumerate(tokens) if token.level == 0 and token.nesting >= 0]
    for start, end in pairwise([*starts, len(tokens)]):
        first = (tokens[start].map or [0, 0])[0]
        last = (tokens[end].map or [0, 0])[0] if end < len(tokens) else len(lines)
        yield tokens[start:end], "\n".join(lines[first:last])


def _faults(tokens: "Sequence[Token]") -> Iterator[str]:
    """What a page cannot show of a block, images aside."""
    for token in _all(tokens):
        if token.type in ("html_block", "html_inline"):
            yield f"{' '.join(token.content.split())[:40]}: HTML is not allowed"
        if token.type == "link_open" and not _WEB.match(str(token.attrs["href"])):
            yield f"{token.attrs['href']}: only links to the web are allowed"
        if token.type == "fence" and token.level == 0 and not _closed(token):
            yield "a block of code that begins with ``` has no end"


def _closed(fence: "Token") -> bool:
    """Whether the lines of a block of code are its content and two fences."""
    first, last = fence.map or (0, 0)
    return last - first == fence.content.count("\n") + 2


def _images(tokens: "Sequence[Token]") -> list[str]:
    """Names of the images of a block."""
    return [unquote(str(token.attrs["src"])) for token in _all(tokens) if token.type == "image"]


def _all(tokens: "Sequence[Token]") -> "Iterator[Token]":
    for token in tokens:
        yield token
        yield from _all(token.children or ())


@cache
def _parser() -> "MarkdownIt":
    """A parser that finds every link and all HTML, so that nothing of them passes unseen."""
    from markdown_it import MarkdownIt

    parser = MarkdownIt("commonmark", {"html": True}).enable("table")
    parser.validateLink = lambda url: True  # type: ignore[method-assign]
    return parser


def html(text: str, found: Mapping[str, Path]) -> str:
    """HTML of a section; drawings are embedded as images, in which scripts cannot run."""
    from markdown_it import MarkdownIt

    parser = MarkdownIt("commonmark", {"html": False}).enable("table")
    body = str(parser.render(text))
    body = re.sub(f"<p>{_TAG}</p>", lambda tag: _figure(tag[1], tag[2], found), body)
    return re.sub(_TAG, lambda tag: _image(tag[1], tag[2], found), body)


def _figure(name: str, caption: str, found: Mapping[str, Path]) -> str:
    if unquote(name) not in found:
        return f"<p>{caption}</p>"
    return f"<figure>{_image(name, caption, found)}<figcaption>{caption}</figcaption></figure>"


def _image(name: str, caption: str, found: Mapping[str, Path]) -> str:
    """An image; its caption without a file."""
    if unquote(name) not in found:
        return caption
    return f'<img alt="{caption}" src="{data_link(found[unquote(name)].read_bytes(), KIND)}">'


def data_link(content: bytes, kind: str) -> str:
    """The content of a file as a data link, which needs no other file."""
    return f"data:{kind};base64,{base64.b64encode(content).decode('ascii')}"
