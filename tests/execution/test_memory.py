import sys

import pytest

from vmharness.execution.memory import at_most

SIZE = 2**30


@pytest.mark.skipif(sys.platform != "linux", reason="no limit without /proc")
def test_memory_beyond_the_limit_is_an_error_and_only_within():
    with at_most(SIZE // 4), pytest.raises(MemoryError):
        bytearray(SIZE)
    assert len(bytearray(SIZE)) == SIZE
