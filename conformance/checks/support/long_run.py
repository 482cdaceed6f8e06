"""One run of many episodes, played once for all checks that look at long lists.

A server that is right for ten of anything may be wrong at eleven, at a hundred and one,
or behind the first page. The run has uneven tasks and scores that no binary fraction
holds, and two workers play it, so that the first episode is scored late. It is set-up:
nothing here judges the server; the checks that read the run do.
"""

from copy import copy
from dataclasses import dataclass, field, replace
from typing import Any

from conformance.checks.support.planned_run import PlannedEpisode
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient, WorkerClient
from conformance.exchanges.exchange import Exchange
from conformance.verdicts.expect import SetUpFailed

# More than a page of 100, and more differing pairs than 170: 171! overflows a double.
EPISODES = 180
_TASKS = (
    "score",
    "score",
    "count",
    "score",
    "echo",
    "delay",
    "score",
    "fault",
    "score",
)
# The first episode is scored after this many others.
_HELD_BACK = 20
_TIES = 4


@dataclass
class LongRun:
    """A run played to its end, and what its turns said."""

    run: RunClient
    plan: list[PlannedEpisode]
    turns: list[dict[str, Any]] = field(default_factory=list)
    evidence: list[Exchange] = field(default_factory=list)  # how it began and ended

    def results(self) -> list[dict[str, Any]]:
        """Give the results that the turns carried, in the order of scoring."""
        return [t["episode_result"] for t in self.turns if "episode_result" in t]


def long_run(context: CheckContext) -> LongRun:
    """Give the long run, which the first check to need it plays."""
    return _stored(context, "long run", is_other=False)


def other_long_run(context: CheckContext) -> LongRun:
    """Give a run of the same manifest with nearly opposite outcomes, in its order."""
    return _stored(context, "other long run", is_other=True)


def _stored(context: CheckContext, name: str, *, is_other: bool) -> LongRun:
    stored = context.shared.stored
    if name not in stored:
        log = context.exchange_log
        count = len(log.exchanges)
        try:
            stored[name] = _play(context, is_other)
            stored[name].evidence = log.exchanges[count:][:3] + log.exchanges[-2:]
        except SetUpFailed as error:
            stored[name] = error
    entry: LongRun | SetUpFailed = stored[name]
    if isinstance(entry, SetUpFailed):
        raise entry
    context.exchange_log.adopt(entry.evidence, len(entry.turns))
    run = copy(entry.run)  # whose requests are those of this check
    run.context, run.http_client = context, context.http_client
    return replace(entry, run=run)


def _plan(index: int, is_other: bool, tasks: list[str]) -> PlannedEpisode:
    is_success = (index % 7 in (0, 2, 4)) != (is_other and index >= _TIES)
    outcome, task = "success" if is_success else "failure", tasks[index % len(tasks)]
    score = (index * (5 if is_other else 7) % 11) / 11
    return PlannedEpisode(
        outcome, score if task == "score" else float(is_success), task
    )


def _play(context: CheckContext, is_other: bool) -> LongRun:
    tasks = context.tasks(*_TASKS)
    plan = [_plan(index, is_other, tasks) for index in range(EPISODES)]
    run = context.submit(*[planned.task for planned in plan])
    long = LongRun(run, plan)
    context.judge.history.keep(run.id)
    wanted = 1 if is_other else context.worker_count(2)
    workers = [run.worker() for _ in range(wanted)]
    for worker in workers:
        long.turns.append(worker.attach())
    *held_back, worker = workers
    for played in range(1, EPISODES + 1):
        if worker.turn["done"]:
            break
        _play_episode(long, worker)
        if held_back and played == _HELD_BACK:
            first = held_back.pop()
            _play_episode(long, first)
            if not first.turn["done"]:
                first.detach()
    if run.get()["state"] != "completed":
        raise SetUpFailed(f"a run of {EPISODES} episodes ends {run.body['state']}")
    return long


def _play_episode(long: LongRun, worker: WorkerClient) -> None:
    index = worker.turn["episode"]["index"]
    if not 0 <= index < EPISODES:
        raise SetUpFailed(f"an episode has the index {index} of {EPISODES}")
    planned = long.plan[index]
    action = long.run.context.action(
        score=planned.score, success=int(planned.outcome == "success"), end=1
    )
    long.turns.append(worker.predict(action))
    if "episode_result" not in worker.turn:
        raise SetUpFailed("an action with `end` 1 did not end the episode")
