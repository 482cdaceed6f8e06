"""The requests of EBench's client: their schemas, and what they name, checked.

Reads bodies that are decoded already; must not know sessions, turns or responses.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from pydantic import BaseModel, Field

from reference_record.generated.answers import RunPolicy
from reference_record.texts.pattern_words import in_words
from reference_server.http.dispatch import PATH_PATTERNS
from reference_server.profiles.ebench import pickle_writer
from reference_server.rules.manifest import Submission
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.lifecycle import Refuse
from reference_server.rules.runs.run import Run, RunHead

_HOMEPAGE = re.compile(r"https?://[!-~]{1,490}")  # as `submit_run` takes it
# Larger pickles and chunks are worked on in a thread.
INLINE_BYTES_MAX, INLINE_VALUES_MAX = 2**13, 2**12
STEPS_MAX = 4096  # of all workers; no setting allows a longer chunk


class CreateTask(BaseModel):
    """The body of createTask; empty members are absent, unknown ones are ignored."""

    task_id: str = ""
    model_name: str = ""
    model_type: str = ""
    benchmark_set: str = ""
    submitter_name: str = ""
    submitter_homepage: str = ""
    is_public: int = 0

    def policy(self) -> RunPolicy:
        """The policy as a submission names it."""
        name = self.model_name or "unnamed"
        policy: RunPolicy = {"name": name}
        if self.model_type:
            policy["name"] += f" ({self.model_type})"
        if self.submitter_name:
            policy["submitter"] = self.submitter_name
        if _HOMEPAGE.fullmatch(self.submitter_homepage):
            policy["homepage"] = self.submitter_homepage
        return policy

    def repeat_submission(self, old: RunHead) -> Submission:
        """The submission of the run `old` again, and its id in the policy (EBE-027)."""
        policy = self.policy() if self.model_name else old.submission["policy"]
        version = f"re-execution of {old.run_id}"
        return old.submission | {"policy": policy | {"version": version}}


class Ready(BaseModel):
    task_id: str


class WorkerIds(BaseModel):
    worker_ids: list[str | int] = Field(max_length=1024)


class Workers(BaseModel):
    """The body of create_workers and of kill."""

    data: WorkerIds


@dataclass(frozen=True, slots=True)
class Chunk:
    """A worker's actions as they were sent, and the JSON pointer to each.

    digest: of the actions, by which a repeated step is recognised (EBE-013). is_varied:
    whether it has several actions that are not all equal (EBE-029). is_large: whether
    it takes so long to convert that this is done beside the event loop.
    """

    actions: Sequence[Any]
    at: Sequence[str]
    digest: str
    is_varied: bool
    is_large: bool

    @classmethod
    def of(cls, actions: Sequence[Any], at: Sequence[str]) -> Chunk:
        written = [pickle_writer.write(_plain(action)) for action in actions]
        digest = hashlib.sha256()
        for text in written:  # a pickle says where it ends
            digest.update(text)
        is_large = sum(map(len, written)) > INLINE_BYTES_MAX
        return cls(
            actions, at, digest.hexdigest(), len(set(written)) > 1, is_large=is_large
        )

    def translate_refusal(self, verdict: Refuse) -> Refused:
        """The refusal of the converted actions, with pointers into the request."""
        refused = Refused.from_verdict(verdict)
        refused.errors = tuple(self._error(*error) for error in refused.errors)
        return refused

    def _error(self, pointer: str, detail: str) -> tuple[str, str]:
        match = re.fullmatch(r"/actions/(\d+)/values/(.*)", pointer)
        if match is None:
            return self.at[0], detail
        return f"{self.at[int(match[1])]}/action", f"{match[2]}: {detail}"


def _plain(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return [value.dtype.str, *value.shape, value.tobytes().hex()]
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_plain(item) for item in value]
    return value


def read_chunks(body: Any, run: Run) -> dict[str, Chunk]:
    """EBE-008: each worker's actions in order, from one step or a list of steps.

    For a large body it takes a second, and so it is called in a thread.
    """
    steps = body if isinstance(body, list) else [body]
    if len(steps) > STEPS_MAX:
        raise schema_error("", f"must have at most {STEPS_MAX} steps")
    actions: dict[str, list[Any]] = {}
    at: dict[str, list[str]] = {}
    for number, step in enumerate(steps):
        place = f"/{number}" if isinstance(body, list) else ""
        if not isinstance(step, dict):
            raise schema_error(place, "must be a dict from worker ids to actions")
        ids = read_worker_ids(list(step), run)
        for worker_id, action in zip(ids, step.values(), strict=True):
            actions.setdefault(worker_id, []).append(action)
            at.setdefault(worker_id, []).append(f"{place}/{worker_id}")
    if not actions:
        raise schema_error("", "must name at least one worker")
    return {i: Chunk.of(chunk, at[i]) for i, chunk in actions.items()}


def read_worker_ids(named: Sequence[Any], run: Run) -> list[str]:
    ids = [str(name) if type(name) in (str, int) else "" for name in named]
    pattern, _ = PATH_PATTERNS["worker_id"]
    are_valid = all(re.fullmatch(pattern, worker_id) for worker_id in ids)
    if not are_valid or len(set(ids)) < len(ids):
        raise schema_error(
            "/worker_ids", f"each {in_words(pattern)}, and must be unique"
        )
    if len(ids) > run.max_workers:
        raise schema_error("/worker_ids", f"must be at most {run.max_workers}")
    return ids


def schema_error(at: str, text: str) -> Refused:
    return Refused(
        "invalid_request", "The body does not match its schema.", errors=[(at, text)]
    )
