"""Pages for readers who use a keyboard or a screen reader, by the rules of axe-core."""

from axe_playwright_python.sync_playwright import Axe

GRAVE = ("serious", "critical")
WITHIN = {"exclude": [["svg > *"]]}  # a figure is one image, with its caption
NARROW = ["scrollable-region-focusable", "target-size"]  # rules that depend on the width


def findings(tab, **options):
    found = Axe().run(tab, context=WITHIN, options={"resultTypes": ["violations"], **options})
    return [
        (each["id"], [node["target"] for node in each["nodes"][:3]])
        for each in found.response["violations"]
        if each["impact"] in GRAVE
    ]


def grave(tab, pages, **options):
    """Findings by page."""
    found = {}
    for name, address in pages.items():
        tab.goto(address)
        found[name] = findings(tab, **options)
    return {name: each for name, each in found.items() if each}


def test_no_page_has_a_serious_finding(tab, pages):
    tab.set_viewport_size({"width": 1200, "height": 900})
    assert grave(tab, pages, rules={"color-contrast": {"enabled": False}}) == {}


def test_colours_have_contrast(tab, pages):
    """Looked at on some pages, because it takes long and all pages have one style."""
    some = dict(list(pages.items())[:: max(1, len(pages) // 4)])
    assert grave(tab, some, runOnly=["color-contrast"]) == {}


def test_no_narrow_page_has_a_serious_finding(tab, pages):
    tab.set_viewport_size({"width": 390, "height": 900})
    assert grave(tab, pages, runOnly=NARROW) == {}


def test_the_rules_see_a_fault(tab):
    tab.set_content("<html><body><img src='data:,'><p style='color: #ddd'>pale</p></body></html>")
    assert {"image-alt", "color-contrast", "html-has-lang"} <= {name for name, _ in findings(tab)}


def test_the_rules_of_a_narrow_page_see_a_fault(tab):
    tab.set_content(
        "<main><div style='overflow: auto; width: 50px'><pre>a line that is longer</pre></div></main>"
    )
    assert [name for name, _ in findings(tab, runOnly=NARROW)] == ["scrollable-region-focusable"]
