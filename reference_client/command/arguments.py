"""The command line of `proctor`, described once: its help and docs/command.md say it.

Flags win over the environment. Values are checked here as far as they can be without a
server.
"""

from __future__ import annotations

import argparse
import json
import os
import re
from typing import Any, NoReturn

from reference_client.command.aliases import PASS_THROUGH_COMMANDS
from reference_client.command.exit_codes import UsageError

DEFAULT_URL = "http://127.0.0.1:8460"  # where `proctor serve` serves
EXIT_CODES_HELP = (
    "exit codes: 0 done; 1 the run failed, is not complete or not to be released; "
    "2 wrong usage or no server; 130 Ctrl-C"
)
# command → what it does; the last three are programs of their own.
COMMANDS = {
    "submit": "ask for a new run, or take up an old one",
    "run": "evaluate a policy: submit, play, score",
    "status": "how far a run is; without one, your latest runs",
    "stop": "stop a run; what is scored is kept",
    "resume": "let a stopped or failed run go on",
    "results": "the score of a run, by task and split",
    "compare": "runs beside a baseline, and whether they may be released",
    "benchmarks": "what can be evaluated; with a name, its spaces",
    "serve": "run the reference server (its own flags)",
    "serve-policy": "serve a policy for a server to call (its own flags)",
    "conformance": "judge a server (the kit's own flags)",
}


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise UsageError(f"{message}; {self.prog} --help lists what can be said")


def build_parser() -> argparse.ArgumentParser:
    """Every command with its flags."""
    parser = _Parser(
        prog="proctor",
        description="Evaluate robot policies on any Proctor server.",
        epilog=EXIT_CODES_HELP,
        allow_abbrev=False,
    )
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    made = {
        name: commands.add_parser(
            name, help=text, description=f"{name}: {text}.", epilog=EXIT_CODES_HELP,
            allow_abbrev=False, add_help=name not in PASS_THROUGH_COMMANDS,
        )
        for name, text in COMMANDS.items()
    }  # fmt: skip
    for name, command in made.items():
        if name not in PASS_THROUGH_COMMANDS:
            _add_server_options(command)
    _add_run_id(made["status"], "the run; your latest runs without it")
    made["status"].add_argument(
        "--watch", action="store_true", help="stay until the run is over"
    )
    for name in ("stop", "resume", "results"):
        _add_run_id(made[name], "the run")
    made["stop"].add_argument(
        "--drain",
        action="store_true",
        help="let episodes under way be played to the end",
    )
    made["results"].add_argument(
        "--episodes", action="store_true", help="every episode as well"
    )
    compare = made["compare"]
    compare.add_argument("baseline", metavar="BASELINE", help="the run to equal")
    compare.add_argument("runs", nargs="+", metavar="RUN", help="run beside it")
    compare.add_argument(
        "--tolerance", type=_fraction, metavar="X",
        help="largest difference of scores, from 0 to 1, that is released (0.05)",
    )  # fmt: skip
    made["benchmarks"].add_argument("benchmark", nargs="?", help="show this one")
    _add_submission_options(made["submit"])
    made["submit"].add_argument(
        "--push", metavar="URL",
        help="have the server call the policy server there [key: PROCTOR_POLICY_KEY]",
    )  # fmt: skip
    submit = made["submit"].add_argument_group("waiting")
    submit.add_argument("--wait", action="store_true", help="until it can be played")
    submit.add_argument(
        "--timeout", type=_seconds, metavar="S", help="the longest wait (no limit)"
    )
    submit.add_argument(
        "--print-endpoint", action="store_true", help="print the endpoint alone"
    )
    _add_submission_options(made["run"])
    _add_policy_options(made["run"])
    return parser


def _add_server_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("the server")
    group.add_argument(
        "--url",
        default=os.environ.get("PROCTOR_URL") or DEFAULT_URL,
        help=f"base URL [PROCTOR_URL, or {DEFAULT_URL}]",
    )
    group.add_argument("--host", metavar="HOST", help="instead of --url, with --port")
    group.add_argument("--port", type=int, metavar="PORT", help="8460 without it")
    group.add_argument(
        "--token", default=None, help="bearer token [better: PROCTOR_TOKEN]"
    )
    group.add_argument(
        "--patience-s", type=_seconds, metavar="S", help="wait for a lost server "
        "this long (10; run: 300)",
    )  # fmt: skip
    shape = parser.add_argument_group("what is printed")
    shape.add_argument(
        "--json", action="store_true", help="one JSON value, for scripts"
    )
    shape.add_argument("--debug", action="store_true", help="tracebacks of errors")


