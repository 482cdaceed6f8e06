"""The options of every command of `proctor`. docs/evaluate/command.md names each."""

from __future__ import annotations

from itertools import chain

import click
from click.shell_completion import CompletionItem

from reference_client.command.command_line import option_values as values
from reference_client.command.command_line.chosen_server import (
    DEFAULT_URL,
    SERVERLESS_COMMANDS,
)
from reference_record.command_line.click_commands import (
    OneOf,
    argument,
    flag,
    option,
)

STATES = (
    *("queued", "ready", "running", "stopping"),
    *("stopped", "failed", "completed"),
)
SHELLS = ("bash", "zsh", "fish")
FORMATS = ("text", "markdown", "latex")  # of tables
EXPORTS = ("parquet", "every-eval-ever", "lerobot")
Headings = dict[str, list[click.Parameter]]


def headings_of_commands() -> dict[str, Headings]:
    """Command → heading → the options that --help shows under it."""
    commands = _commands_on_runs() | _commands_on_records()
    for name, headings in commands.items():
        if name not in SERVERLESS_COMMANDS:
            headings["Server"] = _server(("--to",) if name == "upload" else ())
        headings["Transport"] = [
            option(
                "--ca", metavar="FILE",
                help="certificates to accept, instead of the system's [PROCTOR_CA]",
            ),
            option(
                "--retry-timeout-s", type=values.seconds, metavar="S",
                help="retry an unreachable server for S seconds (10; run: 300)",
            ),
        ]  # fmt: skip
        headings["Output"] = [
            flag("--json", help="print one JSON value, for scripts"),
            option("--format", type=OneOf(FORMATS), default="text", help="of tables"),
            flag("--debug", help="print the tracebacks of errors"),
        ]
    return commands


def _commands_on_runs() -> dict[str, Headings]:
    run_id = _run_id("id of the run")
    listed = _run_id("id of the run; without it, the latest runs are listed")
    watch = flag("--watch", help="wait until the run has ended")
    drain = flag("--drain", help="finish the episodes in progress first")
    played = flag("--yes", help="delete runs that were played, too")
    episodes = flag("--episodes", help="also list every episode")
    address = flag("--print", help="print the address only")
    name = argument(
        "benchmark", required=False, metavar="[NAME]", shell_complete=_benchmarks,
        help="id of the benchmark to show",
    )  # fmt: skip
    view: list[click.Parameter] = [
        flag("--view", help="serve a live view on localhost"),
        option(
            "--view-port", type=int, default=0, metavar="PORT",
            help="port of the live view (default: a free port)",
        ),
    ]  # fmt: skip
    return {
        "submit": {
            "Run": _submission(),
            "Push mode: the server calls the policy": _push(),
            "Waiting": [
                flag("--wait", help="wait until the run accepts workers"),
                _timeout(),
                flag(
                    "--print-endpoint",
                    help="print only the endpoint of the data plane",
                ),
            ],
        },
        "run": {
            "": [_save()],
            "Policy": _policy(),
            "Run": _submission(),
            "Workers": _workers(),
            "Live view": view,
        },
        "status": {"": [*listed, watch], "List": _list()},
        "stop": {"": [*run_id, drain]},
        "resume": {"": run_id},
        "delete": {"": [_runs("RUN…", "ids of runs"), played]},
        "open": {"": [*run_id, address]},
        "results": {"": [*run_id, episodes, _save()]},
        "compare": {"": _compare()},
        "benchmarks": {"": [name]},
        "completion": {"": [argument("shell", type=OneOf(SHELLS), help="the shell")]},
    }


def _commands_on_records() -> dict[str, Headings]:
    record = argument("file", help="the record, or its directory")
    source = _run_id("id of the run; or the file of its record")
    completed = _run_id("id of the completed run")
    host = option(
        "--server", metavar="URL", help="host whose published keys are accepted"
    )
    replayed = flag("--wait", help="wait until it has been replayed")
    simulated = "What is simulated again (video, --to lerobot)"
    return {
        "export": {"": [*source, *_export()], simulated: _simulation()},
        "video": {"": [*source, *_video()], simulated: _simulation()},
        "verify": {"": [record, _key(), host]},
        "upload": {"": [record, replayed, _timeout()]},
        "report": {"": _report()},
        "board": {"": _board()},
        "publish": {"": [*completed, *_publish()]},
        "withdraw": {"": completed},
    }


# --- what several commands have ---


def _server(further_names: tuple[str, ...]) -> list[click.Parameter]:
    return [
        option(
            "--url",
            *further_names,
            default=DEFAULT_URL,
            envvar="PROCTOR_URL",
            help=f"base URL [PROCTOR_URL, or {DEFAULT_URL}]",
        ),
        option("--host", help="with --port, instead of --url"),
        option("--port", type=int, help="with --host (8460)"),
        option(
            "--token",
            help="bearer token; prefer PROCTOR_TOKEN, which other users cannot read",
        ),
    ]


