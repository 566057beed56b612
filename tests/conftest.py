"""Settings for all tests."""

from hypothesis import settings

# The first call of a kernel may compile it, so no time limits; the same examples on every machine.
settings.register_profile("vmharness", deadline=None, derandomize=True)
settings.load_profile("vmharness")
