"""Pages for readers who use a keyboard or a screen reader, by the rules of axe-core."""

import pytest
from axe_playwright_python.sync_playwright import Axe

GRAVE = ("serious", "critical")
WITHIN = {"exclude": [["svg > *"]]}  # a figure is one image, with its caption
NARROW = {"runOnly": ["scrollable-region-focusable", "target-size"]}  # rules that depend on the width


def findings(tab, **options):
    found = Axe().run(tab, context=WITHIN, options={"resultTypes": ["violations"], **options})
    return [
        (each["id"], [node["target"] for node in each["nodes"][:3]])
        for each in found.response["violations"]
        if each["impact"] in GRAVE
    ]


@pytest.mark.parametrize(("width", "options"), [(1200, {}), (390, NARROW)])
def test_no_page_has_a_serious_finding(tab, pages, width, options):
    tab.set_viewport_size({"width": width, "height": 900})
    found = {}
    for name, address in pages.items():
        tab.goto(address)
        found[name] = findings(tab, **options)
    assert {name: grave for name, grave in found.items() if grave} == {}


def test_the_rules_see_a_fault(tab):
    tab.set_content("<html><body><img src='data:,'><p style='color: #ddd'>pale</p></body></html>")
    assert {"image-alt", "color-contrast", "html-has-lang"} <= {name for name, _ in findings(tab)}


def test_the_rules_of_a_narrow_page_see_a_fault(tab):
    tab.set_content(
        "<main><div style='overflow: auto; width: 50px'><pre>a line that is longer</pre></div></main>"
    )
    assert [name for name, _ in findings(tab, **NARROW)] == ["scrollable-region-focusable"]
