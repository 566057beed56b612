"""The results of a run for machines: the types of the file of `vm run --json`, and their JSON schema.

The schema is published: `python -m vmharness.export > docs/schema/results.schema.json`.
"""

import json
from typing import Annotated, Any, Literal

from msgspec import Meta, Struct
from msgspec.json import schema

# It changes when the meaning of a key changes; new keys, outcomes and verdicts come without a new number.
SCHEMA: Literal[2] = 2

Time = Annotated[
    str, Meta(description="UTC, as 2026-01-31T09:30:00Z", pattern=r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$")
]
Digest = Annotated[str, Meta(pattern="^[0-9a-f]{64}$")]
Seconds = Annotated[float, Meta(ge=0)]
Percent = Annotated[
    float | None, Meta(description="Of the target; null where the target is 0 or there is no value")
]
Verdict = Annotated[
    str,
    Meta(
        description="pass, fail (out of tolerance), error (could not be judged), "
        "not reported (the results do not hold the quantity), not representable (by the solver). More may follow: "
        "a reader takes one that it does not know as not judged."
    ),
]


class Result(Struct, frozen=True, kw_only=True):
    """A result: a channel measured at an event, compared with its target by theory."""

    key: Annotated[str, Meta(description="Its identifier in the case")]
    label: str
    event: Annotated[str, Meta(description="Title of the event")]
    channel: Annotated[str, Meta(description="What is measured; `time` for the time of the event")]
    unit: Annotated[str, Meta(description="Of target, value, error and tolerance; empty without a dimension")]
    target: float
    value: Annotated[float | None, Meta(description="null: none, NaN or infinite; then there is a reason")]
    error: Annotated[float | None, Meta(description="value - target")]
    error_percent: Percent
    tolerance: Annotated[float, Meta(description="The largest |value - target| that passes", ge=0)]
    tolerance_percent: Percent
    share: Annotated[float | None, Meta(description="|value - target| / tolerance")]
    verdict: Verdict
    reason: Annotated[str, Meta(description="Why it does not pass; empty for a pass")]
    published: Annotated[
        dict[str, float], Meta(description="Values printed elsewhere, by name of the column")
    ]


class Case(Struct, frozen=True, kw_only=True):
    """A selected case with the outcome of its run by one solver; id, set and solver identify it."""

    id: str
    title: str
    folder: Annotated[str | None, Meta(description="null where a selector named no case")]
    solver: Annotated[str, Meta(description="Name and version")]
    set: Annotated[dict[str, float], Meta(description="Data changed by --set, each in its unit of the case")]
    outcome: Annotated[
        str,
        Meta(
            description="pass, fail, error (could not be judged), not representable (by the solver), "
            "case error (the case is wrong), defect (of vmharness), not run (interrupted before it was finished). "
            "More may follow, as for a verdict."
        ),
    ]
    verdict: Annotated[Verdict, Meta(description="pass, fail, not representable as the outcome; else error")]
    reason: Annotated[str, Meta(description="Why it does not pass; empty for a pass")]
    started: Time | None
    seconds: Annotated[
        Seconds | None, Meta(description="Wall time from the start of the solver to the verdict")
    ]
    cycles: int | None
    facts: Annotated[
        dict[str, str], Meta(description="What the solver says of its run: time step, precision, ...")
    ]
    notes: Annotated[list[str], Meta(description="What was read of the deck without effect")]
    sha256: Annotated[
        dict[str, Digest], Meta(description="By file: case.toml, the deck that ran, what it includes")
    ]
    inputs_sha256: Annotated[
        Digest | None, Meta(description="Of all files of the case but prose and pictures")
    ]
    results: Annotated[
        list[Result], Meta(description="In the order of case.toml; empty where nothing was judged")
    ]


class Solver(Struct, frozen=True, kw_only=True):
    """A solver of the run."""

    name: Annotated[str, Meta(description="As --solver names it")]
    version: Annotated[str, Meta(description="Name and version, as the cases name it")]
    machine: Annotated[str, Meta(description="Compiler and processor where the last digits depend on them")]
    sources_sha256: Annotated[
        Digest, Meta(description="Of the sources of vmharness that a measured value depends on")
    ]


class Machine(Struct, frozen=True, kw_only=True):
    """Where the run took place."""

    host: str
    system: str
    processor: str
    cores: Annotated[int, Meta(ge=1)]
    python: str
    packages: Annotated[dict[str, str], Meta(description="Versions: numpy, numba, ...")]


class Run(Struct, frozen=True, kw_only=True):
    """The results of `vm run`."""

    schema: Annotated[
        Literal[2],
        Meta(
            description="The meaning of the keys. It does not change when keys, outcomes or verdicts are added."
        ),
    ]
    version: Annotated[str, Meta(description="Of vmharness")]
    command: Annotated[list[str], Meta(description="The words of the command line", min_length=1)]
    started: Time
    seconds: Seconds
    machine: Machine
    solvers: list[Solver]
    counts: Annotated[dict[str, Annotated[int, Meta(ge=1)]], Meta(description="Number of cases by outcome")]
    cases: Annotated[list[Case], Meta(description="In the order of the manual: by id")]


class Numbered(Struct, frozen=True):
    """What a file of any schema has."""

    schema: int


def json_schema() -> dict[str, Any]:
    """The schema of the file, made from these types."""
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema(Run)}


if __name__ == "__main__":
    print(json.dumps(json_schema(), indent=2))
