# ruff: noqa: UP031 - formats are those of C, as in the converter
"""Writers of LS-DYNA's text files, in the formats of its converter l2a; what they write is the run of a solver here.

Each takes the path, the times (n,), and columns (n,) by name.
"""

HEAD = " {title}\n                         ls-dyna smp.131 d  R14.1        date 11/30/2026\n"
LEGEND = "\n{{BEGIN LEGEND}}\n Entity #        Title\n{:9d}     a name\n{{END LEGEND}}\n\n"
MOTION = ("displacement", "velocity", "acceleration", "coordinate")
NODOUT = (
    "\n nodal point  x-disp     y-disp      z-disp      x-vel       y-vel       z-vel      x-accl      y-accl      "
    "z-accl      x-coor      y-coor      z-coor\n"
)
ROTATIONS = (
    "\n nodal point  x-rot      y-rot       z-rot       x-rot vel   y-rot vel   z-rot vel   x-rot acc   y-rot acc   "
    "z-rot acc\n"
)
STATE = "\n\n\n n o d a l   p r i n t   o u t   f o r   t i m e  s t e p%8d                              ( at time%14.7E )\n"


def head(title="a case"):
    """The first lines of every text file."""
    return HEAD.format(title=title)


def nodout(path, time, nodes, rotations=False):
    """`nodes`: columns by name, by number of the node; what is not given is zero."""
    with open(path, "w") as file:
        file.write(head() + LEGEND.format(next(iter(nodes))))
        for i, t in enumerate(time):
            file.write(STATE % (i + 1, t) + NODOUT)
            for nid, columns in nodes.items():
                names = [f"{axis}-{quantity}" for quantity in MOTION for axis in "xyz"]
                values = [columns[name][i] if name in columns else 0.0 for name in names]
                file.write(
                    "%9d%13.4E" % (nid, values[0]) + "".join("%12.4E" % value for value in values[1:]) + "\n"
                )
            if rotations:
                file.write(STATE % (i + 1, t) + ROTATIONS)
                for nid in nodes:
                    file.write("%9d%13.4E" % (nid, 0.0) + "%12.4E" % 0.0 * 8 + "\n")


def glstat(path, time, energies):
    """`energies`: lines of the file, by their names; stonewall energies may be several columns (n, walls)."""
    with open(path, "w") as file:
        file.write(head())
        for i, t in enumerate(time):
            file.write("\n\n dt of cycle%8d is controlled by shell      element%8d\n\n" % (i + 1, 1))
            file.write(
                " %s%14.5E\n" % ("time".ljust(31, "."), t)
                + " %s%14.5E\n" % ("time step".ljust(31, "."), 1e-6)
            )
            for name, values in energies.items():
                label = (name + " ").ljust(31, ".") if name == "hourglass energy" else name.ljust(31, ".")
                if getattr(values, "ndim", 1) == 2:
                    for wall, value in enumerate(values[i], 1):
                        file.write(" %s%14.5E wall#%2d\n" % (label, value, wall))
                else:
                    file.write(" %s%14.5E\n" % (label, values[i]))
            file.write(" time per zone cycle.(nanosec)..%14d\n" % 100)


def matsum(path, time, parts):
    """`parts`: columns by name, by number of the part."""
    with open(path, "w") as file:
        file.write(head() + LEGEND.format(next(iter(parts))))
        for i, t in enumerate(time):
            file.write("\n\n time =%13.4E\n" % t)
            for pid, columns in parts.items():
                at = lambda name, columns=columns, i=i: columns[name][i] if name in columns else 0.0  # noqa: E731
                file.write(
                    " mat.#=%5d             inten=%13.4E     kinen=%13.4E"
                    % (pid, at("internal"), at("kinetic"))
                )
                file.write("     eroded_ie=%13.4E     eroded_ke=%13.4E\n" % (0, 0))
                for short, name in (("mom", "momentum"), ("rbv", "velocity")):
                    values = (at("x-" + name), at("y-" + name), at("z-" + name))
                    file.write(f" x-{short}=%13.4E     y-{short}=%13.4E     z-{short}=%13.4E\n" % values)
                file.write(
                    "                         hgeng=%13.4E     +mass=%13.4E\n" % (at("hourglass"), 0.0)
                )


