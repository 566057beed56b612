"""Format of case.toml: its tables as types, which check the file and make its JSON schema."""

from typing import Annotated, Literal

from msgspec import Meta, Struct

Text = Annotated[str, Meta(min_length=1)]
Name = Annotated[str, Meta(pattern="^[A-Za-z][A-Za-z0-9_]*$")]
Formula = Annotated[
    str, Meta(min_length=1, description="A formula over the given data and the theory above it")
]
Positive = Annotated[float, Meta(gt=0)]
NotNegative = Annotated[float, Meta(ge=0)]
Count = Annotated[int, Meta(ge=1)]
Order = Annotated[float, Meta(ge=0.1, le=10, description="Order of accuracy of a method")]


class Table(Struct, forbid_unknown_fields=True, frozen=True):
    """A table of the file; unknown keys are an error."""


class Units(Table, frozen=True):
    """The consistent units of the deck."""

    length: Text
    time: Text
    force: Text | None = None
    mass: Text | None = None


class Given(Table, frozen=True):
    """A datum of the problem, independent of the deck."""

    value: float
    unit: str
    text: Text
    group: Annotated[
        str, Meta(description="Column of the data table: Material, Geometric, Loading, Model")
    ] = "Given"


class Line(Table, frozen=True):
    """A line of the theory."""

    formula: Formula
    text: Annotated[str, Meta(description="Meaning of the line, in words")] = ""
    unit: Annotated[
        str | None, Meta(description="Unit for printing; it must have the dimension of the formula")
    ] = None


class Channel(Table, frozen=True):
    """A quantity over time that the solver records: of a node, an element, a contact, the supports, or an energy."""

    text: Text
    node: int | None = None
    shell: Annotated[int | None, Meta(description="Number of a shell element")] = None
    solid: Annotated[int | None, Meta(description="Number of a solid element")] = None
    beam: Annotated[int | None, Meta(description="Number of a beam or truss element")] = None
    discrete: Annotated[int | None, Meta(description="Number of a spring or damper")] = None
    point: Annotated[
        Count | None, Meta(description="Integration point of the element, from 1; 1 if not given")
    ] = None
    part: Annotated[int | None, Meta(description="Part of the energy; the whole model if not given")] = None
    contact: Annotated[
        int | None,
        Meta(
            description="CID of the contact, or its place among the contacts; with node, the force on that node"
        ),
    ] = None
    support: Annotated[
        Literal["all"] | int | None,
        Meta(description="Reactions of all supports together, or of that at a node"),
    ] = None
    wall: Annotated[int | None, Meta(description="ID of the rigid wall, or its place among the walls")] = None
    centre: Annotated[
        int | Literal["all"] | None,
        Meta(description="Part whose centre of mass it is, or all: x-momentum, ..."),
    ] = None
    motion: Annotated[int | None, Meta(description="Number of the prescribed motion in the deck's order")] = (
        None
    )
    rigid: Annotated[int | None, Meta(description="Number of a rigid body: of its part, or its own")] = None
    joint: Annotated[int | None, Meta(description="Number of the joint in the deck's order")] = None
    energy: Annotated[str | None, Meta(description="kinetic, contact, external work, total, ratio, ...")] = (
        None
    )
    component: Annotated[str | None, Meta(description="z-displacement, z-velocity, z-force, nodes, ...")] = (
        None
    )


class Event(Table, frozen=True):
    """An event: a given time, or a time found between samples of the channel that a `..._of` key names."""

    title: Text
    onset_of: Name | None = None
    end_of: Name | None = None
    crossing_of: Name | None = None
    minimum_of: Name | None = None
    maximum_of: Name | None = None
    at: Annotated[Formula | None, Meta(description="The time itself")] = None
    level: Annotated[Formula | None, Meta(description="Level of a crossing")] = None
    direction: Literal["up", "down"] | None = None
    times: Annotated[
        Count, Meta(description="Number of times that it happens in the run; any other number fails")
    ] = 1
    pick: Annotated[Count, Meta(description="Number of the one to measure")] = 1

    @property
    def of(self) -> str:
        """The channel whose event it is; none for a given time."""
        named = (self.onset_of, self.end_of, self.crossing_of, self.minimum_of, self.maximum_of)
        return next(filter(None, named), "")


class Tolerance(Table, frozen=True):
    """Tolerance |value - target| <= absolute + relative |target|, and its reason."""

    because: Text
    relative: NotNegative = 0.0
    absolute: NotNegative = 0.0


class Result(Table, frozen=True):
    """A row of the table of results: a channel measured at an event, and its target by theory."""

    key: Name
    label: Text
    event: Name
    channel: Annotated[Name, Meta(description="A channel, or `time` for the time of the event")]
    target: Formula
    unit: str
    tolerance: Tolerance


class Budget(Table, frozen=True):
    """A line of the error budget: the largest error by one cause, as fractions of the targets."""

    source: Text
    because: Text
    relative: dict[
        Name,
        Annotated[
            float | Formula, Meta(description="By key of the result; in its unit if the target is zero")
        ],
    ]


