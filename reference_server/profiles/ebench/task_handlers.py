"""The HTTP handlers of the profile `ebench`: what EBench's public client calls.

A task of EBench is a run, a worker's connection is a session, and a step is a predict.
EBench's requests have neither a session nor a count of turns: both are read from the
run. Each handler translates a request into calls of `runs/service.py` and the result
back; whether something is allowed is decided there and in the rules. See
spec/profiles/ebench.yaml and docs/evaluate/ebench.md.
"""

from __future__ import annotations

import asyncio
import contextlib
import secrets
from collections.abc import Awaitable, Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any, TypeAlias

from starlette.responses import HTMLResponse, Response

from reference_server.http import codec
from reference_server.http.bodies import request_bodies
from reference_server.http.dispatch import Operation, OperationCall
from reference_server.http.handlers import Handlers
from reference_server.profiles.ebench import (
    long_chunks,
    message_conversion,
    pickle_reader,
    pickle_writer,
)
from reference_server.profiles.ebench.long_chunks import LongChunk, LongChunks, Turn
from reference_server.profiles.ebench.lost_answers import LostAnswers
from reference_server.profiles.ebench.owed_results import OwedResults
from reference_server.profiles.ebench.task_requests import (
    INLINE_BYTES_MAX,
    INLINE_VALUES_MAX,
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
    TaskScores,
    WorkerView,
    envelope,
    refusal_response,
    status_of,
    task_scores,
    worker_view,
)
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.lifecycle import Attach, Detach, Predict, Refuse
from reference_server.rules.runs.run import Run, RunHead, Session
from reference_server.runs.service import RunService
from reference_server.views import run_views

