import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from vmharness.studies.converge.richardson import Kind, richardson

HALVED = [0.8, 0.4, 0.2, 0.1]


def sequence(p, limit=3.0, factor=0.5, sizes=HALVED):
    return [limit + factor * h**p for h in sizes]


@given(st.floats(0.5, 6.0), st.floats(-10.0, 10.0), st.floats(0.1, 5.0), st.floats(1.3, 4.0))
def test_a_pure_power_is_seen_through(p, limit, factor, ratio):
    sizes = [ratio**-i for i in range(4)]
    values = sequence(p, limit, factor, sizes)
    assume(abs(values[-1] - values[-2]) > 1e-6 * max(map(abs, values)))
    found = richardson(sizes, values, None)
    assert found.kind is Kind.CONVERGES
    assert found.order == pytest.approx(p, abs=1e-3)
    assert found.extrapolated == pytest.approx(limit, abs=1e-4 * max(map(abs, values)))
    assert found.gci == pytest.approx(1.25 * abs(values[-1] - limit), rel=1e-2)


def test_a_scheme_of_the_first_order_is_of_order_1_whatever_was_promised():
    """Forward Euler for y' = -y, y(0) = 1, at t = 1."""
    steps = [10, 20, 40, 80]
    found = richardson([1 / n for n in steps], [(1 - 1 / n) ** n for n in steps], promised=2.0)
    assert found.kind is Kind.CONVERGES
    assert found.order == pytest.approx(1.0, abs=0.03)
    assert found.uncertainty < 0.05


@pytest.mark.parametrize(
    ("values", "kind"),
    [
        ([1.0, 2.0, 4.0, 8.0], Kind.DIVERGES),
        ([1.0, 2.0, 3.0, 4.0], Kind.DIVERGES),  # 0.0256 % at every step: aliasing, no order
        ([1.0, 1.2, 1.1, 1.15], Kind.OSCILLATES),
        ([2.0, 2.0, 2.0, 2.0], Kind.EXACT),
        ([2.0, 2.0 + 1e-10, 2.0, 2.0], Kind.EXACT),
        ([2.0, 1.2, 1.1, 1.08], Kind.NOT_ASYMPTOTIC),  # orders 3.0 and 2.3
        ([2.0, 1.2, None, 1.08], Kind.NO_VALUE),
        ([1.0, 1.2, 1.1, 1.08], Kind.NOT_ASYMPTOTIC),  # turns on its way
    ],
)
def test_what_is_not_in_its_asymptotic_range_is_given_no_order(values, kind):
    found = richardson(HALVED, values, promised=2.0)
    assert found.kind is kind
    assert found.order is None
    assert found.extrapolated == (values[-1] if kind is Kind.EXACT else None)


def test_an_order_above_the_promised_one_does_not_shrink_the_gci():
    found = richardson(HALVED, sequence(4.0), promised=2.0)
    assert found.order == pytest.approx(4.0)
    step = abs(sequence(4.0)[-1] - sequence(4.0)[-2])
    assert found.gci == pytest.approx(1.25 * step / 3.0)


def test_three_levels_give_an_order_without_uncertainty():
    found = richardson(HALVED[:3], sequence(2.0, sizes=HALVED[:3]), promised=2.0)
    assert found.order == pytest.approx(2.0)
    assert found.uncertainty is None
