"""Mutants of the profile `ebench`."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from starlette.responses import Response

from reference_server.profiles.ebench import (
    long_chunks,
    message_conversion,
    pickle_reader,
    pickle_writer,
    task_handlers,
    task_requests,
    task_responses,
)
from reference_server.profiles.ebench.lost_answers import LostAnswers
from reference_server.profiles.ebench.owed_results import OwedResults
from reference_server.profiles.ebench.task_handlers import EbenchHandlers
from reference_server.rules.lifecycle import Detach, Predict
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Episode, Run, RunHead
from reference_server.runs.service import RunService
from tests.mutants import mutant, put

SCORE_AT = 5  # among calibration's numbers by name


# --- control plane ---


@mutant("EBE-001")
def takes_another_benchmark_for_the_task() -> None:
    """A policy is evaluated on another benchmark than submitted."""
    wrong = {**task_handlers.BENCHMARK_SETS, "calibration": "mobile_bimanual_state"}
    put(task_handlers, "BENCHMARK_SETS", wrong)


@mutant("EBE-002")
def refuses_a_task_without_a_message() -> None:
    """The client prints an error without a text."""

    def wrong(refused: Refused) -> Response:
        body = json.loads(bytes(task_responses.refusal_response(refused).body))
        return task_responses.envelope(None, body["code"], "")

    put(task_handlers, "refusal_response", wrong)


@mutant("EBE-003")
def calls_a_queued_task_ready() -> None:
    """Workers attach too early and are refused."""
    right = RunService.get_availability

    async def wrong(self: RunService, *arguments: Any) -> Any:
        run, available = await right(self, *arguments)
        return run, "open" if available == "waiting" else available

    put(RunService, "get_availability", wrong)


@mutant("EBE-004", "EBE-027")
def gives_a_resumed_task_another_id() -> None:
    """The client asks for the progress of an id that is no longer used."""
    right = EbenchHandlers.create_task

    async def wrong(self: EbenchHandlers, call: Any) -> Response:
        response = await right(self, call)
        if not call.body.task_id:
            return response
        return task_responses.envelope({"task_id": f"{call.body.task_id}-2"})

    put(EbenchHandlers, "create_task", wrong)


@mutant("EBE-027")
def executes_a_task_again_without_a_trace() -> None:
    """The best of many runs is taken for the only one."""
    right = task_requests.CreateTask.repeat_submission

    def wrong(self: task_requests.CreateTask, old: Run) -> dict[str, Any]:
        submission = right(self, old)
        del submission["policy"]["version"]
        return submission

    put(task_requests.CreateTask, "repeat_submission", wrong)


@mutant("EBE-027")
def executes_the_whole_benchmark_again_after_a_part() -> None:
    """Another run than the one that was named is compared with it."""
    right = task_requests.CreateTask.repeat_submission

    def wrong(self: task_requests.CreateTask, old: Run) -> dict[str, Any]:
        return {k: v for k, v in right(self, old).items() if k != "select"}

    put(task_requests.CreateTask, "repeat_submission", wrong)


@mutant("EBE-024")
def knows_no_run_id_in_the_query_of_docs() -> None:
    """The current client does not start."""
    right = EbenchHandlers._paths

    def wrong(self: EbenchHandlers) -> Any:
        table = right(self)
        docs = table[f"{task_handlers.ENDPOINT}/docs"]
        docs["GET"] = dataclasses.replace(docs["GET"], query=())
        return table

    put(EbenchHandlers, "_paths", wrong)


@mutant("EBE-005", "EBE-024")
def has_no_docs_page() -> None:
    """The client does not start."""

    async def wrong(_self: EbenchHandlers, _call: Any) -> Response:
        raise Refused("not_found", "There is no such page.")

    put(EbenchHandlers, "docs", wrong)


@mutant("EBE-018")
def lacks_one_of_two_stop_paths() -> None:
    """An older client cannot stop what it started."""
    right = EbenchHandlers._paths

    def wrong(self: EbenchHandlers) -> Any:
        table = right(self)
        del table[f"{task_handlers.RUN_PATH}/stop"]
        return table

    put(EbenchHandlers, "_paths", wrong)


@mutant("EBE-019")
def counts_episodes_in_progress_as_completed() -> None:
    """A run seems nearer to its end than it is."""
    right = task_responses.status_of

    def wrong(run: RunHead, episodes: Sequence[Episode]) -> dict[str, Any]:
        status = right(run, episodes)
        status["completed_episodes"] += status["in_progress_episodes"]
        return status

    put(task_handlers, "status_of", wrong)


# --- workers ---


@mutant("EBE-006")
def shows_the_first_of_many_workers() -> None:
    """A client with sixteen workers cannot start."""
    right = EbenchHandlers._worker_views

    async def wrong(
        self: EbenchHandlers, run: Run, turns: Mapping[str, Any], *, current: bool
    ) -> Any:
        if not any(turn.get("executed_steps") for turn in turns.values()):
            turns = dict(list(turns.items())[:1])
        return await right(self, run, turns, current=current)

    put(EbenchHandlers, "_worker_views", wrong)


@mutant("EBE-007", "EBE-031")
def begins_an_episode_anew_at_every_reset() -> None:
    """A client that resets a bad episode gets a better score."""
    right = EbenchHandlers._open

    async def wrong(
        self: EbenchHandlers, run: Run, worker_id: str, takeover: bool = False
    ) -> Any:
        session = run.workers.get(worker_id)
        if takeover and session is not None:
            detach = Detach(worker_id, session.session_id)
            await self.service.detach_worker(run.account, run.run_id, detach)
        return await right(self, run, worker_id, takeover)

    put(EbenchHandlers, "_open", wrong)


@mutant("EBE-016", "EBE-024", "EBE-030")
def ignores_kill_requests() -> None:
    """A worker's session is blocked until its lease ends."""

    async def wrong(_self: EbenchHandlers, call: Any) -> Response:
        return call.answer({"data": {"success": True}})  # type: ignore[no-any-return]

    put(EbenchHandlers, "kill", wrong)


