"""Mutants around the simulator: which actions it executes, and how it is judged."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import msgspec

from reference_sim.process.pool import Begin, SimulatorHandle
from reference_sim.process.simulator_process import SimulatorFault
from tests.mutants import Json, Row, mutant, mutants, put
from tests.mutants.server_changes import (
    change_results,
)

Actions = Sequence[Any]


def change_actions(change: Callable[[list[Any]], Actions]) -> None:
    """Change the actions of every turn before they are executed."""
    right = SimulatorHandle.play

    async def wrong(self: Any, actions: Actions, **how: Any) -> Any:
        return await right(self, change(list(actions)), **how)

    put(SimulatorHandle, "play", wrong)


def change_each_action(change: Callable[[Any], Json]) -> None:
    """Replace members of each action before it is executed."""
    change_actions(lambda actions: [{**action, **change(action)} for action in actions])


@mutant(
    *("ATR-004", "ATR-006", "CAL-007", "CAL-008", "CAL-011", "FAULT-012", "PRED-001"),
    *("PRED-006", "PRED-007", "PRED-012", "PRED-018", "PRED-028"),
    *("SCORE-002", "SCORE-003"),
    through=change_actions,
)
def executes_a_chunk_backwards(actions: list[Any]) -> Actions:
    """The robot puts an object down before it picks it up."""
    return actions[::-1]


@mutant("CAL-004", through=change_each_action)
def sleeps_for_whole_milliseconds(action: Any) -> Json:
    """Many short delays come to nothing."""
    return {"delay_s": [int(action["delay_s"][0] * 1000) / 1000]}


@mutant("CAL-005", "PRED-017", through=change_each_action)
def ends_an_episode_too_early(action: Any) -> Json:
    """An episode is over although the policy did not end it."""
    return {"end": [float(action["end"][0] > 0.5)]}


@mutant("CAL-009", through=change_each_action)
def rounds_commanded_faults(action: Any) -> Json:
    """A fault that was not commanded disturbs the run."""
    return {"fault": [round(action["fault"][0])]}


@mutant("CAL-010", "PRED-017")
def breaks_down_in_every_task() -> None:
    """An action that has no meaning in a task disturbs the run."""
    right_begin, right_play = SimulatorHandle.begin, SimulatorHandle.play
    tasks: dict[int, str] = {}

    async def begin(self: Any, command: Begin) -> Any:
        tasks[id(self)] = command.task
        return await right_begin(self, command)

    async def play(self: Any, actions: Actions, **named: Any) -> Any:
        if tasks[id(self)] != "fault" and any(a["fault"][0] >= 1 for a in actions):
            raise SimulatorFault("it was commanded to break")
        return await right_play(self, actions, **named)

    put(SimulatorHandle, "begin", begin)
    put(SimulatorHandle, "play", play)


@mutants(
    Row(
        "judges_only_the_last_step",
        ("CAL-011", "SCORE-002"),
        "A cube that was lifted and put down again was never lifted.",
        "last_step",
    ),
    Row(
        "judges_every_step",
        ("CAL-011", "SCORE-003"),
        "A cube that was dropped in the end counts as lifted.",
        "any_step",
    ),
)
def judge_by(rule: str) -> None:
    """Judge every benchmark by one rule of success."""
    right = SimulatorHandle.begin

    async def wrong(self: Any, begin: Begin) -> Any:
        return await right(self, msgspec.structs.replace(begin, success_rule=rule))

    put(SimulatorHandle, "begin", wrong)


@mutant("CAL-002", "SCORE-001", "SVC-003", through=change_results)
def scores_more_than_one(result: Json, episode: Any) -> None:
    """One episode can outweigh the others."""
    result["score"] *= episode.result.steps
