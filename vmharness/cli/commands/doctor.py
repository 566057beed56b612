"""`vm doctor`: the solvers on this machine."""

import click

from vmharness.cli.say import plain_table, say_table


@click.command("doctor")
def command() -> int:
    """Show each solver: version and location, or why it cannot run.

    Other installed packages can offer solvers, in the entry point group vmharness.solvers.
    """
    from vmharness.backends import BackendError, calls, names
    from vmharness.backends.protocol import full_name

    table = plain_table("Solver", "Version", "Found")
    for name in names():
        try:
            solver = calls.solver(name)
            found = solver.found()
        except BackendError as error:
            table.add_row(name, "", str(error))
        else:
            where = f"no: {found.missing}" if found.missing else found.where
            table.add_row(name, full_name(solver, found), where)
    say_table(table)
    return 0