CONTROL = "/api/v1/benchmark/onlineEvaluation"
RUN_PATH = "/eval-server/{run_id}"
ENDPOINT = f"{RUN_PATH}/api/predict/{{benchmark_id}}"
# Benchmark set of EBench → benchmark_id; a benchmark_id is accepted as well (EBE-001).
BENCHMARK_SETS = {
    "ebench_generalist": "mobile_bimanual",
    "EBench": "mobile_bimanual",
    "ebench_mobile_manip": "mobile_bimanual_mobile_manip",
    "ebench_table_top_manip": "mobile_bimanual_table_top_manip",
}
# Headers of the only page that a browser shows: it may load nothing, and is not taken
# for another type.
PAGE_HEADERS = {
    "Content-Security-Policy": "default-src 'none'; frame-ancestors 'none'",
    "X-Content-Type-Options": "nosniff",
}
NO_LIMIT = 2**31 - 1  # of attempts: the largest that `attempt` can show

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
    long_chunks: LongChunks = field(default_factory=LongChunks)
    owed_results: OwedResults = field(default_factory=OwedResults)

    @property
    def service(self) -> RunService:
        return self.handlers.service

    def table(self) -> dict[str, dict[str, Operation]]:
        """path → method → operation, at the root and under each prefix."""
        prefixes = [
            "",
            *filter(None, self.handlers.settings.ebench_prefixes.split(",")),
        ]
        return {
            prefix + path: operations
            for prefix in prefixes
            for path, operations in self._paths().items()
        }

    def _paths(self) -> dict[str, dict[str, Operation]]:
        # EBE-024: the older client names the run in the header, the current one twice.
        named = partial(Operation, headers=("run_id",))
        binary = partial(named, scope="run", writes=(PICKLE,), query=("run_id",))
        plain = partial(named, query=("run_id",))
        requested = partial(Operation, refusal_response=refusal_response)
        stop = requested(self.stop, "run", query=("run_id", "user_id"))
        workers = partial(plain, scope="run", body=Workers)
        chunk_query = ("run_id", "render_mode", "subframes")
        return {
            f"{CONTROL}/createTask": {
                "POST": requested(self.create_task, "run", CreateTask)
            },
            f"{CONTROL}/ready": {"POST": requested(self.ready, body=Ready)},
            f"{ENDPOINT}/docs": {"GET": plain(self.docs, writes=("text/html",))},
            f"{ENDPOINT}/status": {"GET": plain(self.status)},
            f"{ENDPOINT}/create_workers": {"POST": workers(self.create_workers)},
            f"{ENDPOINT}/reset": {"POST": binary(self.reset)},
            f"{ENDPOINT}/step": {"POST": binary(self.step)},
            f"{ENDPOINT}/step_chunk": {
                "POST": binary(self.step_chunk, query=chunk_query)
            },
            f"{ENDPOINT}/kill": {"POST": workers(self.kill)},
            f"{ENDPOINT}/stop": {"POST": stop},
            f"{RUN_PATH}/stop": {"POST": stop},  # EBE-018: both paths
        }

    # --- control plane ---

    async def create_task(self, call: OperationCall) -> Response:
        """A new run (EBE-001); with a `task_id`, that run resumed (EBE-004).

        EBE-027: a run that is completed is executed again, by a new run that names it.
        """
        requested: CreateTask = call.body
        if requested.task_id:
            old = await self.service.find_run(call.account, requested.task_id)
            if old.state == "completed" and not old.is_push:
                again = requested.repeat_submission(old)
                run = await self.service.submit_run(call.account, again)
                return envelope({"task_id": run.run_id})
            await self.service.command_run("resume", call.account, old.run_id)
            return envelope({"task_id": old.run_id})
        wanted = requested.benchmark_set or "ebench_generalist"
        submission = {
            "benchmark_id": BENCHMARK_SETS.get(wanted, wanted),
            "policy": requested.policy(),
        }
        checked = codec.read_submission(submission)
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
        prefix = call.request.scope["path"].removesuffix(f"{CONTROL}/ready")
        endpoint = f"{self.handlers.base_url(call)}{prefix}{path}" if is_open else ""
        return envelope({"ready": is_open, "endpoint": endpoint})

    async def stop(self, call: OperationCall) -> Response:
        run = await self.service.stop_run(call.account, _run_id(call))
        return envelope({"run_id": run.run_id})

    # --- data plane ---

    async def docs(self, call: OperationCall) -> Response:
        """EBE-005: EBench's client calls it to see whether the endpoint answers."""
        run = await self._find_run(call)
        return HTMLResponse(
            f"<p>EBench API of run {run.run_id}.</p>", headers=PAGE_HEADERS
        )

    async def status(self, call: OperationCall) -> Response:
        run = await self._find_run(call)
        stored = await self.service.registry.reader.read_view(
            run.run_id, call.account, status_of, end=None
        )
        settings = self.handlers.settings
        announced = {
            "max_attempts": settings.ebench_max_attempts or None,  # EBE-030
            "max_chunk": settings.ebench_max_chunk,  # EBE-028
            "equal_steps": settings.ebench_equal_steps,  # EBE-029
        }
        return call.answer({"data": stored | announced})

    async def create_workers(self, call: OperationCall) -> Response:
        """EBE-032: opens a session for each worker that has none."""
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
        requested = await self._pickle(call, lambda value: value)
        if not isinstance(requested, dict) or not isinstance(
            requested.get("worker_ids"), list
        ):
            raise schema_error("/worker_ids", "is a list of worker ids")
        ids = read_worker_ids(requested["worker_ids"], run)
        turns = await _gather(
            {i: partial(self._open, run, i, takeover=True) for i in ids}
        )
        views = await self._worker_views(run, turns, current=_is_current(call))
        return Response(pickle_writer.write(views), media_type=PICKLE)

    async def step(self, call: OperationCall) -> Response:
        """EBE-008: one turn of each worker."""
        run, turns, on_sent = await self._step_all(call)
        with _reported_lost(on_sent):
            views = await self._worker_views(run, turns, current=_is_current(call))
        return ConfirmedResponse(views, call, on_sent)

    async def step_chunk(self, call: OperationCall) -> Response:
        """EBE-023: `step` with a list, and how much of it was executed."""
        run, turns, on_sent = await self._step_all(call)
        with _reported_lost(on_sent):
            # EBE-025: only the current client sends lists this way.
            views = await self._worker_views(run, turns, current=True)
        body = {
            "obs": views,
            "executed_steps": max(t.get("executed_steps", 0) for t in turns.values()),
            "stopped_early": any(map(_is_stopped_early, turns.values())),
        }
        return ConfirmedResponse(body, call, on_sent)

    async def _step_all(
        self, call: OperationCall
    ) -> tuple[Run, dict[str, Turn], Callable[[bool], None]]:
        """One step of each worker: all are checked before any is executed (EBE-012).

        Returns also what to call when the answer was sent, or lost.
        """
        run = await self._run(call)
        read = partial(read_chunks, run=run)
        chunks: dict[str, Chunk] = await self._pickle(call, read)
        run = await self._run(call)  # leases may have ended while the body came
        steps = {
            i: await self._prepare_step(run, i, chunk) for i, chunk in chunks.items()
        }
        commands = [s.command for s in steps.values() if s.command is not None]
        refused = await self.service.find_refused(call.account, run.run_id, commands)
        if refused is not None:
            command, verdict = refused
            raise chunks[command.worker_id].translate_refusal(verdict)
        scored = run.scored
        try:
            turns = await _gather({i: step.work for i, step in steps.items()})
        except Exception:  # of one worker: the answers of the others are lost
            self.owed_results.add(run, run.scored_order[scored:])
            raise
        # EBE-029: a repetition of the others is a repetition for ever.
        first_answered = [i for i in turns if not self._is_answered_again(chunks[i])]
        on_delivered = self._on_delivered(run, {i: turns[i] for i in first_answered})
        turns = {i: self._add_owed_result(run, turn) for i, turn in turns.items()}
        ended = [turn.get("episode_result") for turn in turns.values()]
        results = [result["index"] for result in ended if result is not None]

        def on_sent(is_connected: bool) -> None:
            if is_connected:
                on_delivered()
            else:
                self.owed_results.add(run, results)

        return run, turns, on_sent

    def _add_owed_result(self, run: Run, turn: Turn) -> Turn:
        """EBE-031: where the client reads a result and the turn has none of its own."""
        if "episode_result" in turn or not turn.get("executed_steps"):
            return turn
        episode = self.owed_results.take(run)
        if episode is None:
            return turn
        return {**turn, "episode_result": run_views.result_view(episode), "owed": True}

    # --- what a worker does ---

    async def _prepare_step(self, run: Run, worker_id: str, chunk: Chunk) -> _Step:
        """Decide what a step does for one worker; nothing is executed yet.

        A change of the session while a large chunk is converted is noticed by predict.
        """
        session = run.workers.get(worker_id)
        if session is None:  # EBE-017: the actions were chosen in an ended session
            return _Step(partial(self._open, run, worker_id))
        if not session.done:  # EBE-010: else the actions are not executed, nor checked
            limit = self.handlers.settings.ebench_max_chunk
            message_conversion.check_length(chunk.actions, limit, chunk.at)
        digest = chunk.digest
        long = self.long_chunks.find_repeated(session, digest)
        if long is not None:
            return _Step(partial(self._repeat_long, run, session, long))
        if self.long_chunks.is_played(session):
            raise Refused("worker_busy", "A list of steps of the worker is executed.")
        failed = self.long_chunks.find_failed(session, digest)
        if failed is not None:
            return self._play_long(run, session, digest, failed.turns, failed.executed)
        command = self.lost_answers.find_repeated_turn(session, digest)
        if command is None and session.done and not session.busy:  # EBE-010
            return _Step(partial(self._last_turn, session))
        if command is None:
            seq, last = session.seq + 1, partial(_last_command, session)
            read = partial(
                message_conversion.read_actions,
                *(chunk.actions, run.manifest, last, chunk.at),
            )
            made = await asyncio.to_thread(read) if chunk.is_large else read()
            command = Predict(worker_id, session.session_id, seq, made)
            if len(made) > run.manifest["max_chunk"]:
                return self._prepare_long(run, session, command, chunk, digest)
        return _Step(partial(self._play, run, session, command, digest), command)

    def _prepare_long(
        self, run: Run, session: Session, command: Predict, chunk: Chunk, digest: str
    ) -> _Step:
        """EBE-028: a list that is longer than a turn; all of it is checked now."""
        errors = message_conversion.whole_chunk_errors(command.actions, run.manifest)
        if errors:
            verdict = Refuse(
                "invalid_request",
                "The actions do not fit this benchmark; none was executed.",
                errors=tuple(errors),
            )
            raise chunk.translate_refusal(verdict)
        turns = long_chunks.split(command, run.manifest["max_chunk"])
        return self._play_long(run, session, digest, turns)

    def _play_long(
        self,
        run: Run,
        session: Session,
        digest: str,
        turns: Sequence[Predict],
        executed: Sequence[int] = (),
    ) -> _Step:
        play = partial(self.service.predict, run.account, run.run_id)

        async def work() -> Turn:
            chunk = self.long_chunks.start(session, digest, turns, play, executed)
            return await chunk.result()

        return _Step(work, turns[len(executed)])

    async def _repeat_long(self, run: Run, session: Session, long: LongChunk) -> Turn:
        """EBE-013: the answer again; its last turn is repeated as by any client."""
        whole = await long.result()
        assert session.request is not None, "the list had a turn"
        last = Predict(
            session.worker_id, session.session_id, session.seq, *session.request
        )
        turn = await self.service.predict(run.account, run.run_id, last)
        counted = ("executed_steps", "stopped_early")
        return {**turn, **{name: whole[name] for name in counted}}

    def _is_answered_again(self, chunk: Chunk) -> bool:
        """EBE-029: whether a step that equals the last one repeats it by setting."""
        chosen = self.handlers.settings.ebench_equal_steps
        return chosen == "answer" or (chosen == "answer_chunks" and chunk.is_varied)

    async def _play(
        self, run: Run, session: Session, command: Predict, digest: str
    ) -> Turn:
        """EBE-022: the predict of every client, so that it is scored like any other."""
        self.lost_answers.await_confirmation(session, command, digest)
        return await self.service.predict(run.account, run.run_id, command)

    async def _open(self, run: Run, worker_id: str, takeover: bool = False) -> Turn:
        limit = self.handlers.settings.ebench_max_attempts or NO_LIMIT  # EBE-030
        key = secrets.token_hex(16)
        command = Attach(worker_id, key, takeover, max_attempts=limit)
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
        _check_endpoint(call, run)
        self.owed_results.notice(run)
        return run

    async def _find_run(self, call: OperationCall) -> RunHead:
        """The same to be read: that of another node as it is stored."""
        run = await self.service.find_run(call.account, _run_id(call))
        _check_endpoint(call, run)
        if isinstance(run, Run):
            self.owed_results.notice(run)
        return run

    async def _pickle(self, call: OperationCall, read: Callable[[Any], Any]) -> Any:
        """`read`, applied to the value in the pickle of the body (EBE-015)."""
        codec.media_type_of(call.request, (PICKLE,))
        limit = self.handlers.settings.max_body_bytes
        body = await request_bodies.read_body(call.request, limit)
        try:
            # A few bytes can stand for thousands of values.
            if len(body) <= INLINE_BYTES_MAX:
                with contextlib.suppress(pickle_reader.TooManyValues):
                    return read(pickle_reader.read(body, INLINE_VALUES_MAX))
            return await asyncio.to_thread(lambda: read(pickle_reader.read(body)))
        except pickle_reader.BadPickle as error:
            raise Refused("malformed_body", f"The pickle: {error}.") from error

    async def _worker_views(
        self, run: Run, turns: Mapping[str, Turn], *, current: bool
    ) -> dict[str, WorkerView]:
        """The view of each worker. current: for that generation of the client."""
        scores: TaskScores = {}
        if any(turn["done"] or "episode_result" in turn for turn in turns.values()):
            scores = await self.service.registry.reader.render_when_stored(
                run, lambda run: task_scores(run, run.episodes)
            )
        return {
            worker: worker_view(run, turn, scores, current=current)
            for worker, turn in turns.items()
        }

    def _on_delivered(self, run: Run, turns: Mapping[str, Turn]) -> Callable[[], None]:
        """The work to do once the answer was sent to a connected client (EBE-014)."""
        sessions = [
            (run.workers.get(i), turn.get("seq", 0)) for i, turn in turns.items()
        ]

        def on_delivered() -> None:
            for session, seq in sessions:
                if session is not None:
                    self.lost_answers.confirm_delivery(session, seq)
                    self.long_chunks.confirm_delivery(session, seq)

        return on_delivered


