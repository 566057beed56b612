"""The runs that split the error of each result into its causes, and the record of the split."""

from collections.abc import Mapping
from dataclasses import replace

from vmharness.case import Case, CaseError
from vmharness.deck import DeckError
from vmharness.studies.changed_deck import contact_scales, with_step, with_stiffer_contacts
from vmharness.studies.converge import runs as converge
from vmharness.studies.converge.richardson import Kind, Richardson, richardson
from vmharness.studies.explain.record import Explained, ExplainRecord, Part, explained, halved, sampled
from vmharness.studies.faults.declared import RUN_LENGTH
from vmharness.studies.maker import maker
from vmharness.studies.measured import Measured
from vmharness.studies.variant import Variant

SOUND, HALF, QUARTER = "unchanged", "half the time step", "a quarter of the time step"
EXACT, STIFF = "exact numbers in the deck", "contacts twice as stiff"
TIME_STEP, NUMBERS, PENALTY, MESH = "time step", "rounding of the deck", "contact penalty", "mesh"


def variants(case: Case) -> dict[str, Variant]:
    """The runs by name: unchanged, finer time steps, exact numbers, stiffer contacts, and the meshes of [converge]."""
    found = {SOUND: Variant(case, SOUND)}
    try:
        found[HALF] = Variant(with_step(case, 0.5), HALF, strides=(2,))
        found[QUARTER] = Variant(with_step(case, 0.25), QUARTER, strides=(1, 2, 4))
    except DeckError:  # the step follows a curve
        found.pop(HALF, None)
    if case.file.deck.parameters:
        found[EXACT] = Variant(_with_exact_numbers(case), EXACT)
    if _has_penalty(case):
        found[STIFF] = Variant(with_stiffer_contacts(case, 2.0), STIFF)
    return found | {variant.label: variant for variant in _meshes(case)}


def record(case: Case, outcomes: Mapping[str, Measured]) -> ExplainRecord:
    """The record of the split; raises CaseError if the run of the unchanged case failed."""
    sound = outcomes[SOUND]
    if sound.failure:
        raise CaseError(f"{case.id}: the run of the unchanged case failed: {sound.failure}")
    notes = [
        f"the run '{name}' failed, and its cause cannot be separated: {outcome.failure}"
        for name, outcome in outcomes.items()
        if outcome.failure
    ]
    if HALF not in outcomes:
        notes.append(
            "the time step follows a curve of the deck: the errors of time step and sampling cannot be separated"
        )
    if not _meshes(case):
        notes.append(
            "the case declares no refinement of its mesh: an error of the mesh is part of the unexplained rest"
        )
    results = [
        _explained(case, key, outcomes) for key, value in sound.results.items() if value.value is not None
    ]
    if _meshes(case):
        open_ = [one.key for one in results if MESH not in [part.cause for part in one.parts]]
        if open_:
            notes.append(
                f"the error of the mesh is not separated for {', '.join(open_)}: the results do not converge yet"
            )
    made_by = maker(outcomes.values())
    return ExplainRecord(case.id, case.inputs_sha256, results, notes=notes, made_by=made_by)


def _explained(case: Case, key: str, outcomes: Mapping[str, Measured]) -> Explained:
    result, sound = case.result(key), outcomes[SOUND].results[key]
    value, target = sound.value or 0.0, sound.target
    parts = [*_steps(key, value, outcomes), *_numbers(key, value, outcomes), *_penalty(key, value, outcomes)]
    parts += _mesh(case, key, value, target, outcomes, parts)
    allowed = result.tolerance.absolute + result.tolerance.relative * abs(target)
    return explained(key, result.label, result.unit, target, value, allowed, parts)


def _steps(key: str, value: float, outcomes: Mapping[str, Measured]) -> list[Part]:
    """Time step: finer steps, read at the times of the run. Sampling: one run, read at more and more samples."""
    if HALF not in outcomes or outcomes[HALF].failure or outcomes[QUARTER].failure:
        return []
    half = outcomes[HALF].thinned[2][key][0]
    quarter = [outcomes[QUARTER].thinned[stride][key] for stride in (1, 2, 4)]
    known = [[value for value in phases if value is not None] for phases in quarter]
    if half is None or [len(phases) for phases in known] != [1, 2, 4]:
        return []
    coarse = known[-1][0]
    return [halved(value - half, half - coarse, TIME_STEP), sampled(coarse, known)]


def _numbers(key: str, value: float, outcomes: Mapping[str, Measured]) -> list[Part]:
    """Rounding of the deck: the value of the run less that of the run with all digits of the data."""
    if EXACT not in outcomes or outcomes[EXACT].failure:
        return []
    exact = outcomes[EXACT].results[key].value
    return [] if exact is None else [Part(NUMBERS, value - exact)]


def _penalty(key: str, value: float, outcomes: Mapping[str, Measured]) -> list[Part]:
    """Contact penalty: its error is proportional to 1/k, hence twice the change from doubling the stiffness k."""
    if STIFF not in outcomes or outcomes[STIFF].failure:
        return []
    stiff = outcomes[STIFF].results[key].value
    return [] if stiff is None else [Part(PENALTY, 2.0 * (value - stiff), abs(value - stiff))]


def _mesh(
    case: Case, key: str, value: float, target: float, outcomes: Mapping[str, Measured], others: list[Part]
) -> list[Part]:
    """Mesh: the value less the limit of the refined meshes, and less the time step if that is refined with them."""
    plan, levels = case.file.converge, _meshes(case)
    if plan is None or not levels:
        return []
    sizes = [case.formulas["converge size"].evaluate({**case.values, "N": number}) for number in plan.levels]
    values = [
        outcomes[level.label].results[key].value if key in outcomes[level.label].results else None
        for level in levels
    ]
    found: Richardson = richardson([float(size) for size in sizes], values, plan.orders.get(key))
    if found.kind not in (Kind.CONVERGES, Kind.EXACT) or found.extrapolated is None:
        return []
    along = sum(part.value for part in others if part.cause == TIME_STEP) if plan.refined == "both" else 0.0
    return [Part(MESH, value - found.extrapolated - along, found.gci or 0.0)]


def _has_penalty(case: Case) -> bool:
    """Whether the deck has contacts whose stiffness is a penalty, and no datum of the problem.

    It is a datum of the problem if a target depends on data that change a scale factor of the stiffness.
    """
    scales = contact_scales(case)
    if len(scales) < 2:
        return False
    data = frozenset[str]().union(*(case.origins(f"target {result.key}") for result in case.file.results))
    for name in case.file.deck.parameters:
        if data & case.origins(f"parameter {name}"):
            other = {**case.deck_parameters(), name: 1.01 * case.evaluate(f"parameter {name}")}
            if contact_scales(replace(case, overrides=other)) != scales:
                return False
    return True


def _meshes(case: Case) -> list[Variant]:
    plan = case.file.converge
    return converge.variants(case) if plan is not None and plan.refined != "time step" else []


def _with_exact_numbers(case: Case) -> Case:
    """The case with all digits of every parameter of its deck that follows from the data."""
    names = [name for name, formula in case.file.deck.parameters.items() if formula != RUN_LENGTH]
    exact = {name: case.evaluate(f"parameter {name}") for name in names}
    return replace(case, overrides={**exact, **case.deck_parameters()})
