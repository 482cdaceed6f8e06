"""Entry points: `python -m conformance`, and the commands of an installation.

The client is installed from the same wheel without the kit's dependencies. There, they
report the missing one in one line. This module must not import what may be missing.
"""

import gc
import importlib
import sys
from functools import partial

from conformance.client.connections.transport.closed_output import run_program
from conformance.client.connections.transport.printable_text import prepare_output


def main() -> int:
    """Judge a server; 2 when the kit cannot start."""
    return _start("conformance.cli.main")


def main_policy() -> int:
    """Judge a policy server; 2 when the kit cannot start."""
    return _start("conformance.policy.__main__")


def main_simulator() -> int:
    """Judge a simulator; 2 when the kit cannot start."""
    return _start("conformance.simulator.__main__")


def _start(module: str) -> int:
    gc.disable()  # a fifth of the start: nothing is garbage until the checks begin
    prepare_output()
    return run_program(partial(_run, module))


def _run(module: str) -> int:
    try:
        begin = importlib.import_module(module).main
    except ModuleNotFoundError as missing:
        print(
            f"proctor-conformance: {missing.name} is not installed: `make setup` and "
            "`. .venv/bin/activate` in the repository; from the first release on: "
            "pip install 'proctor-eval[kit]' (the client alone is proctor)",
            file=sys.stderr,
        )
        return 2
    return int(begin())


if __name__ == "__main__":
    sys.exit(main())
