"""The contract of a law: what a module must define, constants by name, moduli that other rooms ask for."""

from typing import NamedTuple

import pytest

from vmharness.explicit.build import build
from vmharness.explicit.loop import steps
from vmharness.explicit.materials import _law, elastic, piecewise_linear_plasticity, spring_elastic
from vmharness.explicit.materials._law import Moduli, laws
from vmharness.explicit.materials._plasticity.long_curves import has_long_curve
from vmharness.explicit.probes import probe
from vmharness.plugins import ContractError

BAR = """*KEYWORD
*CONTROL_TERMINATION
1.0
*PART
bar
1,1,1
*SECTION_BEAM
1,3
1.0
*MAT_ELASTIC
1,1.0,100.0,0.25
*ELEMENT_BEAM
1,1,1,2
*NODE
1,0.0,0.0,0.0,7,7
2,1.0,0.0,0.0,5,7
*INITIAL_VELOCITY_NODE
2,0.01
"""


@pytest.fixture
def laws_anew():
    """The folder is listed again, before and after."""
    laws.cache_clear()
    yield
    laws.cache_clear()


class Copied(NamedTuple):
    """Of *MAT_ELASTIC, with two more: at the place of a yield curve, and of its name, but no yield curve."""

    E: float
    nu: float
    C: float
    Y: tuple[float, float]


def test_constants_of_any_shape_are_no_yield_curve(deck, monkeypatch):
    """A law of one's own, with a tuple as the fourth of its constants, vibrates as *MAT_ELASTIC does."""
    stresses = []
    for constants in (elastic.constants, lambda deck, entry: Copied(entry.e, entry.pr, 0.0, (1.0, 2.0))):
        monkeypatch.setattr(elastic, "constants", constants)
        model = build(deck(BAR))
        read = probe(model, beam=1, component="axial-stress")
        stresses.append([read() for _ in steps(model)])
    assert not has_long_curve(Copied(1.0, 0.0, 0.0, (1.0, 2.0)))
    assert max(stresses[0]) > 0.05
    assert stresses[1] == stresses[0]


@pytest.mark.parametrize(
    ("module", "name"),
    [
        (elastic, "moduli"),
        (elastic, "density"),
        (elastic, "CHANNELS"),
        (elastic, "solid"),
        (piecewise_linear_plasticity, "constants"),
        (spring_elastic, "bounds"),
        (spring_elastic, "spring"),
    ],
)
def test_what_a_law_lacks_is_said_with_its_file(monkeypatch, laws_anew, module, name):
    monkeypatch.delattr(module, name)
    file = module.__name__.rpartition(".")[2]
    with pytest.raises(ContractError, match=rf"{file}\.py: a module of {_law.FOLDER} must define {name}"):
        laws()


def test_every_law_keeps_its_constants_by_name(monkeypatch):
    """A NamedTuple, or nothing where there is no kernel."""
    assert len(laws()) >= 9
    for module in laws().values():
        made = module.constants.__annotations__["return"]
        assert hasattr(made, "_fields") or not module.HISTORY


def test_moduli():
    """K = E/(3 (1 - 2 nu)) and rho c^2 = K + 4/3 G."""
    E, nu = 210.0, 0.3
    moduli = Moduli(E, nu)
    assert moduli.bulk == pytest.approx(175.0)
    assert moduli.longitudinal == pytest.approx(moduli.bulk + 4 / 3 * E / (2 * (1 + nu)), rel=1e-14)
