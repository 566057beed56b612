"""Pages on a telephone and on a desk: nothing is wider than the window, and formulas are drawn as formulas."""

import shutil
import subprocess

import pytest

WIDER = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
# Formulas that must be scrolled.
CUT = "[...document.querySelectorAll('.theory')].filter(e => e.scrollWidth > e.clientWidth).length"
# Braces before several lines, and how high they are by these lines.
BRACES = """[...document.querySelectorAll('mo')].filter(e => e.textContent == '{' && e.nextElementSibling.tagName == 'mtable')
    .map(e => e.getBoundingClientRect().height / e.nextElementSibling.getBoundingClientRect().height)"""


@pytest.mark.parametrize("width", [390, 1200])
def test_no_page_is_wider_than_its_window(tab, pages, width):
    tab.set_viewport_size({"width": width, "height": 900})
    found = {}
    for name, address in pages.items():
        tab.goto(address)
        found[name] = tab.evaluate(WIDER)
    assert {name: wider for name, wider in found.items() if wider > 0} == {}


def test_no_formula_is_cut_on_a_desk(tab, pages):
    tab.set_viewport_size({"width": 1200, "height": 900})
    found = {}
    for name, address in pages.items():
        tab.goto(address)
        found[name] = tab.evaluate(CUT)
    assert {name: cut for name, cut in found.items() if cut} == {}


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
