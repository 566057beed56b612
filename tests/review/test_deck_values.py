"""The deck's own parameters are those of the case, to their digits."""

import pytest

from vmharness.case import CaseError, read
from vmharness.case.deck import read_deck
from vmharness.review.deck_values import disagreements

GRAVITY = 'G    = "g"'
WEIGHT = ('G    = "g"', 'G    = "g*pi/pi*1.0000123456"')  # a formula: 9.810121110336


def found(folder):
    case = read(folder)
    return disagreements(case, read_deck(case))


def gravity(text):
    return ("RG             9.81 ", f"RG        {text:>10}")


@pytest.mark.parametrize("text", ["9.81", "9.8100", "981.E-2"])
def test_the_deck_has_the_datum(fall, text):
    assert found(fall(gravity(text))) == []


@pytest.mark.parametrize("text", ["8.00", "9.8", "10.0", "9.810001", "-9.81"])
def test_another_number_than_the_datum_is_named(fall, text):
    (sentence,) = found(fall(gravity(text)))
    assert (
        sentence
        == f"deck.k: parameter G = {float(text):.15g}, but g = 9.81: the deck must have the datum of case.toml"
    )


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("9.81012111", ""),
        ("9.810121", ""),
        ("9.81012", ""),
        ("9.81", "write six digits or more, or say in [deck.rounded] why fewer are enough"),
        ("10.0", "write six digits or more"),
        ("9.81013", "it is not this value, rounded to the digits of the deck"),
        ("9.82", "it is not this value, rounded"),
    ],
)
def test_the_value_of_a_formula_is_rounded_to_the_digits_of_the_deck(fall, text, why):
    sentences = found(fall(WEIGHT, gravity(text)))
    assert len(sentences) == bool(why)
    assert all(why in sentence and "g*pi/pi*1.0000123456 = 9.81012111" in sentence for sentence in sentences)


def test_fewer_digits_need_a_reason(fall):
    rounded = (GRAVITY, f'{WEIGHT[1]}\nTEND = "t_end"\n\n[deck.rounded]\nG = "the published deck has three"')
    once = ('\nTEND = "t_end"\n\n# ', "\n\n# ")
    assert found(fall(rounded, gravity("9.81"), once)) == []
    assert "it is not this value" in found(fall(rounded, gravity("9.83"), once, id="other"))[0]
    assert "three digits are the fewest" in found(fall(rounded, gravity("10.0"), once, id="one"))[0]


def test_only_parameters_can_be_rounded(fall):
    with pytest.raises(CaseError, match=r"\[deck.rounded\]: there is no parameter K"):
        read(fall(("[deck.parameters]", '[deck.rounded]\nK = "why"\n\n[deck.parameters]')))


def test_the_run_may_end_at_another_time(fall):
    assert found(fall(("RTEND          0.6", "RTEND          0.7"))) == []


def test_other_data_replace_those_of_the_deck(fall):
    case = read(fall()).with_given({"g": 5.0})
    assert disagreements(case, read_deck(case)) == []
