"""The process in which MuJoCo runs: a model that it does not compile, or a crash, ends this process alone.

Channels are taken after mj_forward at each step: mj_step leaves the state of the last stage of the Runge-Kutta method
in what it derives from positions. Curves act by the control callback, which MuJoCo calls at each stage.
"""

import json
from array import array
from math import isfinite
from pathlib import Path
from typing import Any

import mujoco
import numpy as np

from vmharness.backends.mujoco.readers import reader

LONGEST = 20_000_000  # steps


def main() -> None:
    """Run model.xml and task.json; leave history.npy and facts.json."""
    task = json.loads(Path("task.json").read_text(encoding="utf-8"))
    model = mujoco.MjModel.from_xml_path("model.xml")
    data = mujoco.MjData(model)
    if model.nkey:
        mujoco.mj_resetDataKeyframe(model, data, 0)
    _apply(model, task["loads"], task["bases"])
    rows, failure = _record(model, data, task)
    np.save("history.npy", rows)
    facts = {
        "Integrator": "RK4, Runge-Kutta method of the fourth order (MuJoCo's default is semi-implicit Euler)",
        "Time step": f"{model.opt.timestep:.6g}, constant",
        **task["facts"],
    }
    Path("facts.json").write_text(json.dumps(facts | {"failure": failure}), encoding="utf-8")


def _apply(model: Any, loads: list[Any], bases: list[Any]) -> None:
    """Forces on masses, and accelerations of all bodies, by curves over time."""
    if not (loads or bases):
        return
    forces = [(model.body(name).id, *map(np.array, rest)) for name, *rest in loads]
    accelerations = [tuple(map(np.array, base)) for base in bases]

    def callback(model: Any, data: Any) -> None:
        data.xfrc_applied[:] = 0.0
        for vector, t, value in accelerations:
            data.xfrc_applied[:, :3] += model.body_mass[:, None] * vector * np.interp(data.time, t, value)
        for body, vector, t, value in forces:
            data.xfrc_applied[body, :3] += vector * np.interp(data.time, t, value)

    mujoco.set_mjcb_control(callback)


def _record(model: Any, data: Any, task: dict[str, Any]) -> tuple[np.ndarray, str]:
    """Rows of time and channels at every step, and why the run ended early."""
    functions = {term[0] for _, found in task["channels"].values() for term in found}
    channels = [
        (constant, [(reader(model, data, *term[:3]), term[3]) for term in found])
        for constant, found in task["channels"].values()
    ]
    values, count, failure = array("d"), 1 + len(channels), f"stopped after {LONGEST} steps"
    for _ in range(LONGEST):
        mujoco.mj_forward(model, data)
        if "joint force" in functions:
            mujoco.mj_rnePostConstraint(model, data)
        if failed := _failed(data):
            failure = failed
            break
        values.append(data.time)
        values.extend([constant + sum(f * read() for read, f in found) for constant, found in channels])
        if data.time >= task["end"]:
            failure = ""
            break
        mujoco.mj_step(model, data)
    return np.array(values).reshape(-1, count), failure


def _failed(data: Any) -> str:
    """A warning of MuJoCo, which resets the model when it finds numbers that are not finite."""
    if data.warning.number.any():
        first = int(np.flatnonzero(data.warning.number)[0])
        return f"MuJoCo warned of {mujoco.mjtWarning(first).name} before t = {data.time:g}"
    return "" if isfinite(data.qacc.sum()) else f"accelerations are not finite at t = {data.time:g}"


if __name__ == "__main__":
    main()
