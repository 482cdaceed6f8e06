"""The options of every command of `proctor`. docs/evaluate/command.md names each."""

from __future__ import annotations

from itertools import chain

import click
from click.shell_completion import CompletionItem

from reference_client.command.command_line import option_values as values
from reference_client.command.command_line.chosen_server import (
    SERVERLESS_COMMANDS,
)
from reference_record.command_line.click_commands import (
    OneOf,
    argument,
    count,
    episode_indices,
    flag,
    fraction,
    option,
    seconds,
)
from reference_record.command_line.default_server import DEFAULT_URL

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
            headings["Server"] = _server("--to" if name == "upload" else None)
        headings["Transport"] = [
            option(
                "--ca", "certificates to accept, instead of the system's [PROCTOR_CA]",
                metavar="FILE",
            ),
            option(
                "--retry-timeout-s",
                "retry an unreachable server for S seconds, from the start "
                "(300, but 10 at the start; run: 3 at the start)",
                type=seconds, metavar="S",
            ),
        ]  # fmt: skip
        headings["Output"] = [
            flag("--json", "print one JSON value, for scripts"),
            option("--format", "of tables", type=OneOf(FORMATS), default="text"),
            flag("--debug", "print the tracebacks of errors"),
        ]
    return commands


def _commands_on_runs() -> dict[str, Headings]:
    run_id = _run_id("id of the run")
    source = _run_id("id of the run, or the file of its record")
    listed = _run_id("id of the run; without it, the latest runs are listed")
    watch = flag("--watch", "wait until the run has ended")
    drain = flag("--drain", "finish the episodes in progress first")
    reason = option("--reason", "why, for the people who read the run", metavar="TEXT")
    played = flag("--yes", "delete runs that were played, too")
    episodes = flag("--episodes", "also list every episode")
    address = flag("--print", "print the address only")
    name = argument(
        "benchmark", "id of the benchmark to show",
        required=False, metavar="[NAME]", shell_complete=_benchmarks,
    )  # fmt: skip
    view: list[click.Parameter] = [
        flag("--view", "serve a live view on localhost"),
        option(
            "--view-port", "port of the live view (default: a free port)",
            type=int, default=0, metavar="PORT",
        ),
    ]  # fmt: skip
    return {
        "submit": {
            "Run": _submission(),
            "Push mode: the server calls the policy": _push(),
            "Waiting": [
                flag("--wait", "wait until the run accepts workers"),
                _timeout(),
                flag("--print-endpoint", "print only the endpoint of the data plane"),
            ],
            "Hosted: the server runs the policy": _hosted(),
        },
        "run": {
            "": [_save()],
            "Policy": _policy(),
            "Run": _submission(),
            "Workers": _workers(),
            "Live view": view,
            "Experiment trackers": _trackers(),
        },
        "status": {"": [*listed, watch], "List": _list()},
        "stop": {"": [*run_id, drain, reason]},
        "resume": {"": run_id},
        "delete": {"": [_runs("RUN…", "ids of runs"), played]},
        "open": {"": [*run_id, address]},
        "results": {"": [*source, episodes, _save()]},
        "compare": {"": _compare()},
        "benchmarks": {"": [name]},
        "login": {"": [flag("--forget", "remove the key that is kept for the server")]},
        "completion": {"": [argument("shell", "the shell", type=OneOf(SHELLS))]},
    }


def _commands_on_records() -> dict[str, Headings]:
    record = argument("file", "the record, or its directory")
    source = _run_id("id of the run; or the file of its record")
    completed = _run_id("id of the completed run")
    host = option("--server", "host whose published keys are accepted", metavar="URL")
    replayed = flag("--wait", "wait until it has been replayed")
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


def _server(also: str | None) -> list[click.Parameter]:
    return [
        option(
            "--url",
            f"base URL [PROCTOR_URL, or {DEFAULT_URL}]",
            also=also,
            default=DEFAULT_URL,
            envvar="PROCTOR_URL",
        ),
        option("--host", "with --port, instead of --url"),
        option("--port", "with --host (8460)", type=int),
        option(
            "--token",
            "bearer token; prefer PROCTOR_TOKEN, which other users cannot read",
        ),
    ]


def _run_id(text: str) -> list[click.Parameter]:
    return [
        argument("run", text, required=False, metavar="[RUN]", shell_complete=_runs_of),
        option("--run-id", "the same as RUN", metavar="RUN", shell_complete=_runs_of),
    ]


def _runs(metavar: str, text: str) -> click.Parameter:
    return argument(
        "runs",
        text,
        nargs=-1, required=True, metavar=metavar, shell_complete=_runs_of,
    )  # fmt: skip


def _benchmark(text: str) -> click.Parameter:
    return option("--benchmark", text, metavar="NAME", shell_complete=_benchmarks)