def _run_id(call: OperationCall) -> str:
    """The run id of the path; header and query may repeat it, but not name another."""
    run_id = call.path["run_id"]
    for named in (call.headers.get("run_id"), call.query.get("run_id")):
        if named is not None and named != run_id:
            raise Refused(
                "not_found", f"The run {named} does not belong to this endpoint."
            )
    return run_id


def _check_endpoint(call: OperationCall, run: RunHead) -> None:
    if run.manifest["benchmark_id"] != call.path["benchmark_id"]:
        raise Refused("not_found", "The run does not belong to this endpoint.")


@contextlib.contextmanager
def _reported_lost(on_sent: Callable[[bool], None]) -> Iterator[None]:
    """An answer that cannot be built is one that was lost (EBE-031)."""
    try:
        yield
    except BaseException:
        on_sent(False)
        raise


def _is_current(call: OperationCall) -> bool:
    """EBE-025: only the current client names the run in the query."""
    return "run_id" in call.query


def _is_stopped_early(turn: Turn) -> bool:
    """Whether an episode ended, or the chunk was cut, before its last action."""
    ended = "episode_result" in turn and "owed" not in turn
    return ended or bool(turn["done"] or turn.get("stopped_early"))


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
    """The base of relative actions: the last command, or the initial state."""
    if session.request is not None and (session.steps or session.busy):
        return session.request[0][-1]
    if session.turn is None:
        raise Refused(
            "worker_busy", "The worker's first observation is not available yet."
        )
    state: Mapping[str, Sequence[float]] = session.turn["observation"]["state"]
    return state
