"""The prose of a case: sections, pictures from its own folder only, and no HTML of its own."""

import re
from types import SimpleNamespace

import pytest
from markdown_it import MarkdownIt

from vmharness.report import prose

PARSER = MarkdownIt("gfm-like", {"html": True, "linkify": False})


def written(tmp_path, text):
    (tmp_path / "README.md").write_text(text)
    return SimpleNamespace(folder=tmp_path)


def test_sections_by_title(tmp_path):
    case = written(tmp_path, "# Head\n\nlead\n\n## One\n\ntext\n\n### Deeper\n\nmore\n\n## Two\n")
    assert prose.sections(case) == {"One": "text\n\n### Deeper\n\nmore", "Two": ""}


def test_a_case_without_prose_has_no_sections(tmp_path):
    assert prose.sections(SimpleNamespace(folder=tmp_path)) == {}


def test_pictures_come_from_the_folder_of_the_case_alone(tmp_path):
    outside = tmp_path / "secret.svg"
    outside.write_text("<svg/>")
    folder = tmp_path / "case"
    folder.mkdir()
    (folder / "figure.svg").write_text("<svg/>")
    text = "## A\n\n![in](figure.svg)\n\n![out](../secret.svg)\n\n![far](https://example.org/x.svg)\n"
    case = written(folder, text)
    found = prose.pictures(case)
    assert list(found) == ["figure.svg"]
    page = prose.html(prose.sections(case)["A"], found)
    assert page.count("<img") == 1
    assert 'src="data:image/svg+xml;base64,' in page
    assert "example.org" not in page


def test_html_in_prose_is_text():
    assert "<script>" not in prose.html("<script>alert(1)</script>", {})


def shown(tmp_path, body):
    """A section with this body: as Markdown, and as HTML."""
    case = written(tmp_path, f"## A\n\n{body}\n")
    text = prose.sections(case)["A"]
    return text, prose.html(text, prose.pictures(case))


@pytest.mark.parametrize(
    "body",
    [
        "a <script>alert(1)</script> b",
        "<!-- unclosed\n\ntext",
        "- a\n- <img src=x onerror=alert(1)>",
        "| a | b |\n|---|---|\n| ` | <b>x</b> ` |",
        "[a](javascript:alert(1))",
        "[a][1]\n\n[1]: file:///etc/passwd",
        "<javascript:alert(1)>",
        "[a](../../../etc/passwd)",
        "![a](http://example.org/x.png) and ![b](/etc/x.svg)",
    ],
)
def test_a_block_that_a_page_cannot_show_is_shown_as_it_is_written(tmp_path, body):
    text, html = shown(tmp_path, f"*before*\n\n{body}\n\n*after*")
    tokens = PARSER.parse(text)
    kinds = {
        token.type for token in [*tokens, *(child for token in tokens for child in token.children or ())]
    }
    assert not kinds & {"html_inline", "html_block", "link_open", "image"}
    assert html.startswith("<p><em>before</em></p>")
    assert html.rstrip().endswith("<p><em>after</em></p>") or "unclosed" in body
    assert not re.search(r"<(?!/?(p|em|br|ul|li|code)\b)", html)
    assert prose.review(written(tmp_path, f"## A\n\n{body}\n"))


def test_formatting_tables_code_and_links_to_the_web_stay(tmp_path):
    body = (
        "**a** `<b>` [c](https://example.org) x < y\n\n| a | b |\n|---|---|\n| 1 | 2 |\n\n```\n<script>\n```"
    )
    text, html = shown(tmp_path, body)
    assert text == body
    assert '<a href="https://example.org">c</a>' in html
    assert "<table>" in html
    assert prose.review(written(tmp_path, f"## A\n\n{body}\n")) == []


def test_code_without_an_end_does_not_swallow_the_page(tmp_path):
    text, _ = shown(tmp_path, "before\n\n```\ncode")
    assert text.endswith("\\`\\`\\`\\\ncode")
    (why,) = prose.review(SimpleNamespace(folder=tmp_path))
    assert (
        why
        == "README.md: a block of code that begins with ``` has no end; a page shows this block as it is written"
    )


def test_a_drawing_with_a_script_is_neither_shown_nor_copied(tmp_path):
    (tmp_path / "x.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg" onload="alert(1)"/>')
    text, html = shown(tmp_path, "![A view](x.svg)")
    assert text == "*A view* (this drawing cannot be shown)"
    assert "<img" not in html
    assert prose.pictures(SimpleNamespace(folder=tmp_path)) == {}
    (why,) = prose.review(SimpleNamespace(folder=tmp_path))
    assert why == "README.md: x.svg: has <svg onload>: a drawing of a page cannot have scripts or animations"


def test_sections_of_one_title_are_joined(tmp_path):
    assert prose.sections(written(tmp_path, "## A\n\none\n\n## B\n\n## A\n\ntwo\n")) == {
        "A": "one\n\ntwo",
        "B": "",
    }
