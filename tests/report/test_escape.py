"""Texts in Markdown: parsed by a Markdown parser, they are what was written."""

from html import unescape

import pytest
from hypothesis import given
from hypothesis import strategies as st
from markdown_it import MarkdownIt

from vmharness.report import escape

PARSER = MarkdownIt("gfm-like", {"html": True, "linkify": False})
MARKS = st.text(alphabet="ab1 .)-+=#>*_`~|$&;<!/[](){}\\\"'\n\t\x00\x1b:é", max_size=30)


def words(text):
    """The text with the white space that a page has."""
    return " ".join(escape.printable(text).split())


def shown(tokens):
    return "".join(unescape(token.content) if token.type == "text" else "" for token in tokens)


@given(MARKS)
def test_a_text_is_one_paragraph_of_nothing_but_text(text):
    tokens = PARSER.parse(escape.markdown(text))
    if words(text):
        opened, inline, closed = tokens
        assert (opened.type, closed.type) == ("paragraph_open", "paragraph_close")
        assert {child.type for child in inline.children} == {"text"} or not inline.children
        assert shown(inline.children) == words(text)


@given(MARKS, MARKS)
def test_a_text_stays_in_its_cell(one, two):
    row = f"| {escape.markdown(one)} | {escape.markdown(two)} |"
    tokens = PARSER.parse(f"| a | b |\n|---|---|\n{row}\n")
    cells = [tokens[i + 1] for i, token in enumerate(tokens) if token.type == "td_open"]
    assert [shown(cell.children) for cell in cells] == [words(one), words(two)]


@given(MARKS)
def test_code_is_code(text):
    (_, inline, _) = PARSER.parse(f"x {escape.code(text)}")
    assert [child.type for child in inline.children] == ["text", "code_inline"]
    assert inline.children[1].content.strip() == words(text)


@given(st.text(max_size=20))
def test_a_link_leads_to_a_file_beside_the_page(path):
    tokens = PARSER.parse(f"[a](x{escape.link(path)})")
    assert [child.type for child in tokens[1].children] == ["link_open", "text", "link_close"]
    assert ":" not in tokens[1].children[0].attrs["href"]


@pytest.mark.parametrize(
    "text", ["z_peak = -0.5 m", "+0.1 %", "2.5 mm (10 %)", "t_impact/(N + 0.2)", "A: B, C"]
)
def test_what_has_no_meaning_in_markdown_is_not_escaped(text):
    assert escape.markdown(text) == text
