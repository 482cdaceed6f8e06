"""The command line of `proctor`: every command, flag and help text.

Flags take precedence over environment variables. Values are checked here as far as that
is possible without a server. docs/evaluate/command.md names every flag.

Why argparse: it is part of Python, so the client needs no further dependency. The flags
are declarations in any library; another one would not make this module shorter.
"""

from __future__ import annotations

import argparse
import importlib.metadata
import json
import os
import re
from collections.abc import Mapping, Sequence
from typing import Any, NoReturn

from reference_client.command.command_line.aliases import PASS_THROUGH_COMMANDS
from reference_client.command.usage_error import UsageError
from reference_client.generated.protocol_version import PROTOCOL_VERSION
from reference_client.protocol.local_token import find_token
from reference_client.spelling import did_you_mean

DEFAULT_URL = "http://127.0.0.1:8460"  # where `proctor serve` serves
EXIT_CODES_HELP = (
    "exit codes: 0 success; 1 the run failed, is incomplete, or fails the release "
    "check; 2 usage error, or the server is unreachable or refuses; 130 interrupted"
)
STATES = (
    *("queued", "ready", "running", "stopping"),
    *("stopped", "failed", "completed"),
)
SERVERLESS_COMMANDS = ("verify", "completion")
SHELLS = ("bash", "zsh", "fish")
FORMATS = ("text", "markdown", "latex")  # of tables
EXPORTS = ("parquet", "every-eval-ever", "lerobot")
SIDE_MIN, SIDE_MAX = 16, 4096  # pixels of a video
# Command → what it does; the last five are programs of their own.
COMMANDS = {
    "submit": "submit a new run, or resume an existing one",
    "run": "evaluate a policy: submit, play, score",
    "status": "show the state of a run; without RUN, list the latest runs",
    "stop": "stop a run; scored episodes are kept",
    "resume": "resume a stopped or failed run",
    "delete": "delete runs that were never played, for good",
    "open": "open the page of a run in a browser; without RUN, the first page",
    "results": "show the score of a run, by task and split",
    "compare": "compare runs with a baseline, with the release decision",
    "export": "save the signed record of a completed run in a file, or convert it",
    "verify": "check a record: signature, every episode, the score (no server needed)",
    "upload": "hand a record in at a server, which verifies it and replays it",
    "report": "write pages about runs, as files that any browser opens",
    "board": "show the leaderboard of a benchmark; `verify` checks its history",
    "publish": "publish a completed run on the leaderboard, or change its entry",
    "withdraw": "take the entry of a run off the leaderboard, for good",
    "video": "draw episodes of a record again from their recorded actions",
    "benchmarks": "list benchmarks; with NAME, show its action and observation spaces",
    "completion": "print what makes a shell complete words of this command",
    "serve": "start the reference server (own flags)",
    "admin": "manage tokens, keys, recordings, seeds, the database here (own flags)",
    "serve-policy": "serve a policy over HTTP, for push mode (own flags)",
    "replay": "simulate the actions of a record again, sign what came out (own flags)",
    "conformance": "run the conformance kit against a server (own flags)",
}


class CommandParser(argparse.ArgumentParser):
    """Refuses in one line, with the name that was probably meant."""

    commands: Sequence[argparse.ArgumentParser] = ()

    def error(self, message: str) -> NoReturn:
        raise UsageError(f"{self._reword(message)}; see {self.prog} --help")

    def _reword(self, message: str) -> str:
        if unknown := re.match(r"unrecognized arguments: (\S+)", message):
            word = unknown[1].partition("=")[0]
            what = "option" if word.startswith("-") else "argument"
            if word in self._flags():
                return f"{word} is an option of {', '.join(self._owners(word))} only"
            return f"unknown {what} {word}{did_you_mean(word, self._flags())}"
        if wrong := re.search(r"invalid choice: '(.*?)'", message):
            word, name = wrong[1], message.partition(":")[0]
            if name.endswith("COMMAND"):
                return f"unknown command {word}{did_you_mean(word, COMMANDS)}"
            return (
                f"{name.removeprefix('argument ')} cannot be {word}"
                + (message.partition("'" + word + "'")[2])
            )
        return message

    def _owners(self, flag: str) -> list[str]:
        return [
            parser.prog
            for parser in self.commands
            if re.search(rf"{flag}\b(?!-)", parser.format_help())
        ]

    def _flags(self) -> set[str]:
        """The flags of this command, or of all where the command is not known."""
        texts = [parser.format_help() for parser in (self, *self.commands)]
        return set(re.findall(r"--[a-z][a-z-]*", " ".join(texts)))


