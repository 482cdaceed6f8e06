"""A small record with a success, a failure, a fault and an abandoned episode.

Every byte follows from constants, so that vectors can be written again.
"""

import hashlib
import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import msgspec

from reference_record.contents.replay_verdict import (
    ReplaySummary,
    replay_of,
    write_verdict,
)
from reference_record.contents.score import compute_score
from reference_record.contents.statement import (
    BenchmarkFacts,
    EpisodeLine,
    Evaluation,
    PolicyFacts,
    RecordingFacts,
    RunFacts,
)
from reference_record.formats.archive import Content
from reference_record.formats.bundle import Bundle, open_bundle
from reference_record.formats.names import recording_name
from reference_record.formats.strict_json import canonical_json
from reference_record.generated.answers import Outcome
from reference_record.keys import SigningKey
from reference_record.recordings.recording import (
    AttemptEvent,
    EpisodeResult,
    Fault,
    Message,
    Turn,
)
from reference_record.recordings.recording_file import join_parts
from reference_record.recordings.recording_parts import PartWriter
from reference_record.texts.timestamps import timestamp
from reference_record.unsigned_record import Record, host_of, read_files

HOST_KEY = SigningKey(bytes(range(32)))
OTHER_KEY = SigningKey(bytes(range(1, 33)))
START_NS = 1_800_000_000_000_000_000
ENGINE = {"packages": {"mujoco": "4.0.0"}, "python": "3.11", "os": "Linux", "cpu": "x"}
TASKS = ("lift", "lift", "stack", "stack")
_PART = {"start": 0, "size": 2, "quantity": "joint_position", "unit": "rad"}
_PART |= {"frame": "joint", "rotation": "none", "relative_to": "none"}
_ARM = {"size": 2, "out_of_range": "unbounded", "parts": {"all": _PART}}
MANIFEST: dict[str, Any] = {
    "benchmark_id": "sample",
    "version": "1",
    "simulator": {"name": "sample", "version": "1"},
    "tasks": ["lift", "stack"],
    "splits": ["val"],
    "control_rate_hz": 10,
    "max_steps": 10,
    "max_attempts": 3,
    "max_faults": 3,
    "success_rule": "any_step",
    "action_space": {"arm": _ARM},
    "observation_space": {"state": {"arm": _ARM}, "images": {}, "tensors": {}},
}
Messages = Sequence[tuple[str, Message]]


def at(second: int) -> str:
    return timestamp(START_NS / 10**9 + second)


def started(attempt: int, index: int) -> tuple[str, Message]:
    digest = f"{index:030x}00"
    return "/attempt", AttemptEvent(attempt, "started", at(0), state_digest=digest)


def turn(
    attempt: int, seq: int, index: int, *, score: float, ended: bool = False
) -> tuple[str, Message]:
    return "/turn", Turn(
        attempt=attempt,
        seq=seq,
        actions=[{"arm": [0.25 * seq, -1.0]}, {"arm": [0.5, 0.125 * index]}],
        rewards=[0.0, score],
        steps=2,
        score=score,
        success=score == 1,
        ended=ended,
        state_digest=f"{index:030x}{attempt:x}{seq:x}",
        simulate_ms=1.5,
        think_ms=20.0,
        at=at(seq),
    )


def ended(attempt: int, reason: str) -> tuple[str, Message]:
    return "/attempt", AttemptEvent(attempt, "ended", at(9), reason=reason)


def result(
    outcome: Outcome, score: float, steps: int, attempts: int
) -> tuple[str, Message]:
    success = outcome == "success"
    return "/result", EpisodeResult(outcome, success, score, steps, attempts, at(9))


def success(index: int) -> Messages:
    return [
        started(1, index),
        turn(1, 1, index, score=0.5),
        turn(1, 2, index, score=1.0, ended=True),
        ended(1, "scored"),
        result("success", 1.0, 4, 1),
    ]


def failure(index: int) -> Messages:
    return [
        started(1, index),
        turn(1, 1, index, score=0.25, ended=True),
        ended(1, "scored"),
        result("failure", 0.25, 2, 1),
    ]


def success_behind_a_fault(index: int) -> Messages:
    fault = Fault(1, 2, "simulator_fault", "it broke", at(2))
    begun = [started(1, index), turn(1, 1, index, score=0.5)]
    return [*begun, ("/fault", fault), *success(index)]


def abandoned(index: int) -> Messages:
    return [
        started(1, index),
        turn(1, 1, index, score=0.5),
        ended(1, "lease_ended"),
        started(2, index),
        ended(2, "detached"),
        result("abandoned", 0.0, 0, 2),
    ]


