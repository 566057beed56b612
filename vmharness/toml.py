"""The text of a TOML file, as far as it can be parsed in bounded time."""

import re
from pathlib import Path

MOST = 10**6  # bytes
PARTS = 100  # of a key with dots: the time of the parser grows with the square of them
_KEY = re.compile(rf"""(?:(?:[\w-]+|"[^"\n]*"|'[^'\n]*')[ \t]*\.[ \t]*){{{PARTS}}}""")


class TomlError(ValueError):
    """A file that is not to be parsed, and why: `LINE: what is wrong`, or ` what is wrong` without a line."""


def text_of(path: Path) -> str:
    """The text of a file; raises OSError, and TomlError for what has no end, is too long, nested or not UTF-8."""
    if path.exists() and not path.is_file():
        raise TomlError(" not a file")
    if path.stat().st_size > MOST:
        raise TomlError(f" longer than {MOST} bytes")
    text = utf8(path.read_bytes())
    if deep := _KEY.search(text):
        line = text.count("\n", 0, deep.start()) + 1
        raise TomlError(f"{line}: a key of more than {PARTS} parts")
    return text


def utf8(content: bytes) -> str:
    """The text of a file; raises TomlError with the line that is not UTF-8."""
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        byte = f"0x{content[error.start]:02x}"
        raise TomlError(f"{line}: the byte {byte} is not UTF-8; save the file as UTF-8") from None
