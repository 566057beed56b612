"""No link of a page is broken, every picture is drawn, and no page asks for anything else."""

from pathlib import Path
from urllib.parse import unquote, urldefrag, urlparse

LINKS = "[...document.querySelectorAll('a[href], use')].map(e => e.href.baseVal ?? e.href)"
ANCHORS = "[...document.querySelectorAll('[id]')].map(e => e.id)"
BROKEN = "[...document.images].filter(e => !e.complete || !e.naturalWidth).map(e => e.alt)"


def broken(address, link, anchors):
    """Whether a link of the page at `address` leads to no file and to no place of the page."""
    page, fragment = urldefrag(link)
    if not page or page == address:
        return fragment not in anchors
    parts = urlparse(page)
    return parts.scheme == "file" and not Path(unquote(parts.path)).is_file()


def test_no_link_is_broken_and_a_page_asks_for_nothing(browser, pages):
    page = browser.new_page()  # with the security policy of the pages
    asked, said, found = [], [], {}
    page.on("request", lambda request: asked.append(request.url))
    page.on("console", lambda message: said.append(message.text))
    for name, address in pages.items():
        page.goto(address)
        links, anchors = page.evaluate(LINKS), set(page.evaluate(ANCHORS))
        found[name] = [link for link in links if broken(address, link, anchors)] + page.evaluate(BROKEN)
    page.close()
    assert {name: links for name, links in found.items() if links} == {}
    assert [url for url in asked if url not in pages.values() and not url.startswith("data:")] == []
    assert said == []


def test_the_index_leads_to_every_page(tab, pages):
    tab.goto(pages["index"])
    led = {urldefrag(link)[0] for link in tab.evaluate(LINKS)}
    assert set(pages.values()) - led <= {pages["index"]}


def test_a_link_to_nowhere_is_seen():
    assert broken("file:///a", "file:///a#b", {"c"})
    assert broken("file:///a", "file:///nowhere/index.html", set())
    assert not broken("file:///a", "#c", {"c"})
