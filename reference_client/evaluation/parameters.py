"""The parameters of an evaluation, checked before anything is sent.

Used by `evaluate` and by the command. Values that the protocol would drop or refuse are
rejected here, before a run is created.
"""

from __future__ import annotations

import contextlib
import json
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

from proctor_client import (
    Assumptions,
    Benchmark,
    CalibrationOptions,
    EpisodeSelection,
    ImageChoice,
    Player,
    PolicyInfo,
    PolicyServer,
    Run,
    RunMode,
    Service,
    SubmitRun,
)
from pydantic import BaseModel, ValidationError
from pydantic_core import to_jsonable_python

from reference_client.api.assumed_conventions import check_assumptions
from reference_client.errors import ProctorError
from reference_client.evaluation.declared_policy import (
    DeclaredPolicy,
    check_offered,
    declare_player,
)
from reference_client.protocol.control_client import ControlClient
from reference_client.protocol.credentials import Credential
from reference_record.command_line.spelling import did_you_mean
from reference_record.generated import answers

# The pattern of the parameter WorkerId: a refusal would leave an unused run behind.
WORKER_ID = re.compile(r"[A-Za-z0-9_-]{1,64}")

Model = TypeVar("Model", Assumptions, CalibrationOptions, ImageChoice, PolicyServer)


@dataclass(frozen=True, slots=True)
class EvaluationPlan:
    """A run, new or existing, and the workers that play it.

    policy: what the workers play.
    submission: of a new run, or None for the run `run_id`, which must be of `benchmark`
        if that is given.
    worker_ids: one worker each.
    retry_timeout_s: how long an unreachable server is retried, seconds, also the
        first time; without it, 300, and 3 the first time.
    episodes: how many of the manifest's episodes are played, from its first.
    dry_turn: whether a policy is called once before a new run is created.
    check_benchmark: called with the benchmark before the run is created; raises if the
        policy does not fit it.
    """

    url: str
    credential: Credential
    worker_ids: tuple[str, ...]
    policy: DeclaredPolicy
    submission: SubmitRun | None = None
    run_id: str | None = None
    benchmark: str | None = None
    takeover: bool = False
    assumes: Assumptions | None = None
    retry_timeout_s: float | None = None
    check_benchmark: Callable[[Benchmark], None] | None = None
    episodes: int | None = None
    dry_turn: bool = True

    def __post_init__(self) -> None:
        if self.submission is None and self.run_id is None:
            raise ValueError(
                "give benchmark=... for a new run, or run_id=... to continue a run"
            )
        if not self.worker_ids:
            raise ValueError("workers must be at least 1")
        check_episodes(self.episodes)
        if len(set(self.worker_ids)) < len(self.worker_ids):
            raise ValueError("worker ids must differ")
        for worker_id in self.worker_ids:
            if not WORKER_ID.fullmatch(worker_id):
                raise ValueError(
                    f"{worker_id!r} is not a valid worker id "
                    "(1 to 64 of A-Z a-z 0-9 _ -)"
                )

    def open(
        self,
        control_client: ControlClient,
        service: Service,
        prepare: Callable[[], None],
        play_dry_turn: Callable[[answers.Benchmark], None],
    ) -> tuple[Run, answers.Benchmark | None, Player | None]:
        """Submit or resume the run; `prepare`, which loads the policies, comes before.

        So a policy that fails to load, or in the dry turn, leaves no run behind.
        Parameters that the server would refuse are refused before policies are loaded.
        Returns the run, its benchmark as JSON, if the server has it, and the player
        that the workers declare.
        """
        if self.run_id is None:
            assert self.submission is not None
            with _noting_interruption():
                described = self._check(control_client, service, self.submission)
                prepare()
                if self.dry_turn:
                    play_dry_turn(described)
            run = control_client.submit(self.submission)
            player = declare_player(self.policy, run, service, control_client)
            return run, described, player
        run = control_client.read(self.run_id)
        player = declare_player(self.policy, run, service, control_client)
        if self.benchmark not in (None, run.benchmark_id):
            raise ValueError(
                f"run {self.run_id} is of benchmark {run.benchmark_id!r}, "
                f"not {self.benchmark!r}"
            )
        of_run = _benchmark_of(control_client, run)
        if self.check_benchmark is not None and of_run is not None:
            self.check_benchmark(of_run)
        prepare()
        resumed = control_client.resume_if_needed(self.run_id)
        return resumed, None if of_run is None else _as_json(of_run), player

    def _check(
        self,
        control_client: ControlClient,
        service: Service,
        submission: SubmitRun,
    ) -> answers.Benchmark:
        """Refuse here what the server would refuse; returns the benchmark."""
        check_offered(submission, service)
        benchmark = control_client.check(submission.benchmark_id)
        if self.check_benchmark is not None:
            self.check_benchmark(benchmark)
        described = _as_json(benchmark)
        if self.assumes is not None:
            check_assumptions(self.assumes.to_dict(), described)
        return described

    def max_attempts(self, benchmark: answers.Benchmark | None) -> int | None:
        """The attempts that an episode may have; None where they cannot be known."""
        if benchmark is None:
            return None
        if benchmark["benchmark_id"] == "calibration":  # its submitter decides
            options = None if self.submission is None else self.submission.options
            return None if options is None else options.max_attempts
        return benchmark["max_attempts"]


@contextlib.contextmanager
def _noting_interruption() -> Iterator[None]:
    """An interruption of the block says that it left no run behind."""
    try:
        yield
    except KeyboardInterrupt as interruption:
        interruption.add_note("No run was submitted.")
        raise


