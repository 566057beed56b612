import shutil
from pathlib import Path

import pytest

from vmharness.case import CaseError, read

CASES = Path(__file__).parents[2] / "cases"


@pytest.fixture
def changed(tmp_path):
    """Reads a copy of VM-061 with other text in its case.toml."""

    def read_changed(old, new):
        folder = Path(shutil.copytree(CASES / "VM-061", tmp_path / "VM-061"))
        text = (folder / "case.toml").read_text()
        assert text.count(old) == 1
        (folder / "case.toml").write_text(text.replace(old, new))
        return read(folder)

    return read_changed


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("[45, 90, 180, 360, 720]", "[45, 90]", r"\[converge\] levels: .*length >= 3"),
        ("[45, 90, 180, 360, 720]", "[90, 45, 180]", r"\[converge\] levels: must increase"),
        ('"t_impact/(N + 0.2)"', '"t_impact/(M + 0.2)"', r"\[converge\] size: M is not defined here"),
        ("set     = { rho = ", "set     = { roh = ", r"\[converge\] set: roh: there is no given datum roh; did you mean rho\?"),
        ("set     = { rho = ", "set     = { dt = ", r"\[converge\] set: dt: unit s does not fit"),
        ("z_peak = 2 }", "z_peek = 2 }", r"\[converge\] orders: there is no result z_peek; did you mean z_peak"),
        ("ranges = { m = [0.125, 2.0]", "ranges = { m = [2.0, 0.125]", r"\[sweep\] ranges: m: the first value must be below"),
        ("ranges = { m = ", "ranges = { dt = [1e-5, 1e-4], m = ", r"\[sweep\] ranges: dt cannot be set: nothing in the deck"),
        ('formula = "v0*omega/g"', 'formula = "v0*omega"', r"\[sweep\] within: 1: .*does not fit"),
        ("set    = { rho = ", "set    = { L = ", r"\[sweep\] set: L: is in ranges, so it cannot be set"),
        ('K         = {', 'N = "2*h/h"\nK         = {', r"\[converge\]: N is the name of the level"),
    ],
)  # fmt: skip
def test_what_is_wrong_with_a_plan_is_said_with_its_place(changed, old, new, message):
    with pytest.raises(CaseError, match=message):
        changed(old, new)


@pytest.mark.parametrize(
    "case", sorted(path.parent for path in CASES.glob("*/case.toml")), ids=lambda p: p.name
)
def test_what_studies_of_the_cases_set_keeps_their_targets(case):
    from vmharness.studies.converge.runs import variants

    found = read(case)
    if found.file.converge is not None:
        assert len(variants(found)) == len(found.file.converge.levels)
