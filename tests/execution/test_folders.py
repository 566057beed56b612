"""Work folders of runs."""

from vmharness.execution.folders import WorkFolders


def test_the_folder_of_a_run_is_empty_and_gone_after_it():
    with WorkFolders() as folders:
        first, second = folders.folder(0), folders.folder(1)
        assert first != second
        assert not list(first.iterdir())
        (first / "d3plot").write_text("")
        assert folders.close(0) == ""
        assert not first.exists()
    assert not second.exists()
    assert not second.parent.exists()


def test_files_of_a_run_that_failed_are_kept_and_named():
    with WorkFolders() as folders:
        with_files, without = folders.folder(0), folders.folder(1)
        (with_files / "messag").write_text("no licence")
        assert folders.close(0, "exit code 1") == f"exit code 1 (its files: {with_files})"
        assert folders.close(1, "exit code 1") == "exit code 1"
    assert (with_files / "messag").read_text() == "no licence"
    assert not without.exists()
    (with_files / "messag").unlink()
    with_files.rmdir()
    with_files.parent.rmdir()