def _timeout() -> click.Parameter:
    text = "maximum wait (default: none)"
    return option("--timeout", text, type=seconds, metavar="S")


def _save() -> click.Parameter:
    text = "write result.json and episodes.csv to DIR"
    return option("--save", text, metavar="DIR")


def _key() -> click.Parameter:
    return option(
        "--key",
        "a key that you know to be of the host, or of who replayed; repeatable",
        multiple=True, metavar="[NAME=]SHA256:…",
    )  # fmt: skip


def _output(metavar: str, text: str, *, required: bool = False) -> click.Parameter:
    return option("--output", text, also="-o", metavar=metavar, required=required)


# --- runs ---


def _compare() -> list[click.Parameter]:
    return [
        argument(
            "baseline", "id of the baseline run, or the file of its record",
            shell_complete=_runs_of,
        ),
        _runs("RUN…", "id of a run to compare, or the file of its record"),
        option(
            "--tolerance", "maximum score difference for release, 0 to 1 (0.05)",
            type=fraction, metavar="X",
        ),
    ]  # fmt: skip


def _list() -> list[click.Parameter]:
    return [
        _benchmark("runs of this benchmark"),
        option("--name", "runs of the policies with this name"),
        option("--state", "runs in this state", type=OneOf(STATES)),
        option(
            "--limit", "rows of a page (20)",
            type=count, metavar="N", default=20,
        ),
        option(
            "--page", "page of the list (1)",
            type=count, metavar="N", default=1,
        ),
    ]  # fmt: skip


def _submission() -> list[click.Parameter]:
    return [
        _benchmark("benchmark of a new run"),
        option(
            "--run-id", "continue this run instead of a new one",
            metavar="RUN", shell_complete=_runs_of,
        ),
        option("--name", "name of the policy"),
        option("--type", "type of the policy, appended to its name"),
        option("--policy-version", "version of the policy", metavar="V"),
        option("--submitter", "name of the submitter", metavar="NAME"),
        option("--homepage", "homepage of the submitter", metavar="URL"),
        flag(
            "--any-policy",
            "other policies may play the new run, too; each result says which did",
        ),
        option(
            "--tasks", "only episodes of these tasks", type=values.names, metavar="A,B",
        ),
        option(
            "--split", "only episodes of these splits",
            type=values.names, metavar="A,B",
        ),
        option(
            "--max-workers", "maximum simultaneous workers",
            type=count, metavar="N",
        ),
        option(
            "--idle-timeout-s",
            "lease of a session: seconds without a request until it ends",
            type=seconds, metavar="S",
        ),
        option(
            "--images", "image format, one that the benchmark offers: jpeg:224x224",
            type=values.images, metavar="CODEC:WxH",
        ),
        option(
            "--options", "options of the benchmark `calibration`",
            type=values.json_object, metavar="JSON",
        ),
    ]  # fmt: skip


def _push() -> list[click.Parameter]:
    return [
        option(
            "--push",
            "the policy server, or the base URL of a model that is asked [bearer "
            "token: PROCTOR_POLICY_KEY]", metavar="URL",
        ),
        option(
            "--model", "ask this chat model, as OpenAI and vLLM offer it",
            metavar="NAME",
        ),
        option(
            "--protocol",
            "what is called at URL (openai_chat with --model, else proctor)",
            type=OneOf(("proctor", "openai_chat", "openai_completions")),
        ),
        option(
            "--generation",
            """numbers of the model: '{"temperature": 0, "max_tokens": 512}'""",
            type=values.json_object, metavar="JSON",
        ),
        option(
            "--call-timeout-s", "time for one call (30)",
            type=seconds, metavar="S",
        ),
        option("--max-concurrent", "calls at a time", type=count, metavar="N"),
    ]  # fmt: skip


def _hosted() -> list[click.Parameter]:
    return [
        option("--track", "hand a policy in for this track", metavar="TRACK"),
        option(
            "--phase",
            "of the track (the open one that closes first)",
        ),
        option("--image", "the policy, as an OCI archive", metavar="FILE"),
        option("--dockerfile", "shown to who reviews the image", metavar="FILE"),
        option("--code", "or the policy, as a folder", metavar="FOLDER"),
        option("--preset", "what the code runs in", metavar="NAME"),
        flag("--verify-only", "with --track: do not start the evaluation"),
        flag("--start", "with --submission: start the evaluation, which counts"),
        flag("--another", "hand in again what is handed in already, as one more"),
        option(
            "--submission",
            "follow this submission; with its --image or --code, continue its upload",
            metavar="ID",
        ),
    ]


