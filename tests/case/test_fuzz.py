"""Case files changed at random: each is a case, or a CaseError that names the place; formulas end, with a number or not."""

import copy
import json
import math
import shutil
import tomllib
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from vmharness.case import Case, CaseError
from vmharness.formula import Formula, FormulaError
from vmharness.formula.functions import FUNCTIONS
from vmharness.suite.check import accepted
from vmharness.suite.select import Entry

CASES = Path(__file__).parents[2] / "cases"
HOSTILE = [
    "",
    "x" * 3000,
    "a\0b",
    "\x1b[2J",
    "<script>alert(1)</script>",
    "../../etc/passwd",
    "{{ 7 * 7 }}",
    "%s%n",
    "1/0",
    "h/(h - h)",
    "sqrt(-h/h)",
    "9**9**9",
    "((((((((((",
    "h + g",
    "h**h",
    "sum(1, i, 1, 1e9)",
    "sum(sum(sum(i*j*k/i/j/k, i, 1, 90), j, 1, 90), k, 1, 90)",
    "root(root(root(x + y + z, x, -99, 99), y, -20, 20), z, -9, 9)",
    "+1 %",
    "-1e400 %",
    "=nan",
    "kg*m/s^2^2",
    "kg/0",
    "m^99999999999",
    "s^(1/0)",
]
NUMBERS = [0, -1, 1, 10**30, 10**400, 5e-324, 1e308, -1e-3, math.inf, -math.inf, math.nan, True, False]
VALUES = st.one_of(
    st.sampled_from(HOSTILE),
    st.sampled_from(NUMBERS),
    st.text(max_size=8).filter(lambda text: text.isprintable()),
    st.floats(),
    st.sampled_from([[], {}, [[]], [{}], {"a": {"b": []}}, ["x", 1], {"relative": 1e-6}]),
)


@pytest.fixture(scope="module")
def folders(tmp_path_factory):
    """Copies of a case with a deck and of one with a template, and the tables of their files."""
    root = tmp_path_factory.mktemp("cases")
    copies = [shutil.copytree(CASES / id, root / id) for id in ("VM-061", "D-37")]
    return [(folder, tomllib.loads((folder / "case.toml").read_text())) for folder in copies]


def written(value):
    """A value in TOML."""
    match value:
        case bool():
            return str(value).lower()
        case str():
            return json.dumps(value).replace("\x7f", "\\u007f")
        case dict():
            return (
                "{" + ", ".join(f"{json.dumps(key)} = {written(part)}" for key, part in value.items()) + "}"
            )
        case list():
            return f"[{', '.join(map(written, value))}]"
    return repr(value)


def places(table, above=()):
    """The paths to all values in a table."""
    for key, value in table.items() if isinstance(table, dict) else enumerate(table):
        yield (*above, key)
        if isinstance(value, dict | list):
            yield from places(value, (*above, key))


def changed(draw, table):
    """The table with some values replaced, removed, doubled or given another name."""
    table = copy.deepcopy(table)
    for _ in range(draw(st.integers(1, 3))):
        *above, last = draw(st.sampled_from(sorted(places(table), key=str)))
        owner = table
        for key in above:
            owner = owner[key]
        match draw(st.sampled_from(["replace", "replace", "replace", "remove", "double", "rename"])):
            case "replace":
                owner[last] = draw(VALUES)
            case "remove":
                del owner[last]
            case "double" if isinstance(owner, list):
                owner.append(owner[last])
            case "rename" if isinstance(owner, dict):
                owner[draw(st.sampled_from(["", "x", "t", "pi", "sum", "N", *owner]))] = owner.pop(last)
    return table


def read(folder, content):
    """Read and review a case with another case.toml; anything but a CaseError that names the case is an error."""
    (folder / "case.toml").write_bytes(content)
    found = tried(lambda: accepted(Entry(folder)), CaseError)
    if isinstance(found, str):
        assert "cannot be read" not in found  # the words of an exception that nothing expects
    else:
        assert isinstance(found, Case)
        assert all(map(math.isfinite, found.values.values()))


def tried(call, expected):
    """What a call returns, or the words of the expected exception."""
    try:
        return call()
    except expected as error:
        return str(error) or "no words"


@settings(max_examples=250, suppress_health_check=list(HealthCheck))
@given(st.data())
def test_tables_changed_at_random(folders, data):
    folder, table = data.draw(st.sampled_from(folders))
    table = changed(data.draw, table)
    read(folder, "\n".join(f"{json.dumps(key)} = {written(value)}" for key, value in table.items()).encode())


@settings(max_examples=100, suppress_health_check=list(HealthCheck))
@given(st.data())
def test_bytes_changed_at_random(folders, data):
    folder, _ = data.draw(st.sampled_from(folders))
    content = (CASES / folder.name / "case.toml").read_bytes()
    at = data.draw(st.integers(0, len(content)))
    removed = data.draw(st.integers(0, 40))
    added = data.draw(
        st.one_of(st.binary(max_size=6), st.sampled_from([b"[" * 3000, b"9" * 5000, b'"""', b"=", b"\n["]))
    )
    read(folder, content[:at] + added + content[at + removed :])


LEAVES = st.sampled_from(
    ["a", "b", "c", "n", "x", "pi", "0", "1", "2", "0.5", "1e3", "1e300", "1e-300", "-3"]
)
FORMULAS = st.recursive(
    LEAVES,
    lambda inner: st.one_of(
        st.builds("({} {} {})".format, inner, st.sampled_from(["+", "-", "*", "/", "**"]), inner),
        st.builds("{}({})".format, st.sampled_from(sorted({*FUNCTIONS} - {"sum", "root"})), inner),
        st.builds("{}({}, {})".format, st.sampled_from(["max", "min", "atan2", "besselj"]), inner, inner),
        st.builds("where({} < {}, {}, {})".format, inner, inner, inner, inner),
        st.builds("sum({}, n, 1, {})".format, inner, st.sampled_from(["3", "1e3", "1e6", "b"])),
        st.builds("root({}, x, {}, {})".format, inner, inner, inner),
    ),
    max_leaves=12,
)


@settings(max_examples=300, suppress_health_check=list(HealthCheck))
@given(text=FORMULAS)
def test_formulas_end_with_a_finite_number_or_say_why_not(text):
    names = {"a": 2.0, "b": 3.0, "c": -0.5, "n": 1.0, "x": 1.5}
    value = tried(lambda: Formula(text).evaluate(names), FormulaError)
    assert "no words" not in str(value)
    assert isinstance(value, str) or math.isfinite(value)
