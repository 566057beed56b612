"""A case that does wrong whatever it can, beside one that is good: it costs only itself, in every command."""

import os
import shutil
import time
from pathlib import Path

import pytest

SUM = "T = 'sum(sum(sum(sum(1, i, 1, 100), j, 1, 100), k, 1, 100), n, 1, 100)'"
LOOPS = 4 * "{% for i in range(99999) %}" + 4 * "{% endfor %}"


def text_of(folder, name, old, new):
    path = folder / name
    path.write_text(path.read_text().replace(old, new, 1))


def template(text):
    """A change: the deck becomes a template, with `text` at its end."""

    def change(folder):
        deck = folder / "deck.k"
        deck.rename(folder / "deck.k.j2").open("a").write(f"$ {text}\n")
        text_of(
            folder, "case.toml", "[deck]", '[deck]\nfile = "deck.k.j2"\n[deck.mesh]\nn = "3"\n[deck.ignored]'
        )
        text = (folder / "case.toml").read_text()
        (folder / "case.toml").write_text(text.replace("[deck.ignored]", ""))

    return change