def _run_id(text: str) -> list[click.Parameter]:
    return [
        argument(
            "run", required=False, metavar="[RUN]", help=text, shell_complete=_runs_of
        ),
        option(
            "--run-id", metavar="RUN", help="the same as RUN", shell_complete=_runs_of
        ),
    ]


def _runs(metavar: str, text: str) -> click.Parameter:
    return argument(
        "runs", nargs=-1, required=True, metavar=metavar, help=text,
        shell_complete=_runs_of,
    )  # fmt: skip


def _benchmark(text: str) -> click.Parameter:
    return option("--benchmark", metavar="NAME", help=text, shell_complete=_benchmarks)


def _timeout() -> click.Parameter:
    text = "maximum wait (default: none)"
    return option("--timeout", type=values.seconds, metavar="S", help=text)


def _save() -> click.Parameter:
    text = "write result.json and episodes.csv to DIR"
    return option("--save", metavar="DIR", help=text)


def _key() -> click.Parameter:
    return option(
        "--key", multiple=True, metavar="[NAME=]SHA256:…",
        help="a key that you know to be of the host, or of who replayed; repeatable",
    )  # fmt: skip


def _output(metavar: str, text: str, *, required: bool = False) -> click.Parameter:
    return option("--output", "-o", metavar=metavar, help=text, required=required)


# --- runs ---


def _compare() -> list[click.Parameter]:
    return [
        argument("baseline", help="id of the baseline run", shell_complete=_runs_of),
        _runs("RUN…", "id of a run to compare"),
        option(
            "--tolerance", type=values.fraction, metavar="X",
            help="maximum score difference for release, 0 to 1 (0.05)",
        ),
    ]  # fmt: skip


def _list() -> list[click.Parameter]:
    return [
        _benchmark("runs of this benchmark"),
        option("--name", help="runs of the policies with this name"),
        option("--state", type=OneOf(STATES), help="runs in this state"),
        option(
            "--limit", type=values.count, metavar="N", default=20,
            help="rows of a page (20)",
        ),
        option(
            "--page", type=values.count, metavar="N", default=1,
            help="page of the list (1)",
        ),
    ]  # fmt: skip


def _submission() -> list[click.Parameter]:
    return [
        _benchmark("benchmark of a new run"),
        option(
            "--run-id", metavar="RUN", shell_complete=_runs_of,
            help="continue this run instead of a new one",
        ),
        option("--name", help="name of the policy"),
        option("--type", help="type of the policy, appended to its name"),
        option("--policy-version", metavar="V", help="version of the policy"),
        option("--submitter", metavar="NAME", help="name of the submitter"),
        option("--homepage", metavar="URL", help="homepage of the submitter"),
        flag(
            "--any-policy",
            help="other policies may play the new run, too; each result says which did",
        ),
        option(
            "--tasks", type=values.names, metavar="A,B",
            help="only episodes of these tasks",
        ),
        option(
            "--split", type=values.names, metavar="A,B",
            help="only episodes of these splits",
        ),
        option(
            "--max-workers", type=values.count, metavar="N",
            help="maximum simultaneous workers",
        ),
        option(
            "--idle-timeout-s", type=values.seconds, metavar="S",
            help="lease of a session: seconds without a request until it ends",
        ),
        option(
            "--images", type=values.images, metavar="CODEC:WxH",
            help="image format, one that the benchmark offers: jpeg:224x224",
        ),
        option(
            "--options", type=values.json_object, metavar="JSON",
            help="options of the benchmark `calibration`",
        ),
    ]  # fmt: skip


def _push() -> list[click.Parameter]:
    return [
        option(
            "--push", metavar="URL",
            help="the policy server, or the base URL of a model that is asked "
            "[bearer token: PROCTOR_POLICY_KEY]",
        ),
        option(
            "--model", metavar="NAME",
            help="ask this chat model, as OpenAI and vLLM offer it",
        ),
        option(
            "--protocol",
            type=OneOf(("proctor", "openai_chat", "openai_completions")),
            help="what is called at URL (openai_chat with --model, else proctor)",
        ),
        option(
            "--generation", type=values.json_object, metavar="JSON",
            help="""numbers of the model: '{"temperature": 0, "max_tokens": 512}'""",
        ),
        option(
            "--call-timeout-s", type=values.seconds, metavar="S",
            help="time for one call (30)",
        ),
        option(
            "--max-concurrent", type=values.count, metavar="N", help="calls at a time"
        ),
    ]  # fmt: skip


