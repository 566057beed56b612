"""The JSON schema of case.toml, for editors: `python -m vmharness.case.schema > cases/case.schema.json`."""

import json
from typing import Any

from msgspec.json import schema

from vmharness.case.format import CaseFile


def json_schema() -> dict[str, Any]:
    """The schema, made from the types that check the file."""
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema(CaseFile)}


if __name__ == "__main__":
    print(json.dumps(json_schema(), indent=2))
