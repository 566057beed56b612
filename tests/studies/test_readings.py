"""The reading of a published column, found again from digits that were made with it."""

from dataclasses import replace
from pathlib import Path

import msgspec
import numpy as np
import pytest

from vmharness.case import read
from vmharness.history import History
from vmharness.reading import prints_as, states
from vmharness.studies.explain import readings
from vmharness.studies.explain.published import columns, half_unit
from vmharness.studies.explain.record import SAMPLING

BALL = Path(__file__).parents[2] / "cases" / "VM-061"


@pytest.fixture(scope="module")
def ball():
    return read(BALL)


@pytest.fixture(scope="module")
def history(ball):
    """Theory itself, in steps of 3.7 microseconds."""
    time = np.arange(0.0, 0.11, 3.7e-6)
    channels = {name: ball.curve(name, time) for name in ball.file.curves}
    late = time > ball.theory["t_impact"]
    channels["contact_force"] = np.where(
        late, ball.given["k"] * np.maximum(-channels["z"] - ball.given["h"], 1e-9), 0.0
    )
    return History(time, channels)


def published(case, **values):
    column = msgspec.structs.replace(case.file.published[0], values=values, errors_percent={})
    return replace(case, file=msgspec.structs.replace(case.file, published=[column]))


def test_the_published_column_of_the_ball_is_read_from_states_a_millisecond_apart(ball, history):
    found, _ = columns(ball, history)
    assert found.reading.startswith("states 0.001 s apart, each is the last cycle up to its nominal time")
    assert set(found.same) == {"t_impact", "z_impact", "v_impact", "t_peak", "z_peak"}
    assert list(found.others) == ["ke_impact"]
    assert "at exactly its nominal time" in found.others["ke_impact"]
    assert found.also == [0.002]  # 72 and 100 ms are states of both
    for one in found.results:
        parts = {part.cause: part.value for part in one.parts}
        assert abs(parts[SAMPLING]) > 0.8 * abs(one.difference)
        assert one.unexplained.value == 0.0


@pytest.mark.parametrize("interval", [5e-4, 2.5e-3])
def test_digits_made_with_an_interval_give_it_back(ball, history, interval):
    chosen = states(history, interval)
    on = next(i for i in chosen if history["contact_force"][i] != 0.0)
    low = min(chosen, key=lambda i: history["z"][i])
    values = {
        "t_impact": f"{history.time[on]:.7f}",
        "v_impact": f"{history['v'][on]:.5f}",
        "t_peak": f"{history.time[low]:.7f}",
        "z_peak": f"{history['z'][low]:.7f}",
    }
    (column,) = published(ball, **values).published
    found = readings.best(ball, history, column)
    assert found.interval == interval
    assert len(found.same) == 4


def test_a_column_that_the_history_gives_needs_no_states(ball, history):
    plain = readings.plain(ball, history, ball.file.published[0])
    (column,) = published(ball, **{key: f"{value:.6g}" for key, value in plain.values.items()}).published
    assert readings.best(ball, history, column).interval == 0.0


def test_targets_that_are_rounded_are_the_same(ball, history):
    case = published(ball, t_impact="0.07198", z_peak="-1.5506")
    case = replace(
        case,
        file=msgspec.structs.replace(
            case.file, published=[msgspec.structs.replace(case.file.published[0], kind="target")]
        ),
    )
    (found,) = columns(case, history)
    assert found.same == ["t_impact"]  # theory has -1.55066, which rounds to -1.5507
    assert half_unit("0.07198") == pytest.approx(5e-6)
    assert prints_as(case.target("t_impact"), "0.07198")
