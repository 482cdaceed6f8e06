"""Mutants of the profile `ebench`."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

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
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.lifecycle import Detach, Predict
from reference_server.rules.runs.run import Episode, Run, RunHead
from reference_server.runs.service import RunService
from tests.mutants import instead_of, mutant, put

SCORE_AT = 5  # among calibration's numbers by name


# --- control plane ---


@mutant("EBE-001")
def takes_another_benchmark_for_the_task() -> None:
    """A policy is evaluated on another benchmark than submitted."""
    wrong = {**task_handlers.BENCHMARK_SETS, "calibration": "mobile_bimanual_state"}
    put(task_handlers, "BENCHMARK_SETS", wrong)


@mutant("EBE-002", through=instead_of(task_handlers, "refusal_response"))
def refuses_a_task_without_a_message(_right: Any, refused: Refused) -> Any:
    """The client prints an error without a text."""
    body = json.loads(bytes(task_responses.refusal_response(refused).body))
    return task_responses.envelope(None, body["code"], "")


@mutant("EBE-003", through=instead_of(RunService, "get_availability"))
async def calls_a_queued_task_ready(
    right: Any, self: RunService, *arguments: Any
) -> Any:
    """Workers attach too early and are refused."""
    run, available = await right(self, *arguments)
    return run, "open" if available == "waiting" else available


@mutant("EBE-004", "EBE-027", through=instead_of(EbenchHandlers, "create_task"))
async def gives_a_resumed_task_another_id(
    right: Any, self: EbenchHandlers, call: Any
) -> Any:
    """The client asks for the progress of an id that is no longer used."""
    response = await right(self, call)
    if not call.body.task_id:
        return response
    return task_responses.envelope({"task_id": f"{call.body.task_id}-2"})


@mutant("EBE-027", through=instead_of(task_requests.CreateTask, "repeat_submission"))
def executes_a_task_again_without_a_trace(
    right: Any, self: task_requests.CreateTask, old: Run
) -> Any:
    """The best of many runs is taken for the only one."""
    submission = right(self, old)
    del submission["policy"]["version"]
    return submission


@mutant("EBE-005", "EBE-024", through=instead_of(EbenchHandlers, "docs"))
async def has_no_docs_page(_right: Any, _self: EbenchHandlers, _call: Any) -> Any:
    """The client does not start."""
    raise Refused("not_found", "There is no such page.")


@mutant("EBE-018", through=instead_of(EbenchHandlers, "_paths"))
def lacks_one_of_two_stop_paths(right: Any, self: EbenchHandlers) -> Any:
    """An older client cannot stop what it started."""
    table = right(self)
    del table[f"{task_handlers.RUN_PATH}/stop"]
    return table


@mutant("EBE-019", through=instead_of(task_handlers, "status_of"))
def counts_episodes_in_progress_as_completed(
    right: Any, run: RunHead, episodes: Sequence[Episode]
) -> Any:
    """A run seems nearer to its end than it is."""
    status = right(run, episodes)
    status["completed_episodes"] += status["in_progress_episodes"]
    return status


# --- workers ---


@mutant("EBE-006", through=instead_of(EbenchHandlers, "_worker_views"))
async def shows_the_first_of_many_workers(
    right: Any,
    self: EbenchHandlers,
    run: Run,
    turns: Mapping[str, Any],
    *,
    current: bool,
) -> Any:
    """A client with sixteen workers cannot start."""
    if not any(turn.get("executed_steps") for turn in turns.values()):
        turns = dict(list(turns.items())[:1])
    return await right(self, run, turns, current=current)


@mutant("EBE-007", "EBE-031", through=instead_of(EbenchHandlers, "_open"))
async def begins_an_episode_anew_at_every_reset(
    right: Any, self: EbenchHandlers, run: Run, worker_id: str, takeover: bool = False
) -> Any:
    """A client that resets a bad episode gets a better score."""
    session = run.workers.get(worker_id)
    if takeover and session is not None:
        detach = Detach(worker_id, session.session_id)
        await self.service.detach_worker(run.account, run.run_id, detach)
    return await right(self, run, worker_id, takeover)


@mutant("EBE-016", "EBE-024", "EBE-030", through=instead_of(EbenchHandlers, "kill"))
async def ignores_kill_requests(_right: Any, _self: EbenchHandlers, call: Any) -> Any:
    """A worker's session is blocked until its lease ends."""
    return call.answer({"data": {"success": True}})


