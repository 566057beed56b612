"""The folder is the list of keywords."""

import sys
from pathlib import Path

import pytest

from vmharness.deck import Card, Entry, Keyword, Rows, integer, vocabulary
from vmharness.deck.keyword import RESERVED


def package(folder: Path, name: str, monkeypatch: pytest.MonkeyPatch, **modules: str) -> str:
    (folder / name).mkdir()
    (folder / name / "__init__.py").write_text("")
    for module, names in modules.items():
        source = "from vmharness.deck import Keyword\n"
        source += "".join(f"K{i} = Keyword({n})\n" for i, n in enumerate(names.split(";")))
        (folder / name / f"{module}.py").write_text(source)
    monkeypatch.syspath_prepend(str(folder))
    for known in [known for known in sys.modules if known.partition(".")[0] == name]:
        monkeypatch.delitem(sys.modules, known)
    return name


def test_keywords_of_every_module_by_name_and_alias(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    name = package(
        tmp_path,
        "dropped_in",
        monkeypatch,
        one="'A'",
        two="'B', aliases=('C',)",
    )
    found = vocabulary(name)
    assert sorted(found) == ["A", "B", "C"]
    assert found["C"] is found["B"]


def test_a_name_defined_twice_is_fatal(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    name = package(tmp_path, "dropped_twice", monkeypatch, one="'A'", two="'B';'A'")
    with pytest.raises(ValueError, match=r"dropped_twice\.two: \*A is defined already"):
        vocabulary(name)


def test_a_module_that_cannot_be_imported_is_fatal(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    name = package(tmp_path, "dropped_broken", monkeypatch, one="'A'", two="nonsense")
    with pytest.raises(NameError):
        vocabulary(name)


def test_a_layout_that_cannot_be_meant_is_refused() -> None:
    with pytest.raises(ValueError, match=r"\*A: two fields have the name a"):
        Keyword("A", Card(a=integer()), Card(a=integer()))
    with pytest.raises(ValueError, match=r"\*A: an entry cannot have a field line"):
        Keyword("A", Card(line=integer()))
    with pytest.raises(ValueError, match=r"\*A: rows take all lines"):
        Keyword("A", Card(a=integer()), Rows(b=integer()), repeat=True)


def test_no_field_can_hide_what_an_entry_has() -> None:
    own = {name for name in dir(Entry) if not name.startswith("_")}
    assert own == RESERVED


def test_summary_shows_what_is_supported() -> None:
    keyword = vocabulary("vmharness.deck.keywords")["CONTROL_SHELL"]
    assert "THEORY=2(only 2)" in keyword.summary({"theory": "only 2"})[0]
    assert "THEORY=2 " in keyword.summary()[0]