@dataclass
class Sample:
    """The parts of a record; a test changes one of them before it is signed."""

    episodes: list[Messages] = field(
        default_factory=lambda: [
            make(index)
            for index, make in enumerate(
                (success, failure, success_behind_a_fault, abandoned)
            )
        ]
    )
    manifest: bytes = b""
    manifest_sha256: str | None = None
    change_lines: Callable[[list[EpisodeLine]], Iterable[EpisodeLine]] = list
    change_recording: Callable[[int, bytes], bytes] = lambda _, data: data
    change_score: Mapping[str, Any] = field(default_factory=dict)
    key: SigningKey = HOST_KEY

    def __post_init__(self) -> None:
        tasks = [TASKS[index % len(TASKS)] for index in range(len(self.episodes))]
        plan = [
            {"task": task, "split": "val", "seed": 7 + index}
            for index, task in enumerate(tasks)
        ]
        self.manifest = self.manifest or canonical_json(MANIFEST | {"episodes": plan})

    def record(self, folder: Path) -> Record:
        """Signed; its recordings are files in `folder`."""
        return self.sign(self.play(folder), folder)

    def play(self, folder: Path) -> list[EpisodeLine]:
        """Write the recordings to files in `folder`."""
        lines = [
            self._line(index, messages, folder / f"{index:05}.mcap")
            for index, messages in enumerate(self.episodes)
        ]
        return list(self.change_lines(lines))

    def sign(self, lines: list[EpisodeLine], folder: Path) -> Record:
        paths = {
            recording_name(index): folder / f"{index:05}.mcap"
            for index in range(len(self.episodes))
        }
        files = read_files(manifest=self.manifest, lines=lines, recordings=paths)
        return files.sign(self._evaluation(lines), self.key)

    def _line(self, index: int, messages: Messages, path: Path) -> EpisodeLine:
        parts = path.with_suffix("")
        writer = PartWriter(parts)
        for number, (topic, message) in enumerate(messages):
            writer.write(topic, message, START_NS + number)
        writer.close()
        # As the vectors were written at first.
        summary = join_parts(parts, path, [], level=3)
        path.write_bytes(self.change_recording(index, path.read_bytes()))
        said = next(m for _, m in messages if isinstance(m, EpisodeResult))
        assert summary.first_digest is not None
        assert summary.last_digest is not None
        facts = RecordingFacts(
            recording_name(index),
            hashlib.sha256(path.read_bytes()).hexdigest(),
            path.stat().st_size,
            summary.first_digest,
            summary.last_digest,
        )
        return EpisodeLine(
            f"e-{index}",
            index,
            TASKS[index % len(TASKS)],
            "val",
            msgspec.convert(said.outcome, Outcome),
            said.success,
            said.score,
            said.steps,
            said.attempts,
            msgspec.to_builtins(summary.latency),
            facts,
        )

    def _evaluation(self, lines: list[EpisodeLine]) -> Evaluation:
        digest = hashlib.sha256(self.manifest).hexdigest()
        sha256 = self.manifest_sha256 or digest
        run = RunFacts("r-1", "pull")
        score: dict[str, Any] = {**compute_score([line.scored for line in lines])}
        score |= {"run_id": run.run_id, "benchmark_id": "sample"}
        score |= {"manifest_sha256": sha256, "state": "completed", **self.change_score}
        return Evaluation(
            run=run,
            benchmark=BenchmarkFacts("sample", "1"),
            manifest_sha256=sha256,
            policy=PolicyFacts("a policy", "2"),
            score=score,
            engine=ENGINE,
            protocol_version="1.0.0",
            host=host_of("example host", self.key),
            started_at=at(0),
            finished_at=at(60),
            attempts_by_submitter=1,
            previous_statement_sha256=None,
            promise="exact",
        )


def make_archive(sample: Sample | None = None) -> bytes:
    """The bytes of the sample's record."""
    with tempfile.TemporaryDirectory() as folder:
        return b"".join((sample or Sample()).record(Path(folder)).stream())


def contents_of(archive: bytes) -> dict[str, bytes]:
    """Name → content of each file of a good archive, in order."""
    with tempfile.TemporaryDirectory() as folder:
        bundle = open_archive(archive, Path(folder))
        return {name: bundle.read(name) for name in bundle.sizes}


def open_archive(archive: bytes, folder: Path) -> Bundle:
    path = folder / "run.proctor"
    path.write_bytes(archive)
    return open_bundle(path)


def content_of(data: bytes, crc32: int) -> Content:
    return Content(len(data), crc32, lambda: [data])


def good_replay() -> ReplaySummary:
    return replay_of(dict.fromkeys(range(4), ("exact", None)), ENGINE)


def make_verdict(
    archive: bytes,
    replay: ReplaySummary | None = None,
    *,
    statement_sha256: str | None = None,
    key: SigningKey = OTHER_KEY,
) -> bytes:
    statement = contents_of(archive)["statement.dsse.json"]
    return write_verdict(
        replay or good_replay(),
        statement_sha256=statement_sha256 or hashlib.sha256(statement).hexdigest(),
        name="another lab",
        at=at(3600),
        key=key,
    )