def rcforc(path, time, contacts, sides=("slave ", "master")):
    """`contacts`: x, y and z-forces on side A, by number of the contact."""
    with open(path, "w") as file:
        file.write(head() + LEGEND.format(next(iter(contacts))))
        for i, t in enumerate(time):
            for number, columns in contacts.items():
                for side, sign in zip(sides, (1.0, -1.0), strict=True):
                    forces = [sign * columns[f"{axis}-force"][i] for axis in "xyz"]
                    file.write("  %s%11d time" % (side, number))
                    file.write("%12.5E  x %12.5E  y %12.5E  z %12.5E mass %12.5E" % (t, *forces, 0.0))
                    file.write(
                        "  mx %12.5E  my %12.5E  mz %12.5E\n" % (0, 0, 0) if side == "SURFA " else "\n"
                    )


def spcforc(path, time, nodes):
    """`nodes`: x, y and z-forces, and moments, by number of the node."""
    with open(path, "w") as file:
        file.write(head() + " single point constraint forces\n\n")
        for i, t in enumerate(time):
            file.write(" output at time =%14.5E\n" % t)
            total = [0.0, 0.0, 0.0]
            for nid, columns in nodes.items():
                for kind in ("forces ", "moments"):
                    names = [f"{axis}-{kind.strip()[:-1]}" for axis in "xyz"]
                    values = [columns[name][i] if name in columns else 0.0 for name in names]
                    file.write(" node=%8d local x,y,z %s=" % (nid, kind))
                    file.write("%14.4E%14.4E%14.4E setid=%8d\n" % (*values, 1))
                    if kind == "forces ":
                        total = [a + b for a, b in zip(total, values, strict=True)]
            file.write("             force resultants   =%14.4E%14.4E%14.4E\n" % tuple(total))


def rwforc(path, time, walls, segments=0):
    """`walls`: normal forces, by number of the wall."""
    with open(path, "w") as file:
        file.write(head() + LEGEND.format(next(iter(walls))))
        file.write("\n\n    time       wall#   normal-force    x-force        y-force        z-force\n")
        for i, t in enumerate(time):
            for number, forces in walls.items():
                file.write("%12.5E%8d%15.6E%15.6E%15.6E%15.6E\n" % (t, number, forces[i], 0, 0, 0))
                if segments:
                    file.write("                seg#    \n")
                    for k in range(segments):
                        file.write("            %8d               %15.6E%15.6E%15.6E\n" % (k + 1, 0, 0, 0))
                    file.write("  total force                      %15.6E%15.6E%15.6E\n" % (0, 0, 0))


def dotted(path, time, number, things):
    """deforc, jntforc: lines by name, by number; `number` is the name of the line with the number."""
    with open(path, "w") as file:
        file.write(head())
        for i, t in enumerate(time):
            file.write("\n %s%14.5E\n" % ("time".ljust(29, "."), t))
            for n, lines in things.items():
                file.write(" %s%10d\n" % (number.ljust(29, "."), n))
                for name, values in lines.items():
                    file.write(" %s%14.5E\n" % (name.ljust(29, "."), values[i]))


def sleout(path, time, contacts):
    """`contacts`: energies of side A and side B, or of side A alone, by number of the contact."""
    with open(path, "w") as file:
        file.write(head())
        for i, t in enumerate(time):
            file.write("\n\n\n contact interface energy file, time=%14.7E\n" % t)
            file.write("    #            slave       master        cycle=%14d\n\n" % (i + 1))
            for number, sides in contacts.items():
                file.write("%10d" % number + "".join("%13.4E" % side[i] for side in sides) + "\n")
            file.write("\n summary   total slave side=%14.7E\n           total mastr side=%14.7E\n" % (0, 0))
            file.write("           total energy    =%14.7E\n\n\n\n" % 0)


def rbdout(path, time, bodies):
    """`bodies`: columns by name, by number of the body."""
    rows = (
        ("   coordinates:  ", ("coordinate",)), (" displacements:  ", ("displacement", "rotation")),
        ("    velocities:  ", ("velocity", "angular-velocity")),
        (" accelerations:  ", ("acceleration", "angular-acceleration")),
    )  # fmt: skip
    with open(path, "w") as file:
        file.write(head())
        for i, t in enumerate(time):
            file.write(
                "1\n\n  r i g i d   b o d y   m o t i o n   a t  cycle=%8d    time=%15.6E\n" % (i + 1, t)
            )
            for number, columns in bodies.items():
                file.write("\n rigid body%8d\n" % number)
                file.write(
                    "   global             x           y           z          x-rot       y-rot       z-rot\n"
                )
                for label, names in rows:
                    names = [f"{axis}-{name}" for name in names for axis in "xyz"]
                    values = [columns[name][i] if name in columns else 0.0 for name in names]
                    file.write(label + "".join("%12.4E" % value for value in values) + "\n")
                file.write("\nprincipal or user defined local coordinate direction vectors\n")
                file.write("                     a           b           c\n")
                for row in (1, 2, 3):
                    file.write("     row %d%15.4E%15.4E%15.4E\n" % (row, 1, 0, 0))
                file.write("\n output in principal or user defined local coordinate directions\n")
                file.write(
                    "                      a           b           c          a-rot       b-rot       c-rot\n"
                )
                for label, _ in rows[1:]:
                    file.write(label + "%12.4E" % 9.0 * 6 + "\n")


