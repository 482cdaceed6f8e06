"""The HTTP handlers of the profile `ebench`: what EBench's public client calls.

A task of EBench is a run, a worker's connection is a session, and a step is a predict.
EBench's requests have neither a session nor a count of turns: both are read from the
run. Each handler translates a request into calls of `runs/service.py` and the result
back; whether something is allowed is decided there and in the rules. See
spec/profiles/ebench.yaml and docs/evaluate/ebench.md.
"""

from __future__ import annotations

import asyncio
import secrets
from collections.abc import Awaitable, Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any, TypeAlias

from starlette.responses import HTMLResponse, Response

from reference_server.generated import models
from reference_server.http import codec
from reference_server.http.dispatch import Operation, OperationCall
from reference_server.http.handlers import Handlers
from reference_server.profiles.ebench import (
    message_conversion,
    pickle_reader,
    pickle_writer,
)
from reference_server.profiles.ebench.lost_answers import LostAnswers
from reference_server.profiles.ebench.task_requests import (
    Chunk,
    CreateTask,
    Ready,
    Workers,
    read_chunks,
    read_worker_ids,
    schema_error,
)
from reference_server.profiles.ebench.task_responses import (
    PICKLE,
    ConfirmedResponse,
    envelope,
    refusal_response,
    results_of,
    status_of,
    worker_view,
)
from reference_server.rules.lifecycle import Attach, Detach, Predict
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Run, Session
from reference_server.runs.service import RunService

CONTROL = "/api/v1/benchmark/onlineEvaluation"
RUN_PATH = "/eval-server/{run_id}"
ENDPOINT = f"{RUN_PATH}/api/predict/{{benchmark_id}}"
# Benchmark set of EBench → benchmark_id; a benchmark_id is accepted as well (EBE-001).
BENCHMARK_SETS = {
    "ebench_generalist": "mobile_bimanual",
    "ebench_mobile_manip": "mobile_bimanual_mobile_manip",
    "ebench_table_top_manip": "mobile_bimanual_table_top_manip",
}
# Of the only page that a browser shows: it loads nothing and is taken for nothing else.
PAGE_HEADERS = {
    "Content-Security-Policy": "default-src 'none'; frame-ancestors 'none'",
    "X-Content-Type-Options": "nosniff",
}
PICKLE_INLINE_BYTES = 2**13  # larger ones are read in a thread

Turn: TypeAlias = Mapping[str, Any]
Work: TypeAlias = Callable[[], Awaitable[Turn]]


@dataclass(frozen=True, slots=True)
class _Step:
    """A worker's part of a step. command: the predict that `work` makes, if any."""

    work: Work
    command: Predict | None = None


