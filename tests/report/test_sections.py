"""The sections of `vm faults` and `vm explain`, and the matrix on the index, from records made by hand."""

from dataclasses import replace

import msgspec
import pytest

from vmharness import report
from vmharness.reading import last_cycles
from vmharness.report import records
from vmharness.report.sections import explain, faults
from vmharness.studies.explain.record import SAMPLING, Column, ExplainRecord, Part, explained
from vmharness.studies.faults.record import FaultsRecord, Finding, Noticed


def detection(case, *findings):
    return FaultsRecord(case.id, case.sha256, list(findings))


@pytest.fixture
def planted(good):
    return detection(
        good.case,
        Finding("K +1 %", "Deck: K +1 %", "deck", Noticed.CAUGHT, "z_peak", 214.0),
        Finding(
            "K with the opposite sign",
            "Deck: K with the opposite sign",
            "deck",
            Noticed.CAUGHT,
            reason="refused",
        ),
        Finding("RHO +1 %", "Deck: RHO +1 %", "deck", Noticed.HARMLESS, "z_peak", 0.3),
        Finding("lag", "Times are late", "reading", Noticed.MISSED, "t_peak", 0.47),
        Finding("friction", "Friction pulls", "physics", Noticed.UNSEEN),
    )


def test_faults_are_on_the_page_and_in_the_index(good, planted, tmp_path):
    records.write(tmp_path, good.case.id, "faults", planted)
    report.write_case(good, tmp_path)
    page = (tmp_path / good.case.id / "README.md").read_text()
    assert "Of the 3 faults that change this run, 2 are caught" in page
    assert "Not caught in this case: lag." in page
    assert "| K | ✓ 210 × | ✓ no result |" in page
    assert "| Times are late (lag) | output or reading | ✗ 0.47 × | t_peak |" in page
    assert "<summary>1 planted fault does not change this run.</summary>\n\nfriction.\n" in page
    assert "Wrong values make no result fail: RHO." in page
    report.write_index([good], tmp_path)
    for name in ("README.md", "index.html"):
        index = (tmp_path / name).read_text()
        assert "2 of 3 faults" in index
        assert "Faults of the solver that the cases catch" in index
        assert (
            "No case catches lag (Times are late). The largest error is that of t_peak: 0.47 × its tolerance."
            in index
        )
        assert "These faults change no case: friction." in index


def test_a_row_of_the_index_names_the_cases_that_notice_a_fault_the_farthest_off_first(good, planted):
    def noticed(how, share):
        return Finding("lag", "Times are late", "reading", how, "t", share)

    others = [
        FaultsRecord("B", "0", [noticed(Noticed.CAUGHT, 2.0)]),
        FaultsRecord("C", "0", [noticed(Noticed.CAUGHT, 70.0)]),
        FaultsRecord("D", "0", [noticed(Noticed.UNSEEN, 0.0)]),
    ]
    (table,) = faults.together([planted, *others]).tables
    assert list(table.head) == [
        "Fault",
        "Caught by",
        "Largest error, in tolerances",
        "Changed, but not caught",
    ]
    assert table.rows == [
        ["Times are late (lag)", "C, B", "70 ×", good.case.id],
        ["Friction pulls (friction)", "–", "–", "–"],
    ]
    refused = FaultsRecord("E", "0", [noticed(Noticed.CAUGHT, None)])
    found = faults.together([planted, *others, refused])
    assert found.tables[0].rows[0][1:3] == ["E, C, B", "no result"]
    assert found.summary == "1 of 2"


def test_the_score_of_the_manual(planted):
    assert faults.together([planted]).summary == "0 of 2"


def test_an_index_without_records_has_no_matrix(good, tmp_path):
    report.write_index([good], tmp_path)
    assert "Faults of the solver that the cases catch" not in (tmp_path / "index.html").read_text()


