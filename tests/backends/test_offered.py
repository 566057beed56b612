"""Solvers of other installed packages, found by their entry points."""

import pytest

from vmharness.backends import BackendError, backend, names

SOUND = """
from vmharness.backends.protocol import Found

NAME = "Other"
review = reports = solve = None

def found():
    return Found(version="2.1", where="/opt/other")
"""


def test_a_solver_of_another_package_is_listed_without_an_import_and_found_by_its_name(installed):
    installed("broken", "1 / 0")
    installed("other", SOUND)
    assert names() == ["broken", "builtin", "other"]
    assert backend("other").found().version == "2.1"


def test_an_import_that_fails_is_the_error_of_that_solver_alone(installed):
    installed("broken", "import no_such_library")
    with pytest.raises(
        BackendError, match=r"solver broken, broken_adapter of the package broken_adapter: .*no_such"
    ):
        backend("broken")
    assert backend("builtin").NAME == "vmharness"


def test_what_a_module_lacks_is_named_with_its_file(installed):
    site = installed("other", SOUND.replace("solve = None", "None"))
    with pytest.raises(BackendError, match=r"other_adapter\.py: .* must define solve") as caught:
        backend("other")
    assert str(site) in str(caught.value)


def test_a_name_is_taken_once(installed):
    installed("builtin", SOUND)
    message = (
        "solver builtin is offered twice, by vmharness.backends.builtin and by "
        "builtin_adapter of the package builtin_adapter; uninstall one"
    )
    with pytest.raises(BackendError, match=message):
        backend("builtin")
    installed("other", SOUND, package="first")
    installed("other", SOUND, package="second")
    with pytest.raises(BackendError, match=r"offered twice.*first.*second|offered twice.*second.*first"):
        backend("other")


def test_an_unknown_name_says_which_there_are():
    with pytest.raises(BackendError, match="no solver abaqus; there are: builtin"):
        backend("abaqus")
