"""Entry points: `python -m conformance`, and the commands of an installation.

The client is installed from the same wheel without the kit's dependencies. There, they
report the missing one in one line. This module must not import what may be missing.
"""

import contextlib
import gc
import importlib
import sys

from conformance.client.connections.transport.printable_text import (
    output_that_may_end,
    prepare_output,
)


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
    try:
        begin = importlib.import_module(module).main
    except ModuleNotFoundError as missing:
        print(
            f"proctor-conformance: {missing.name} is not installed: "
            "pip install '.[kit]' in the repository; from the first release on: "
            "pip install 'proctor-eval[kit]' (the client alone is proctor)",
            file=sys.stderr,
        )
        return 2
    except KeyboardInterrupt:
        print("\nInterrupted.", file=sys.stderr)
        return 130
    code = 141  # as shells report the end by SIGPIPE
    with contextlib.suppress(BrokenPipeError):  # `proctor-conformance --list | head`
        code = int(begin())
    with output_that_may_end(sys.stdout):
        sys.stdout.flush()
    return code


if __name__ == "__main__":
    sys.exit(main())
