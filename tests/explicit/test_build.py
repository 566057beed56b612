"""Building a model: names of files have no effect, and a drop-in that breaks its folder's contract is named."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from vmharness import plugins

PACKAGE = Path(__file__).parents[2] / "vmharness"
FOLDERS = {
    "explicit/elements": ("NAME", "build"),
    "explicit/contact/kinds": ("NAME", "build"),
    "explicit/loads": ("NAME", "build"),
    "explicit/probes": ("PROBES",),
}

# Shells, a bar and a spring, masses, two kinds of contact, three kinds of load.
DECK = """*KEYWORD
*CONTROL_TERMINATION
0.2
*CONTROL_TIMESTEP
0.0,0.8,0,0.0,-0.01
*PART
shells
1,1,1
*PART
bar
2,2,1
*PART
spring
3,3,3
*SECTION_SHELL
1,2,1.0,2
0.1
*SECTION_BEAM
2,3
0.1
*SECTION_DISCRETE
3

*MAT_ELASTIC
1,1e-4,3.0,0.3
*MAT_SPRING_ELASTIC
3,0.5
*NODE
1,0.0,0.0,0.0
2,1.0,0.0,0.0
3,1.0,1.0,0.0
4,0.0,1.0,0.0
5,0.0,0.0,-1.0,7,7
6,0.3,0.3,0.01
7,0.7,0.6,0.02
*ELEMENT_SHELL
1,1,1,2,3,4
*ELEMENT_BEAM
1,2,1,5
*ELEMENT_DISCRETE
1,3,3,6
*ELEMENT_MASS
1,6,1e-5
2,7,1e-5
*DEFINE_CURVE
1
0.0,1.0
1.0,1.0
*LOAD_BODY_Z
1,10.0
*LOAD_NODE_POINT
6,3,1,-0.01
*LOAD_SEGMENT
1,0.1,0.0,1,2,3,4
*SET_NODE_LIST
1
6
*SET_NODE_LIST
2
7
*CONTACT_NODES_TO_SURFACE
1,1,4,3


*CONTACT_AUTOMATIC_NODES_TO_SURFACE
2,1,4,3


"""
RUN = """
import sys
from pathlib import Path
from vmharness.deck import read, vocabulary
from vmharness.explicit.build import build
from vmharness.explicit.loop import steps
model = build(read(Path(sys.argv[1]), vocabulary()))
for state in steps(model):
    pass
print(sys.modules["vmharness"].__file__ == str(Path.cwd() / "vmharness" / "__init__.py"))
print([force.name for force in model.forces], model.facts, state.cycle, state.t.hex())
print(state.x.tobytes().hex(), state.v.tobytes().hex())
"""


def modules_of(folder: Path) -> list[Path]:
    return sorted(
        path for path in folder.iterdir() if not path.name.startswith("_") and path.suffix in ("", ".py")
    )


def rename_backwards(package: Path) -> None:
    """Rename the drop-ins of a copy of the package so that their alphabetical order is reversed."""
    for folder in ("explicit/elements", "explicit/contact/kinds", "explicit/loads"):
        prefix = "vmharness." + folder.replace("/", ".")
        new = {}
        for place, path in enumerate(reversed(modules_of(package / folder))):
            new[path.stem] = f"renamed_{place}"
            path.rename(path.with_name(new[path.stem] + path.suffix))
        for path in package.rglob("*.py"):
            path.write_text(with_new_names(path.read_text(), prefix, new))


def with_new_names(source: str, prefix: str, new: dict[str, str]) -> str:
    """The source with its imports from `prefix` changed: `prefix.old` and `from prefix import old, ...`."""
    dotted = re.compile(rf"{re.escape(prefix)}\.({'|'.join(new)})\b")
    source = dotted.sub(lambda found: f"{prefix}.{new[found[1]]}", source)
    names = re.compile(rf"(?<=from {re.escape(prefix)} import ).*")
    old = re.compile(rf"\b({'|'.join(new)})\b")
    return names.sub(
        lambda found: old.sub(lambda name: f"{new[name[1]]} as {name[1]}", found.group()), source
    )


def results(root: Path, deck: Path) -> str:
    """What the package in `root` prints: a process looks first in the folder in which it runs."""
    command = [sys.executable, "-c", RUN, str(deck)]
    return subprocess.run(command, cwd=root, capture_output=True, text=True, check=True).stdout


def test_names_of_files_have_no_effect_on_order_facts_and_bits(tmp_path):
    deck = tmp_path / "deck.k"
    deck.write_text(DECK)
    ignored = shutil.ignore_patterns("__pycache__")
    shutil.copytree(PACKAGE, tmp_path / "vmharness", ignore=ignored)
    rename_backwards(tmp_path / "vmharness")
    sound = results(PACKAGE.parent, deck)
    assert sound.startswith("True")
    assert "shells of part 1" in sound
    assert "Mass added to" in sound
    assert results(tmp_path, deck) == sound


def test_names_of_drop_ins_that_order_them_are_unique():
    for folder, required in FOLDERS.items():
        if "NAME" in required:
            found = plugins.modules("vmharness." + folder.replace("/", "."), *required)
            assert len({module.NAME for module in found}) == len(found), folder


@pytest.mark.parametrize("folder", FOLDERS)
def test_a_drop_in_without_what_its_folder_requires_is_named(folder):
    required = FOLDERS[folder]
    broken = PACKAGE / folder / "broken_drop_in_of_a_test.py"
    package = "vmharness." + folder.replace("/", ".")
    broken.write_text('"""A drop-in that defines nothing."""\n')
    try:
        with pytest.raises(
            plugins.ContractError, match=rf"{broken.name}: .*must define {', '.join(required)}"
        ):
            plugins.modules(package, *required)
    finally:
        broken.unlink()
        sys.modules.pop(f"{package}.{broken.stem}", None)
