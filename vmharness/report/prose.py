"""Prose of a case: the sections of its README.md, as Markdown and as HTML."""

import base64
import re
from pathlib import Path

from vmharness.case import Case

FILE = "README.md"
KIND = "image/svg+xml"
_IMAGE = re.compile(r"!\[[^\]]*\]\(([^)\s]+)[^)]*\)")


def sections(case: Case) -> dict[str, str]:
    """Markdown of each section by title, in order; the text before the first `## ` is left out."""
    path = case.folder / FILE
    text = path.read_text(encoding="utf-8") if path.is_file() else ""
    parts = re.split(r"^## +(.+?)\s*$", text, flags=re.MULTILINE)
    return {title: body.strip() for title, body in zip(parts[1::2], parts[2::2], strict=True)}


def pictures(case: Case) -> dict[str, Path]:
    """The drawings (SVG) in the case folder that the prose shows, by name."""
    return {
        name: case.folder / name
        for name in _named(case)
        if Path(name).name == name and name.endswith(".svg") and (case.folder / name).is_file()
    }


def review(case: Case) -> list[str]:
    """Sentences on missing prose and drawings."""
    if not (case.folder / FILE).is_file():
        return [f"{FILE}: there is no such file in the case's folder"]
    found = pictures(case)
    return [
        f"{FILE}: {name}: no drawing (.svg) in the case's folder"
        for name in _named(case)
        if name not in found
    ]


def _named(case: Case) -> list[str]:
    """Names of the images in the prose."""
    return sorted({name for body in sections(case).values() for name in _IMAGE.findall(body)})


def html(markdown: str, found: dict[str, Path]) -> str:
    """HTML of a section; drawings are embedded as images, in which scripts cannot run."""
    from markdown_it import MarkdownIt

    parser = MarkdownIt("commonmark", {"html": False}).enable("table")
    text = str(parser.render(markdown))
    return re.sub(
        r'<p><img src="([^"]*)" alt="([^"]*)" /></p>', lambda tag: _figure(tag[1], tag[2], found), text
    )


def _figure(name: str, caption: str, found: dict[str, Path]) -> str:
    if name not in found:
        return f"<p>{caption}</p>"
    source = data_link(found[name].read_bytes(), KIND)
    return f'<figure><img src="{source}" alt="{caption}"><figcaption>{caption}</figcaption></figure>'


def data_link(content: bytes, kind: str) -> str:
    """The content of a file as a data link, which needs no other file."""
    return f"data:{kind};base64,{base64.b64encode(content).decode('ascii')}"
