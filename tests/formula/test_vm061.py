"""The theory of VM-061, a ball that falls on a spring: values, dimensions, curves over time."""

import math

import numpy as np
import pytest

from vmharness.formula import Formula, Unit, UnitSystem

INCH = UnitSystem(length="in", force="lbf", time="s")
GIVEN = {"m": (0.5, "lbf-s2/in"), "k": (1973.92, "lbf/in"), "h": (1.0, "in"), "g": (386.0, "in/s2")}
THEORY = {
    "omega": ("sqrt(k/m)", "rad/s"),
    "t_impact": ("sqrt(2*h/g)", "s"),
    "v0": ("sqrt(2*g*h)", "in/s"),
    "ke_impact": ("m*v0^2/2", "lbf-in"),
    "y_max": ("g/omega**2 + sqrt((v0/omega)**2 + (g/omega**2)**2)", "in"),
    "z_peak": ("-(h + y_max)", "in"),
    "t_peak": ("t_impact + (pi - atan(v0*omega/g))/omega", "s"),
    "F_max": ("k*y_max", "lbf"),
    "t_end": ("2*t_peak - t_impact", "s"),
}
CURVES = {
    "phase": ("where(t < t_impact, 0, omega*(t - t_impact))", "rad"),
    "y": ("v0/omega*sin(phase) + g/omega^2*(1 - cos(phase))", "in"),
    "z": ("where(t < t_impact, -g*t^2/2, -h - y)", "in"),
    "v": ("where(t < t_impact, -g*t, -v0*cos(phase) - g/omega*sin(phase))", "in/s"),
    "kinetic": ("m*v**2/2", "lbf-in"),
    "contact": ("k*y**2/2", "lbf-in"),
    "work": ("-m*g*z", "lbf-in"),
}


def solve(t: np.ndarray | None = None) -> dict:
    """The theory in order, its dimensions checked on the way."""
    values: dict = {name: value for name, (value, _) in GIVEN.items()}
    known = {name: Unit(unit).dimension for name, (_, unit) in GIVEN.items()}
    if t is not None:
        values["t"], known["t"] = t, Unit("s").dimension
    for name, (text, unit) in (THEORY | (CURVES if t is not None else {})).items():
        formula = Formula(text)
        assert formula.dimension(known) == Unit(unit).dimension, name
        assert INCH.factor(unit) == 1.0
        values[name], known[name] = formula.evaluate(values), Unit(unit).dimension
    return values


def test_exact_values() -> None:
    omega, v0 = math.sqrt(1973.92 / 0.5), math.sqrt(2 * 386.0)
    static = 386.0 / omega**2
    y_max = static + math.hypot(v0 / omega, static)
    exact = {
        "omega": omega,
        "t_impact": math.sqrt(2 / 386.0),
        "v0": v0,
        "ke_impact": 193.0,
        "z_peak": -1.0 - y_max,
        "t_peak": math.sqrt(2 / 386.0) + math.atan2(v0 * omega, -386.0) / omega,
        "F_max": 0.5 * 386.0 * (1 + math.sqrt(1 + 2 * 1973.92 / (0.5 * 386.0))),
    }
    assert {name: solve()[name] for name in exact} == pytest.approx(exact, rel=1e-12)


def test_printed_values() -> None:
    printed = {
        "t_impact": 0.0719815751,
        "v0": 27.7848880,
        "t_peak": 0.1004448599,
        "z_peak": -1.5506656,
        "F_max": 1086.970,
    }
    for name, value in printed.items():
        assert solve()[name] == pytest.approx(value, rel=5e-8 if name == "t_impact" else 1e-6), name


def test_curves_over_time() -> None:
    t = np.linspace(0.0, solve()["t_end"], 4001)
    s = solve(t)
    np.testing.assert_allclose(s["kinetic"] + s["contact"], s["work"], rtol=0, atol=1e-10)
    np.testing.assert_allclose(np.gradient(s["z"], t, edge_order=2), s["v"], atol=2e-3)
    assert s["z"].min() == pytest.approx(s["z_peak"], rel=1e-7)
    assert np.interp(s["t_impact"], t, s["z"]) == pytest.approx(-1.0, abs=1e-5)
    assert s["contact"].max() == pytest.approx(299.2785, abs=1e-4)


def test_published_values_are_a_sampling_artefact() -> None:
    s = solve(np.array([0.071998, 0.1]))
    assert np.round(s["z"], 4) == pytest.approx([-1.0005, -1.5505])
    assert round(float(s["v"][0]), 3) == -27.791