class Published(Table, frozen=True):
    """A column of published values, shown for comparison; it does not change the verdict."""

    name: Text
    source: Text
    kind: Annotated[
        Literal["target", "computed"], Meta(description="Whether theory or a solver gave the values")
    ]
    values: Annotated[dict[Name, Text], Meta(description="By key of the result, with the digits as printed")]
    errors_percent: dict[Name, float] = {}
    interval: Annotated[
        Positive | None, Meta(description="Interval of the states from which the column seems to be read")
    ] = None
    exactly_at: Annotated[
        dict[Name, NotNegative],
        Meta(description="Results that agree with a reading at exactly this time, by key"),
    ] = {}
    remark: str = ""


class Fault(Table, frozen=True):
    """A change of the deck alone that must fail the case."""

    text: Text
    change: Annotated[dict[Name, str], Meta(description='By given datum: "+1 %", "-0.1 %", or "=2.0"')]
    must_fail: Annotated[list[Name], Meta(min_length=1)]


class Deck(Table, frozen=True):
    """The deck, with the formulas of its parameters."""

    file: Annotated[
        Text,
        Meta(description="The deck, or a template with the suffix .j2 that uses the names of `mesh`"),
    ] = "deck.k"
    parameters: Annotated[
        dict[Name, Formula], Meta(description="Each *PARAMETER of the deck, as a formula of data and theory")
    ] = {}
    mesh: Annotated[
        dict[Name, Formula],
        Meta(description="Mesh parameters of the template, as formulas of data and theory"),
    ] = {}
    rounded: Annotated[
        dict[Name, Text],
        Meta(description="Parameters that the deck has with fewer than six digits, and why they are enough"),
    ] = {}
    include_outside: Annotated[
        bool, Meta(description="Whether *INCLUDE may name files outside the deck's folder")
    ] = False


class Converge(Table, frozen=True):
    """A refinement for the order of accuracy: levels N from coarse to fine, and the data of each level."""

    refined: Literal["time step", "mesh", "both"]
    levels: Annotated[
        list[Positive], Meta(min_length=3, description="Increasing values of N, such as numbers of elements")
    ]
    size: Annotated[Formula, Meta(description="The time step or element size of the level N")]
    set: Annotated[
        dict[Name, Formula], Meta(min_length=1, description="Given data at each level, as formulas of N")
    ]
    orders: Annotated[
        dict[Name, Order],
        Meta(min_length=1, description="The order that theory expects, by key of the result"),
    ]
    because: Annotated[Text, Meta(description="Why theory expects these orders")]
    held: Annotated[str, Meta(description="What is held constant on all levels, and why")] = ""


class Within(Table, frozen=True):
    """A constraint on the data of a sweep: a formula that must be between two plain numbers."""

    formula: Formula
    low: float
    high: float
    because: Text


class Sweep(Table, frozen=True):
    """The region of the given data in which the case must pass."""

    ranges: Annotated[
        dict[Name, tuple[float, float]],
        Meta(min_length=1, description="Lowest and highest value by given datum, in its unit"),
    ]
    within: list[Within] = []
    set: Annotated[
        dict[Name, Formula], Meta(description="Given data that follow from those of the ranges, as formulas")
    ] = {}
    points: Annotated[
        int, Meta(ge=1, le=100_000, description="Number of points, unless the command gives another")
    ] = 200


class CaseFile(Table, frozen=True):
    """A verification case: data, theory, measurements, targets, tolerances, faults."""

    title: Text
    reference: Text
    units: Units
    given: dict[Name, Given]
    theory: dict[Name, Formula | Line]
    channels: Annotated[dict[Name, Channel], Meta(min_length=1)]
    events: Annotated[dict[Name, Event], Meta(min_length=1)]
    results: Annotated[list[Result], Meta(min_length=1)]
    faults: Annotated[list[Fault], Meta(min_length=1)]
    deck: Deck = Deck()
    curves: Annotated[
        dict[Name, Formula | Line], Meta(description="Theory over the time `t`, by channel")
    ] = {}
    also: Annotated[str, Meta(description="Other publications of the problem")] = ""
    analysis: list[Text] = []
    elements: list[Text] = []
    tags: list[Text] = []
    kind: Annotated[
        Literal["analytic", "semi-analytic", "other code", "published"],
        Meta(description="Origin of the targets"),
    ] = "analytic"
    budget: list[Budget] = []
    published: list[Published] = []
    converge: Converge | None = None
    sweep: Sweep | None = None
    files: Annotated[list[Text], Meta(description="Further input files, offered beside the deck")] = []


RUN_LENGTH = (
    "t_end"  # a parameter with exactly this formula is the end of the run, and no datum of the problem
)
EVENTS = ("at", "onset_of", "end_of", "crossing_of", "minimum_of", "maximum_of")
ELEMENTS = ("shell", "solid", "beam", "discrete")
OWNERS = (
    "node",
    *ELEMENTS,
    "contact",
    "wall",
    "centre",
    "support",
    "motion",
    "rigid",
    "joint",
    "energy",
)  # of a channel


def as_line(line: str | Line) -> Line:
    """A line of theory; a bare formula becomes a line without text."""
    return line if isinstance(line, Line) else Line(formula=line)
