"""`python -m conformance.policy --url …`: judge a policy server by policy.yaml.

The same ledger, verdicts, reports and exit codes as for a server; only what is looked
at first differs, and what a check gets to play with.
"""

import argparse
import json
import os
import random
import sys
import time
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from conformance.cli.console import Terminal
from conformance.client.check_context import CheckContext
from conformance.client.request_context import SharedContext
from conformance.policy.turn_builder import calibration
from conformance.reports.files import write_reports
from conformance.run_settings import Settings
from conformance.runner.preflight import CannotJudge
from conformance.specification.document import load_policy_spec, spec_name
from conformance.specification.ledger import POLICY, load_ledger
from conformance.verdicts.expect import Violation, describe_answer
from conformance.verdicts.result import Result, conclude
from conformance.verdicts.universal_rules import Tally


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the kit; the exit code is 0 conformant, 1 violated, 2 could not judge."""
    options = _parser().parse_args(arguments)
    terminal, began_at = Terminal(), time.monotonic()
    result = Result(Settings(report=options.report, profiles=[POLICY]))
    result.started_at = datetime.now(UTC).isoformat(timespec="seconds")
    try:
        result.settings = _settings(options)
        terminal.say(f"judging a policy server by {spec_name()}")
        _judge(result, terminal)
    except CannotJudge as error:
        result.problem = str(error)
    except KeyboardInterrupt:
        result.problem = "interrupted before the end"
    result.elapsed_s = time.monotonic() - began_at
    if result.problem is not None and not result.rows:
        conclude(result, {}, Tally(load_policy_spec()), set())
    write_reports(result)
    terminal.report(result)
    return result.exit_code


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m conformance.policy",
        description="Judge a policy server by its answers alone.",
        epilog="Exit codes: 0 conformant, 1 a MUST is violated, 2 could not judge.",
    )
    parser.add_argument("--url", required=True, help="base URL of the policy server")
    parser.add_argument(
        "--key", help="its API key, if it has one [better: PROCTOR_POLICY_KEY]"
    )
    parser.add_argument(
        "--benchmark",
        metavar="FILE",
        help="what get_benchmark says of the benchmark that the policy is for; "
        "calibration without it",
    )
    parser.add_argument("--only", metavar="ID,...", help="ids or beginnings of ids")
    parser.add_argument("--seed", type=int, help="repeat a run's session ids")
    parser.add_argument("--report", default="report", metavar="DIR")
    return parser


def _settings(options: argparse.Namespace) -> Settings:
    if not options.url.startswith(("http://", "https://")):
        raise CannotJudge(f"--url {options.url} is no http or https URL")
    only = [part.strip() for part in (options.only or "").split(",") if part.strip()]
    known = [row.id for row in load_ledger().values() if row.profile == POLICY]
    for wanted in only:
        if not any(row.startswith(wanted) for row in known):
            raise CannotJudge(f"--only {wanted}: no requirement has such an id")
    seed = options.seed
    return Settings(
        url=options.url.rstrip("/"),
        token=options.key or os.environ.get("PROCTOR_POLICY_KEY") or None,
        only=only,
        profiles=[POLICY],
        report=options.report,
        seed=random.randrange(10**6) if seed is None else seed,
        benchmark=_benchmark(options.benchmark),
    )


def _benchmark(path: str | None) -> dict[str, Any]:
    if path is None:
        return calibration()
    try:
        benchmark: dict[str, Any] = json.loads(Path(path).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise CannotJudge(f"--benchmark {path}: {error}") from error
    schema = load_policy_spec().schema("Benchmark")
    missing = set(schema["required"]) - set(benchmark)
    if missing:
        raise CannotJudge(f"--benchmark {path} lacks {', '.join(sorted(missing))}")
    return benchmark


def _judge(result: Result, terminal: Terminal) -> None:
    settings = result.settings
    settings.service = _description(settings) | {"profiles": [POLICY]}
    name = settings.service.get("name")
    terminal.say(
        f"{name} at {settings.url}, asked for {settings.benchmark['benchmark_id']}"
    )
    # It brings pytest, which no earlier exit needs.
    from conformance.runner.execution import execute

    collector = execute(settings, 1, terminal.progress)
    result.problem = collector.problem
    conclude(result, collector.verdicts, collector.tally, set())


def _description(settings: Settings) -> dict[str, Any]:
    """Look whether there is a policy server that can be judged."""
    shared = SharedContext.of(settings)
    try:
        answer = CheckContext(shared, "preflight").call(
            "describe_policy", timeout_s=10.0
        )
    except Violation as error:
        raise CannotJudge(
            f"nothing answers GET {settings.url}/v1/policy ({error.observed}): start "
            "the policy server, or correct --url"
        ) from error
    finally:
        shared.close()
    body = answer.json
    if answer.status in (401, 403):
        raise CannotJudge(
            f"the key is refused: {describe_answer(answer)}; use PROCTOR_POLICY_KEY"
        )
    if answer.status != 200 or not isinstance(body, dict):
        raise CannotJudge(f"this is not a policy server: {describe_answer(answer)}")
    return body


if __name__ == "__main__":
    sys.exit(main())
