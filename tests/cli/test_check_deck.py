"""`vm check` of a deck file: one list of all that is wrong, in one go."""

import json

import pytest

# An export of a pre-processor: five keywords that nobody here knows, ten values that are not supported.
EXPORT = """*KEYWORD
*TITLE
a plate
*CONTROL_TERMINATION
1.0,0,0.0,5.0
*CONTROL_TIMESTEP
0.0,0.9,3,,,,1
*CONTROL_ACCURACY
0,4
*CONTROL_BULK_VISCOSITY
1.5,0.06,-2
*CONTROL_IMPLICIT_GENERAL
1
*DATABASE_NODOUT
0.1
*DATABASE_SLEOUTT
0.1
*NODE
1,0.0,0.0,0.0
2,1.0,0.0,0.0
3,1.0,1.0,0.0
4,0.0,1.0,0.0,8
*ELEMENT_SHELL
1,1,1,2,3,4
*PART
plate
1,1,1,5
*SECTION_SHELL
1,2,,,,-7
0.1,,,,0.5
*MAT_ELASTIC
1,7800.0,2e11,0.3,0.1
*MAT_FABRICS
2,1.0
*MAT_ELASTICK
3,1.0
*BOUNDARY_SPC_NODE
1,7,1
*LOAD_NODE_POINT
2,4,9
*CONTACT_TIED_SHELL_EDGE
1,2
*CONTROL_SOLID
1
"""


@pytest.fixture
def export(tmp_path):
    """Write the deck, changed or not."""

    def write(text=EXPORT):
        path = tmp_path / "export.k"
        path.write_text(text)
        return path

    return write


def lines_of(out):
    """The findings, put together again."""
    found, group = {}, ""
    for line in out.splitlines():
        if line.startswith("      "):
            found[group][-1] += " " + line.strip()
        elif line.startswith("    "):
            found[group].append(line.strip())
        elif line.startswith("  "):
            group = line.strip().rstrip(":")
            found[group] = []
    return found


def test_one_list_has_everything(vm, export):
    path = export()
    code, out, _ = vm("check", str(path))
    assert code == 4
    assert all(len(line) <= 80 for line in out.splitlines()[1:])
    assert out.splitlines()[0] == f"{path}: wrong"
    found = lines_of(out)
    assert found["not supported"] == [
        "export.k:5: *CONTROL_TERMINATION: ENDENG = 5.0: only 0.0 is supported",
        "export.k:7: *CONTROL_TIMESTEP: ISDO = 3: only 0, 1 and 2 are supported",
        "export.k:9: *CONTROL_ACCURACY: INN = 4: only 1 is supported",
        "export.k:11: *CONTROL_BULK_VISCOSITY: TYPE = -2: only 1 is supported",
        "export.k:12: *CONTROL_IMPLICIT_GENERAL: unknown keyword",
        "export.k:16: *DATABASE_SLEOUTT: unknown keyword; did you mean *DATABASE_SLEOUT?",
        "export.k:22: *NODE: TC = 8: only 0, 1, 2, 3, 4, 5, 6 and 7 are supported",
        "export.k:27: *PART: EOSID = 5: only 0 is supported",
        "export.k:29: *SECTION_SHELL: QR = -7.0: only 0.0 is supported",
        "export.k:30: *SECTION_SHELL: NLOC = 0.5: only 0.0 is supported",
        "export.k:32: *MAT_ELASTIC: DA = 0.1: only 0.0 is supported",
        "export.k:33: *MAT_FABRICS: unknown keyword",
        "export.k:35: *MAT_ELASTICK: unknown keyword; did you mean *MAT_ELASTIC?",
        "export.k:38: *BOUNDARY_SPC_NODE: CID = 7: only 0 is supported",
        "export.k:40: *LOAD_NODE_POINT: DOF = 4: only 1, 2, 3, 5, 6 and 7 are supported",
        "export.k:40: *LOAD_NODE_POINT: LCID = 9: no *DEFINE_CURVE with LCID = 9; defined: none",
        "export.k:41: *CONTACT_TIED_SHELL_EDGE: unknown keyword",
    ]
    assert found["has no effect here"] == [
        "export.k:2: *TITLE: title; no effect on results.",
        "export.k:7: *CONTROL_TIMESTEP: ERODE = 1: nothing is eroded without DTMIN",
        "export.k:8: *CONTROL_ACCURACY: the stress update is always of second order (OSU = 1).",
        "export.k:14: *DATABASE_NODOUT: asks for output files; no effect on results.",
        "export.k:44: *CONTROL_SOLID: ESORT = 1: no solid is degenerate",
    ]