def _add_run_id(parser: argparse.ArgumentParser, text: str) -> None:
    parser.add_argument("run", nargs="?", metavar="RUN", help=text)
    parser.add_argument("--run-id", metavar="RUN", help="the same, as a flag")


def _add_submission_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("the run")
    group.add_argument("--benchmark", metavar="NAME", help="for a new run")
    group.add_argument("--run-id", metavar="RUN", help="go on with this run instead")
    group.add_argument("--name", help="of the policy")
    group.add_argument("--type", help="of the policy, shown behind its name")
    group.add_argument("--policy-version", metavar="V", help="of the policy")
    group.add_argument("--submitter", metavar="WHO", help="whose policy it is")
    group.add_argument("--homepage", metavar="URL", help="the submitter's")
    group.add_argument(
        "--max-workers", type=_count, metavar="N", help="most workers at a time"
    )
    group.add_argument(
        "--idle-timeout-s", type=_seconds, metavar="S", help="lease of a session"
    )
    group.add_argument(
        "--images", type=_images, metavar="CODEC:WxH",
        help="such as jpeg:224x224, chosen from the benchmark's",
    )  # fmt: skip
    group.add_argument(
        "--options", type=_json, metavar="JSON", help="of the benchmark calibration"
    )


def _add_policy_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("the policy")
    group.add_argument(
        "--policy", metavar="WHAT",
        help="module:Class, file.py:Class, module:function, openpi:ws://host:8000, or "
        "proctor:http://host:8470",
    )  # fmt: skip
    group.add_argument(
        "--policy-url", metavar="URL", help="the last one, without its prefix"
    )
    group.add_argument("--mapping", metavar="FILE", help="its names for ours (TOML)")
    group.add_argument(
        "--assumes", type=_json, metavar="JSON", help="conventions it takes for granted"
    )
    workers = parser.add_argument_group("workers")
    workers.add_argument("--workers", type=_count, metavar="N", help="how many (1)")
    workers.add_argument(
        "--worker-prefix", default="worker", metavar="NAME",
        help="their name; another for each program that shares a run",
    )  # fmt: skip
    workers.add_argument("--worker-ids", metavar="A,B", help="their names, instead")
    workers.add_argument(
        "--processes", action="store_true", help="a process for each, not a thread"
    )
    workers.add_argument(
        "--takeover",
        action="store_true",
        help="of a crashed program's workers, at once",
    )
    view = parser.add_argument_group("live view")
    view.add_argument(
        "--view", action="store_true", help="serve a page to look on, on this machine"
    )
    view.add_argument("--view-port", type=int, default=0, metavar="PORT",
        help="of that page (a free one)",
    )  # fmt: skip


def _count(text: str) -> int:
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"{text} is no number from 1")
    return int(text)


def _seconds(text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        number = -1.0
    if not 0 <= number < 1e9:
        raise argparse.ArgumentTypeError(f"{text} is no number of seconds")
    return number


def _fraction(text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        number = -1.0
    if not 0 <= number <= 1:
        raise argparse.ArgumentTypeError(f"{text} is no number from 0 to 1")
    return number


def _json(text: str) -> dict[str, Any]:
    try:
        value = json.loads(text)
    except json.JSONDecodeError as error:
        raise argparse.ArgumentTypeError(f"no JSON: {error}") from error
    if not isinstance(value, dict):
        raise argparse.ArgumentTypeError("must be a JSON object")
    return value


def _images(text: str) -> dict[str, Any]:
    found = re.fullmatch(r"([a-z]+):(\d{1,4})x(\d{1,4})", text)
    if found is None:
        raise argparse.ArgumentTypeError(f"{text} is not like jpeg:224x224")
    codec, width, height = found.groups()
    return {"codec": codec, "width": int(width), "height": int(height)}
