"""`proctor replay FILE`: simulates the recorded actions again on this machine.

Says for the record whether every state digest was the same (exact), the results alone
(outcome), or where it diverged, and puts a signed verdict into the record. Exit codes:
0 exact or outcome; 1 diverged, or the record is broken; 2 it cannot be replayed here.
"""

from __future__ import annotations

import json
import platform
import re
import sys
import time
from pathlib import Path

import msgspec

from reference_record.broken import BrokenRecord, UnusableRecord
from reference_record.command_line.click_commands import (
    Command,
    Options,
    WrongUsage,
    argument,
    episode_indices,
    flag,
    option,
    parse_options,
)
from reference_record.command_line.closed_output import run_program
from reference_record.command_line.replaced_file import check_writable
from reference_record.command_line.written_output import writing
from reference_record.contents.replay_verdict import ReplaySummary, write_verdict
from reference_record.contents.statement import Evaluation
from reference_record.formats.bundle import open_bundle
from reference_record.formats.names import MANIFEST, STATEMENT
from reference_record.formats.opened_seeds import load_opened_seeds
from reference_record.keys import SigningKey, load_or_make, own_key_file
from reference_record.texts.counted_text import counted
from reference_record.texts.timestamps import timestamp
from reference_record.this_machine import usable_processors
from reference_record.unsigned_record import add_verdict
from reference_record.verification import Report, verify
from reference_sim.gymnasium import BadBenchmark
from reference_sim.replay import host_benchmarks
from reference_sim.replay.episode_replay import EpisodeReplay
from reference_sim.replay.foreign_manifest import read_choice
from reference_sim.replay.record_replay import (
    ReplayedBenchmark,
    add_drawn_seeds,
    left_out_texts,
    replay_record,
    resolve,
    resolve_choice,
)

SAME, DIVERGED, IMPOSSIBLE = 0, 1, 2
REPORT_EVERY_S = 10.0
_KEY = re.compile("[0-9a-f]{64}")


def main(arguments: list[str] | None = None) -> int:
    try:
        args = parse_options(build_command(), arguments)
    except WrongUsage as error:
        _say(str(error))
        return IMPOSSIBLE
    try:
        return _replay(args)
    except BrokenRecord as broken:
        _say(f"{args.file}: do not trust it: {broken}")
        return DIVERGED
    except (UnusableRecord, BadBenchmark, WrongUsage) as error:
        _say(str(error))
    except OSError as error:
        _say(": ".join(filter(None, (error.filename, error.strerror or str(error)))))
    return IMPOSSIBLE


def build_command() -> Command:
    """The command line of the program."""
    parameters = [
        argument("file", "the record, or its directory"),
        option(
            "--episodes", "only these (default: all)",
            type=episode_indices, metavar="I,J,…",
        ),
        option(
            "--processes",
            "how many simulate at once (default: one for each processor that it may "
            "use)",
            type=int, default=usable_processors(), metavar="N",
        ),
        option(
            "--benchmarks", "your own benchmarks, as for the server",
            default="", metavar="REF,…",
        ),
        option(
            "--seeds", "of sealed splits, opened by the host: a file, or the key of a "
            "draw", metavar="FILE|KEY",
        ),
        option(
            "--name", "who replays (host name)", default=platform.node() or "unnamed",
        ),
        option(
            "--signing-key",
            "key that signs the verdict, made if it does not exist "
            "(~/.config/proctor/signing-key)", type=Path, metavar="FILE",
        ),
        flag("--no-verdict", "leave the record as it is"),
        flag("--json", "print one JSON value"),
    ]  # fmt: skip
    return Command("proctor replay", "", parameters, help_text=__doc__)


def _replay(args: Options) -> int:
    bundle = open_bundle(Path(args.file))
    report = verify(bundle)
    # Before hours of simulation: the end needs the key, and the record to be written.
    key = None if args.no_verdict else _prepare_verdict(args)
    name = report.evaluation.benchmark.benchmark_id
    host_benchmarks.add(name, args.benchmarks, _say)
    benchmark = _resolved(report.evaluation, bundle.read(MANIFEST), args.seeds)
    replay = replay_record(
        Path(args.file),
        benchmark,
        only=args.episodes,
        processes=max(args.processes, 1),
        report=_Progress(report.episodes),
    )
    for text in left_out_texts(Path(args.file), benchmark, args.episodes or ()):
        _say(text)
    if args.json:
        sealed = {"sealed_episodes": report.sealed, "secret_seeds": benchmark.secret}
        said = msgspec.to_builtins(replay) | sealed
        sys.stdout.write(json.dumps(said, indent=2) + "\n")
    else:
        _print(replay, report, _name_seeds(args, report, benchmark))
    if key is not None:
        _add_verdict(args, report, replay, key)
    return DIVERGED if replay.result == "diverged" else SAME


