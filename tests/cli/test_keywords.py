"""`vm keywords`: what a deck may have."""


def test_names_of_all_keywords(vm):
    code, out, _ = vm("keywords")
    assert code == 0
    names = [line.split()[0] for line in out.splitlines()]
    assert names == sorted(names)
    assert {"*NODE", "*MAT_ELASTIC", "*LOAD_BODY_Z", "*ELEMENT_SHELL"} <= set(names)


def test_the_cards_of_some(vm):
    code, out, _ = vm("keywords", "load_body_z", "*mat_elastic")
    assert code == 0
    assert [line.split()[0] for line in out.splitlines() if line.startswith("*")] == [
        "*LOAD_BODY_Z",
        "*MAT_ELASTIC",
    ]
    assert "    LCID SF" in out


def test_what_changes_no_result_is_said(vm):
    _, out, _ = vm("keywords", "control_energy")
    assert "every energy is always computed" in out


def test_a_word_in_no_name_is_answered_with_near_ones(vm):
    code, _, err = vm("keywords", "MAT_ELASTIK")
    assert code == 5
    assert "*MAT_ELASTIC" in err


def test_only_a_typing_error_is_corrected(vm):
    _, _, err = vm("keywords", "MAT_VISCOELASTIC")
    assert err == "vm: no keyword like MAT_VISCOELASTIC\n"
    _, _, err = vm("keywords", "mat_elastik")
    assert err == "vm: no keyword like mat_elastik; did you mean *MAT_ELASTIC?\n"
