from dataclasses import dataclass

from vmharness import report
from vmharness.report import section
from vmharness.report.section import Figure, Section, Table


@dataclass
class Record:
    orders: dict[str, float]


class Module:
    """A study as one of report/studies."""

    @staticmethod
    def section(content, case):
        assert b'"z_peak": 2.0' in content
        table = Table(["Result", "Order"], [["z_peak | a", "-2.0"]])
        return Section(
            "Kept",
            "order 2",
            ["Some <text>."],
            [table],
            [Figure("kept", "A chart", "<svg>1</svg>")],
            ["A remark"],
        )


def test_what_a_study_left_is_on_the_page(good, tmp_path, monkeypatch):
    monkeypatch.setattr(
        section.dropins, "names", lambda package: ["kept"] if package == section.STUDIES else real(package)
    )
    monkeypatch.setattr(
        section.dropins,
        "module",
        lambda package, name: Module if name == "kept" else real_module(package, name),
    )
    path = section.write(tmp_path, good.case.id, "kept", Record({"z_peak": 2.0}))
    first = path.read_bytes()
    assert section.write(tmp_path, good.case.id, "kept", Record({"z_peak": 2.0})).read_bytes() == first
    report.write_case(good, tmp_path)
    html = (tmp_path / good.case.id / "index.html").read_text()
    assert "<h2>Kept</h2>" in html
    assert "Some &lt;text&gt;." in html
    assert '<td class="number">−2.0</td>' in html
    markdown = (tmp_path / good.case.id / "README.md").read_text()
    assert "| Result | Order |\n|:--|--:|\n| z_peak \\| a | -2.0 |\n\n![A chart](kept.svg)" in markdown
    assert "Some &lt;text>." in markdown
    assert (tmp_path / good.case.id / "kept.svg").read_text() == "<svg>1</svg>"


real, real_module = section.dropins.names, section.dropins.module


def test_a_page_without_studies_has_none(good, tmp_path):
    report.write_case(good, tmp_path)
    assert "Convergence" not in (tmp_path / good.case.id / "README.md").read_text()
