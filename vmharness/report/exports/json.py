"""Results as JSON; `docs/schema/results.schema.json` describes the file."""

import msgspec

from vmharness.export import Run


def render(run: Run) -> str:
    """All cases; missing values, NaN and infinity are null."""
    return msgspec.json.format(msgspec.json.encode(run), indent=2).decode() + "\n"
