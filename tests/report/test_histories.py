"""Histories drawn: no text lies on another, whatever the names and the sizes."""

import re
from dataclasses import replace
from itertools import combinations

import pytest

from vmharness.report.figures import histories
from vmharness.report.figures.curves import curves

LONG = ["Displacement of the front end", "Displacement of the free end", "Velocity of the centre of mass"]
TEXT = r'font-size: (\d+)px.*?text-anchor: (\w+).*? x="([-\d.]+)" y="([-\d.]+)"[^>]*>([^<]*)<'
LETTER = 0.5  # width of one, in sizes: as DejaVu Sans has it on average


@pytest.fixture
def together(good):
    """Three curves in one figure, whose key names each."""
    return next(found for found in curves(good) if len(found) == 3)


def boxes(drawn):
    """(left, right, top, bottom, content) of every line of text, in points."""
    found = []
    for size, anchor, x, y, content in re.findall(TEXT, drawn):
        width, size = LETTER * float(size) * len(content), float(size)
        left = float(x) - {"start": 0.0, "middle": 0.5, "end": 1.0}[anchor] * width
        found.append((left, left + width, float(y) - 0.8 * size, float(y), content))
    return found


def collisions(drawn):
    return [
        (one[4], other[4])
        for one, other in combinations(boxes(drawn), 2)
        if one[0] < other[1] and other[0] < one[1] and one[2] < other[3] and other[2] < one[3]
    ]


def renamed(together, labels):
    return [replace(curve, label=label) for curve, label in zip(together, labels, strict=False)]


def scaled(together, factor):
    names = "computed", "theory", "residual"
    return [
        replace(curve, allowed={}, **{name: getattr(curve, name) * factor for name in names})
        for curve in together
    ]


@pytest.fixture
def plain(good, monkeypatch):
    """Channels that are no energies, whose names stand in the title."""
    monkeypatch.setattr(histories, "quantity", lambda run, some: histories.joined([c.label for c in some]))
    return good


@pytest.mark.parametrize("count", [2, 3])
def test_long_names_keep_clear_of_events_and_of_one_another(plain, together, count):
    assert not collisions(histories.draw(plain, "h", renamed(together, LONG[:count]), "vmharness"))


def test_names_too_long_for_a_line_are_of_two(plain, together):
    names = [f"{word} of a thing whose name is rather long" for word in ("Length", "Place", "Height")]
    drawn = histories.draw(plain, "h", renamed(together, names), "vmharness")
    assert not collisions(drawn)
    assert max(right for _, right, *_ in boxes(drawn)) < 6.6 * 72


@pytest.mark.parametrize(("factor", "power"), [(1e9, "10¹¹ "), (1e-9, "10⁻⁷ "), (1.0, "")])
def test_a_power_of_ten_stands_with_the_unit(good, together, factor, power):
    drawn = histories.draw(good, "h", scaled(together, factor), "vmharness")
    contents = [box[4] for box in boxes(drawn)]
    assert f"Energy ({power}lbf·in)" in contents
    assert not [content for content in contents if content.startswith("1e")]
    assert not collisions(drawn)


def test_the_measure_sees_a_collision():
    line = '<text style="font-size: 9px; text-anchor: start; fill: #000" x="{}" y="10">Time</text>'
    assert collisions(line.format(0) + line.format(10)) == [("Time", "Time")]
    assert collisions(line.format(0) + line.format(30)) == []
