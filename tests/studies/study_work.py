"""Faults that worker processes can plant."""


def plant(fault):
    """Read every time late by a thousandth."""
    from vmharness import measure

    assert fault == "late"
    value_at = measure.value_at
    measure.value_at = lambda history, channel, t: (
        value_at(history, channel, t) * (1.001 if channel == "time" else 1.0)
    )