@dataclass(frozen=True, slots=True)
class EbenchHandlers:
    """The operations of EBench over the use cases of this server."""

    handlers: Handlers
    lost_answers: LostAnswers = field(default_factory=LostAnswers)

    @property
    def service(self) -> RunService:
        return self.handlers.service

    def table(self) -> dict[str, dict[str, Operation]]:
        """path → method → operation."""
        binary = partial(Operation, scope="run", writes=(PICKLE,), headers=("run_id",))
        plain = partial(Operation, headers=("run_id",))
        requested = partial(Operation, refusal_response=refusal_response)
        stop = requested(self.stop, "run", query=("run_id", "user_id"))
        workers = partial(plain, scope="run", body=Workers)
        return {
            f"{CONTROL}/createTask": {
                "POST": requested(self.create_task, "run", CreateTask)
            },
            f"{CONTROL}/ready": {"POST": requested(self.ready, body=Ready)},
            f"{ENDPOINT}/docs": {"GET": plain(self.docs, writes=("text/html",))},
            f"{ENDPOINT}/status": {"GET": plain(self.status, query=("run_id",))},
            f"{ENDPOINT}/create_workers": {"POST": workers(self.create_workers)},
            f"{ENDPOINT}/reset": {"POST": binary(self.reset)},
            f"{ENDPOINT}/step": {"POST": binary(self.step)},
            f"{ENDPOINT}/step_chunk": {
                "POST": binary(self.step_chunk, query=("render_mode", "subframes"))
            },
            f"{ENDPOINT}/kill": {"POST": workers(self.kill)},
            f"{ENDPOINT}/stop": {"POST": stop},
            f"{RUN_PATH}/stop": {"POST": stop},  # EBE-018: both paths
        }

    # --- control plane ---

    async def create_task(self, call: OperationCall) -> Response:
        """A new run (EBE-001); with a `task_id`, that run resumed (EBE-004)."""
        requested: CreateTask = call.body
        if requested.task_id:
            run = await self.service.resume_run(call.account, requested.task_id)
            return envelope({"task_id": run.run_id})
        wanted = requested.benchmark_set or "ebench_generalist"
        submission = {
            "benchmark_id": BENCHMARK_SETS.get(wanted, wanted),
            "policy": requested.policy(),
        }
        checked = codec.validate(models.SubmitRun, submission).model_dump()
        run = await self.service.submit_run(call.account, checked)
        return envelope({"task_id": run.run_id})

    async def ready(self, call: OperationCall) -> Response:
        """EBE-003: false while queued; a completed task is ready to answer "done"."""
        run, available = await self.service.get_availability(
            call.account, call.body.task_id
        )
        if available == "closed":
            raise Refused(
                "illegal_transition",
                f"The task is {run.state} ({run.reason or 'no reason is known'}); "
                "call createTask with its task_id to resume it.",
            )
        is_open = available != "waiting"
        path = ENDPOINT.format(
            run_id=run.run_id, benchmark_id=run.manifest["benchmark_id"]
        )
        endpoint = self.handlers.base_url(call) + path if is_open else ""
        return envelope({"ready": is_open, "endpoint": endpoint})

    async def stop(self, call: OperationCall) -> Response:
        run = await self.service.stop_run(call.account, _run_id(call))
        return envelope({"run_id": run.run_id})

    # --- data plane ---

    async def docs(self, call: OperationCall) -> Response:
        """EBE-005: EBench's client calls it to see whether the endpoint answers."""
        run = await self._run(call)
        return HTMLResponse(
            f"<p>EBench API of run {run.run_id}.</p>", headers=PAGE_HEADERS
        )

    async def status(self, call: OperationCall) -> Response:
        run = await self._run(call)
        return call.answer(
            {"data": await self.service.registry.render_when_stored(run, status_of)}
        )

    async def create_workers(self, call: OperationCall) -> Response:
        run = await self._run(call)
        ids = read_worker_ids(call.body.data.worker_ids, run)
        new = [i for i in ids if i not in run.workers]
        await _gather({i: partial(self._open, run, i) for i in new})
        return call.answer({"data": {"success": True}})

    async def kill(self, call: OperationCall) -> Response:
        """EBE-016: ends the session of each worker that has one."""
        run = await self._run(call)
        for worker_id in read_worker_ids(call.body.data.worker_ids, run):
            session = run.workers.get(worker_id)
            if session is not None:
                command = Detach(worker_id, session.session_id)
                await self.service.detach_worker(call.account, run.run_id, command)
        return call.answer({"data": {"success": True}})

    async def reset(self, call: OperationCall) -> Response:
        """EBE-006, EBE-007: each worker's observation; live sessions are taken over."""
        run = await self._run(call)
        requested = await self._pickle(call)
        if not isinstance(requested, dict) or not isinstance(
            requested.get("worker_ids"), list
        ):
            raise schema_error("/worker_ids", "is a list of worker ids")
        ids = read_worker_ids(requested["worker_ids"], run)
        turns = await _gather(
            {i: partial(self._open, run, i, takeover=True) for i in ids}
        )
        body = pickle_writer.write(await self._worker_views(run, turns))
        return Response(body, media_type=PICKLE)

    async def step(self, call: OperationCall) -> Response:
        """EBE-008: one turn of each worker."""
        run, turns = await self._step_all(call)
        return ConfirmedResponse(
            await self._worker_views(run, turns), call, self._on_delivered(run, turns)
        )

    async def step_chunk(self, call: OperationCall) -> Response:
        """EBE-023: `step` with a list, and how much of it was executed."""
        run, turns = await self._step_all(call)
        body = {
            "obs": await self._worker_views(run, turns),
            "executed_steps": max(t.get("executed_steps", 0) for t in turns.values()),
            "stopped_early": any(map(_is_stopped_early, turns.values())),
        }
        return ConfirmedResponse(body, call, self._on_delivered(run, turns))

    async def _step_all(self, call: OperationCall) -> tuple[Run, dict[str, Turn]]:
        """One turn of each worker: all are checked before any is executed (EBE-012)."""
        run = await self._run(call)
        body = await self._pickle(call)
        run = await self._run(call)  # leases may have ended while the body came
        chunks = read_chunks(body, run)
        steps = {i: self._prepare_step(run, i, chunk) for i, chunk in chunks.items()}
        commands = [s.command for s in steps.values() if s.command is not None]
        found = await self.service.find_refused(call.account, run.run_id, commands)
        if found is not None:
            command, verdict = found
            raise chunks[command.worker_id].translate_refusal(verdict)
        return run, await _gather({i: step.work for i, step in steps.items()})

    # --- what a worker does ---

    def _prepare_step(self, run: Run, worker_id: str, chunk: Chunk) -> _Step:
        """What a step means for one worker; nothing is executed yet."""
        session = run.workers.get(worker_id)
        if session is None:  # EBE-017: the actions were chosen in an ended session
            return _Step(partial(self._open, run, worker_id))
        if not session.done:  # EBE-010: else the actions are not executed, nor checked
            message_conversion.check_length(chunk.actions, run.manifest, chunk.at)
        digest = chunk.digest()
        command = self.lost_answers.find_repeated_turn(session, digest)
        if command is None and session.done and not session.busy:  # EBE-010
            return _Step(partial(self._last_turn, session))
        if command is None:
            made = message_conversion.read_actions(
                chunk.actions, run.manifest, partial(_last_command, session), chunk.at
            )
            command = Predict(worker_id, session.session_id, session.seq + 1, made)
        return _Step(partial(self._play, run, session, command, digest), command)

    async def _play(
        self, run: Run, session: Session, command: Predict, digest: str
    ) -> Turn:
        """EBE-022: the predict of every client, so that it is scored like any other."""
        self.lost_answers.await_confirmation(session, command, digest)
        return await self.service.predict(run.account, run.run_id, command)

    async def _open(self, run: Run, worker_id: str, takeover: bool = False) -> Turn:
        command = Attach(worker_id, secrets.token_hex(16), takeover)
        try:
            return await self.service.attach_worker(run.account, run.run_id, command)
        except Refused as refused:
            if refused.members.get("state") != "completed":
                raise
            return {"done": True}  # EBE-010: no episode is left

    async def _last_turn(self, session: Session) -> Turn:
        assert session.turn is not None, "a session that is not busy has its turn"
        return session.turn

    # --- from requests and to answers ---

    async def _run(self, call: OperationCall) -> Run:
        """The run of the endpoint, if it is the account's (EBE-021)."""
        run = await self.service.get_run(call.account, _run_id(call))
        if run.manifest["benchmark_id"] != call.path["benchmark_id"]:
            raise Refused("not_found", "The run does not belong to this endpoint.")
        return run

    async def _pickle(self, call: OperationCall) -> Any:
        """The value in the pickle of the body (EBE-015)."""
        codec.media_type_of(call.request, (PICKLE,))
        limit = self.handlers.settings.max_body_bytes
        body = await codec.read_body(call.request, limit)
        try:
            if len(body) <= PICKLE_INLINE_BYTES:
                return pickle_reader.read(body)
            return await asyncio.to_thread(pickle_reader.read, body)
        except pickle_reader.BadPickle as error:
            raise Refused("malformed_body", f"The pickle: {error}.") from error

    async def _worker_views(
        self, run: Run, turns: Mapping[str, Turn]
    ) -> dict[str, Any]:
        results: dict[str, float] = {}
        if any(turn["done"] for turn in turns.values()):
            results = await self.service.registry.render_when_stored(run, results_of)
        return {
            worker: worker_view(run, turn, results) for worker, turn in turns.items()
        }

    def _on_delivered(self, run: Run, turns: Mapping[str, Turn]) -> Callable[[], None]:
        """What to do once the answer was sent to a connected client (EBE-014)."""
        sessions = [
            (run.workers.get(i), turn.get("seq", 0)) for i, turn in turns.items()
        ]

        def on_delivered() -> None:
            for session, seq in sessions:
                if session is not None:
                    self.lost_answers.confirm_delivery(session, seq)

        return on_delivered


