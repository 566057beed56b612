"""Solvers of other installed packages, found by their entry points."""

import pytest

from vmharness.backends import BackendError, backend, calls, names
from vmharness.deck import DeckError

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
    assert names() == ["broken", "builtin", "calculix", "mujoco", "opensees", "other"]
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


@pytest.mark.parametrize("call", ["found", "review", "reports", "solve"])
def test_what_a_function_raises_is_an_error_of_its_solver(installed, call):
    raising = "def _raise(*given):\n    raise KeyError('x')\n"
    installed("other", SOUND + raising + f"{call} = _raise\n")
    given = {"found": (), "reports": (None,), "solve": (None,)}.get(call, (None, {}))
    with pytest.raises(BackendError, match=rf"^solver other: {call} failed: KeyError: 'x'$"):
        getattr(calls.solver("other"), call)(*given)


def test_what_the_protocol_lets_a_solver_raise_is_passed_on(installed):
    raising = (
        "from vmharness.deck import DeckError\ndef review(*given):\n    raise DeckError('no such card')\n"
    )
    installed("other", SOUND + raising)
    with pytest.raises(DeckError, match="no such card"):
        calls.solver("other").review(None, {})


def test_an_exception_of_the_built_in_solver_stays_a_defect(monkeypatch):
    def fail(*given):
        raise KeyError("x")

    monkeypatch.setattr(backend("builtin"), "review", fail)
    with pytest.raises(KeyError):
        calls.solver("builtin").review(None, {})


def test_a_solver_need_not_declare_what_it_supports(installed):
    installed("other", SOUND)
    assert calls.supported("other") is None
    assert "MAT_ELASTIC" in calls.supported("builtin")
    installed("third", SOUND + "def supported():\n    raise KeyError('x')\n")
    with pytest.raises(BackendError, match=r"^solver third: supported failed: KeyError: 'x'$"):
        calls.supported("third")
