"""`python -m conformance.policy --url …`: check a policy server.

The ledger, verdicts, reports and exit codes are those of `python -m conformance`; only
the options, the preflight and the checks (POL, against policy.yaml) differ.
"""

import random
import sys
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from conformance.cli.console import Terminal
from conformance.cli.kit_command import BadArguments, KitCommand, KitOptions, option
from conformance.cli.kit_run import read_only, run_checks, run_profile_kit
from conformance.cli.reached_server import (
    accept_authorities,
    read_base_url,
    read_secret,
)
from conformance.client.check_context import CheckContext
from conformance.client.connections.failure_texts import describe_failure
from conformance.client.connections.transport.closed_output import run_program
from conformance.client.request_context import SharedContext
from conformance.policy.benchmark_source import DEFAULT_SERVER, read_benchmark
from conformance.run_settings import Settings
from conformance.runner.preflight import CannotJudge
from conformance.specification.ledger import POLICY
from conformance.verdicts.expect import OwnConnectionFailed, Violation, describe_answer
from conformance.verdicts.result import Result


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the kit; the exit code is 0 conformant, 1 violated, 2 not decided."""
    return run_profile_kit(build_command(), arguments, POLICY, _settings, _judge)


def build_command() -> KitCommand:
    """Describe every option."""
    options = [
        option("--url", "base URL of the policy server", required=True),
        option(
            "--ca",
            "certificates to accept, instead of the system's [PROCTOR_CA]",
            "FILE",
        ),
        option("--key", "its API key, if it has one [PROCTOR_POLICY_KEY]"),
        option(
            "--benchmark",
            "id of a benchmark of the evaluation server, or a JSON file with its "
            "get_benchmark response; default: calibration",
            "NAME",
        ),
        option(
            "--instruction",
            "instruction of an episode of its first task; default: that with which the "
            "evaluation server begins an episode, to which no action is sent",
            "TEXT",
        ),
        option(
            "--server",
            "evaluation server that describes the benchmark; its token is "
            f"PROCTOR_TOKEN [PROCTOR_URL, or {DEFAULT_SERVER}]",
            "URL",
            default=DEFAULT_SERVER,
            envvar="PROCTOR_URL",
        ),
        option("--only", "rule ids or id prefixes", "ID,..."),
        option("--seed", "seed of the session ids", type=int),
        option("--report", "directory of the reports", "DIR", default="report/policy"),
    ]
    return KitCommand(
        "proctor-conformance-policy",
        {"Policy server": options},
        help="Check a policy server against policy.yaml over HTTP (black box).",
        epilog="Exit codes: 0 conformant, 1 a MUST is violated, 2 not decided (no "
        "policy server, wrong key, kit error).",
    )


def _settings(options: KitOptions) -> Settings:
    try:
        accept_authorities(options.ca)
        url = read_base_url("--url", options.url)
        server = read_base_url("--server", options.server)
        key = read_secret(options.key, "--key", "PROCTOR_POLICY_KEY")
        token = read_secret(None, "PROCTOR_TOKEN", "PROCTOR_TOKEN")
    except ValueError as error:
        raise BadArguments(str(error)) from error
    seed = options.seed
    benchmark, beginning = read_benchmark(
        options.benchmark, options.instruction, server, token
    )
    return Settings(
        url=url,
        token=key,
        only=read_only(options.only, POLICY),
        profiles=[POLICY],
        report=options.report,
        seed=random.randrange(10**6) if seed is None else seed,
        benchmark=benchmark,
        beginning=asdict(beginning),
    )


def _judge(result: Result, terminal: Terminal) -> None:
    settings = result.settings
    settings.service = _description(settings) | {"profiles": [POLICY]}
    name = settings.service.get("name")
    terminal.say(
        f"{name} at {settings.url}, benchmark {settings.benchmark['benchmark_id']}, "
        f"task {settings.beginning['task']}: {settings.beginning['instruction']}"
    )
    run_checks(result, terminal)


def _description(settings: Settings) -> dict[str, Any]:
    """Read the description of the policy server, or raise CannotJudge."""
    shared = SharedContext.of(settings)
    try:
        answer = CheckContext(shared, "preflight").call(
            "describe_policy", timeout_s=10.0
        )
    except (Violation, OwnConnectionFailed) as error:
        url, observed = settings.url, getattr(error, "observed", error)
        text = f"no response from {url} ({observed}): start it or correct --url"
        if error.__cause__ is not None:
            text = describe_failure(error.__cause__, url)
        raise CannotJudge(text) from error
    finally:
        shared.close()
    body = answer.json
    if answer.status in (401, 403):
        raise CannotJudge(
            f"API key was rejected: {describe_answer(answer)}; set PROCTOR_POLICY_KEY"
        )
    if answer.status != 200 or not isinstance(body, dict):
        raise CannotJudge(f"this is not a policy server: {describe_answer(answer)}")
    return body


if __name__ == "__main__":
    sys.exit(run_program(main))
