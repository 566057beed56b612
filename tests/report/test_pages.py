"""The pages of a case and the index: what they show, that they stand alone, and that they repeat."""

import re
import shutil
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from vmharness.case import read
from vmharness.formula import Unit
from vmharness.report import write_case, write_index
from vmharness.report.page import page
from vmharness.result import CaseRun, Solution, Unrun

CASES = Path(__file__).parents[2] / "cases"

VOID = {"meta", "br", "wbr", "img", "link", "hr", "input"}


class Page(HTMLParser):
    """The tags of a page, with a check that they nest."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.open, self.tags, self.text = [], [], []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, dict(attributes)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.tags.append((tag, dict(attributes)))

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, f"</{tag}> closes something else, at {self.getpos()}"

    def handle_data(self, data):
        self.text.append(data)


def written(run, folder, **how):
    write_case(run, folder, **how)
    case = folder / run.case.id
    return (case / "README.md").read_text(), (case / "index.html").read_text()


def table_after(markdown, heading):
    """Cells of the first table below a heading."""
    lines = markdown.split(f"## {heading}", 1)[1].splitlines()
    first = next(i for i, line in enumerate(lines) if line.startswith("|"))
    rows = []
    for line in lines[first:]:
        if not line.startswith("|"):
            break
        rows.append([cell.strip() for cell in line.strip("|").split("|")])
    return rows


def test_html_nests_and_needs_nothing_else(good, tmp_path):
    _, html = written(good, tmp_path)
    write_index([good], tmp_path)
    for text in (html, (tmp_path / "index.html").read_text()):
        page = Page(text)
        assert page.open == []
        assert not any(tag in ("script", "link", "iframe", "object") for tag, _ in page.tags)
        for tag, attributes in page.tags:
            for name, value in attributes.items():
                assert not name.startswith("on")
                if name in ("src", "href", "xlink:href") and tag != "a":
                    assert value.startswith(("data:", "#")), f"<{tag} {name}={value[:60]}>"
        assert not re.search(r"url\((?!#)|@import", text)


def test_identifiers_of_figures_do_not_collide(good, tmp_path):
    _, html = written(good, tmp_path)
    ids = [attributes["id"] for _, attributes in Page(html).tags if "id" in attributes]
    assert ids
    assert len(ids) == len(set(ids))


def test_figures_are_sound_xml_and_are_linked(good, tmp_path):
    markdown, _ = written(good, tmp_path)
    linked = set(re.findall(r"!\[[^\]]*\]\(([^)]+)\)", markdown))
    assert linked == {path.name for path in (tmp_path / good.case.id).glob("*.svg")}
    assert {"schematic.svg", "model.svg", "history-z.svg", "history-v.svg"} <= linked
    for name in linked:
        assert ElementTree.parse(tmp_path / good.case.id / name).getroot().tag.endswith("svg")


def test_results_table_has_the_columns_of_the_manual_and_a_row_for_each_result(good, tmp_path):
    markdown, _ = written(good, tmp_path)
    head, _, *rows = table_after(markdown, "Results comparison")
    assert head[:4] == ["Result", "Target", "vmharness", "Error (%)"]
    assert {len(row) for row in rows} == {len(head)}
    assert [row[0] for row in rows] == [
        "**At Impact**", "Time (s)", "Z-Displacement (in)", "Z-Velocity (in/s)", "Kinetic Energy (lbf-in)",
        "**At Maximum Displacement**", "Time (s)", "Z-Displacement (in)",
    ]  # fmt: skip
    velocity = dict(zip(head, rows[3], strict=False))
    assert velocity["Target"] == "-27.7849"
    assert velocity["LS-DYNA"] == "-27.791"
    assert velocity["VM65"] == "-27.79"
    assert velocity["Verdict"] == "✓ pass"
    assert velocity["Share used"] == "50 %"


@pytest.mark.parametrize("kind", ["good", "broken"])
def test_no_cell_holds_what_is_not_a_number_or_a_negative_zero(kind, request, tmp_path):
    markdown, html = written(request.getfixturevalue(kind), tmp_path)
    cells = [
        cell.strip() for line in markdown.splitlines() if line.startswith("|") for cell in line.split("|")
    ]
    cells += [cell.strip() for cell in re.findall(r"<td[^>]*>(.*?)</td>", html, re.DOTALL)]
    assert len(cells) > 200
    assert not [cell for cell in cells if re.fullmatch(r"nan|-?inf|None|[-−]0\.?0*", cell)]
    assert "{{" not in markdown + html
    assert "{%" not in markdown + html


def test_committed_files_are_the_same_bytes_whatever_varies(good, tmp_path):
    write_case(good, tmp_path / "a")
    write_index([good], tmp_path / "a")
    solution = replace(
        good.solution,
        solver="vmharness 10.0",
        seconds=99.0,
        seconds_loop=98.0,
        cycles=7,
        facts={"Time step": "2"},
    )
    write_case(replace(good, seconds=100.0, solution=solution), tmp_path / "b")
    write_index([replace(good, seconds=100.0, solution=solution)], tmp_path / "b")
    kept = [path for path in (tmp_path / "a").rglob("*") if path.suffix in (".md", ".svg")]
    assert len(kept) >= 6
    for path in kept:
        # The links to the input files depend on where the folders lie, and on nothing else.
        assert path.read_bytes() == (tmp_path / "b" / path.relative_to(tmp_path / "a")).read_bytes()


def test_round_off_does_not_reach_the_committed_files(good, tmp_path):
    write_case(good, tmp_path / "a")
    noise = np.random.default_rng(1)
    history = good.solution.history
    channels = {
        name: values * (1.0 + 1e-14 * noise.standard_normal(values.size))
        for name, values in history.channels.items()
    }
    noisy = replace(good.solution, history=replace(history, channels=channels))
    write_case(replace(good, solution=noisy), tmp_path / "b")
    for path in (tmp_path / "a").rglob("*.svg"):
        assert path.read_bytes() == (tmp_path / "b" / path.relative_to(tmp_path / "a")).read_bytes(), (
            path.name
        )


def test_the_settings_of_a_user_do_not_reach_the_figures(good, tmp_path):
    import matplotlib

    write_case(good, tmp_path / "a")
    with matplotlib.rc_context(
        {"font.size": 20.0, "axes.grid": True, "svg.fonttype": "path", "lines.linewidth": 9.0}
    ):
        write_case(good, tmp_path / "b")
        assert matplotlib.rcParams["font.size"] == 20.0
    for path in (tmp_path / "a").rglob("*.svg"):
        assert path.read_bytes() == (tmp_path / "b" / path.relative_to(tmp_path / "a")).read_bytes(), (
            path.name
        )


def test_what_varies_is_in_the_html_and_can_be_left_out(good, tmp_path):
    markdown, html = written(good, tmp_path)
    assert "1.25 s" in html
    assert "vmharness 9.9.9" in html
    assert "9.9.9" not in markdown
    _, html = written(good, tmp_path, volatile=False)
    assert "1.25 s" not in html
    assert "9.9.9" not in html


def test_a_run_that_fails_leads_with_the_reason(failed, tmp_path):
    markdown, html = written(failed, tmp_path)
    reason = "z_peak: -1.550619 differs from -1.550666"
    assert markdown.splitlines()[2].startswith(f"**✗ FAIL** – {reason}")
    words = "".join(Page(html).text)
    assert words.index("✗ fail") < words.index(reason) < words.index("Overview")


def test_a_run_that_ends_early_says_why_and_shows_what_there_is(broken, tmp_path):
    markdown, html = written(broken, tmp_path)
    assert markdown.splitlines()[2] == "**! ERROR** – energy is not finite at t = 0.08 &lt;cycle 800>"
    assert "&lt;cycle 800&gt;" in html
    assert "history-z.svg" in markdown
    assert "Source of the published difference" not in markdown
    peak = [row for row in table_after(markdown, "Results comparison") if row[0] == "Time (s)"][1]
    assert peak[2:4] == ["–", "–"]


def test_a_run_without_a_history_has_a_page(broken, tmp_path):
    run = replace(
        broken,
        solution=replace(broken.solution, history=None, view=None),
        events={"impact": "no", "peak": "no"},
    )
    markdown, _ = written(run, tmp_path)
    assert "history-" not in markdown
    assert "## Results comparison" in markdown


def test_published_difference_is_told_apart_into_explained_and_not(good, tmp_path):
    markdown, _ = written(good, tmp_path)
    assert "gives 1 of the 2 figures of the LS-DYNA column" in markdown
    assert "Kinetic Energy at impact agrees with the value of this run at exactly 0.072 s." in markdown
    assert "No reading of this run gives" not in markdown
    kinetic = table_after(markdown, "Source of the published difference")[3]
    assert kinetic[-1] == "✗ no; at exactly 0.072 s: 193.099, ✓ yes"


def test_a_figure_that_no_reading_gives_is_named(good, tmp_path):
    first, second = good.readings["LS-DYNA"]
    odd = replace(second, other=None, other_same=False)
    markdown, _ = written(replace(good, readings={"LS-DYNA": (first, odd)}), tmp_path)
    assert "No reading of this run gives: Kinetic Energy at impact." in markdown


def test_the_head_of_a_row_tells_the_verdict_where_its_column_is_off_the_screen(failed, tmp_path):
    _, html = written(failed, tmp_path)
    heads = re.findall(r'<tr><th scope="row"><span class="sign (\w+)" title="\w+">(.)</span>', html)
    assert heads == [("pass", "✓")] * 5 + [("fail", "✗")]
    assert [attributes["data-head"] for tag, attributes in Page(html).tags if "data-head" in attributes] == [
        "Material", "Geometric", "Loading", "Model",
    ]  # fmt: skip


def test_results_of_one_event_stand_together_wherever_the_case_has_them(good, tmp_path):
    peak_within = replace(good, rows=(*good.rows[:2], *good.rows[4:], *good.rows[2:4]))
    assert [(event, len(rows)) for event, rows in peak_within.groups] == [
        ("At Impact", 4), ("At Maximum Displacement", 2)
    ]  # fmt: skip
    _, html = written(peak_within, tmp_path)
    assert html.count('<tr class="event">') == 2


def test_planted_faults_say_how_far_theory_moves_what_must_fail(good, tmp_path):
    markdown, _ = written(good, tmp_path)
    stiff = table_after(markdown, "Declared faults")[2]
    # One percent of stiffness shortens the time on the surface by about half a percent.
    moved = float(re.search(r"t_peak: (-[\d.]+) %", stiff[2])[1])
    on_surface = good.case.theory["t_peak"] - good.case.theory["t_impact"]
    assert moved == pytest.approx(-0.5 * on_surface / good.case.theory["t_peak"], rel=0.15)


def test_other_data_than_the_case_s_are_said(good, tmp_path):
    markdown, html = written(replace(good, case=good.case.with_given({"k": 2000.0})), tmp_path)
    for text in (markdown, html):
        assert "k = 2000 lbf/in instead of 1973.92" in text
    assert "k = 2000" in markdown


def test_values_published_for_the_case_s_own_data_stand_beside_no_others(good, tmp_path):
    markdown, html = written(replace(good, case=good.case.with_given({"k": 2000.0})), tmp_path)
    for text in (markdown, html):
        assert "LS-DYNA Verification Manual, VM" not in text
        assert "Source of the published difference" not in text
        assert "27.791" not in text
        assert "The text below describes the case with its own data." in text
    head, *rows = table_after(markdown, "Results comparison")
    assert head[-1] == "Verdict"
    assert {len(row) for row in rows} == {len(head)}


def test_the_deck_that_ran_is_the_one_that_is_offered(good, tmp_path):
    import base64

    run = replace(good, solution=replace(good.solution, resolved_deck="*KEYWORD LONG=Y\n*END\n"))
    markdown, html = written(run, tmp_path)
    link = next(a for tag, a in Page(html).tags if tag == "a" and a.get("download") == "deck.k")
    assert base64.b64decode(link["href"].split(",", 1)[1]) == b"*KEYWORD LONG=Y\n*END\n"
    assert "[deck.k](deck.k)" in markdown
    assert (tmp_path / "VM-061" / "deck.k").read_text() == "*KEYWORD LONG=Y\n*END\n"


def test_input_files_are_offered_whole(good, tmp_path):
    import base64

    _, html = written(good, tmp_path)
    link = next(a for tag, a in Page(html).tags if tag == "a" and a.get("download") == "deck.k")
    assert base64.b64decode(link["href"].split(",", 1)[1]) == good.case.deck_path.read_bytes()


def test_links_of_the_markdown_lead_to_the_deck(good, tmp_path):
    markdown, _ = written(good, tmp_path)
    link = re.search(r"\[deck\.k\]\(([^)]+)\)", markdown)[1]
    assert (tmp_path / good.case.id / link).resolve() == good.case.deck_path.resolve()


def test_index_puts_the_worst_first(good, failed, broken, tmp_path):
    def renamed(run, name):
        return replace(run, case=replace(run.case, id=name))

    runs = [renamed(good, "VM-1"), renamed(failed, "VM-2"), renamed(broken, "VM-3")]
    write_index(runs, tmp_path)
    text = (tmp_path / "README.md").read_text()
    rows = table_after(text, "Cases solved by vmharness")
    assert [row[0] for row in rows[2:]] == [
        f"[{name}]({name}/README.md)" for name in ("VM-3", "VM-2", "VM-1")
    ]
    assert [row[4] for row in rows[2:]] == ["–", "300 %", "50 %"]
    assert table_after(text, "What the cases cover")[2][0] == "contact"
    assert "1 ✓ pass, 1 ✗ fail, 1 ! error" in text


def test_index_counts_and_names_the_cases_without_a_run_first(good, tmp_path):
    write_index([good], tmp_path, [Unrun("VM-9", "deck <b>"), Unrun("VM-8", "interrupted")])
    text = (tmp_path / "README.md").read_text()
    assert "3 cases: 1 ✓ pass, 2 ! error" in text
    assert "- VM-8: interrupted\n- VM-9: deck &lt;b>\n\n## Cases solved by vmharness" in text
    html = (tmp_path / "index.html").read_text()
    assert html.index("deck &lt;b&gt;") < html.index(">VM-061<")
    assert Page(html).open == []


def test_sensitivity_tells_what_moves_what_and_from_where_on_it_is_seen(good, tmp_path):
    markdown, html = written(good, tmp_path)
    head, _, *rows = table_after(markdown, "Sensitivity")
    table = {row[0]: dict(zip(head[1:], row[1:], strict=True)) for row in rows}
    assert head == ["Result", "m", "k", "h", "g"]
    assert (table["t_impact"]["h"], table["t_impact"]["g"]) == ("0.5", "-0.5")
    assert table["**Smallest error that fails**"]["g"] == "0.0001 % (t_impact)"
    assert "No target depends on E, nu, L, rho, dt." in markdown
    assert "<h2>Sensitivity</h2>" in html


@pytest.mark.parametrize(
    ("id", "line"), [("D-59", "w_peak"), ("D-59", "t_down"), ("D-49", "s_peak"), ("D-45", "t_p")]
)
def test_a_target_has_one_unit_in_the_theory_and_in_the_results(id, line):
    case = read(CASES / id)
    run = CaseRun(case, Solution("vmharness", None), (), {}, {}, "d", "c", 1.0)
    shown = next(each for each in page(run).theory if each.name == line)
    result = next(result for result in case.file.results if result.target == line)
    assert shown.unit == Unit(result.unit)
    assert shown.value * case.units.factor(shown.unit) == pytest.approx(case.theory[line])


def test_a_drawing_of_the_case_does_not_replace_a_figure_of_the_page(good, tmp_path):
    folder = tmp_path / "case"
    shutil.copytree(good.case.folder, folder)
    (folder / "schematic.svg").rename(folder / "model.svg")
    prose = (folder / "README.md").read_text().replace("schematic.svg", "model.svg")
    (folder / "README.md").write_text(prose)
    with pytest.raises(FileExistsError, match=r"model\.svg: the page has a figure of this name; rename"):
        write_case(replace(good, case=replace(good.case, folder=folder)), tmp_path / "reports")
    assert not (tmp_path / "reports").exists()
