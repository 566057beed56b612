"""The `vm` command: the only package that prints or exits."""

from collections.abc import Sequence


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code."""
    # Imported here, because a spawned worker imports the script that started it, and needs no click.
    from vmharness.cli.vm import guarded

    return guarded(arguments)
