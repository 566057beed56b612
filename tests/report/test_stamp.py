"""What the page and `vm check` say of what made a record."""

from dataclasses import dataclass

import pytest

from vmharness import report
from vmharness.report import records
from vmharness.report.records import stale
from vmharness.studies.faults.record import FaultsRecord
from vmharness.studies.maker import Maker

OURS, OTHERS = "a1" * 32, "b2" * 32


@dataclass
class Old:
    """A record of before it was kept what made it."""

    case: str
    case_sha256: str
    solver: str = "builtin"


def record(case, sources=OURS, case_sha256=None):
    return FaultsRecord(case.id, case_sha256 or case.inputs_sha256, [], Maker("vmharness 9.9.9", sources))


def page(run, folder):
    report.write_case(run, folder)
    to = folder / run.case.id
    return (to / "README.md").read_text(), (to / "index.html").read_text()


def test_the_page_says_what_made_a_study(good, tmp_path):
    records.write(tmp_path, good.case.id, "faults", record(good.case))
    markdown, html = page(good, tmp_path)
    assert "\n*Made by vmharness 9.9.9, sources a1a1a1a1.*\n" in markdown
    assert '<p class="reasons other">Made by vmharness 9.9.9, sources a1a1a1a1.</p>' in html


def test_a_record_of_before_is_read_and_says_that_its_maker_is_unknown(good, tmp_path):
    records.write(tmp_path, good.case.id, "faults", Old(good.case.id, good.case.inputs_sha256))
    markdown, _ = page(good, tmp_path)
    assert "## Planted faults\n" in markdown
    assert "*The record does not name the solver and the sources that made it.*" in markdown


@pytest.mark.parametrize(
    ("sources", "case_sha256", "said"),
    [
        (OURS, None, []),
        (OTHERS, None, ["study faults: made from sources b2b2b2b2; the sources are now a1a1a1a1"]),
        (OURS, "0" * 64, ["study faults: the case was changed after the study"]),
    ],
)
def test_what_would_be_made_otherwise_is_stale(good, tmp_path, sources, case_sha256, said):
    path = records.write(tmp_path, good.case.id, "faults", record(good.case, sources, case_sha256))
    assert stale(path.parent, good.case.inputs_sha256, OURS) == said


def test_studies_that_are_stale_for_one_reason_are_named_together(good, tmp_path):
    for name in ("converge", "sweep"):
        path = records.write(tmp_path, good.case.id, name, Old(good.case.id, good.case.inputs_sha256))
    (path.parent / "faults.json").write_text("nothing")
    assert stale(path.parent, good.case.inputs_sha256, OURS) == [
        "study converge, sweep: the record does not name the sources that made it",
        "study faults: the record cannot be read",
    ]


def test_a_case_without_studies_has_none_that_are_stale(good, tmp_path):
    assert stale(tmp_path / "studies", good.case.inputs_sha256, OURS) == []
