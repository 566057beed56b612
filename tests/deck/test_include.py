"""*INCLUDE: files in their place, and no file that should not be read."""

import hashlib
from pathlib import Path

import pytest

from vmharness.deck import Card, DeckError, Keyword, integer, read, source

KNOWN = {"THING": Keyword("THING", Card(n=integer()))}


def write(folder: Path, **files: str) -> Path:
    for name, content in files.items():
        (folder / f"{name}.k").write_text(content)
    return folder / "deck.k"


def numbers(path: Path, **options: bool) -> list[int]:
    return [entry.n for entry in read(path, KNOWN, **options).all("THING")]


def test_blocks_of_an_include_stand_in_its_place(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "three.k").write_text("*THING\n3\n")
    path = write(
        tmp_path,
        deck="*KEYWORD\n*THING\n1\n*INCLUDE\ntwo.k\nparts/thr +\nee.k\n*THING\n4\n",
        two="*KEYWORD\n*THING\n2\n*END\n*THING\n99\n",
    )
    found = read(path, KNOWN)
    assert [(entry.n, entry.file, entry.line) for entry in found.all("THING")] == [
        (1, "deck.k", 2),
        (2, "two.k", 2),
        (3, "parts/three.k", 1),
        (4, "deck.k", 8),
    ]
    assert list(found.files) == ["deck.k", "two.k", "parts/three.k"]
    assert found.files["two.k"] == hashlib.sha256((tmp_path / "two.k").read_bytes()).hexdigest()


def test_the_format_is_inherited_unless_a_file_says_otherwise(tmp_path: Path) -> None:
    path = write(
        tmp_path,
        deck="*KEYWORD LONG=Y\n*INCLUDE\na.k\nb.k\n*THING\n                   3\n",
        a="*THING\n                   1\n",
        b="*KEYWORD LONG=S\n*THING\n         2\n",
    )
    assert numbers(path) == [1, 2, 3]


def test_parameters_pass_through_includes(tmp_path: Path) -> None:
    path = write(
        tmp_path,
        deck="*KEYWORD\n*INCLUDE\na.k\n*THING\n&n\n",
        a="*PARAMETER\nI n,7\n",
    )
    assert numbers(path) == [7]


def test_a_cycle_is_named(tmp_path: Path) -> None:
    path = write(tmp_path, deck="*KEYWORD\n*INCLUDE\na.k\n", a="*INCLUDE\nb.k\n", b="*INCLUDE\na.k\n")
    with pytest.raises(DeckError) as error:
        numbers(path)
    assert str(error.value) == (
        "b.k:2: *INCLUDE: FILENAME = a.k: a file includes itself: deck.k -> a.k -> b.k -> a.k"
    )


def test_a_file_is_read_once(tmp_path: Path) -> None:
    path = write(tmp_path, deck="*KEYWORD\n*INCLUDE\na.k\na.k\n", a="*THING\n1\n")
    with pytest.raises(
        DeckError, match=r"deck\.k:4: \*INCLUDE: FILENAME = a\.k: the file is included already"
    ):
        numbers(path)


def test_depth_is_limited(tmp_path: Path) -> None:
    chain = {f"f{i}": f"*INCLUDE\nf{i + 1}.k\n" for i in range(30)}
    path = write(tmp_path, deck="*KEYWORD\n*INCLUDE\nf11.k\n", **chain, f30="*THING\n1\n")
    assert numbers(path) == [1]  # 20 deep
    path.write_text("*KEYWORD\n*INCLUDE\nf10.k\n")
    with pytest.raises(DeckError, match=r"f29\.k:2: .* nested more than 20 deep"):
        numbers(path)


def test_size_is_limited(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = write(tmp_path, deck="*KEYWORD\n*INCLUDE\na.k\n", a="*THING\n1\n" + "$" * 50)
    assert numbers(path) == [1]
    monkeypatch.setattr(source, "MOST_BYTES", 70)
    with pytest.raises(DeckError, match=r"deck\.k:3: .*the deck has more than 70 bytes"):
        numbers(path)


@pytest.mark.parametrize(
    "way", ["../outside.k", "{absolute}", "link.k", "folder/outside.k", "sub/../../outside.k"]
)
def test_files_outside_the_folder_are_read_only_if_allowed(tmp_path: Path, way: str) -> None:
    folder = tmp_path / "case"
    folder.mkdir()
    (folder / "sub").mkdir()
    (tmp_path / "outside.k").write_text("*THING\n1\n")
    (folder / "link.k").symlink_to(tmp_path / "outside.k")
    (folder / "folder").symlink_to(tmp_path)
    name = way.format(absolute=tmp_path / "outside.k")
    path = write(folder, deck=f"*KEYWORD\n*INCLUDE\n{name}\n")
    with pytest.raises(DeckError, match=r"deck\.k:\d+: \*INCLUDE: .*lies outside the deck's folder"):
        numbers(path)
    assert numbers(path, include_outside=True) == [1]


def test_links_and_absolute_names_within_the_folder_are_fine(tmp_path: Path) -> None:
    (tmp_path / "a.k").write_text("*THING\n1\n")
    (tmp_path / "link.k").symlink_to(tmp_path / "a.k")
    assert numbers(write(tmp_path, deck="*KEYWORD\n*INCLUDE\nlink.k\n")) == [1]
    assert numbers(write(tmp_path, deck=f"*KEYWORD\n*INCLUDE\n{tmp_path / 'a.k'}\n")) == [1]


def test_a_path_is_where_includes_may_lie_too(tmp_path: Path) -> None:
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "a.k").write_text("*THING\n1\n")
    (tmp_path / "sub" / "b.k").write_text("*THING\n9\n")
    path = write(tmp_path, deck="*KEYWORD\n*INCLUDE_PATH\nsub\nnone\n*INCLUDE\na.k\nb.k\n", b="*THING\n2\n")
    found = read(path, KNOWN)
    assert [entry.n for entry in found.all("THING")] == [1, 2]  # the deck's own folder comes first
    assert list(found.files) == ["deck.k", "sub/a.k", "b.k"]
    path.write_text("*KEYWORD\n*INCLUDE\na.k\n*INCLUDE_PATH\nsub\n")
    with pytest.raises(DeckError, match=r"deck\.k:3: .*no such file in the deck's folder"):
        read(path, KNOWN)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("*INCLUDE\nnone.k\n", "deck.k:3: *INCLUDE: FILENAME = none.k: no such file in the deck's folder"),
        ("*INCLUDE\n.\n", "deck.k:3: *INCLUDE: FILENAME = .: no such file in the deck's folder"),
        ("*INCLUDE\na\0b\n", "deck.k:3: *INCLUDE: FILENAME = a\0b: not a file name"),
        ("*INCLUDE\n\n", "deck.k:2: *INCLUDE: a file name is required"),
        ("*INCLUDE\n", "deck.k:2: *INCLUDE: a file name is required"),
        ("*INCLUDE\nnone +\n", "deck.k:3: *INCLUDE: the continued file name does not end"),
        (
            "*INCLUDE_PATH\n..\n",
            "deck.k:3: *INCLUDE_PATH: FILENAME = ..: lies outside the deck's folder, where files are read only if allowed",
        ),
    ],
)
def test_message(tmp_path: Path, content: str, message: str) -> None:
    with pytest.raises(DeckError) as error:
        numbers(write(tmp_path, deck="*KEYWORD\n" + content))
    assert str(error.value) == message