@mutant("EBE-024", "EBE-032", through=instead_of(EbenchHandlers, "create_workers"))
async def creates_no_workers(_right: Any, _self: EbenchHandlers, call: Any) -> Any:
    """A client that creates its workers first cannot see whether they have places."""
    return call.answer({"data": {"success": True}})


@mutant("EBE-030")
def abandons_an_episode_whose_worker_is_killed() -> None:
    """A client that crashes three times gets score 0 for an episode it never ended."""
    put(task_handlers, "NO_LIMIT", None)


@mutant("EBE-017", through=instead_of(EbenchHandlers, "_prepare_step"))
async def executes_actions_of_a_lost_episode(
    right: Any, self: EbenchHandlers, run: Run, worker_id: str, chunk: Any
) -> Any:
    """A new episode starts with an action chosen in another one."""
    if worker_id in run.workers:
        return await right(self, run, worker_id, chunk)

    async def work() -> Any:
        turn = await self._open(run, worker_id)
        actions = message_conversion.read_actions(
            chunk.actions, run.manifest, dict, chunk.at
        )
        command = Predict(worker_id, turn["session_id"], 1, actions)
        return await self.service.predict(run.account, run.run_id, command)

    return task_handlers._Step(work)


@mutant("EBE-021", through=instead_of(EbenchHandlers, "_run"))
async def opens_its_endpoint_to_every_account(
    right: Any, self: EbenchHandlers, call: Any
) -> Any:
    """Another account can play the episodes of a run."""
    run = await self.service.registry.get(call.path["run_id"])
    call.caller = dataclasses.replace(call.caller, account=run.account)
    return await right(self, call)


# --- steps ---


@mutant("EBE-008", through=instead_of(task_handlers, "read_chunks"))
def executes_a_list_of_steps_backwards(right: Any, body: Any, run: Run) -> Any:
    """A robot executes the last steps first."""
    return right(body[::-1] if isinstance(body, list) else body, run)


@mutant("EBE-023")
def never_reports_a_chunk_as_stopped_early() -> None:
    """A policy believes that it is still in the episode it planned for."""
    put(task_handlers, "_is_stopped_early", lambda _turn: False)


@mutant(
    "EBE-009", "EBE-026", "EBE-031", through=instead_of(task_handlers, "worker_view")
)
def omits_the_result_of_an_episode(right: Any, *arguments: Any, **how: Any) -> Any:
    """The client's folder of results stays empty."""
    return right(*arguments, **how) | {"episode_result": None}


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


@mutant("EBE-011", through=instead_of(message_conversion, "_numbers"))
def reads_numbers_in_single_precision(
    right: Any, value: Any, at: str, size: int
) -> Any:
    """A target is met by less than the policy commanded."""
    with np.errstate(over="ignore"):
        return [float(np.float32(number)) for number in right(value, at, size)]


@mutant("EBE-012")
def executes_part_of_a_refused_step() -> None:
    """A refused step was executed by half of the workers."""
    right = EbenchHandlers._prepare_step

    async def wrong(self: EbenchHandlers, *arguments: Any) -> Any:
        try:
            return await right(self, *arguments)
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


@mutant("EBE-014", "EBE-026")
def takes_an_equal_action_for_a_repeated_one() -> None:
    """A policy that repeats an action never sees time pass."""
    put(LostAnswers, "confirm_delivery", lambda _self, _session, _seq: None)


@mutant("EBE-022", through=instead_of(task_handlers, "read_chunks"))
def shares_scores_among_the_workers_of_a_step(right: Any, body: Any, run: Run) -> Any:
    """The result of one worker depends on another worker."""
    chunks = right(body, run)
    last = [chunk.actions[-1]["action"] for chunk in chunks.values()]
    if all(isinstance(action, list) and len(action) > SCORE_AT for action in last):
        mean = sum(action[SCORE_AT] for action in last) / len(last)
        for action in last:
            action[SCORE_AT] = mean
    return chunks


# --- pickles ---


@mutant("EBE-015", through=instead_of(pickle_reader, "read"))
def accepts_pickles_that_call_functions(right: Any, body: bytes, *most: int) -> Any:
    """An attack is reported as malformed data."""
    try:
        return right(body, *most)
    except pickle_reader.BadPickle:
        return None


@mutant("EBE-020", through=instead_of(pickle_writer, "write"))
def names_numpy_in_its_answers(right: Any, value: Any) -> Any:
    """A client that reads only plain data cannot read the answers."""
    body = right(value)
    return body[:2] + b"cnumpy\ndtype\n0" + body[2:]
