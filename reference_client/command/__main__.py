"""Entry point of `proctor` and `python -m reference_client.command`.

The kit is installed from the same wheel without the client's dependencies. There,
`proctor` reports the missing dependency in one line. This module must not import what
may be missing.
"""

import json
import signal
import sys
import threading
from collections.abc import Callable

# As shells report a program that SIGINT has ended.
INTERRUPTED = 130
THREADS_SAID_AFTER_S = 3.0


def main() -> int:
    """Returns the exit code of the command; 2 when it cannot start."""
    try:
        from reference_record.command_line.closed_output import run_program
    except KeyboardInterrupt:
        if sys.stderr is not None:
            sys.stderr.write("\nInterrupted.\n")
        return INTERRUPTED
    code = run_program(_run_command)
    _end_with_threads()
    return code


def _end_with_threads() -> None:
    """Say so where threads of a policy keep the program; Ctrl-C ends it at once."""
    if signal.getsignal(signal.SIGINT) == signal.default_int_handler:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    from reference_record.this_machine import start_if_possible

    reminder = threading.Timer(THREADS_SAID_AFTER_S, _say_what_is_awaited)
    reminder.daemon = True
    start_if_possible(reminder)


def _say_what_is_awaited() -> None:
    main_thread = threading.main_thread()
    names = [
        thread.name
        for thread in threading.enumerate()
        if thread is not main_thread and not thread.daemon
    ]
    if names:
        from reference_client.printable_text import LenientStream

        LenientStream(sys.stderr).write(
            f"proctor: waits for the end of {', '.join(names)}, which the policy has "
            "begun; Ctrl-C ends it. A thread with daemon=True is not awaited.\n"
        )


def _run_command() -> int:
    """Also an interruption is one JSON value, where that is what a script reads."""
    from reference_record.command_line.closed_output import interrupted_by_signals

    try:
        with interrupted_by_signals():
            from reference_client.printable_text import prepare_output

            prepare_output()
            streams = sys.stdout, sys.stderr
            try:
                return _prepare_command()()
            finally:
                # Python flushes them at its exit, which those of a policy may not have.
                sys.stdout, sys.stderr = streams
    except KeyboardInterrupt:
        if "--json" in sys.argv:
            error = {"code": "interrupted", "detail": "Interrupted."}
            print(json.dumps({"error": error}))
        raise


def _prepare_command() -> Callable[[], int]:
    try:
        from reference_client.command.main import prepare

        return prepare(sys.argv[1:])
    except ModuleNotFoundError as missing:
        from reference_record.command_line.installation import install_command

        print(
            f"proctor: {missing.name} is not installed: "
            f"{install_command('client')} (the kit alone is proctor-conformance)",
            file=sys.stderr,
        )
        return lambda: 2


if __name__ == "__main__":
    sys.exit(main())