def _run_id(call: OperationCall) -> str:
    """That of the path; header and query may repeat it, and not name another run."""
    run_id = call.path["run_id"]
    for named in (call.headers.get("run_id"), call.query.get("run_id")):
        if named is not None and named != run_id:
            raise Refused(
                "not_found", f"The run {named} does not belong to this endpoint."
            )
    return run_id


def _is_stopped_early(turn: Turn) -> bool:
    """Whether an episode ended, or the chunk was cut, before its last action."""
    return "episode_result" in turn or bool(turn["done"] or turn.get("stopped_early"))


async def _gather(works: Mapping[str, Work]) -> dict[str, Turn]:
    """Run all concurrently; the first error is raised when all have ended."""
    begun = (work() for work in works.values())
    ended = await asyncio.gather(*begun, return_exceptions=True)
    turns: dict[str, Turn] = {}
    for worker_id, turn in zip(works, ended, strict=True):
        if isinstance(turn, BaseException):
            raise turn
        turns[worker_id] = turn
    return turns


def _last_command(session: Session) -> Mapping[str, Sequence[float]]:
    """What relative actions are added to: the last command, or the initial state."""
    if session.request is not None and (session.steps or session.busy):
        return session.request[0][-1]
    if session.turn is None:
        raise Refused(
            "worker_busy", "The worker's first observation is not available yet."
        )
    state: Mapping[str, Sequence[float]] = session.turn["observation"]["state"]
    return state
