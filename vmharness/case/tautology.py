"""Results that cannot disagree with their targets: their event gives the value, whatever the solver computes.

At a crossing of z the displacement z is the level, and the coordinate z differs from it by a number of the deck. At an
extremum of z its velocity is zero. Where a force begins or ends it is zero. At t = 0 all values are those of the deck.
"""

from vmharness.case.case import Case
from vmharness.case.decode import FILE
from vmharness.case.error import CaseError
from vmharness.case.format import OWNERS, Channel, Event

# Of each quantity what it is a derivative of, and of which order; quantities of one order differ by constants.
DERIVATIVES = {
    "displacement": ("position", 0),
    "coordinate": ("position", 0),
    "velocity": ("position", 1),
    "momentum": ("position", 1),
    "acceleration": ("position", 2),
    "rotation": ("angle", 0),
    "angular-velocity": ("angle", 1),
    "impulse": ("impulse", 0),
    "force": ("impulse", 1),
}
MULTIPLES = {"axial-stress": "axial-force"}  # of an element, by constants of its section
ENDING = ("x-force", "y-force", "z-force", "area", "nodes")  # of a contact: zero when it is over


def tautology(event: Event, seen: Channel, read: Channel) -> str:
    """Why `read` has a known value at an event of the channel `seen`; nothing if it has none."""
    if _owner(seen) != _owner(read):
        return ""
    (base, order), (other, other_order) = _derivative(seen), _derivative(read)
    same = (base, order) == (other, other_order)
    if event.crossing_of and same:
        return "there it is the level itself, but for constants of the deck"
    if (event.minimum_of or event.maximum_of) and (base, order + 1) == (other, other_order):
        return "there it is zero, as the derivative of a quantity at its extremum"
    if event.onset_of and (same or (read.contact is not None and event.pick == 1)):
        return "there it is zero, as the contact or the force only begins"
    if event.end_of and (same or (read.contact is not None and read.component in ENDING)):
        return "there it is zero, as the contact or the force ends"
    return ""


def check_times(case: Case) -> None:
    """Raise CaseError for the first event at a given time that is not after the start."""
    for name, event in case.file.events.items():
        if event.at is not None and not case.evaluate(f"at {name}") > 0.0:
            place = f"{case.folder.name}/{FILE}: [events] {name}: at = {event.at}"
            raise CaseError(
                f"{place}: is {case.evaluate(f'at {name}'):g}: at t = 0 all values are those of the deck"
            )


def _owner(channel: Channel) -> tuple[object, ...]:
    """What the channel is a quantity of: the node, the element and its point, the part, ..."""
    return (*(getattr(channel, key) for key in OWNERS if key != "energy"), channel.point or 1, channel.part)


def _derivative(channel: Channel) -> tuple[str, int]:
    """The quantity, along its axis, that the channel is a derivative of, and of which order."""
    name = channel.energy or channel.component or ""
    name = MULTIPLES.get(name, name)
    axis, _, quantity = name.partition("-")
    base, order = DERIVATIVES.get(quantity, (quantity, 0))
    return f"{axis} {base}", order
