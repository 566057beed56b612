"""Writers of binary result files: binout and d3plot of LS-DYNA, T01 of OpenRadioss."""

import struct

import numpy as np

TYPES = {"i": (3, 4), "f": (9, 4), "d": (10, 8), "s": (1, 1)}  # type and size, by letter


class Lsda:
    """A binout, state by state; a table of symbols after each state, as LS-DYNA flushes its output."""

    def __init__(self, path):
        self.file = open(path, "wb")  # noqa: SIM115
        self.file.write(bytes([8, 8, 8, 1, 1, 1, 0, 0]))
        self.file.write(struct.pack("<QB", 17, 7))
        self.link = self.file.tell()
        self.file.write(struct.pack("<Q", 0))
        self.symbols = []

    def put(self, directory, name, letter, values):
        """A variable in a directory."""
        kind, size = TYPES[letter]
        data = values.encode() if letter == "s" else struct.pack(f"<{len(values)}{letter}", *values)
        at = self.file.tell()
        self.file.write(
            struct.pack("<QB", 11 + len(name) + len(data), 3) + struct.pack("<BB", kind, len(name))
        )
        self.file.write(name.encode() + data)
        self.symbols.append((directory, name, kind, at, len(data) // size))

    def flush(self):
        """Write the table of the symbols since the last one."""
        start, content, here = self.file.tell(), b"", None
        for directory, name, kind, at, count in sorted(self.symbols):
            if directory != here:
                here = directory
                content += struct.pack("<QB", 9 + len(directory), 2) + directory.encode()
            content += (
                struct.pack("<QB", 9 + len(name) + 17, 4)
                + name.encode()
                + struct.pack("<BQQ", kind, at, count)
            )
        content += struct.pack("<QB", 17, 6)
        self.file.write(struct.pack("<QB", 9 + len(content) + 8, 5) + content)
        end = self.file.tell()
        self.file.write(struct.pack("<Q", 0))
        self.file.seek(self.link)
        self.file.write(struct.pack("<Q", start))
        self.file.seek(0, 2)
        self.link, self.symbols = end, []

    def close(self):
        self.file.close()


def binout(path, time, branches, letter="f"):
    """`branches`: (metadata, variables) by directory; metadata are numbers by name, variables (n, things) or (n,)."""
    lsda = Lsda(path)
    for directory, (about, _) in branches.items():
        lsda.put(f"{directory}/metadata", "version", "s", "R14.1     ")
        for name, numbers in about.items():
            lsda.put(f"{directory}/metadata", name, "i", numbers)
    for i, t in enumerate(time):
        for directory, (_, variables) in branches.items():
            state = f"{directory}/d{i + 1:06d}"
            lsda.put(state, "time", letter, [t])
            lsda.put(state, "cycle", "i", [i + 1])
            for name, values in variables.items():
                row = values[i]
                lsda.put(state, name, letter, row if hasattr(row, "__len__") else [row])
        lsda.flush()
    lsda.close()


CONTROL = {
    "type": 11, "source": 12, "version": 14, "ndim": 15, "numnp": 16, "icode": 17, "nglbv": 18, "iu": 20, "iv": 21,
    "ia": 22, "nel8": 23, "nummat8": 24, "nv3d": 27, "nel2": 28, "nummat2": 29, "nv1d": 30, "maxint": 36, "narbs": 39,
    "ioshl1": 43, "ioshl2": 44, "nmmat": 51,
}  # fmt: skip


def d3plot(
    path, time, nodes, x0, globals_, parts=None, solids=None, beams=None, letter="f", files=1, titles=True
):
    """A family: `nodes` coordinates, velocities and accelerations (n, nodes, 3), by number and initial place.

    `nodes`: numbers; `x0` (nodes, 3); `globals_` (n, 6); `parts`: numbers and (n, parts, 7) internal and kinetic energy,
    velocity, mass, hourglass energy; `solids`: numbers and (n, solids, 7); `beams`: numbers and (n, beams, 6).
    """
    numbers, motion = nodes
    pids, of_parts = parts or ([1], np.zeros((len(time), 1, 7)))
    eids, stress = solids or ([], np.zeros((len(time), 0, 7)))
    bids, forces = beams or ([], np.zeros((len(time), 0, 6)))
    ids = [*numbers, *eids, *bids, *pids, *pids, *range(1, len(pids) + 1)]
    values = {
        "type": 1, "source": 1, "ndim": 4, "numnp": len(numbers), "icode": 6, "nglbv": 6 + 7 * len(pids), "iu": 1, "iv": 1,
        "ia": 1, "nel8": len(eids), "nummat8": 1, "nv3d": 7, "nel2": len(bids), "nummat2": 1, "nv1d": 6, "maxint": 3,
        "narbs": 16 + len(ids), "ioshl1": 1000, "ioshl2": 1000, "nmmat": len(pids),
    }  # fmt: skip
    size, whole = (4, "i4") if letter == "f" else (8, "i8")
    head = np.zeros(64, f"<{whole}")
    for name, value in values.items():
        head[CONTROL[name]] = value
    content = bytearray(head.tobytes())
    content[: 10 * size] = b"a case".ljust(10 * size)
    content[14 * size : 15 * size] = struct.pack(f"<{letter}", 960.0)
    real = lambda values: np.asarray(values, f"<f{size}").tobytes()  # noqa: E731
    integer = lambda values: np.asarray(values, f"<{whole}").tobytes()  # noqa: E731
    content += real(x0)
    content += integer([[1] * 8 + [1]] * len(eids)) + integer([[1, 1, 1, 0, 0, 1]] * len(bids))
    header = [-1, 1, 1, 1, 1, len(numbers), len(eids), len(bids), 0, 0, 1, 1, 1, len(pids), 0, len(pids)]
    content += integer(header) + integer(ids)
    content += real([-999999.0])
    if titles:
        content += integer([90000]) + b"a case".ljust(18 * size) + integer([90001, len(pids)])
        for pid in pids:
            content += integer([pid]) + b"a part".ljust(18 * size)
        content += real([-999999.0])
    states = []
    for i, t in enumerate(time):
        x, v, a = (part[i] for part in motion)
        energies = of_parts[i]
        by_kind = (energies[:, 0], energies[:, 1], energies[:, 2:5], energies[:, 5], energies[:, 6])
        state = real([t]) + real(globals_[i]) + b"".join(map(real, by_kind)) + real(x) + real(v) + real(a)
        states.append(state + real(stress[i]) + real(forces[i]))
    share = -(-len(states) // files)
    if files > 1:
        content += b"\0" * (-len(content) % (512 * size))
        path.write_bytes(content)
    else:
        path.write_bytes(content + b"".join(states) + real([-999999.0]) + b"\0" * 512 * size)
    for number in range(1, files):
        some = b"".join(states[(number - 1) * share : number * share])
        path.with_name(f"{path.name}{number:02d}").write_bytes(some + real([-999999.0]))
    if files > 1:
        some = b"".join(states[(files - 1) * share :])
        path.with_name(f"{path.name}{files:02d}").write_bytes(some + real([-999999.0]))


def t01(path, time, step, globals_, parts, nodes, version=4021, title=100):
    """`globals_` (n, 12) but for the time step; `parts`: numbers, codes, (n, parts, codes); `nodes` likewise."""

    def record(form, *values):
        content = b"".join(
            value.encode().ljust(title if form == "t" else 80)
            if isinstance(value, str)
            else struct.pack(f">{'f' if form == 'f' else 'i'}", value)
            for value in values
        )
        return struct.pack(">i", len(content)) + content + struct.pack(">i", len(content))

    pids, part_codes, of_parts = parts
    nids, codes, motion = nodes
    content = record("i", version, "a case") + record("i", "Mon Nov 30 2026 RADIOSS")
    if version >= 3050:
        content += record("i", 2) + record("i", title) + record("f", 1.0, 1.0, 1.0)
    content += record("i", len(pids), 1, 1, 1, 1, 12) + record("i", *range(1, 13))
    for pid in pids:
        content += record("t", pid, "a part", 1, 1, 1, len(part_codes)) + record("i", *part_codes)
    content += record("t", 1, "a material") + record("t", 1, "a property")
    content += record("t", 1, 0, 0, len(pids), 2, "all") + record("i", *pids) + record("i", 1, 2)
    content += record("t", 1, 0, 0, len(nids), len(codes), "nodes")
    for nid in nids:
        content += record("t", nid, "a node")
    content += record("i", *codes)
    for i, t in enumerate(time):
        row = [*globals_[i]]
        row[6] = step
        content += record("f", t) + record("f", *row) + record("f", *of_parts[i].ravel())
        content += record("f", 7.0, 7.0) + record("f", *motion[i].ravel())
    path.write_bytes(content)
