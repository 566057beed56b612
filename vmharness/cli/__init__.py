"""The `vm` command: the only package that prints or exits."""

from collections.abc import Sequence


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code."""
    # Imported here: a spawned worker imports the script that it was started from, and this with it, but needs no click.
    from vmharness.cli.vm import guarded

    return guarded(arguments)