def build_parser() -> CommandParser:
    """The parser of all commands."""
    parser = CommandParser(
        prog="proctor",
        description="Evaluate robot policies on any Proctor server.",
        epilog=EXIT_CODES_HELP,
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="version", version=_version())
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    made = {
        name: commands.add_parser(
            name, help=text, description=f"{text[:1].upper()}{text[1:]}.",
            epilog=EXIT_CODES_HELP,
            allow_abbrev=False, add_help=name not in PASS_THROUGH_COMMANDS,
        )
        for name, text in COMMANDS.items()
    }  # fmt: skip
    parser.commands = [*made.values()]
    for name, command in made.items():
        if name in PASS_THROUGH_COMMANDS:
            continue
        if name not in SERVERLESS_COMMANDS:
            _add_server_options(command)
        _add_transport_options(command)
        _add_output_options(command)
    _add_control_options(made)
    made["benchmarks"].add_argument(
        "benchmark", nargs="?", metavar="NAME", help="id of the benchmark to show"
    )
    _add_record_options(made["export"], made["verify"])
    _add_upload_options(made["upload"])
    _add_report_options(made["report"])
    _add_board_options(made["board"], made["publish"], made["withdraw"])
    _add_export_options(made["export"], made["video"])
    _add_submission_options(made["submit"])
    _add_push_options(made["submit"])
    submit = made["submit"].add_argument_group("waiting")
    submit.add_argument(
        "--wait", action="store_true", help="wait until the run accepts workers"
    )
    submit.add_argument(
        "--timeout", type=_seconds, metavar="S", help="maximum wait (default: none)"
    )
    submit.add_argument(
        "--print-endpoint",
        action="store_true",
        help="print only the endpoint of the data plane",
    )
    _add_submission_options(made["run"])
    _add_policy_options(made["run"])
    return parser


def resolve_server(args: argparse.Namespace) -> None:
    """Set `url` and `token`: of flags, the environment, or a server on this machine."""
    if args.ca:  # also for the processes of workers
        os.environ["PROCTOR_CA"] = args.ca
    if args.command in SERVERLESS_COMMANDS:
        return
    if args.host is not None or args.port is not None:
        from proctor_client.transport.server_address import url_of_host

        args.url = url_of_host(args.host, args.port)
    try:
        args.token = find_token(args.url, args.token)
    except ValueError as error:
        raise UsageError(str(error)) from None


def _add_control_options(made: Mapping[str, argparse.ArgumentParser]) -> None:
    """Add the options of the commands on runs. made: name → parser of the command."""
    _add_run_id(made["status"], "id of the run; without it, the latest runs are listed")
    _add_list_options(made["status"])
    made["status"].add_argument(
        "--watch", action="store_true", help="wait until the run has ended"
    )
    for name in ("stop", "resume", "results", "open"):
        _add_run_id(made[name], "id of the run")
    made["open"].add_argument(
        "--print", action="store_true", help="print the address only"
    )
    made["completion"].add_argument("shell", choices=SHELLS, help="the shell")
    made["stop"].add_argument(
        "--drain",
        action="store_true",
        help="finish the episodes in progress first",
    )
    made["delete"].add_argument("runs", nargs="+", metavar="RUN", help="ids of runs")
    made["delete"].add_argument(
        "--yes", action="store_true", help="delete runs that were played, too"
    )
    _add_results_options(made["results"])
    _add_compare_options(made["compare"])


def _add_server_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("server")
    group.add_argument(
        "--url",
        default=os.environ.get("PROCTOR_URL") or DEFAULT_URL,
        help=f"base URL [PROCTOR_URL, or {DEFAULT_URL}]",
    )
    group.add_argument("--host", metavar="HOST", help="with --port, instead of --url")
    group.add_argument("--port", type=int, metavar="PORT", help="with --host (8460)")
    group.add_argument(
        "--token",
        default=None,
        help="bearer token; prefer PROCTOR_TOKEN, which other users cannot read",
    )


def _add_transport_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("transport")
    group.add_argument(
        "--ca", metavar="FILE",
        help="certificates to accept, instead of the system's [PROCTOR_CA]",
    )  # fmt: skip
    group.add_argument(
        "--retry-timeout-s", type=_seconds, metavar="S",
        help="retry an unreachable server for S seconds (10; run: 300)",
    )  # fmt: skip


