"""The history of a case as LS-DYNA would write it: all text files that hold its channels."""

import numpy as np

ENERGIES = {
    "kinetic": "kinetic energy", "internal": "internal energy", "spring and damper": "spring and damper energy",
    "hourglass": "hourglass energy", "damping": "system damping energy", "contact": "sliding interface energy",
    "external work": "external work", "total": "total energy", "ratio": "total energy / initial energy",
    "rigid wall": "stonewall energy",
}  # fmt: skip
STRESSES = ("xx-stress", "yy-stress", "zz-stress", "xy-stress", "yz-stress", "zx-stress")


def write(lsdyna, folder, case, history, areas=None, normals=None, driven=None):
    """Write the files; `areas` of beams by number, `normals` of walls, `driven` nodes of the motions."""
    t = history.time
    zero = np.zeros(t.size)
    by = {}  # columns by name, by number, by owner
    for name, channel in case.file.channels.items():
        for owner in (
            "contact",
            "wall",
            "centre",
            "support",
            "motion",
            "rigid",
            "joint",
            "energy",
            "shell",
            "solid",
            "beam",
            "discrete",
            "node",
        ):
            number = getattr(channel, owner)
            if number is not None:
                key = (owner, channel.part) if owner == "energy" else (owner, number)
                component = number if owner == "energy" else channel.component
                by.setdefault(key[0], {}).setdefault(key[1], {})[component] = history[name]
                break
    full = lambda columns, names: {name: columns.get(name, zero) for name in names}  # noqa: E731
    force = [f"{axis}-force" for axis in "xyz"]
    if "node" in by:
        lsdyna.nodout(folder / "nodout", t, by["node"])
    centres, energies = by.get("centre", {}), by.get("energy", {})
    glstat = {ENERGIES[name]: values for name, values in energies.get(None, {}).items() if name in ENERGIES}
    if glstat:
        lsdyna.glstat(folder / "glstat", t, glstat)
    parts = {number: columns for number, columns in energies.items() if number is not None}
    for number, columns in centres.items():
        parts.setdefault(1 if number == "all" else number, {}).update(columns)
    if parts:
        lsdyna.matsum(folder / "matsum", t, parts)
    contacts = {
        n: columns for n, columns in by.get("contact", {}).items() if any(name in columns for name in force)
    }
    if contacts:
        lsdyna.rcforc(folder / "rcforc", t, {n: full(columns, force) for n, columns in contacts.items()})
    stored = {
        n: (columns["energy"], zero) for n, columns in by.get("contact", {}).items() if "energy" in columns
    }
    if stored:
        lsdyna.sleout(folder / "sleout", t, stored)
    if "support" in by:
        nodes = {(99 if n == "all" else n): columns for n, columns in by["support"].items()}
        lsdyna.spcforc(folder / "spcforc", t, nodes)
    walls = {
        n: columns["x-force" if "x-force" in columns else "z-force"] * normals[n]
        for n, columns in by.get("wall", {}).items()
        if set(columns) & set(force)
    }
    if walls:
        lsdyna.rwforc(folder / "rwforc", t, walls)
    if "discrete" in by:
        names = {"force": "resultant force", "elongation": "change in length"}
        springs = {
            n: {names[name]: values for name, values in columns.items()}
            for n, columns in by["discrete"].items()
        }
        lsdyna.dotted(folder / "deforc", t, "spring/damper number", springs)
    if "joint" in by:
        lsdyna.dotted(folder / "jntforc", t, "joint number", by["joint"])
    if "rigid" in by:
        lsdyna.rbdout(folder / "rbdout", t, by["rigid"])
    if "motion" in by:
        total = full(by["motion"][1], force)
        shares = {nid: {name: values / len(driven) for name, values in total.items()} for nid in driven}
        lsdyna.bndout(folder / "bndout", t, shares)
    stress = lambda columns: np.column_stack([columns.get(name, zero) for name in STRESSES])  # noqa: E731
    if {"solid", "shell", "beam"} & by.keys():
        lsdyna.elout(
            folder / "elout",
            t,
            {n: stress(columns) for n, columns in by.get("solid", {}).items()},
            {
                n: (stress(columns)[:, None], np.zeros((t.size, 1)))
                for n, columns in by.get("shell", {}).items()
            },
            {
                n: (np.column_stack([columns.get("axial-stress", zero) * areas, *[zero] * 5]), None)
                for n, columns in by.get("beam", {}).items()
            },
        )