def _resolved(
    evaluation: Evaluation, manifest: bytes, seeds: str | None
) -> ReplayedBenchmark:
    """seeds: a file, or the key of a draw."""
    if seeds is None or not _KEY.fullmatch(seeds):
        opened = load_opened_seeds(Path(seeds)) if seeds else None
        return resolve(evaluation, manifest, opened)
    choice = read_choice(evaluation, manifest)
    return add_drawn_seeds(resolve_choice(choice), choice, bytes.fromhex(seeds))


def _prepare_verdict(args: Options) -> SigningKey:
    """The key of the verdict, once its file and the record were found to be writable.

    Raises WrongUsage, which names the flag that chooses another way.
    """
    record = Path(args.file)
    with writing(record, "--no-verdict", "leaves the record as it is"):
        check_writable(record / STATEMENT if record.is_dir() else record)
    try:
        path = args.signing_key or own_key_file()
    except RuntimeError as error:
        raise WrongUsage(f"{error}, --signing-key a file") from error
    way_out = "names another file, and --no-verdict signs nothing"
    with writing(path, "--signing-key", way_out):
        return load_or_make(path)


def _add_verdict(
    args: Options, report: Report, replay: ReplaySummary, key: SigningKey
) -> None:
    verdict = write_verdict(
        replay,
        statement_sha256=report.statement_sha256,
        name=args.name,
        at=timestamp(time.time()),
        key=key,
    )
    path = Path(args.file)
    with writing(path, "--no-verdict", "leaves the record as it is"):
        add_verdict(open_bundle(path), path, key.keyid[7:23], verdict)
    _say(f"signed by {key.keyid}: give it to those who shall trust this verdict")


class _Progress:
    """Says what diverged at once, and how far it is every REPORT_EVERY_S seconds."""

    def __init__(self, total: int) -> None:
        self._total = total
        self._done = 0
        self._said_at = time.monotonic()

    def __call__(self, index: int, replay: EpisodeReplay) -> None:
        self._done += 1
        if replay.result == "diverged":
            step = replay.where.step if replay.where else 0
            _say(
                f"episode {index} diverged at step {step} {replay.error or ''}".rstrip()
            )
        if time.monotonic() - self._said_at > REPORT_EVERY_S:
            self._said_at = time.monotonic()
            _say(f"{self._done} of {counted(self._total, 'episode')}")


def _name_seeds(
    args: Options, report: Report, benchmark: ReplayedBenchmark
) -> str | None:
    """A sentence on the treatment of episodes of sealed splits, if there are any."""
    if not (args.seeds or benchmark.secret or benchmark.secret_file):
        return None
    whole = counted(report.episodes, "episode is", "episodes are")
    count = f"{report.sealed} of {whole} of sealed splits: "
    if benchmark.secret:
        return f"{count}left out, for their seeds are the secret of the host (--seeds)"
    if benchmark.secret_file is not None:
        return f"{count}their seeds are drawn with {benchmark.secret_file}"
    origin = "the key of their draw" if _KEY.fullmatch(args.seeds) else args.seeds
    return f"{count}their seeds are those opened in {origin}"


def _print(replay: ReplaySummary, report: Report, seeds: str | None) -> None:
    packages = ", ".join(f"{k} {v}" for k, v in replay.engine["packages"].items())
    counts = f"{replay.exact} of {counted(replay.episodes, 'episode')} exact, "
    counts += f"{replay.outcome} with the same outcome, {replay.diverged} diverged"
    lines = [
        f"{replay.result}: {counts}",
        f"promised on the same engine: {report.evaluation.promise}; here: {packages}",
        "A replay does not show whether the actions came from the policy.",
    ]
    if seeds is not None:
        lines.insert(1, seeds)
    if where := replay.first_divergence:
        lines.insert(
            1,
            f"diverged first at episode {where.episode_index}, attempt {where.attempt},"
            f" step {where.step}",
        )
    sys.stdout.write("\n".join(lines) + "\n")


def _say(line: str) -> None:
    """Print to stderr, without the control characters that a record may have."""
    shown = "".join(c if c.isprintable() else "?" for c in line)
    sys.stderr.write(f"proctor replay: {shown}\n")


if __name__ == "__main__":
    sys.exit(run_program(main))
