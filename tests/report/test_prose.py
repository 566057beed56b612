"""The prose of a case: sections, pictures from its own folder only, and no HTML of its own."""

from types import SimpleNamespace

from vmharness.report import prose


def written(tmp_path, text):
    (tmp_path / "README.md").write_text(text)
    return SimpleNamespace(folder=tmp_path)


def test_sections_by_title(tmp_path):
    case = written(tmp_path, "# Head\n\nlead\n\n## One\n\ntext\n\n### Deeper\n\nmore\n\n## Two\n")
    assert prose.sections(case) == {"One": "text\n\n### Deeper\n\nmore", "Two": ""}


def test_a_case_without_prose_has_no_sections(tmp_path):
    assert prose.sections(SimpleNamespace(folder=tmp_path)) == {}


def test_pictures_come_from_the_folder_of_the_case_alone(tmp_path):
    outside = tmp_path / "secret.svg"
    outside.write_text("<svg/>")
    folder = tmp_path / "case"
    folder.mkdir()
    (folder / "figure.svg").write_text("<svg/>")
    text = "## A\n\n![in](figure.svg)\n\n![out](../secret.svg)\n\n![far](https://example.org/x.svg)\n"
    case = written(folder, text)
    found = prose.pictures(case)
    assert list(found) == ["figure.svg"]
    page = prose.html(prose.sections(case)["A"], found)
    assert page.count("<img") == 1
    assert 'src="data:image/svg+xml;base64,' in page
    assert "example.org" not in page


def test_html_in_prose_is_text():
    assert "<script>" not in prose.html("<script>alert(1)</script>", {})
