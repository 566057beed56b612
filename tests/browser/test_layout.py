"""Pages on a telephone and on a desk: nothing is wider than the window, and formulas are drawn as formulas."""

import shutil
import subprocess

import pytest

WIDTHS = [390, 1200]
WIDER = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
# Formulas that must be scrolled.
CUT = "[...document.querySelectorAll('.theory')].filter(e => e.scrollWidth > e.clientWidth).length"
# Braces before several lines, and how high they are by these lines.
BRACES = """[...document.querySelectorAll('mo')].filter(e => e.textContent == '{' && e.nextElementSibling.tagName == 'mtable')
    .map(e => e.getBoundingClientRect().height / e.nextElementSibling.getBoundingClientRect().height)"""


def test_no_page_is_wider_than_its_window_and_no_formula_is_cut_on_a_desk(tab, pages):
    wider, cut = {}, {}
    for name, address in pages.items():
        tab.goto(address)
        for width in WIDTHS:
            tab.set_viewport_size({"width": width, "height": 900})
            wider[name, width] = tab.evaluate(WIDER)
        cut[name] = tab.evaluate(CUT)
    assert {where: pixels for where, pixels in wider.items() if pixels > 0} == {}
    assert {name: formulas for name, formulas in cut.items() if formulas} == {}


def test_what_is_wider_is_seen(tab):
    tab.set_viewport_size({"width": 390, "height": 900})
    tab.set_content(
        "<div class='theory' style='width: 500px; overflow: auto'><p style='width: 600px'>a</p></div>"
    )
    assert tab.evaluate(WIDER) > 0
    assert tab.evaluate(CUT) == 1


def test_a_brace_is_as_high_as_its_lines(tab, pages):
    fonts = (
        subprocess.run(["fc-list", ": family"], capture_output=True, text=True)
        if shutil.which("fc-list")
        else None
    )
    if fonts is None or "Math" not in fonts.stdout:
        pytest.skip(
            "no font for mathematics on this machine: install one (apt-get install fonts-dejavu-extra)"
        )
    heights = []
    for address in pages.values():
        tab.goto(address)
        heights += tab.evaluate(BRACES)
    assert heights
    assert min(heights) > 0.8