@mutant("EBE-016")
def ends_no_session_beside_a_worker_without_one() -> None:
    """A client that names its usual workers leaves episodes blocked."""
    right = EbenchHandlers.kill

    async def wrong(self: EbenchHandlers, call: Any) -> Response:
        run = await self._run(call)
        named = task_requests.read_worker_ids(call.body.data.worker_ids, run)
        if all(one in run.workers for one in named):
            return await right(self, call)
        return call.answer({"data": {"success": True}})  # type: ignore[no-any-return]

    put(EbenchHandlers, "kill", wrong)


@mutant("EBE-030")
def abandons_an_episode_whose_worker_is_killed() -> None:
    """A client that crashes three times gets score 0 for an episode it never ended."""
    put(task_handlers, "NO_LIMIT", None)


@mutant("EBE-017")
def executes_actions_of_a_lost_episode() -> None:
    """A new episode starts with an action chosen in another one."""
    right = EbenchHandlers._prepare_step

    def wrong(self: EbenchHandlers, run: Run, worker_id: str, chunk: Any) -> Any:
        if worker_id in run.workers:
            return right(self, run, worker_id, chunk)

        async def work() -> Any:
            turn = await self._open(run, worker_id)
            actions = message_conversion.read_actions(
                chunk.actions, run.manifest, dict, chunk.at
            )
            command = Predict(worker_id, turn["session_id"], 1, actions)
            return await self.service.predict(run.account, run.run_id, command)

        return task_handlers._Step(work)

    put(EbenchHandlers, "_prepare_step", wrong)


@mutant("EBE-021")
def opens_its_endpoint_to_every_account() -> None:
    """Another account can play the episodes of a run."""
    right = EbenchHandlers._run

    async def wrong(self: EbenchHandlers, call: Any) -> Run:
        run = await self.service.registry.get(call.path["run_id"])
        call.caller = dataclasses.replace(call.caller, account=run.account)
        return await right(self, call)

    put(EbenchHandlers, "_run", wrong)


# --- steps ---


@mutant("EBE-008")
def executes_a_list_of_steps_backwards() -> None:
    """A robot executes the last steps first."""
    right = task_requests.read_chunks

    def wrong(body: Any, run: Run) -> Any:
        return right(body[::-1] if isinstance(body, list) else body, run)

    put(task_handlers, "read_chunks", wrong)


@mutant("EBE-023")
def never_reports_a_chunk_as_stopped_early() -> None:
    """A policy believes that it is still in the episode it planned for."""
    put(task_handlers, "_is_stopped_early", lambda _turn: False)


@mutant("EBE-009", "EBE-026", "EBE-031")
def omits_the_result_of_an_episode() -> None:
    """The client's folder of results stays empty."""
    right = task_responses.worker_view

    def wrong(*arguments: Any, **how: Any) -> dict[str, Any]:
        return right(*arguments, **how) | {"episode_result": None}

    put(task_handlers, "worker_view", wrong)


@mutant("EBE-010", "EBE-025")
def ends_a_run_without_metrics() -> None:
    """The client prints an empty table at the end."""
    put(task_responses, "run_metric", lambda _scores, **_how: {})


