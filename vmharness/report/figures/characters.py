"""Units and powers of ten as plain text, which is faster to draw than formulas."""

import re

from vmharness.formula import Unit

SUPERSCRIPTS = str.maketrans("-−0123456789", "⁻⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def unit(text: str) -> str:
    """A unit with raised exponents.

    >>> unit("lbf-s2/in")
    'lbf·s²/in'
    """
    return re.sub(r"<sup>(.*?)</sup>", lambda raised: raised[1].translate(SUPERSCRIPTS), Unit(text).html())


def ten_to(power: int) -> str:
    """A power of ten, nothing for one.

    >>> ten_to(-6), ten_to(0)
    ('10⁻⁶', '')
    """
    return f"10{str(power).translate(SUPERSCRIPTS)}" if power else ""