def _policy() -> list[click.Parameter]:
    return [
        option(
            "--policy",
            "module:Class, file.py:Class, module:function, openpi:ws://host:8000, "
            "gr00t:host:5555, proctor:http://host:8470, or lerobot:FOLDER",
        ),
        option("--policy-url", "the same as --policy proctor:URL", metavar="URL"),
        option(
            "--mapping", "TOML file that maps observation and action names",
            metavar="FILE",
        ),
        option(
            "--assumes", "conventions that the policy assumes (schema Assumptions)",
            type=values.json_object, metavar="JSON",
        ),
        option(
            "--episodes", "play only the first N episodes; the score is then partial",
            type=count, metavar="N",
        ),
        option(
            "--repeat", "evaluate in K runs; print mean and spread",
            type=count, metavar="K",
        ),
        flag(
            "--no-dry-turn",
            "submit without calling the policy once with a made-up observation",
        ),
    ]  # fmt: skip


def _workers() -> list[click.Parameter]:
    return [
        option("--workers", "number of workers (1)", type=count, metavar="N"),
        option(
            "--worker-prefix",
            "prefix of the worker ids; MUST differ between programs that share a run",
            default="worker", metavar="NAME",
        ),
        option(
            "--worker-ids", "explicit worker ids, instead of --workers", metavar="A,B",
        ),
        flag("--processes", "run each worker in its own process"),
        flag("--takeover", "take over the sessions of a crashed program immediately"),
    ]  # fmt: skip


def _trackers() -> list[click.Parameter]:
    return [
        option(
            "--log",
            "wandb:PROJECT, tensorboard:FOLDER or mlflow:EXPERIMENT; repeatable",
            multiple=True, metavar="TRACKER",
        ),
        option(
            "--log-videos", "send videos of N episodes, failures first",
            type=count, default=0, metavar="N",
        ),
    ]  # fmt: skip


# --- records, pages, leaderboard ---


def _export() -> list[click.Parameter]:
    return [
        _output("FILE", "file to write (RUN.proctor); with --to, a new directory"),
        flag("--force", "replace the file"),
        option(
            "--to",
            f"convert the record: {', '.join(EXPORTS)}",
            type=OneOf(EXPORTS), metavar="FORMAT",
        ),
    ]  # fmt: skip


def _video() -> list[click.Parameter]:
    return [
        _output("DIR", "directory of the videos (RUN-videos)"),
        flag("--force", "replace files that exist"),
    ]


def _simulation() -> list[click.Parameter]:
    return [
        option(
            "--episode", "this episode, by its index from 0 or its id; repeatable",
            type=episode_indices,
            multiple=True,
            metavar="N,…",
            callback=lambda _context, _option, given: [*chain(*given)] or None,
        ),
        flag("--failures", "every episode that failed"),
        option(
            "--camera", "this camera; repeatable (default: all)",
            multiple=True, metavar="NAME",
        ),
        option(
            "--size", "pixels of a picture (default: as the policy saw it)",
            type=values.size, metavar="WxH",
        ),
        option(
            "--benchmarks", "your own benchmarks, as for the server",
            default="", metavar="REF,…",
        ),
        option(
            "--seeds", "seeds of sealed splits that the host has opened",
            default="", metavar="FILE",
        ),
        flag("--anyway", "keep episodes whose replay comes to another result, too"),
    ]  # fmt: skip


def _report() -> list[click.Parameter]:
    return [
        _runs("RUN|FILE…", "ids of runs, or their records"),
        _output("DIR", "folder to write", required=True),
        flag("--force", "write into a folder that has files"),
        option(
            "--videos",
            "folder of `proctor video`: shown beside their episodes; repeatable",
            metavar="DIR", multiple=True,
        ),
        _key(),
    ]  # fmt: skip


def _board() -> list[click.Parameter]:
    return [
        argument(
            "benchmark", "id of the benchmark, or verify",
            metavar="BENCHMARK|verify", shell_complete=_benchmarks,
        ),
        option(
            "--manifest", "of runs with options or of a part",
            type=values.sha256, metavar="SHA256",
        ),
        flag("--csv", "print comma-separated values"),
        option("--state", "verify: where the last checkpoint is kept", metavar="FILE"),
        option(
            "--record", "verify: whether its seeds were drawn after its policy was "
            "committed to", metavar="FILE",
        ),
    ]  # fmt: skip


def _publish() -> list[click.Parameter]:
    return [
        option("--name", "of the model (the name of the policy)"),
        option("--type", "of the model, such as VLA"),
        option("--organisation", "who made it", metavar="NAME"),
        option("--homepage", "page about the model", metavar="URL"),
        option("--code-url", "where its code is", metavar="URL"),
        option("--notes", "what readers should know", metavar="TEXT"),
        flag("--private", "only this account sees it, without rank"),
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
