"""`proctor`, and `python -m reference_client.command`: says what is not installed.

The kit is installed with the same wheel but without the client's dependencies; whoever
types `proctor` there is told in one line. It must not import what may be missing.
"""

import sys


def main() -> int:
    """Returns the exit code of the command; 2 when it cannot start."""
    try:
        from reference_client.command.main import main as begin
    except ModuleNotFoundError as missing:
        print(
            f"proctor: {missing.name} is not installed here: "
            "pip install 'proctor-eval[client]' (the kit alone is proctor-conformance)",
            file=sys.stderr,
        )
        return 2
    return begin()


if __name__ == "__main__":
    sys.exit(main())