def _policy() -> list[click.Parameter]:
    return [
        option(
            "--policy",
            help="module:Class, file.py:Class, module:function, openpi:ws://host:8000, "
            "gr00t:host:5555, proctor:http://host:8470, or lerobot:FOLDER",
        ),
        option(
            "--policy-url", metavar="URL", help="the same as --policy proctor:URL"
        ),
        option(
            "--mapping", metavar="FILE",
            help="TOML file that maps observation and action names",
        ),
        option(
            "--assumes", type=values.json_object, metavar="JSON",
            help="conventions that the policy assumes (schema Assumptions)",
        ),
        option(
            "--episodes", type=values.count, metavar="N",
            help="play only the first N episodes; the score is then partial",
        ),
        option(
            "--repeat", type=values.count, metavar="K",
            help="evaluate in K runs; print mean and spread",
        ),
        flag(
            "--no-dry-turn",
            help="submit without calling the policy once with a made-up observation",
        ),
    ]  # fmt: skip


def _workers() -> list[click.Parameter]:
    return [
        option(
            "--workers", type=values.count, metavar="N", help="number of workers (1)"
        ),
        option(
            "--worker-prefix", default="worker", metavar="NAME",
            help="prefix of the worker ids; MUST differ between programs that share a "
            "run",
        ),
        option(
            "--worker-ids", metavar="A,B",
            help="explicit worker ids, instead of --workers",
        ),
        flag("--processes", help="run each worker in its own process"),
        flag(
            "--takeover",
            help="take over the sessions of a crashed program immediately",
        ),
    ]  # fmt: skip


# --- records, pages, leaderboard ---


def _export() -> list[click.Parameter]:
    return [
        _output("FILE", "file to write (RUN.proctor); with --to, a new directory"),
        flag("--force", help="replace the file"),
        option(
            "--to", type=OneOf(EXPORTS), metavar="FORMAT",
            help=f"convert the record: {', '.join(EXPORTS)}",
        ),
    ]  # fmt: skip


def _video() -> list[click.Parameter]:
    return [
        _output("DIR", "directory of the videos (RUN-videos)"),
        flag("--force", help="replace files that exist"),
    ]


def _simulation() -> list[click.Parameter]:
    return [
        option(
            "--episode", type=values.indices, multiple=True, metavar="N,…",
            callback=lambda _context, _option, given: [*chain(*given)] or None,
            help="this episode, by its index from 0; repeatable",
        ),
        flag("--failures", help="every episode that failed"),
        option(
            "--camera", multiple=True, metavar="NAME",
            help="this camera; repeatable (default: all)",
        ),
        option(
            "--size", type=values.size, metavar="WxH",
            help="pixels of a picture (default: as the policy saw it)",
        ),
        option(
            "--benchmarks", default="", metavar="REF,…",
            help="your own benchmarks, as for the server",
        ),
        option(
            "--seeds", default="", metavar="FILE",
            help="seeds of sealed splits that the host has opened",
        ),
        flag(
            "--anyway",
            help="keep episodes whose replay comes to another result, too",
        ),
    ]  # fmt: skip


def _report() -> list[click.Parameter]:
    return [
        _runs("RUN|FILE…", "ids of runs, or their records"),
        _output("DIR", "folder to write", required=True),
        flag("--force", help="write into a folder that has files"),
        option(
            "--videos", metavar="DIR", multiple=True,
            help="folder of `proctor video`: shown beside their episodes; repeatable",
        ),
        _key(),
    ]  # fmt: skip


def _board() -> list[click.Parameter]:
    return [
        argument(
            "benchmark", metavar="BENCHMARK|verify",
            help="id of the benchmark, or verify", shell_complete=_benchmarks,
        ),
        option(
            "--manifest", metavar="SHA256", help="of runs with options or of a part"
        ),
        flag("--csv", help="print comma-separated values"),
        option(
            "--state", metavar="FILE", help="verify: where the last checkpoint is kept"
        ),
    ]  # fmt: skip


def _publish() -> list[click.Parameter]:
    return [
        option("--name", help="of the model (the name of the policy)"),
        option("--type", help="of the model, such as VLA"),
        option("--organisation", metavar="NAME", help="who made it"),
        option("--homepage", metavar="URL", help="page about the model"),
        option("--code-url", metavar="URL", help="where its code is"),
        option("--notes", metavar="TEXT", help="what readers should know"),
        flag("--private", help="only this account sees it, without rank"),
    ]


# --- words that the server knows, for the shell at Tab ---


def _runs_of(
    context: click.Context, _parameter: click.Parameter, incomplete: str
) -> list[CompletionItem]:
    # Imported late: only a Tab needs the connection.
    from reference_client.command.command_line.completion import complete_runs

    return [*complete_runs(context.params, incomplete)]


def _benchmarks(
    context: click.Context, parameter: click.Parameter, incomplete: str
) -> list[CompletionItem]:
    from reference_client.command.command_line.completion import complete_benchmarks

    is_board = "verify" in str(parameter.metavar)
    words = complete_benchmarks(context.params, incomplete, is_board=is_board)
    return [*words]
