"""Pages for readers who use a keyboard or a screen reader, by the rules of axe-core."""

import pytest
from axe_playwright_python.sync_playwright import Axe

GRAVE = ("serious", "critical")


def findings(tab):
    found = Axe().run(tab, options={"resultTypes": ["violations"]}).response["violations"]
    return [
        (each["id"], [node["target"] for node in each["nodes"][:3]])
        for each in found
        if each["impact"] in GRAVE
    ]


@pytest.mark.parametrize("width", [390, 1200])
def test_no_page_has_a_serious_finding(tab, pages, width):
    tab.set_viewport_size({"width": width, "height": 900})
    found = {}
    for name, address in pages.items():
        tab.goto(address)
        found[name] = findings(tab)
    assert {name: grave for name, grave in found.items() if grave} == {}


def test_the_rules_see_a_fault(tab):
    tab.set_content("<html><body><img src='data:,'><p style='color: #ddd'>pale</p></body></html>")
    assert {"image-alt", "color-contrast", "html-has-lang"} <= {name for name, _ in findings(tab)}