def test_a_column_that_the_case_says_how_to_read_is_explained_once(good, tmp_path):
    """The reading that is found is the declared one, and the odd figure the one that the case names."""
    read = explained("z_peak", "Z", "in", -1.55, -1.5505, 1e-5, [Part(SAMPLING, -5e-4)])
    others = {"ke_impact": "states at their very times", "t_peak": "another"}
    column = Column("LS-DYNA", "computed", last_cycles(0.001, "s"), [], ["z_peak"], others, [read])
    records.write(tmp_path, good.case.id, "explain", ExplainRecord(good.case.id, "0", [read], [column]))
    report.write_case(good, tmp_path)
    for name in ("README.md", "index.html"):
        page = (tmp_path / good.case.id / name).read_text()
        assert page.count("Source of the published difference: LS-DYNA") == 1
        assert page.count("0.001 s apart") == 1
        assert (
            "Of all ways of reading that were tried, this one gives the most figures of the column: 1 of 1 figures."
            in page
        )
        assert "very times" not in page
        assert "t_peak agrees with another reading: another." in page
        assert page.count("The published kinetic energy, 193.10") == 1
        assert (
            "VM65: Mechanical APDL Verification Manual, test case VM65, targets. These values are for comparison "
            in page
        )
        assert page.count("The target of VM65") == 1


def test_parts_are_shares_of_the_tolerance_and_drawn(good, tmp_path):
    parts = [Part("time step", 2e-6), Part(SAMPLING, -1e-6, 5e-7)]
    own = explained("z_peak", "Z", "in", -1.55, -1.549998, 1e-5, parts)
    read = explained("z_peak", "Z", "in", -1.55, -1.5505, 1e-5, [Part(SAMPLING, -5e-4)])
    column = Column(
        "LS-DYNA", "computed", "states 0.001 s apart", [0.002], ["z_peak"], {"ke": "another"}, [read]
    )
    target = Column("VM65", "target", "", [], [], {}, [read])
    record = ExplainRecord(good.case.id, good.case.sha256, [own], [column, target], ["the mesh is fixed"])
    records.write(tmp_path, good.case.id, "explain", record)
    report.write_case(good, tmp_path)
    page = (tmp_path / good.case.id / "README.md").read_text()
    assert "| z_peak | 20 | 20 | -10 | 10 ± 5 |" in page
    story = page.partition("## Source of the published difference: LS-DYNA\n")[2].partition("\n## ")[0]
    assert (
        "Of all ways of reading that were tried, the following one (states 0.001 s apart) gives the most figures of the "
        "column: 1 of 1 figures. An interval of 0.002 s gives as many." in story
    )
    assert "ke agrees with another reading: another." in story
    assert "0 of 1 figures equal the rounded targets of this case. These do not: z_peak." in page
    assert "- The mesh is fixed." in page
    assert "| z_peak | 0.032 | 0.032 | – |" in page  # in percent of the target
    for name in ("explained.svg", "explained-1.svg"):
        assert (tmp_path / good.case.id / name).read_text().startswith("<svg")
    report.write_index([good], tmp_path)
    assert "10 % of a tolerance is unexplained" in (tmp_path / "README.md").read_text()


def test_a_rest_is_shown_with_its_uncertainty_and_nothing_where_there_is_none(good):
    def rest(value, uncertainty):
        one = explained("z_peak", "Z", "in", -1.0, -1.0, 1.0, [Part("sampling", 0.5, 0.0)])
        parts = [*one.parts[:-1], Part("unexplained", value, uncertainty, "difference")]
        return explain.section(
            msgspec.json.encode(ExplainRecord("A", "0", [replace(one, parts=parts)], [])), good.case
        )

    cells = [rest(*each).tables[0].rows[0][-1] for each in [(0.0, 0.0), (0.1, 0.0), (0.1, 0.02), (0.0, 0.02)]]
    assert cells == ["–", "10", "10 ± 2", "0 ± 2"]
