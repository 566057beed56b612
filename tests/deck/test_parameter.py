"""*PARAMETER: values by name, replaced on request, at full precision."""

from collections.abc import Callable

import pytest

from vmharness.deck import Card, Deck, DeckError, Keyword, integer, real, text

Read = Callable[..., Deck]

THING = Keyword("THING", Card(n=integer(0), x=real(0.0), w=text("")))
TABLE = Keyword("TABLE", Card(i=integer(width=8), x=real(0.0, width=16)), table=True)
KNOWN = {"THING": THING, "TABLE": TABLE}

DEFINED = f"""*PARAMETER
{"R  side":10s}{0.4:10f}{"I n":10s}{3:10d}{"C  word":10s}{"ball":>10s}
Rthird,0.1,r  Mass , 1.0d-1
*PARAMETER_EXPRESSION
R  area   &side*side
I  twice  2*n
R  most,max(&side, third, 0.2)
"""


def test_values_and_types(deck: Read) -> None:
    assert deck(DEFINED, known=KNOWN).parameters == {
        "side": 0.4,
        "n": 3,
        "word": "ball",
        "third": 0.1,
        "mass": 0.1,
        "area": 0.4 * 0.4,
        "twice": 6,
        "most": 0.4,
    }


def test_references_stand_in_any_field_and_format(deck: Read) -> None:
    found = deck(
        DEFINED + f"*THING\n{'&n':>10s}{'-&SIDE':>10s}{'&word':>10s}\n*THING\n-&twice,&area,&word\n"
        f"*TABLE\n{'&n':>8s}{'-&side':>16s}\n{4:8d}{'&mass':>16s}\n",
        known=KNOWN,
    )
    assert [entry.values for entry in found.all("THING")] == [
        {"n": 3, "x": -0.4, "w": "ball"},
        {"n": -6, "x": 0.4 * 0.4, "w": "ball"},
    ]
    assert found.one("TABLE").i.tolist() == [3, 4]
    assert found.one("TABLE").x.tolist() == [-0.4, 0.1]


def test_replaced_values_keep_full_precision_and_reach_expressions(deck: Read) -> None:
    side = 0.123456789012345678  # more digits than the field has columns
    found = deck(DEFINED + "*THING\n        &n     &side\n", known=KNOWN, parameters={"Side": side, "N": 5})
    assert found.parameters["area"] == side * side
    assert found.parameters["twice"] == 10
    assert (found.one("THING").n, found.one("THING").x) == (5, side)


@pytest.mark.parametrize(
    ("parameters", "message"),
    [
        ({"sid": 1.0}, "deck.k: no parameter sid to set; did you mean side?"),
        ({"area": 1.0}, "deck.k:6: *PARAMETER_EXPRESSION: EXPRESSION = &side*side: area follows from other"),
        ({"n": 2.5}, "deck.k:3: *PARAMETER: VAL2 = 2.5: parameter n: not an integer"),
        ({"word": 2.5}, "deck.k:3: *PARAMETER: VAL3 = 2.5: parameter word: is a text"),
        ({"side": float("nan")}, "deck.k:3: *PARAMETER: VAL1 = nan: parameter side: not a number"),
        ({"side": float("inf")}, "deck.k:3: *PARAMETER: VAL1 = inf: parameter side: not a number"),
    ],
)
def test_what_cannot_be_replaced(deck: Read, parameters: dict[str, float], message: str) -> None:
    with pytest.raises(DeckError) as error:
        deck(DEFINED, known=KNOWN, parameters=parameters)
    assert str(error.value).startswith(message)


def test_nothing_to_replace(deck: Read) -> None:
    with pytest.raises(DeckError, match=r"deck\.k: no parameter k to set; the deck has none"):
        deck("*THING\n\n", known=KNOWN, parameters={"k": 1.0})


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("*PARAMETER\nx,1.0\n", "3: *PARAMETER: PRMR1 = x: expected R, I or C"),
        ("*PARAMETER\nR 2x,1.0\n", "3: *PARAMETER: PRMR1 = R 2x: expected R, I or C"),
        ("*PARAMETER\nR x,1.0,R x,2.0\n", "3: *PARAMETER: PRMR2 = R x: parameter x is defined already"),
        ("*PARAMETER\nR X,1.0\n*PARAMETER\nR x,2.0\n", "5: *PARAMETER: PRMR1 = R x: parameter x is defined"),
        ("*PARAMETER\nR x,1.0,,2.0\n", "3: *PARAMETER: VAL2 = 2.0: the name of this parameter is missing"),
        ("*PARAMETER\nR x\n", "3: *PARAMETER: VAL1 = (blank): parameter x: a value is required"),
        ("*PARAMETER\nI x,2.5\n", "3: *PARAMETER: VAL1 = 2.5: parameter x: not an integer"),
        ("*PARAMETER_EXPRESSION\nR x       1/2\n", "3: *PARAMETER_EXPRESSION: EXPRESSION = 1/2: parameter x: 1/2 is"),
        ("*PARAMETER_EXPRESSION\nR x       y*2\n", "3: *PARAMETER_EXPRESSION: EXPRESSION = y*2: parameter x: y: no"),
        ("*PARAMETER_EXPRESSION\nC x       2\n", "3: *PARAMETER_EXPRESSION: EXPRESSION = 2: parameter x: an expr"),
        ("*THING\n&later\n*PARAMETER\nI later,1\n", "3: *THING: N = &later: undefined parameter"),
        ("*PARAMETER\nI count,1\n*THING\n&coun\n", "5: *THING: N = &coun: undefined parameter; did you mean &count?"),
        ("*PARAMETER\nR x,0.5\n*THING\n&x\n", "5: *THING: N = &x (0.5): not an integer"),
        ("*PARAMETER\nC x,a\n*THING\n,,-&x\n", "5: *THING: W = -&x: a text parameter has no sign"),
        ("*PARAMETER\nC x,a\n*THING\n,&x\n", "5: *THING: X = &x (a): not a number"),
        ("*PARAMETER_LOCAL\nR x,1.\n", "2: *PARAMETER_LOCAL: unknown keyword"),
    ],
)  # fmt: skip
def test_message(deck: Read, content: str, message: str) -> None:
    with pytest.raises(DeckError) as error:
        deck(content, known=KNOWN)
    assert str(error.value).startswith(f"deck.k:{message}")


def test_a_value_after_a_comma_may_have_any_number_of_characters(deck: Read) -> None:
    found = deck("*PARAMETER\nR third,0.333333333333333333333333333333\n", known=KNOWN)
    assert found.parameters == {"third": 1 / 3}