@mutant("EBE-025")
def shows_tasks_without_their_progress() -> None:
    """A table of results shows tasks that are not complete."""
    put(task_responses.TaskScore, "label", lambda _self, task: task)


@mutant("EBE-025", "EBE-026")
def takes_half_a_score_for_half_a_success() -> None:
    """The rate of successes is higher than what succeeded."""
    put(message_conversion, "success_rate", lambda score: score)


@mutant("EBE-031")
def gives_each_result_once_whether_received_or_not() -> None:
    """The folder of results has no file for an episode whose answer was lost."""
    put(OwedResults, "add", lambda _self, _run, _indices: None)


@mutant("EBE-031")
def owes_a_lost_result_one_more_time_only() -> None:
    """The folder of results has no file where two answers were lost in a row."""
    right_take, right_add = OwedResults.take, OwedResults.add
    given: set[tuple[str, int]] = set()

    def take(self: OwedResults, run: Run) -> Episode | None:
        episode = right_take(self, run)
        if episode is not None:
            given.add((run.run_id, episode.index))
        return episode

    def add(self: OwedResults, run: Run, indices: Iterable[int]) -> None:
        right_add(self, run, [i for i in indices if (run.run_id, i) not in given])

    put(OwedResults, "take", take)
    put(OwedResults, "add", add)


@mutant("EBE-028")
def executes_a_refused_list_up_to_its_wrong_action() -> None:
    """A robot moves although the step was refused."""
    put(message_conversion, "whole_chunk_errors", lambda *_: [])


@mutant("EBE-028")
def plays_the_first_turn_of_a_long_list_alone() -> None:
    """The robot stops in the middle of what the policy planned."""
    right = long_chunks.split
    put(long_chunks, "split", lambda *arguments: right(*arguments)[:1])


@mutant("EBE-011")
def reads_numbers_in_single_precision() -> None:
    """A target is met by less than the policy commanded."""
    right = message_conversion._numbers

    def wrong(value: Any, at: str, size: int) -> list[float]:
        with np.errstate(over="ignore"):
            return [float(np.float32(number)) for number in right(value, at, size)]

    put(message_conversion, "_numbers", wrong)


@mutant("EBE-012")
def executes_part_of_a_refused_step() -> None:
    """A refused step was executed by half of the workers."""
    right = EbenchHandlers._prepare_step

    def wrong(self: EbenchHandlers, *arguments: Any) -> Any:
        try:
            return right(self, *arguments)
        except Refused as refused:
            error = refused

        async def work() -> Any:
            raise error

        return task_handlers._Step(work)

    async def find_none(_self: RunService, *_: Any) -> None:
        """Every step may begin; those that do not fit are refused one by one."""

    put(EbenchHandlers, "_prepare_step", wrong)
    put(RunService, "find_refused", find_none)


@mutant("EBE-013")
def executes_a_lost_step_again() -> None:
    """A robot moves twice because an answer did not arrive."""
    put(LostAnswers, "find_repeated_turn", lambda _self, _session, _digest: None)


@mutant("EBE-014")
def takes_an_equal_action_for_a_repeated_one() -> None:
    """A policy that repeats an action never sees time pass."""
    put(LostAnswers, "confirm_delivery", lambda _self, _session, _seq: None)


@mutant("EBE-022")
def shares_scores_among_the_workers_of_a_step() -> None:
    """The result of one worker depends on another worker."""
    right = task_requests.read_chunks

    def wrong(body: Any, run: Run) -> Any:
        chunks = right(body, run)
        last = [chunk.actions[-1]["action"] for chunk in chunks.values()]
        if all(isinstance(one, list) and len(one) > SCORE_AT for one in last):
            mean = sum(one[SCORE_AT] for one in last) / len(last)
            for one in last:
                one[SCORE_AT] = mean
        return chunks

    put(task_handlers, "read_chunks", wrong)


# --- pickles ---


@mutant("EBE-015")
def accepts_pickles_that_call_functions() -> None:
    """An attack is reported as malformed data."""
    right = pickle_reader.read

    def wrong(body: bytes) -> Any:
        try:
            return right(body)
        except pickle_reader.BadPickle:
            return None

    put(pickle_reader, "read", wrong)


@mutant("EBE-020")
def names_numpy_in_its_answers() -> None:
    """A client that reads only plain data cannot read the answers."""
    right = pickle_writer.write

    def wrong(value: Any) -> bytes:
        body = right(value)
        return body[:2] + b"cnumpy\ndtype\n0" + body[2:]

    put(pickle_writer, "write", wrong)
