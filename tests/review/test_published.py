"""Published values beside theory: differences beyond the printed digits need a remark that quotes them."""

import pytest

from vmharness.case import CaseError, read
from vmharness.review.published import fits, unexplained

PRINTED = """[[published]]
name = "Book"
source = "A book"
kind = "{kind}"
values = {{ z_T = "{text}" }}
{more}

[deck]
"""


@pytest.fixture
def printed(fall):
    """The case with a value of a book for the displacement, which is -1.22625 m by theory."""

    def with_value(text, kind="target", more=""):
        return read(fall(("[deck]\n", PRINTED.format(text=text, kind=kind, more=more))))

    return with_value


@pytest.mark.parametrize("text", ["-1.226", "-1.2263", "-1.2262", "-1.22625", "-1", "-1.2e0", "-1.22625000"])
def test_a_value_that_agrees_to_its_digits_needs_no_remark(printed, text):
    assert unexplained(printed(text)) == []


@pytest.mark.parametrize("text", ["-99.9", "-1.227", "1.226", "-1.22624", "0", "-1226"])
def test_another_value_needs_a_remark(printed, text):
    (sentence,) = unexplained(printed(text))
    assert sentence.startswith(
        f"[published] 1 (Book): z_T = {text}: theory gives -1.22625; a remark must quote {text}"
    )


def test_a_remark_quotes_the_value_that_it_explains(printed):
    assert unexplained(printed("1.226", more='remark = "The book has no signs."'))
    assert unexplained(printed("1.226", more='remark = "The book gives 1.2261, without a sign."'))
    assert unexplained(printed("1.226", more='remark = "The book gives 1.226, without a sign."')) == []


@pytest.mark.parametrize(
    ("error", "fine"), [(0.0, True), (6.01, True), (6.014, True), (0.01, False), (-6.01, False), (6.3, False)]
)
def test_a_printed_error_is_that_of_its_value(printed, error, fine):
    value = (
        "-1.3" if error else "-1.226"
    )  # 6.01 % off; half of its last digit is 4.1 %, so more digits are given
    found = unexplained(
        printed(value.replace("-1.3", "-1.3000"), "computed", f"errors_percent = {{ z_T = {error} }}")
    )
    assert (found == []) == fine
    assert fine or "it differs from theory by 6.01 %" in found[0]


def test_a_computed_value_without_an_error_may_be_any(printed):
    assert unexplained(printed("-1.5", "computed")) == []


@pytest.mark.parametrize("text", ["1e999", "1e-999999999", "-1." + "0" * 40])
def test_digits_that_no_double_has_are_no_value(printed, text):
    with pytest.raises(CaseError, match=r"\[published\] 1: z_T = .*digits and a size"):
        printed(text)


def test_half_of_the_last_digit_counts():
    assert fits(0.123451, "0.1235")
    assert not fits(0.123449, "0.1235")
