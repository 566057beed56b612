"""Results that cannot disagree are refused, and those beside them that can are accepted."""

import pytest

from vmharness.case import CaseError, read
from vmharness.case.format import Channel, Event
from vmharness.case.tautology import tautology

AT = 'then = { at = "T", title = "At the Time T" }'
CROSSING = 'crossing_of = "{}", level = "{}", direction = "down", title = "At the Level"'
KINETIC = 'kinetic = { energy = "kinetic"'


def channel(**keys):
    return Channel(text="", **keys)


def of(component, **owner):
    return channel(component=component, **(owner or {"node": 1}))


CROSSED = Event(title="", crossing_of="c", level="1", direction="up")
LEVEL, ZERO = "there it is the level itself", "there it is zero"


@pytest.mark.parametrize(
    ("event", "seen", "read", "why"),
    [
        (CROSSED, of("z-displacement"), of("z-displacement"), LEVEL),
        (CROSSED, of("z-displacement"), of("z-coordinate"), LEVEL),
        (CROSSED, of("x-velocity", centre="all"), of("x-momentum", centre="all"), LEVEL),
        (CROSSED, channel(energy="kinetic"), channel(energy="kinetic"), LEVEL),
        (CROSSED, of("xx-stress", solid=1), of("xx-stress", solid=1, point=1), LEVEL),
        (CROSSED, of("axial-force", beam=1), of("axial-stress", beam=1), LEVEL),
        (CROSSED, of("axial-force", beam=1), of("s-shear", beam=1), ""),
        (CROSSED, of("z-displacement"), of("z-velocity"), ""),
        (CROSSED, of("z-displacement"), of("x-displacement"), ""),
        (CROSSED, of("z-displacement"), of("z-displacement", node=2), ""),
        (CROSSED, of("xx-stress", solid=1), of("xx-stress", solid=1, point=2), ""),
        (CROSSED, channel(energy="internal", part=1), channel(energy="internal", part=2), ""),
        (Event(title="", maximum_of="c"), of("z-coordinate"), of("z-velocity"), ZERO),
        (Event(title="", minimum_of="c"), of("x-velocity", rigid=2), of("x-acceleration", rigid=2), ZERO),
        (Event(title="", maximum_of="c"), of("y-rotation", rigid=2), of("y-angular-velocity", rigid=2), ZERO),
        (Event(title="", minimum_of="c"), of("x-impulse", wall=1), of("x-force", wall=1), ZERO),
        (Event(title="", maximum_of="c"), of("z-coordinate"), of("z-coordinate"), ""),
        (Event(title="", maximum_of="c"), of("z-velocity"), of("z-coordinate"), ""),
        (Event(title="", onset_of="c"), of("z-force", contact=1), of("z-force", contact=1), ZERO),
        (Event(title="", onset_of="c"), of("z-force", contact=1), of("friction energy", contact=1), ZERO),
        (Event(title="", onset_of="c", times=2, pick=2), of("z-force", contact=1), of("friction energy", contact=1), ""),
        (Event(title="", end_of="c"), of("z-force", contact=1), of("area", contact=1), ZERO),
        (Event(title="", end_of="c"), of("z-force", contact=1), of("friction energy", contact=1), ""),
        (Event(title="", end_of="c"), of("z-force", contact=1), of("z-force", contact=2), ""),
    ],
)  # fmt: skip
def test_the_event_gives_the_value_of_some_channels(event, seen, read, why):
    assert tautology(event, seen, read).startswith(why)
    assert bool(tautology(event, seen, read)) == bool(why)


def test_a_displacement_at_its_own_level_is_no_result(fall):
    level = (AT, f"then = {{ {CROSSING.format('z', '-g*T^2/2')} }}")
    message = r"\[results\] 1: z at then \(z\): there it is the level itself.*cannot disagree with its target"
    with pytest.raises(CaseError, match=message):
        read(fall(level))


def test_the_same_quantity_under_another_name_is_none_either(fall):
    same = 'other = { node = 1, component = "z-coordinate", text = "Height" }'
    level = (AT, f"then = {{ {CROSSING.format('other', '-g*T^2/2')} }}")
    with pytest.raises(CaseError, match=r"\[results\] 1: z at then \(other\): there it is the level itself"):
        read(fall((KINETIC, f"{same}\n{KINETIC}"), level))


def test_the_kinetic_energy_at_a_level_of_the_displacement_is_a_result(fall):
    level = (AT, f"then = {{ {CROSSING.format('z', '-g*T^2/2')} }}")
    sideways = ('channel   = "z"', 'channel   = "x"')
    target = ('target    = "z_T"', 'target    = "0*z_T"')
    x = 'x = { node = 1, component = "x-displacement", text = "Sideways" }'
    tolerance = ("{ relative = 1e-6,", "{ absolute = 1e-6,")
    assert (
        read(fall((KINETIC, f"{x}\n{KINETIC}"), level, sideways, target, tolerance)).file.events["then"].of
        == "z"
    )


@pytest.mark.parametrize("time", ["0*T", "-T", "T - T"])
def test_nothing_is_read_at_the_start(fall, time):
    with pytest.raises(
        CaseError, match=r"\[events\] then: at = .*: at t = 0 all values are those of the deck"
    ):
        read(fall(('at = "T"', f'at = "{time}"')))