def _add_output_options(parser: argparse.ArgumentParser) -> None:
    shape = parser.add_argument_group("output")
    shape.add_argument(
        "--json", action="store_true", help="print one JSON value, for scripts"
    )
    shape.add_argument("--format", choices=FORMATS, default="text", help="of tables")
    shape.add_argument(
        "--debug", action="store_true", help="print the tracebacks of errors"
    )


def _add_compare_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("baseline", metavar="BASELINE", help="id of the baseline run")
    parser.add_argument("runs", nargs="+", metavar="RUN", help="id of a run to compare")
    parser.add_argument(
        "--tolerance", type=_fraction, metavar="X",
        help="maximum score difference for release, 0 to 1 (0.05)",
    )  # fmt: skip


def _add_record_options(
    export: argparse.ArgumentParser, verify: argparse.ArgumentParser
) -> None:
    export.add_argument(
        "--output", "-o", metavar="FILE",
        help="file to write (RUN.proctor); with --to, a new directory",
    )  # fmt: skip
    export.add_argument("--force", action="store_true", help="replace the file")
    verify.add_argument("file", metavar="FILE", help="the record, or its directory")
    _add_key(verify)
    verify.add_argument(
        "--server", metavar="URL", help="host whose published keys are accepted"
    )


def _add_upload_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", metavar="FILE", help="the record, or its directory")
    parser.add_argument(
        "--to", metavar="URL", dest="url", default=argparse.SUPPRESS,
        help="the server; the same as --url",
    )  # fmt: skip
    parser.add_argument(
        "--wait", action="store_true", help="wait until it has been replayed"
    )
    parser.add_argument(
        "--timeout", type=_seconds, metavar="S", help="maximum wait (default: none)"
    )


def _add_report_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "runs", nargs="+", metavar="RUN|FILE", help="ids of runs, or their records"
    )
    parser.add_argument(
        "--output", "-o", metavar="DIR", required=True, help="folder to write"
    )
    parser.add_argument(
        "--force", action="store_true", help="write into a folder that has files"
    )
    parser.add_argument(
        "--videos", metavar="DIR", action="append",
        help="folder of `proctor video`: shown beside their episodes; repeatable",
    )  # fmt: skip
    _add_key(parser)


def _add_board_options(
    board: argparse.ArgumentParser,
    publish: argparse.ArgumentParser,
    withdraw: argparse.ArgumentParser,
) -> None:
    board.add_argument(
        "benchmark", metavar="BENCHMARK|verify", help="id of the benchmark, or verify"
    )
    board.add_argument(
        "--manifest", metavar="SHA256", help="of runs with options or of a part"
    )
    board.add_argument(
        "--csv", action="store_true", help="print comma-separated values"
    )
    board.add_argument(
        "--state", metavar="FILE", help="verify: where the last checkpoint is kept"
    )
    for parser in (publish, withdraw):
        _add_run_id(parser, "id of the completed run")
    publish.add_argument("--name", help="of the model (the name of the policy)")
    publish.add_argument("--type", help="of the model, such as VLA")
    publish.add_argument("--organisation", metavar="NAME", help="who made it")
    publish.add_argument("--homepage", metavar="URL", help="page about the model")
    publish.add_argument("--code-url", metavar="URL", help="where its code is")
    publish.add_argument("--notes", metavar="TEXT", help="what readers should know")
    publish.add_argument(
        "--private", action="store_true", help="only this account sees it, without rank"
    )


def _add_key(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--key", action="append", metavar="[NAME=]SHA256:…",
        help="a key that you know to be of the host, or of who replayed; repeatable",
    )  # fmt: skip


def _add_export_options(
    export: argparse.ArgumentParser, video: argparse.ArgumentParser
) -> None:
    for command in (export, video):
        _add_run_id(command, "id of the run; or the file of its record")
        _add_simulation_options(command)
    export.add_argument(
        "--to", choices=EXPORTS, metavar="FORMAT",
        help=f"convert the record: {', '.join(EXPORTS)}",
    )  # fmt: skip
    video.add_argument(
        "--output", "-o", metavar="DIR", help="directory of the videos (RUN-videos)"
    )
    video.add_argument("--force", action="store_true", help="replace files that exist")


