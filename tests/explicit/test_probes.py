"""Probes: the folder is the list, and each channel of a case finds the one that shows it."""

import pytest

from vmharness import plugins
from vmharness.case.format import OWNERS
from vmharness.explicit import probes
from vmharness.explicit.probes import ProbeError, probe
from vmharness.explicit.probes._quantity import split


def test_every_key_of_a_channel_has_just_one_probe():
    keys = [key for module in plugins.modules(probes.__name__, "PROBES") for key in module.PROBES]
    assert sorted(keys) == sorted(OWNERS)


def test_a_node_beside_a_contact_is_where_that_is_read(wall_and):
    model = wall_and("*NODE\n5,0,0,1\n*ELEMENT_MASS\n5,5,1.0\n")
    assert probe(model, node=5, component="z-coordinate")() == 1.0
    with pytest.raises(ProbeError, match="no contact 1; there are: none"):
        probe(model, node=5, component="z-coordinate", contact=1)


@pytest.mark.parametrize("component", ["z", "w-velocity", "-velocity", ""])
def test_a_component_is_an_axis_and_a_quantity(component):
    with pytest.raises(ProbeError, match=r"component '.*' is not of the form z-displacement"):
        split(component)
