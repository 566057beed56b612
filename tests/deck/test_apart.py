"""Reading a deck needs no solver: neither numba nor the built-in one is imported."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]

READ = """
import sys
from pathlib import Path
from vmharness.deck import read_all, vocabulary, write_long
known = vocabulary()
for name in sys.argv[1:]:
    deck, wrong = read_all(Path(name), known)
    assert not wrong, wrong
    write_long(deck)
print(sorted(name for name in sys.modules if name == "numba" or name.startswith("vmharness.explicit")))
"""

SMALL = "*KEYWORD\n*MAT_ELASTIC\n1,1.0,1.0\n*MAT_FABRIC\n2,1.0\n*CONTACT_NODES_TO_SURFACE\n1,2\n\n\n*END\n"


def test_no_deck_imports_a_solver(tmp_path: Path) -> None:
    (tmp_path / "small.k").write_text(SMALL)
    decks = [str(path) for path in sorted(ROOT.glob("cases/*/*.k"))]
    assert len(decks) > 20
    command = [sys.executable, "-c", READ, str(tmp_path / "small.k"), *decks]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.stdout, done.stderr) == ("[]\n", "")
