"""Drawings of a case: those with scripts, or that ask for other files, are not shown."""

from pathlib import Path

import pytest

from vmharness.report.drawing import fault

SVG = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"{}>{}</svg>'
PNG = "data:image/png;base64,AAAA"


@pytest.fixture
def drawing(tmp_path):
    def make(content):
        path = tmp_path / "figure.svg"
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return fault(path)

    return make


@pytest.mark.parametrize(
    "inside",
    [
        '<rect id="a" width="3" height="2" style="fill: url(#g)"/><use xlink:href="#a"/>',
        f'<image href="{PNG}"/>',
        "<style>rect { fill: #123456; mask: url(#m) }</style><text>url is a word, javascript: too</text>",
        "<!-- a comment --><g><title>on</title></g>",
    ],
)
def test_a_drawing_of_its_own_is_shown(drawing, inside):
    assert drawing(SVG.format("", inside)) == ""


@pytest.mark.parametrize(
    ("attributes", "inside", "message"),
    [
        (
            "",
            "<script>alert(1)</script>",
            "has <script>: a drawing of a page cannot have scripts or animations",
        ),
        (' onload="alert(1)"', "", "has <svg onload>: a drawing of a page cannot have scripts or animations"),
        (
            "",
            '<foreignObject><b xmlns="http://www.w3.org/1999/xhtml"/></foreignObject>',
            "has <foreignObject>",
        ),
        ("", '<a xlink:href="javascript:alert(1)"/>', "has <a href>, which leads out of the drawing"),
        ("", '<image href="../../secret.png"/>', "has <image href>, which leads out of the drawing"),
        ("", '<image href="https://example.org/x.png"/>', "has <image href>, which leads out of the drawing"),
        (
            "",
            '<image href="data:image/svg+xml;base64,AAAA"/>',
            "has <image href>, which leads out of the drawing",
        ),
        (
            "",
            "<rect style=\"fill: url( 'http://example.org/a')\"/>",
            "has <rect style>, which asks for another file",
        ),
        ("", "<style>@import 'x.css';</style>", "has a style that asks for another file"),
        ("", '<set attributeName="href" to="javascript:alert(1)"/>', "has <set>"),
    ],
)
def test_a_drawing_that_does_or_fetches_something_is_not(drawing, attributes, inside, message):
    assert drawing(SVG.format(attributes, inside)).startswith(message)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("<html/>", "is not an SVG drawing: it begins with <html>"),
        ("<svg>", "is not an SVG drawing: no element found"),
        (b"\xff\xd8\xff", "is not UTF-8"),
        ('<!DOCTYPE svg [<!ENTITY a "b">]>' + SVG.format("", "&a;"), "has <!ENTITY"),
        ('<?xml-stylesheet href="x.css"?>' + SVG.format("", ""), "has <?xml-stylesheet"),
    ],
)
def test_what_is_no_drawing_is_not(drawing, content, message):
    assert drawing(content).startswith(message)


def test_the_drawings_of_the_manual_are_shown():
    paths = sorted((Path(__file__).parents[2] / "cases").glob("*/*.svg"))
    assert paths
    assert {path.parent.name: fault(path) for path in paths if fault(path)} == {}