def _add_simulation_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("what is simulated again (video, --to lerobot)")
    group.add_argument(
        "--episode", type=_indices, action="extend", metavar="N,…",
        help="this episode, by its index from 0; repeatable",
    )  # fmt: skip
    group.add_argument(
        "--failures", action="store_true", help="every episode that failed"
    )
    group.add_argument(
        "--camera", action="append", metavar="NAME",
        help="this camera; repeatable (default: all)",
    )  # fmt: skip
    group.add_argument(
        "--size", type=_size, metavar="WxH",
        help="pixels of a picture (default: as the policy saw it)",
    )  # fmt: skip
    group.add_argument(
        "--benchmarks", default="", metavar="REF,…",
        help="your own benchmarks, as for the server",
    )  # fmt: skip
    group.add_argument(
        "--seeds", default="", metavar="FILE",
        help="seeds of sealed splits that the host has opened",
    )  # fmt: skip
    group.add_argument(
        "--anyway",
        action="store_true",
        help="keep episodes whose replay comes to another result, too",
    )


def _add_results_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--episodes", action="store_true", help="also list every episode"
    )
    _add_save(parser)


def _add_save(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--save", metavar="DIR", help="write result.json and episodes.csv to DIR"
    )


def _add_list_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("list")
    group.add_argument("--benchmark", metavar="NAME", help="runs of this benchmark")
    group.add_argument("--name", help="runs of the policies with this name")
    group.add_argument("--state", choices=STATES, help="runs in this state")
    group.add_argument(
        "--limit", type=_count, metavar="N", default=20, help="rows of a page (20)"
    )
    group.add_argument(
        "--page", type=_count, metavar="N", default=1, help="page of the list (1)"
    )


def _add_run_id(parser: argparse.ArgumentParser, text: str) -> None:
    parser.add_argument("run", nargs="?", metavar="RUN", help=text)
    parser.add_argument("--run-id", metavar="RUN", help="the same as RUN")


def _add_submission_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("run")
    group.add_argument("--benchmark", metavar="NAME", help="benchmark of a new run")
    group.add_argument(
        "--run-id", metavar="RUN", help="continue this run instead of a new one"
    )
    group.add_argument("--name", help="name of the policy")
    group.add_argument("--type", help="type of the policy, appended to its name")
    group.add_argument("--policy-version", metavar="V", help="version of the policy")
    group.add_argument("--submitter", metavar="NAME", help="name of the submitter")
    group.add_argument("--homepage", metavar="URL", help="homepage of the submitter")
    group.add_argument(
        "--any-policy",
        action="store_true",
        help="other policies may play the new run, too; each result says which did",
    )
    group.add_argument(
        "--tasks", type=_names, metavar="A,B", help="only episodes of these tasks"
    )
    group.add_argument(
        "--split", type=_names, metavar="A,B", help="only episodes of these splits"
    )
    group.add_argument(
        "--max-workers", type=_count, metavar="N", help="maximum simultaneous workers"
    )
    group.add_argument(
        "--idle-timeout-s",
        type=_seconds,
        metavar="S",
        help="lease of a session: seconds without a request until it ends",
    )
    group.add_argument(
        "--images", type=_images, metavar="CODEC:WxH",
        help="image format, one that the benchmark offers: jpeg:224x224",
    )  # fmt: skip
    group.add_argument(
        "--options", type=_json, metavar="JSON",
        help="options of the benchmark `calibration`",
    )  # fmt: skip


def _add_push_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("push mode: the server calls the policy")
    group.add_argument(
        "--push", metavar="URL",
        help="the policy server, or the base URL of a model that is asked "
        "[bearer token: PROCTOR_POLICY_KEY]",
    )  # fmt: skip
    group.add_argument(
        "--model", metavar="NAME",
        help="ask this chat model, as OpenAI and vLLM offer it",
    )  # fmt: skip
    group.add_argument(
        "--protocol",
        choices=("proctor", "openai_chat", "openai_completions"),
        help="what is called at URL (openai_chat with --model, else proctor)",
    )
    group.add_argument(
        "--generation", type=_json, metavar="JSON",
        help="""numbers of the model: '{"temperature": 0, "max_tokens": 512}'""",
    )  # fmt: skip
    group.add_argument(
        "--call-timeout-s", type=_seconds, metavar="S", help="time for one call (30)"
    )
    group.add_argument(
        "--max-concurrent", type=_count, metavar="N", help="calls at a time"
    )


