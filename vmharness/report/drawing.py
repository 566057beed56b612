"""Drawings of a case (SVG): checked before a page shows them."""

import re
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

ACTIVE = {"script", "foreignObject", "iframe", "object", "embed", "handler", "listener", "set", "animate"}
_OWN = re.compile(r"#|data:image/(?:png|jpeg|gif|webp)[;,]")  # what is within the drawing
_DECLARED = re.compile(r"<!ENTITY|<\?xml-stylesheet", re.IGNORECASE)
_OUTSIDE = re.compile(r"@import|url\(\s*[\"']?(?!#|data:image/(?:png|jpeg|gif|webp)[;,])[^)]*", re.IGNORECASE)


def fault(path: Path) -> str:
    """Why a page cannot show a drawing: it is no SVG, has a script, or asks for another file; "" if it can."""
    try:
        text = path.read_text(encoding="utf-8")
        if declared := _DECLARED.search(text):
            return f"has {declared[0]}, which a drawing of a page cannot have"
        root = ElementTree.fromstring(text)
    except OSError as error:
        return f"cannot be read: {error.strerror or error}"
    except UnicodeDecodeError:
        return "is not UTF-8"
    except ElementTree.ParseError as error:
        return f"is not an SVG drawing: {error}"
    if _local(root.tag) != "svg":
        return f"is not an SVG drawing: it begins with <{_local(root.tag)}>"
    return next(_faults(root), "")


def _faults(root: ElementTree.Element) -> Iterator[str]:
    for element in root.iter():
        tag = _local(element.tag)
        if tag in ACTIVE:
            yield f"has <{tag}>: a drawing of a page cannot have scripts or animations"
        if _OUTSIDE.search(element.text or "") and tag == "style":
            yield "has a style that asks for another file"
        for name, value in element.attrib.items():
            yield from _attribute_faults(tag, _local(name), value)


def _attribute_faults(tag: str, name: str, value: str) -> Iterator[str]:
    if name.lower().startswith("on"):
        yield f"has <{tag} {name}>: a drawing of a page cannot have scripts or animations"
    if name in ("href", "src") and not _OWN.match(value.strip()):
        yield f"has <{tag} {name}>, which leads out of the drawing"
    if _OUTSIDE.search(value):
        yield f"has <{tag} {name}>, which asks for another file"


def _local(name: str) -> str:
    """A name of XML without its namespace."""
    return name.rpartition("}")[2]
