"""A case that does wrong whatever it can, beside one that is good: it costs only itself, in every command."""

import json
import os
import shutil
from pathlib import Path

import pytest

BALL = Path(__file__).parents[2] / "cases" / "VM-061"
SUM = "ke = 'm*sum(sum(sum(sum(1, i, 1, 100), j, 1, 100), k, 1, 100), n, 1, 100)'"
LOOPS = 4 * "{% for i in range(99999) %}" + 4 * "{% endfor %}"
MESH = '[deck]\nmesh = { n = "3" }\nfile = "deck.k.j2"'


def replaced(old, new):
    """A change of case.toml."""

    def change(folder):
        text = (folder / "case.toml").read_text()
        assert old in text
        (folder / "case.toml").write_text(text.replace(old, new, 1))

    return change


def template(text):
    """A change: the deck becomes a template with `text` in its first line."""

    def change(folder):
        deck = (folder / "deck.k").read_text()
        (folder / "deck.k").unlink()
        (folder / "deck.k.j2").write_text(f"$ {text}\n{deck}")
        replaced('[deck]\nfile = "deck.k"', MESH)(folder)

    return change


KINDS = {
    "deep": (replaced("[deck]", f"x = {20_000 * '['}\n[deck]"), r"deep/case.toml:"),
    "huge": (replaced("value = 1.0", f"value = {5000 * '9'}"), "a whole number of more than 4300 digits"),
    "nul": (replaced("post.cfile", "a\\u0000b"), "cannot be the name of a file"),
    "long": (replaced("post.cfile", 5000 * "a"), "cannot be the name of a file"),
    "loop": (lambda folder: (folder / "p.svg").symlink_to("p.svg"), "loop/p.svg: a link that leads nowhere"),
    "latin": (lambda folder: (folder / "README.md").write_bytes(b"# Caf\xe9"), "README.md:1: the byte 0xe9"),
    "sums": (replaced("[theory]", f"[theory]\n{SUM}"), "[theory] ke: in `sum(1, i, 1, 100)`"),
    "endless": (template(LOOPS), "not done after 10 s, the time limit"),
    "macro": (template("{% macro f() %}{{ f() }}{% endmacro %}{{ f() }}"), "deck.k.j2:1: calls itself"),
    "nested": (template(f"{{{{ {3000 * '('}n{3000 * ')'} }}}}"), "deck.k.j2:1: nested too deeply"),
    "large": (template("{{ 'a' * 10**11 }}"), "deck.k.j2:1: a text or list repeated"),
    "half": (template("{{ '\\ud800' }}"), "deck.k.j2:1: makes '\\ud800', which no file can hold"),
    "caf\udce9": (lambda folder: None, "caf\\udce9: the name of the folder is not text"),
}


@pytest.fixture
def beside(ball, here):
    """All kinds of bad cases in ./cases, beside a good one."""
    ball(id="good")
    for id, (change, _) in KINDS.items():
        change(ball(id=id))
    (here / "cases" / "round").symlink_to("round")  # a folder that is a link to itself
    (here / "cases" / "gone").mkdir()
    (here / "cases" / "gone" / "case.toml").symlink_to("nowhere")


def test_a_good_case_is_judged_beside_every_kind_of_bad_one(beside, vm):
    code, out, _ = vm("run", "--timeout", "10", "--json", "r.json", "--junit", "r.xml")
    assert code == 4
    assert f"{len(KINDS) + 1} case error, 1 pass" in out
    for _, message in KINDS.values():
        assert message in out
    assert "gone: no case.toml can be read" in out
    assert "PASS" in Path("reports/good/README.md").read_text()
    for id in KINDS:
        shown = id.encode("utf-8", "backslashreplace").decode()
        assert "NOT JUDGED" in Path("reports", shown, "README.md").read_text()
    assert "good" in Path("reports/README.md").read_text()
    assert "good" in [case["id"] for case in json.loads(Path("r.json").read_text())["cases"]]
    assert os.path.getsize("r.xml")


def test_every_other_command_says_what_is_wrong_of_each(beside, here, vm):
    shutil.copytree(BALL, here / "cases" / "sound")
    code, out, _ = vm("check", "--timeout", "10")
    assert code == 4
    assert "sound: ok" in out
    for _, message in KINDS.values():
        assert message in out
    code, out, _ = vm("list")
    assert code == 0
    assert "good" in out
    for command in ("show", "converge", "sweep", "explain"):
        code, _, err = vm(command, "macro")
        assert code == 4
        assert "deck.k.j2:1: calls itself without end" in err
