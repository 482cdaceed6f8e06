"""`python -m tests.mutants.serve NAME`: the reference server with one thing wrong."""

from __future__ import annotations

import sys

from reference_server.__main__ import main
from tests.mutants import load

if __name__ == "__main__":
    load()[sys.argv.pop(1)].patch()
    sys.exit(main())
