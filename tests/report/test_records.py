from dataclasses import dataclass
from pathlib import Path

import pytest

from vmharness import plugins, report
from vmharness.report import records
from vmharness.report.blocks import Figure, Section, Table
from vmharness.report.records import Studies


@dataclass
class Record:
    orders: dict[str, float]
    case_sha256: str | None = None


class Study:
    """As a module of report/studies."""

    @staticmethod
    def section(content, case):
        assert b'"z_peak": 2.0' in content
        table = Table(["Result", "Order"], [["z_peak | a", "-2.0"]])
        return Section("Kept", "order 2", ["Some <text>."], [table], remarks=["A remark"])

    @staticmethod
    def figures(content):
        return [Figure("kept", "A chart", "<svg>1</svg>")]


@pytest.fixture
def study(monkeypatch):
    """One study, called kept, in place of those that there are."""
    names, module = plugins.names, plugins.module
    monkeypatch.setattr(records.plugins, "names", lambda p: ["kept"] if p == records.STUDIES else names(p))
    monkeypatch.setattr(
        records.plugins, "module", lambda p, name: Study if p == records.STUDIES else module(p, name)
    )


def left(folder, case, **others):
    return records.write(folder, case.id, "kept", Record({"z_peak": 2.0}, **others))


def test_what_a_study_left_is_on_the_page(good, tmp_path, study):
    path = left(tmp_path, good.case)
    first = path.read_bytes()
    assert left(tmp_path, good.case).read_bytes() == first
    report.write_case(good, tmp_path)
    html = (tmp_path / good.case.id / "index.html").read_text()
    assert "<h2>Kept</h2>" in html
    assert "Some &lt;text&gt;." in html
    assert '<td class="number">−2.0</td>' in html
    markdown = (tmp_path / good.case.id / "README.md").read_text()
    assert "| Result | Order |\n|:--|--:|\n| z_peak \\| a | -2.0 |\n\n![A chart](kept.svg)" in markdown
    assert "Some &lt;text>." in markdown
    assert (tmp_path / good.case.id / "kept.svg").read_text() == "<svg>1</svg>"


def test_the_index_says_it_in_a_few_words(good, tmp_path, study, monkeypatch):
    left(tmp_path, good.case)
    monkeypatch.setattr(Study, "figures", None)  # the index draws nothing
    report.write_index([good], tmp_path)
    assert "| order 2 |" in (tmp_path / "README.md").read_text()
    assert "order 2</td>" in (tmp_path / "index.html").read_text()


def test_a_study_of_another_state_of_the_case_says_so(good, tmp_path, study):
    left(tmp_path, good.case)
    assert records.studies(good.case, tmp_path / good.case.id).sections[0].text == ["Some <text>."]
    left(tmp_path, good.case, case_sha256="0" * 64)
    assert records.studies(good.case, tmp_path / good.case.id).sections[0].text == [
        records.OLD,
        "Some <text>.",
    ]


def test_other_data_than_the_case_s_have_no_studies(good, tmp_path, study):
    left(tmp_path, good.case)
    other = good.case.with_given({"k": 2000.0})
    assert records.studies(other, tmp_path / good.case.id) == Studies([], {})


def test_a_record_of_another_version_is_left_out(good, tmp_path):
    path = records.write(tmp_path, good.case.id, "converge", Record({}))
    assert records.studies(good.case, path.parents[1]) == Studies([], {})


REPORTS = Path(__file__).parents[2] / "reports"
TRUE = {path.stem: path.read_bytes() for path in sorted((REPORTS / "VM-061" / "studies").glob("*.json"))}
OTHER = b'"nowhere'  # begins the name of each result, in place of its own


@pytest.mark.parametrize("name", TRUE)
def test_a_file_that_is_no_record_is_left_out_and_the_other_studies_stay(good, tmp_path, name):
    folder = tmp_path / good.case.id
    for study, content in TRUE.items():
        (folder / "studies").mkdir(parents=True, exist_ok=True)
        (folder / "studies" / f"{study}.json").write_bytes(content)
    complete = records.studies(good.case, folder)
    assert len(complete.sections) == len(TRUE)
    true = TRUE[name]
    wrong = [
        b"",
        b"{}",
        b"[]",
        b"null",
        true[: len(true) // 2],
        b"\xff" + true,
        99_999 * b"[",
        b'{"results": 7}',
    ]
    for content in [*wrong, true.replace(b'"z_', OTHER).replace(b'"t_', OTHER)]:
        (folder / "studies" / f"{name}.json").write_bytes(content)
        found = records.studies(good.case, folder)
        assert len(found.sections) >= len(TRUE) - 1
        assert [section for section in complete.sections if section in found.sections][: len(TRUE) - 1]
        assert report.write_case(good, tmp_path)
        assert report.write_index([good], tmp_path)
        if content in wrong[4:7]:
            assert f"study {name}: the record cannot be read" in records.stale(folder / "studies", "", "")
