"""The process in which OpenSees runs: its state is global, and a wrong command may end it.

Central differences as OpenSees has them: Newmark with gamma = 1/2 and beta = 0, solved for accelerations. Without
`-form A` and a first step of no length, OpenSees starts from a = 0, and every integrator is of first order under a load
that acts from t = 0.
"""

import json
from array import array
from pathlib import Path
from typing import Any

import numpy as np
import openseespy.opensees as ops

LONGEST = 20_000_000  # steps
SCHEMES = {False: "beta = 0 (central differences)", True: "beta = 1/4 (constant average acceleration)"}


def main() -> None:
    """Run the task of model.json; leave history.npy and facts.json."""
    task = json.loads(Path("model.json").read_text())
    for name, *arguments in task["commands"]:
        getattr(ops, name)(*arguments)
    beta = 0.25 if task["implicit"] else 0.0
    _analysis(beta)
    ops.analyze(1, 0.0)  # the accelerations of the loads at t = 0
    _analysis(beta)
    rows, failure = _record(task)
    np.save("history.npy", rows)
    step = f"{task['step']:.6g}, constant"
    facts = {"Integrator": f"Newmark, gamma = 1/2, {SCHEMES[task['implicit']]}", "Time step": step}
    Path("facts.json").write_text(json.dumps(facts | {"failure": failure}))


def _analysis(beta: float) -> None:
    """The analysis anew: a step of no length leaves it changed."""
    ops.wipeAnalysis()
    ops.constraints("Transformation")
    ops.numberer("RCM")
    ops.system("BandGen")
    if beta:
        ops.test("RelativeNormUnbalance", 1e-9, 20)
        ops.algorithm("ModifiedNewton", "-FactorOnce")  # one factorisation: these meshes move little
    else:
        ops.algorithm("Linear")
    ops.integrator("Newmark", 0.5, beta, "-form", "A")
    ops.analysis("Transient")


def _record(task: dict[str, Any]) -> tuple[np.ndarray, str]:
    """Rows of time and channels at every step, and why the run ended early."""
    channels = list(task["channels"].values())
    reactions = any(name == "nodeReaction" for _, terms in channels for name, *_ in terms)
    values, count = array("d"), 1 + len(channels)
    for _ in range(LONGEST):
        if reactions:
            ops.reactions("-dynamic")
        values.append(ops.getTime())
        values.extend([_value(constant, terms) for constant, terms in channels])
        if ops.getTime() >= task["end"]:
            return np.array(values).reshape(-1, count), ""
        if ops.analyze(1, task["step"]) != 0:
            return np.array(values).reshape(-1, count), f"OpenSees failed at t = {ops.getTime():g}"
    return np.array(values).reshape(-1, count), f"stopped after {LONGEST} steps"


def _value(constant: float, terms: list[Any]) -> float:
    return constant + sum(factor * FUNCTIONS[name](*arguments) for name, arguments, factor in terms)


def _kinetic(node: int) -> float:
    return sum(ops.nodeVel(node, dof) ** 2 for dof in (1, 2, 3))


FUNCTIONS: dict[str, Any] = {
    "nodeDisp": ops.nodeDisp,
    "nodeVel": ops.nodeVel,
    "nodeAccel": ops.nodeAccel,
    "nodeReaction": ops.nodeReaction,
    "axialForce": lambda element: ops.eleResponse(element, "axialForce")[0],
    "deformation": lambda element: ops.eleResponse(element, "deformations")[0],
    "kinetic": _kinetic,
}

if __name__ == "__main__":
    main()
