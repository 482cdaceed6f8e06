"""`python -m reference_client.command` is `proctor`."""

import sys

from reference_client.command.main import main

if __name__ == "__main__":
    sys.exit(main())
