"""Histories: what fits together, what is between samples, and the way to files and back."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from vmharness.history import History, HistoryError

TIME = np.linspace(0.0, 1.0, 11)


def test_parabolas_are_exact_between_samples():
    history = History(TIME, {"z": 3.0 - 2.0 * TIME + 5.0 * TIME**2})
    t = np.linspace(0.0, 1.0, 37)
    np.testing.assert_allclose(history.at("z", t), 3.0 - 2.0 * t + 5.0 * t**2, rtol=1e-13)


def test_interpolation_is_of_third_order():
    errors = []
    for n in (50, 100, 200):
        time = np.linspace(0.0, 3.0, n + 1)
        t = np.linspace(0.5, 2.5, 333)
        errors.append(np.abs(History(time, {"y": np.sin(3 * time)}).at("y", t) - np.sin(3 * t)).max())
    assert np.all(np.log2(np.array(errors[:-1]) / errors[1:]) > 2.9)


@pytest.mark.parametrize("t", [-0.1, 1.1, np.nan])
def test_nothing_is_extrapolated(t):
    with pytest.raises(HistoryError, match="asked for outside the run, 0 to 1"):
        History(TIME, {"z": TIME}).at("z", [t])


def test_a_missing_channel_is_named_with_those_there_are():
    with pytest.raises(HistoryError, match="no channel w; recorded: z, v"):
        History(TIME, {"z": TIME, "v": TIME})["w"]


def test_time_must_increase_and_channels_must_fit():
    with pytest.raises(HistoryError, match="time does not increase"):
        History(TIME[::-1], {})
    with pytest.raises(HistoryError, match="channel z has 3 samples, time has 11"):
        History(TIME, {"z": TIME[:3]})


@given(arrays(float, 11, elements=st.floats(allow_nan=False, allow_infinity=False)))
def test_csv_gives_the_same_numbers_back(tmp_path_factory, values):
    path = tmp_path_factory.mktemp("csv") / "history.csv"
    History(TIME / 3.0, {"z": values, "v": TIME}).to_csv(path)
    back = History.from_csv(path)
    assert back.time.tolist() == (TIME / 3.0).tolist()
    assert back["z"].tolist() == values.tolist()
    assert list(back.channels) == ["z", "v"]


def test_frame_is_indexed_by_time():
    frame = History(TIME, {"z": TIME**2}).to_frame()
    assert frame.index.name == "time"
    assert frame["z"].iloc[3] == pytest.approx(0.09)
    assert History.from_frame(frame)["z"].tolist() == (TIME**2).tolist()