def test_what_is_ill_formed_stands_first_and_the_rest_beside_it(vm, export):
    code, out, _ = vm("check", str(export(EXPORT.replace("1,7800.0,2e11", "1,x,2e11"))))
    assert code == 4
    found = lines_of(out)
    assert list(found) == ["ill-formed", "not supported", "has no effect here"]
    assert found["ill-formed"] == ["export.k:32: *MAT_ELASTIC: RO = x: not a number"]
    assert len(found["not supported"]) == 17
    assert not [line for line in found["not supported"] if "RO =" in line]


GOOD = """*KEYWORD
*TITLE
a mass
*CONTROL_TERMINATION
1.0
*NODE
1,0.0,0.0,0.0
*ELEMENT_MASS
1,1,1.0
*END
"""


def test_a_deck_that_can_run_is_ok_and_what_has_no_effect_is_said(vm, export, tmp_path):
    path = export(GOOD)
    code, out, _ = vm("check", str(path), "--solver", "builtin", "--json", str(tmp_path / "found.json"))
    assert code == 0
    assert out.splitlines() == [
        f"{path}: ok",
        "  has no effect here:",
        "    export.k:2: *TITLE: title; no effect on results.",
    ]
    (found,) = json.loads((tmp_path / "found.json").read_text())
    assert found["deck"] == str(path)
    assert found["not supported"] == []


def test_solve_refuses_with_the_whole_list(vm, export):
    code, _, err = vm("solve", str(export()))
    assert code == 4
    assert len(err.splitlines()) == 17
    assert "Traceback" not in err


def test_a_deck_beside_cases(vm, export, tmp_path):
    code, out, _ = vm("check", str(export(GOOD)), "no-such-case")
    assert "export.k: ok" in out
    assert code == 5


def test_keywords_of_which_the_same_is_to_say_share_a_line(vm, export):
    text = GOOD.replace("*NODE\n", "*DATABASE_ELOUT\n0.1\n*DATABASE_GLSTAT\n0.1\n*NODE\n", 1)
    _, out, _ = vm("check", str(export(text)))
    assert lines_of(out)["has no effect here"][1] == (
        "export.k:6: *DATABASE_ELOUT, *DATABASE_GLSTAT: asks for output files; no effect on results."
    )


def test_json_has_an_object_for_each_finding(vm, export, tmp_path):
    text = EXPORT.replace("1,7800.0,2e11", "1,x,2e11").replace("1,1,1,2,3,4\n", "1,1,1,2,3,99\n")
    path = export(text)
    assert vm("check", str(path), "--json", str(tmp_path / "found.json"))[0] == 4
    (found,) = json.loads((tmp_path / "found.json").read_text())
    place = {"file": "export.k", "line": 32, "keyword": "MAT_ELASTIC", "field": "ro", "value": "x"}
    assert found["ill-formed"] == [{**place, "what": "not a number", "group": "ill-formed"}]
    node = {"file": "export.k", "line": 24, "keyword": "ELEMENT_SHELL", "field": "n4", "value": 99}
    assert {**node, "what": "no *NODE 99", "group": "not supported"} in found["not supported"]


def test_a_parameter_without_a_value_is_said_once(vm, export):
    """And nothing is said of the number that stands in for it."""
    text = GOOD.replace("*TITLE", "*PARAMETER\nI bad,&nothing\n*LOAD_NODE_POINT\n1,1,&bad\n*TITLE")
    _, out, _ = vm("check", str(export(text)))
    assert len(lines_of(out)["ill-formed"]) == 1
    assert "not supported" not in lines_of(out)


def test_what_may_stand_among_cards_that_cannot_be_read_is_not_missing(vm, export):
    """A curve whose card is missing has no number, and neither have the things of a file that is not there."""
    load = "*LOAD_NODE_POINT\n1,1,7\n*BOUNDARY_SPC_SET\n5,0,1\n"
    for hidden, missing in (("", 2), ("*DEFINE_CURVE\n", 1), ("*INCLUDE\nother.k\n", 0)):
        _, out, _ = vm("check", str(export(GOOD.replace("*NODE\n", f"{load}{hidden}*NODE\n"))))
        assert len(lines_of(out).get("not supported", [])) == missing


def test_cards_of_which_the_same_is_to_say_are_counted(vm, export):
    sets = "".join(f"*SET_NODE_LIST\n{sid},2.5\n1\n" for sid in (1, 2, 3))
    _, out, _ = vm("check", str(export(GOOD.replace("*END\n", f"{sets}*END\n"))))
    assert lines_of(out)["has no effect here"][1] == (
        "export.k:11: *SET_NODE_LIST: DA1 = 2.5: nothing here uses attributes of sets (3 such cards)"
    )
