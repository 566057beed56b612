import shutil
from pathlib import Path

import pytest

from vmharness.case import read

CASES = Path(__file__).parents[2] / "cases"


@pytest.mark.parametrize(("id", "deck"), [("VM-061", "deck.k"), ("D-37", "deck.k.j2")])
def test_prose_is_no_input_and_the_deck_is(tmp_path, id, deck):
    folder = Path(shutil.copytree(CASES / id, tmp_path / id))
    known = read(folder).inputs_sha256
    (folder / "README.md").write_text("# Other prose")
    assert read(folder).inputs_sha256 == known
    for name in (deck, "case.toml"):
        (folder / name).write_text((folder / name).read_text() + "\n")
        assert read(folder).inputs_sha256 != known
        known = read(folder).inputs_sha256
