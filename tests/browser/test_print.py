"""Pages on paper: nothing is beyond the edge, and every number of a formula and of a table is there."""

import re
from collections import Counter

import pypdfium2

PAPER = 672  # CSS pixels between the margins of A4
# Elements that, or whose content, is beyond the right margin.
BEYOND = """() => {
    const range = document.createRange();
    const right = e => { range.selectNodeContents(e);
        return Math.max(e.getBoundingClientRect().right, range.getBoundingClientRect().right) };
    return [...document.querySelectorAll('main *')].filter(e => !e.closest('svg') || e.tagName == 'svg')
        .filter(e => right(e) > document.documentElement.clientWidth + 1)
        .map(e => e.tagName + ': ' + e.textContent.trim().slice(0, 40)) }"""
# What must be on paper; a folded list stays folded.
TEXTS = """[...document.querySelectorAll('h1, h2, main > p, .what, li, mn, th, td, figcaption')]
    .filter(e => e.checkVisibility() && !e.querySelector('math')).map(e => e.textContent)"""


def squeezed(text):
    """The text without white space, hyphens and signs, at which a PDF may break a word; capitals are of the style."""
    return re.sub(r"[\s\u2010\u2212\ufffe\u0002✓✗▸-]", "", text).lower()


def lost(tab, path):
    """Words of the page that are fewer times on paper."""
    tab.emulate_media(media="print")
    words = Counter(squeezed(word) for text in tab.evaluate(TEXTS) for word in text.split())
    tab.pdf(path=path, prefer_css_page_size=True)
    sheets = pypdfium2.PdfDocument(path)
    paper = squeezed("".join(sheet.get_textpage().get_text_bounded() for sheet in sheets))
    return sorted(word for word, count in words.items() if paper.count(word) < count)


def test_nothing_is_beyond_the_edge_and_every_number_and_word_is_on_paper(tab, pages, tmp_path):
    tab.emulate_media(media="print")
    tab.set_viewport_size({"width": PAPER, "height": 900})
    wide, absent = {}, {}
    for name, address in pages.items():
        tab.goto(address)
        wide[name] = tab.evaluate(BEYOND)
        absent[name] = lost(tab, tmp_path / "page.pdf")
    assert {name: elements[:4] for name, elements in wide.items() if elements} == {}
    assert {name: words[:4] for name, words in absent.items() if words} == {}


def test_what_is_cut_is_seen(tab, tmp_path):
    tab.emulate_media(media="print")
    tab.set_viewport_size({"width": PAPER, "height": 900})
    tab.set_content(f"<main><p style='white-space: nowrap'>{'0123456789 ' * 200}</p></main>")
    assert [each[:3] for each in tab.evaluate(BEYOND)] == ["P: "]
    assert lost(tab, tmp_path / "page.pdf") == ["0123456789"]
