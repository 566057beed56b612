"""Hostile texts in every text of a case: pages of both formats show them, and are changed by none of them."""

import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote
from xml.etree import ElementTree

import msgspec
import pytest
from markdown_it import MarkdownIt

from vmharness.case.format import CaseFile
from vmharness.report import write_case, write_index, write_unjudged
from vmharness.report.blocks import Section, Table
from vmharness.report.formats import html, markdown
from vmharness.report.page import page
from vmharness.result import Unrun

HOSTILE = (
    "# <script>alert(1)</script><img src=x onerror=alert(2)>\"'`|*_[a](javascript:alert(3))&amp; <!-- ]]> $\\frac$ "
    '\\(y\\) {{7*7}}  id="k" url(#u) href="#h" | \\| ~~z~~ \x1b[31m\x00\n\n- <b>\n\n```\n'
)
ID = "x<b>|*_[a](javascript:b)&amp; `c` 'd' \"e"
# What the reader of case.toml checks: names, units, formulas, choices.
CHECKED = {
    "units",
    "unit",
    "formula",
    "file",
    "files",
    "parameters",
    "mesh",
    "event",
    "channel",
    "target",
    "key",
    "kind",
}
CHECKED |= {
    "channels",
    "must_fail",
    "change",
    "values",
    "refined",
    "size",
    "set",
    "orders",
    "ranges",
    "within",
    "level",
}
CHECKED |= {"onset_of", "end_of", "crossing_of", "minimum_of", "maximum_of", "at", "direction", "relative"}
OURS = {"<br>", "<details>", "<summary>", "</summary>", "</details>"}  # tags of the templates
PARSER = MarkdownIt("gfm-like", {"html": True, "linkify": False})


def hostile(content):
    """The tables of a case with every text in them hostile."""
    match content:
        case str():
            return HOSTILE
        case list():
            return [hostile(each) for each in content]
        case dict():
            return {key: value if key in CHECKED else hostile(value) for key, value in content.items()}
    return content


@pytest.fixture(scope="module")
def written(request, tmp_path_factory):
    """The folder of a manual of one run, one case that was not judged, and their index."""
    root = tmp_path_factory.mktemp("manual")
    case, make = request.getfixturevalue("case"), request.getfixturevalue("make_run")
    content = msgspec.to_builtins(case.file)
    for name in content["given"]:
        content["given"][name]["group"] = "Loading"
    content["channels"] = {
        name: {**channel, "text": HOSTILE} for name, channel in content["channels"].items()
    }
    texts = hostile(content)
    texts["published"] = [{**column, "name": f"{n} {HOSTILE}"} for n, column in enumerate(texts["published"])]
    folder = tmp_path_factory.mktemp("case")
    for path in case.folder.iterdir():
        (folder / path.name).write_bytes(path.read_bytes())
    title = HOSTILE.split("\n")[0]
    prose = f"# A\n\n## {title}\n\n> ```\n\n## Test case\n\n{HOSTILE}"
    (folder / "README.md").write_text(prose)
    run = make(replace(case, id=ID, folder=folder, file=msgspec.convert(texts, CaseFile)))
    rows = [replace(row, comparison=replace(row.comparison, reason=HOSTILE)) for row in run.rows]
    solution = replace(
        run.solution, solver=HOSTILE, notes=(HOSTILE,), facts={HOSTILE: HOSTILE}, files={HOSTILE: "0"}
    )
    run = replace(run, rows=tuple(rows), solution=solution, readings={})
    study = Section(
        HOSTILE,
        HOSTILE,
        [HOSTILE],
        [Table([HOSTILE] * 3, [[HOSTILE] * 3])],
        [],
        [HOSTILE],
        [(HOSTILE, HOSTILE)],
        HOSTILE,
    )
    write_case(run, root, indexed=True)
    full = replace(page(run, indexed=True), studies=[study], doubtful=[HOSTILE])
    for form in (html, markdown):
        (root / ID / form.FILE).write_text(form.case(full, root / ID))
    unrun = Unrun("VM-2", HOSTILE)
    write_unjudged(unrun, root, indexed=True)
    write_index([run], root, [unrun])
    return root


@pytest.fixture(scope="module", params=["case", "unjudged", "index"])
def folder(request, written):
    return written / {"case": ID, "unjudged": "VM-2", "index": ""}[request.param]


def tokens(folder):
    flat = []
    for token in PARSER.parse((folder / "README.md").read_text()):
        flat += [token, *(token.children or ())]
    return flat


def test_markdown_has_no_html_of_a_text(folder):
    found = {token.content.strip() for token in tokens(folder) if token.type in ("html_inline", "html_block")}
    assert {tag for content in found for tag in re.findall(r"<[^>]*>", content)} <= OURS


def test_markdown_has_no_formatting_of_a_text(folder):
    assert not [token for token in tokens(folder) if token.type == "s_open"]
    assert not [token for token in tokens(folder) if token.type == "fence" and token.level == 0]


def test_rows_of_markdown_tables_have_the_columns_of_their_head(folder):
    lines = (folder / "README.md").read_text().split("\n")
    tables = [token.map for token in tokens(folder) if token.type == "table_open"]
    assert tables or folder.name == "VM-2"
    for first, last in tables:
        assert len({len(re.findall(r"(?<!\\)(?:\\\\)*\|", line)) for line in lines[first:last]}) == 1


def test_links_and_images_of_markdown_lead_to_files_beside_it(folder):
    for token in tokens(folder):
        name = {"link_open": "href", "image": "src"}.get(token.type)
        if name:
            assert (folder / unquote(token.attrs[name])).exists(), token.attrs[name]


def test_headings_of_markdown_are_those_of_the_template(folder):
    headings = [token.tag for token in tokens(folder) if token.type == "heading_open"]
    assert headings.count("h1") == 1
    assert set(headings) <= {"h1", "h2"}


class Tags(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.tags, self.text = [], ""
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, dict(attributes)))

    handle_startendtag = handle_starttag

    def handle_data(self, data):
        self.text += data


def test_html_has_no_tag_and_no_address_of_a_text(folder):
    page = Tags((folder / "index.html").read_text())
    assert "alert(1)" in page.text
    assert not {"script", "b" if folder.name == ID else "script"} & {tag for tag, _ in page.tags}
    for tag, attributes in page.tags:
        assert not [name for name in attributes if name.startswith("on")]
        assert tag != "img" or attributes["src"].startswith("data:")
        assert not attributes.get("href", "").startswith("javascript:")


def test_pages_and_figures_have_no_control_characters(written):
    for path in written.rglob("*"):
        if path.is_file():
            assert not re.search("[\x00-\x08\x0e-\x1f]", path.read_text()), path


def test_figures_show_the_texts(written):
    drawn = [ElementTree.parse(path).getroot() for path in sorted((written / ID).glob("history*.svg"))]
    assert drawn
    for root in drawn:
        assert "<script>alert(1)</script>" in " ".join("".join(root.itertext()).split())


def test_the_files_of_a_case_cannot_be_left(written):
    assert {path.name for path in written.iterdir()} == {"README.md", "index.html", ID, "VM-2"}
    assert Path(written / ID / "index.html").is_file()