def _benchmark_of(control_client: ControlClient, run: Run) -> Benchmark | None:
    """None if the server does not have it any more: a score can still be read."""
    try:
        return control_client.benchmark(run.benchmark_id)
    except ProctorError as error:
        if error.code != "not_found":
            raise
        return None


def _as_json(benchmark: Benchmark) -> answers.Benchmark:
    members: answers.Benchmark = to_jsonable_python(benchmark.to_dict())
    return members


def submission(
    benchmark: str,
    policy: PolicyInfo,
    *,
    images: Mapping[str, Any] | None = None,
    options: Mapping[str, Any] | None = None,
    idle_timeout_s: float | None = None,
    max_workers: int | None = None,
    policy_server: Mapping[str, Any] | None = None,
    any_policy: bool = False,
    tasks: Sequence[str] | None = None,
    splits: Sequence[str] | None = None,
) -> SubmitRun:
    """A new run, in mode `push` if `policy_server` is given; ValueError if invalid."""
    try:
        return SubmitRun(
            benchmark_id=benchmark,
            policy=policy,
            idle_timeout_s=idle_timeout_s,
            max_workers=max_workers,
            images=parse_strictly(ImageChoice, "images", images),
            options=parse_strictly(CalibrationOptions, "options", options),
            mode=None if policy_server is None else RunMode.PUSH,
            policy_server=parse_strictly(PolicyServer, "policy_server", policy_server),
            any_policy=any_policy or None,
            select=_selection(tasks, splits),
        )
    except ValidationError as error:
        raise ValueError(fault_texts(error)) from error


# The type of an argument, as a message names it, and whether a value is of it.
_TYPES: dict[str, Callable[[Any], bool]] = {
    "a whole number": lambda value: (
        hasattr(value, "__index__") and not isinstance(value, bool)
    ),
    "a text": lambda value: isinstance(value, str),
    "a list of names": lambda value: not isinstance(value, str),
}


def check_episodes(episodes: int | None) -> None:
    """Raises ValueError where it is not how many episodes may be played."""
    check_types("a whole number", episodes=episodes)
    if episodes is not None and episodes < 1:
        raise ValueError("episodes must be at least 1")


def check_types(kind: str, **arguments: Any) -> None:
    """Raises ValueError with the name of an argument that is not of this kind.

    None stands for an argument that was left out.
    """
    for name, value in arguments.items():
        if value is not None and not _TYPES[kind](value):
            raise ValueError(f"{name} must be {kind}, not {value!r:.60}")


def _selection(
    tasks: Sequence[str] | None, splits: Sequence[str] | None
) -> EpisodeSelection | None:
    """The part of the benchmark; None is all of it."""
    if tasks is None and splits is None:
        return None
    check_types("a list of names", tasks=tasks, splits=splits)
    return EpisodeSelection(
        tasks=None if tasks is None else [*tasks],
        splits=None if splits is None else [*splits],
    )


# Type of a fault → what to say in place of the library's sentence and pattern.
_FAULT_TEXTS = {
    "greater_than_equal": "must be at least {ge}",
    "less_than_equal": "must be at most {le}",
    "string_too_short": "must have at least {min_length} characters",
    "string_too_long": "must have at most {max_length} characters",
    "too_short": "must have at least {min_length} entries",
    "too_long": "must have at most {max_length} entries",
    "missing": "is missing",
    "finite_number": "must be finite",
}


def fault_texts(error: ValidationError) -> str:
    """A sentence on each member of a message that its schema refuses."""
    texts: dict[str, str] = {}
    for fault in error.errors(include_url=False):
        # A number may be of several types; each of them reports its faults.
        parts = [str(p) for p in fault["loc"] if not str(p).startswith("constrained-")]
        name = ".".join(parts)
        text = _FAULT_TEXTS.get(fault["type"])
        if text is None and "https?" in str(fault.get("ctx", {}).get("pattern")):
            text = "must begin with http:// or https:// and have no spaces"
        given = fault.get("input")
        if name == "benchmark_id":
            what = f"cannot be {given!r}: a name has lower-case letters, digits and _"
        elif text is not None:
            what = f"{text.format(**fault.get('ctx', {}))}, not {given!r:.60}"
        else:
            what = f"cannot be {given!r:.60}"
        texts.setdefault(name, what)
    return "; ".join(f"{name} {what}" for name, what in texts.items())


def parse_strictly(
    model: type[Model], name: str, members: Mapping[str, Any] | None
) -> Model | None:
    """The model with these members; ValueError for members that it would drop."""
    if members is None:
        return None
    given = json.loads(json.dumps(members))
    try:
        made = model.from_dict(given)
    except ValidationError as error:
        raise ValueError(f"{name}: {fault_texts(error)}") from error
    _refuse_unknown(name, made)
    if made.to_dict() != given:
        raise ValueError(
            f"{name} has members that the protocol does not define: {given}"
        )
    return made


def _refuse_unknown(name: str, message: BaseModel) -> None:
    """Raises ValueError for a member of no schema, at any depth."""
    fields = type(message).model_fields
    names = [field.alias or own for own, field in fields.items()]
    for member in message.model_extra or {}:
        meant = did_you_mean(member, names)
        raise ValueError(f"{name} has no member {member!r:.60}{meant}")
    for member in fields:
        value = getattr(message, member)
        if isinstance(value, BaseModel):
            _refuse_unknown(f"{name}.{member}", value)
        elif isinstance(value, dict):
            for key, item in value.items():
                if isinstance(item, BaseModel):
                    _refuse_unknown(f"{name}.{member}.{key}", item)
