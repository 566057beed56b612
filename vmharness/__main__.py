"""`python -m vmharness` is `vm`."""

import sys

from vmharness.cli import main

if __name__ == "__main__":
    sys.exit(main())