def _add_policy_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("policy")
    group.add_argument(
        "--policy", metavar="POLICY",
        help="module:Class, file.py:Class, module:function, openpi:ws://host:8000, "
        "gr00t:host:5555, proctor:http://host:8470, or lerobot:FOLDER",
    )  # fmt: skip
    group.add_argument(
        "--policy-url", metavar="URL", help="the same as --policy proctor:URL"
    )
    group.add_argument(
        "--mapping", metavar="FILE",
        help="TOML file that maps observation and action names",
    )  # fmt: skip
    group.add_argument(
        "--assumes", type=_json, metavar="JSON",
        help="conventions that the policy assumes (schema Assumptions)",
    )  # fmt: skip
    group.add_argument(
        "--episodes", type=_count, metavar="N",
        help="play only the first N episodes; the score is then partial",
    )  # fmt: skip
    group.add_argument(
        "--repeat", type=_count, metavar="K",
        help="evaluate in K runs; print mean and spread",
    )  # fmt: skip
    _add_save(parser)
    group.add_argument(
        "--no-dry-turn",
        action="store_true",
        help="submit without calling the policy once with a made-up observation",
    )
    workers = parser.add_argument_group("workers")
    workers.add_argument(
        "--workers", type=_count, metavar="N", help="number of workers (1)"
    )
    workers.add_argument(
        "--worker-prefix", default="worker", metavar="NAME",
        help="prefix of the worker ids; MUST differ between programs that share a run",
    )  # fmt: skip
    workers.add_argument(
        "--worker-ids", metavar="A,B", help="explicit worker ids, instead of --workers"
    )
    workers.add_argument(
        "--processes", action="store_true", help="run each worker in its own process"
    )
    workers.add_argument(
        "--takeover",
        action="store_true",
        help="take over the sessions of a crashed program immediately",
    )
    view = parser.add_argument_group("live view")
    view.add_argument(
        "--view", action="store_true", help="serve a live view on localhost"
    )
    view.add_argument("--view-port", type=int, default=0, metavar="PORT",
        help="port of the live view (default: a free port)",
    )  # fmt: skip
    trackers = parser.add_argument_group("experiment trackers")
    trackers.add_argument(
        "--log", action="append", metavar="TRACKER",
        help="wandb:PROJECT, tensorboard:FOLDER or mlflow:EXPERIMENT; repeatable",
    )  # fmt: skip
    trackers.add_argument(
        "--log-videos", type=_count, default=0, metavar="N",
        help="send videos of N episodes, failures first",
    )  # fmt: skip


def _version() -> str:
    try:
        installed = importlib.metadata.version("proctor-eval")
    except importlib.metadata.PackageNotFoundError:
        installed = "not installed"
    return f"proctor {installed}, protocol version {PROTOCOL_VERSION}"


def _count(text: str) -> int:
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"{text}: expected an integer >= 1")
    return int(text)


def _names(text: str) -> list[str]:
    names = [name for part in text.split(",") if (name := part.strip())]
    if not names:
        raise argparse.ArgumentTypeError("expected names with commas between them")
    return names


def _seconds(text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        number = -1.0
    if not 0 <= number < 1e9:
        raise argparse.ArgumentTypeError(f"{text}: expected seconds >= 0")
    return number


def _fraction(text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        number = -1.0
    if not 0 <= number <= 1:
        raise argparse.ArgumentTypeError(f"{text}: expected a number from 0 to 1")
    return number


def _indices(text: str) -> list[int]:
    if not re.fullmatch(r"\d{1,5}(,\d{1,5})*", text):
        raise argparse.ArgumentTypeError(f"{text}: expected indices such as 0,3,12")
    return [int(index) for index in text.split(",")]


def _size(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"(\d{2,4})x(\d{2,4})", text)
    width, height = map(int, match.groups()) if match else (0, 0)
    if not (min(width, height) >= SIDE_MIN and max(width, height) <= SIDE_MAX):
        raise argparse.ArgumentTypeError(
            f"{text}: expected WIDTHxHEIGHT, for example 640x480, "
            f"each from {SIDE_MIN} to {SIDE_MAX}"
        )
    if width % 2 or height % 2:
        raise argparse.ArgumentTypeError(f"{text}: a video has even sides")
    return width, height


def _json(text: str) -> dict[str, Any]:
    try:
        value = json.loads(text)
    except json.JSONDecodeError as error:
        raise argparse.ArgumentTypeError(
            f"invalid JSON at character {error.pos + 1}: {text}"
        ) from error
    if not isinstance(value, dict):
        raise argparse.ArgumentTypeError("expected a JSON object")
    return value


def _images(text: str) -> dict[str, Any]:
    match = re.fullmatch(r"([a-z]+):(\d{1,4})x(\d{1,4})", text)
    if match is None:
        raise argparse.ArgumentTypeError(
            f"{text}: expected CODEC:WIDTHxHEIGHT, for example jpeg:224x224"
        )
    codec, width, height = match.groups()
    return {"codec": codec, "width": int(width), "height": int(height)}
