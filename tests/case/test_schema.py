"""The published JSON schema is the one that the format makes, and the case files name it."""

import json
from pathlib import Path

from vmharness.case.schema import json_schema

CASES = Path(__file__).parents[2] / "cases"


def test_the_published_schema_is_up_to_date():
    """Write it anew with: python -m vmharness.case.schema > cases/case.schema.json"""
    assert json.loads((CASES / "case.schema.json").read_text()) == json_schema()


def test_every_case_names_it():
    for path in CASES.glob("*/case.toml"):
        name = path.read_text().splitlines()[0].removeprefix("#:schema ")
        assert (path.parent / name).resolve() == (CASES / "case.schema.json").resolve()
