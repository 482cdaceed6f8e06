"""`python -m conformance.simulator CMD…`: check a simulator against spec/simulator.md.

The ledger, verdicts, reports and exit codes are those of `python -m conformance`; the
kit starts the program itself, as often as its checks need.
"""

import random
import re
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from conformance.cli.console import Terminal
from conformance.cli.kit_command import BadArguments, KitCommand, KitOptions, option
from conformance.cli.kit_run import read_only, run_checks, run_profile_kit
from conformance.client.check_context import CheckContext
from conformance.client.connections.transport.closed_output import run_program
from conformance.client.request_context import SharedContext
from conformance.run_settings import Settings
from conformance.runner.preflight import CannotJudge
from conformance.simulator.benchmark_notes import (
    notes_on_members,
    notes_on_replies,
    notes_on_seeds,
)
from conformance.simulator.description_faults import description_faults
from conformance.simulator.simulator_client import (
    NO_ROBOT,
    SimulatorClient,
    playable_tasks,
)
from conformance.specification.ledger import SIMULATOR, load_ledger
from conformance.verdicts.expect import SetUpFailed
from conformance.verdicts.result import Result
from conformance.verdicts.verdict import Outcome

_CLASS = re.compile(r"(.+\.py|[A-Za-z_][\w.]*):[A-Za-z_]\w*")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the kit; the exit code is 0 conformant, 1 violated, 2 not decided."""
    return run_profile_kit(build_command(), arguments, SIMULATOR, _settings, _judge)


def build_command() -> KitCommand:
    """Describe every option, and the command that follows them."""
    options = [
        option("--only", "rule ids or id prefixes", "ID,..."),
        option(
            "--start-timeout",
            "time to start, in seconds (default: 120)",
            "S",
            type=float,
            default=120.0,
        ),
        option(
            "--timeout",
            "time for each other reply, in seconds (default: 60)",
            "S",
            type=float,
            default=60.0,
        ),
        option("--seed", "first seed of episodes", type=int),
        option(
            "--report", "directory of the reports", "DIR", default="report/simulator"
        ),
    ]
    command = KitCommand(
        "proctor-conformance-simulator",
        {"Simulator": options},
        help="Start CMD, with its arguments, and check it against the simulator "
        "protocol.",
        epilog="Exit codes: 0 conformant, 1 a MUST is violated, 2 not decided (it "
        "cannot be started, kit error).",
    )
    command.context_settings["ignore_unknown_options"] = True
    command.allow_interspersed_args = False  # options behind CMD are its own
    command.params.append(click.Argument(["command"], nargs=-1, metavar="CMD..."))
    return command


def _why_no_program(word: str) -> str | None:
    """Why a word names no program, and how the thing that it names is checked."""
    if Path(word).is_file() and word.endswith(".toml"):
        return f"{word} is a benchmark file; give the command of its `simulator`"
    if _CLASS.fullmatch(word) and not Path(word).exists():
        check = f"python -m reference_sim.gymnasium check {word}"
        return f"{word} is a class, and this kit starts programs; `{check}` checks it"
    return None


def _settings(options: KitOptions) -> Settings:
    if not options.command:
        raise BadArguments("the command that starts the simulator is missing")
    if (why := _why_no_program(options.command[0])) is not None:
        raise BadArguments(why)
    return Settings(
        only=read_only(options.only, SIMULATOR),
        profiles=[SIMULATOR],
        report=options.report,
        seed=random.randrange(10**6) if options.seed is None else options.seed,
        simulator={
            "command": list(options.command),
            "start_timeout_s": options.start_timeout,
            "timeout_s": options.timeout,
            "benchmark": {},
            "faults": [],
        },
    )


def _judge(result: Result, terminal: Terminal) -> None:
    settings = result.settings
    benchmark = _read_description(settings)
    faults = description_faults(benchmark)
    settings.simulator |= {"benchmark": benchmark, "faults": faults}
    settings.service = {
        "name": " ".join(settings.simulator["command"]),
        "version": str(benchmark.get("version", "1")),
        "profiles": [SIMULATOR],
    }
    terminal.say(settings.service["name"])
    settings.simulator["tasks"] = [] if faults else _playable_tasks(settings)
    run_checks(result, terminal)
    if "physical" not in benchmark:
        _leave_robots_out(result)
    if not faults:
        result.notes += [*notes_on_members(benchmark), *notes_on_replies(settings)]
    repeatable = result.rows.get("SIM-011")
    if repeatable is not None and repeatable.outcome is Outcome.PASSED:
        result.notes += notes_on_seeds(settings)


def _leave_robots_out(result: Result) -> None:
    """Rules of robots that are not judged do not apply to a simulator that is none."""
    for verdict in result.rows.values():
        row = load_ledger()[verdict.requirement_id]
        if not row.is_observable and " robot " in row.text:
            verdict.outcome = Outcome.NOT_APPLICABLE
            verdict.reason = NO_ROBOT


def _playable_tasks(settings: Settings) -> Sequence[str]:
    """The tasks by which rules are judged; a refused `reset` breaks one rule alone."""
    shared = SharedContext.of(settings)
    try:
        return playable_tasks(CheckContext(shared, "preflight"))
    except SetUpFailed:
        return []
    finally:
        shared.close()


def _read_description(settings: Settings) -> dict[str, Any]:
    """Start the program once. Raises CannotJudge."""
    shared = SharedContext.of(settings)
    try:
        client = SimulatorClient(CheckContext(shared, "preflight"))
        try:
            benchmark = client.describe()
        finally:
            client.process.end()
    except SetUpFailed as failed:
        raise CannotJudge(f"no description: {failed.reason}") from failed
    finally:
        shared.close()
    return benchmark


if __name__ == "__main__":
    sys.exit(run_program(main))