def bndout(path, time, nodes):
    """`nodes`: forces of prescribed motions, by number of the node."""
    with open(path, "w") as file:
        file.write(head())
        for i, t in enumerate(time):
            for section in (
                "discrete nodal point forces ",
                "velocity boundary condition forces/rigid body moments ",
            ):
                file.write("\n\n\n\n\n n o d a l   f o r c e/e n e r g y    o u t p u t   t=%9.3E\n" % t)
                file.write("\n\n\n\n\n %s\n\n" % section)
                sign = 1.0 if section[0] == "v" else 7.0
                for nid, columns in nodes.items():
                    forces = [sign * columns[f"{axis}-force"][i] for axis in "xyz"]
                    file.write(
                        " nd#%8d  xforce=%13.4E   yforce=%13.4E  zforce=%13.4E   energy=%13.4E\n"
                        % (nid, *forces, 0)
                    )
                file.write(
                    "              xtotal=%13.4E   ytotal=%13.4E  ztotal=%13.4E   etotal=%13.4E\n"
                    % (0, 0, 0, 0)
                )


def elout(path, time, solids=(), shells=(), beams=(), system="local "):
    """Stresses (n, points, 6) and plastic strains (n, points) of shells, (n, 6) of solids; of beams resultants (n, 6), and stresses (n, points, 4)."""
    calculations = "\n\n\n e l e m e n t   s t r e s s   c a l c u l a t i o n s   f o r   t i m e  s t e p%9d   ( at time%12.5E )\n\n"
    axes = "sig-xx      sig-yy      sig-zz      sig-xy      sig-yz      sig-zx"
    with open(path, "w") as file:
        file.write(head())
        for i, t in enumerate(time):
            if solids:
                file.write(calculations % (i + 1, t) + " element  materl\n")
                file.write(f"     ipt  stress       {axes}                       yield\n           state\n")
                for eid, stress in solids.items():
                    file.write(
                        "%8d-%7d\n       1 %-7s " % (eid, 1, "elastic")
                        + "".join("%12.4E" % s for s in stress[i])
                    )
                    file.write("%14.4E%14.4E\n" % (0, 0))
            if beams:
                file.write(
                    "\n\n\n\n r e s u l t a n t s   a n d   s t r e s s e s   f o r   t i m e  s t e p"
                )
                file.write("%9d   ( at time%12.5E )\n" % (i + 1, t))
                for eid, (forces, points) in beams.items():
                    file.write("\n\n\n\n beam/truss # =%8d      material #  =%5d\n" % (eid, 1))
                    file.write(
                        "\n\n resultants      axial    shear-s    shear-t    moment-s   moment-t   torsion\n"
                    )
                    file.write("           " + "".join("%11.3E" % force for force in forces[i]) + "\n")
                    if points is not None:
                        file.write("\n\n integration point stresses\n                       ")
                        file.write("sigma 11       sigma 12       sigma 31   plastic  eps\n")
                        for k, point in enumerate(points[i], 1):
                            file.write("%5d           %15.6E%15.6E%15.6E%15.6E\n" % (k, *point))
            if shells:
                file.write(calculations % (i + 1, t) + f" element  materl({system})\n")
                file.write(
                    f" ipt-shl  stress       {axes}       plastic\n           state            strain \n"
                )
                for eid, (stress, strain) in shells.items():
                    file.write("%8d-%7d\n" % (eid, 1))
                    for k, (row, plastic) in enumerate(zip(stress[i], strain[i], strict=True), 1):
                        file.write("%4d-%3d %-7s " % (k, 2, "plastic") + "".join("%12.4E" % s for s in row))
                        file.write("%14.4E\n" % plastic)
                file.write("\n strains (%s)       eps-xx      eps-yy\n\n" % system)
                for eid in shells:
                    file.write("%8d-%7d\n lower surface   %12.4E%12.4E\n" % (eid, 1, 5, 5))
