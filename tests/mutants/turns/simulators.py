"""Mutants around the simulator: what is executed, what is observed, what it scores."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

from msgspec.structs import replace as changed

from reference_server.rules import action_space
from reference_server.views import run_views, turn_view
from reference_sim import benchmark_registry
from reference_sim.benchmarks import calibration
from reference_sim.process.pool import SimulatorHandle
from reference_sim.process.simulator_process import SimulatorFault
from tests.mutants import mutant, put

Actions = Sequence[Any]


def _same(value: Any, *_: Any) -> Any:
    return value


def spoil_play(
    before: Callable[[list[Any]], Actions] = _same,
    after: Callable[[Any, Actions], Any] = _same,
) -> None:
    """Change the actions before they are executed, or the report of them."""
    right = SimulatorHandle.play

    async def wrong(self: Any, actions: Actions, **how: Any) -> Any:
        played = await right(self, before(list(actions)), **how)
        return after(played, actions)

    put(SimulatorHandle, "play", wrong)


def spoil_observations(change: Callable[[Any], None]) -> None:
    """Change every observation on its way from the simulator."""

    def change_report(report: Any) -> Any:
        for observation in [report.observation, *(_all(report) or [])]:
            if observation is not None:
                change(observation)
        return report

    right_begin, right_play = SimulatorHandle.begin, SimulatorHandle.play
    right_observe = SimulatorHandle.observe

    async def begin(self: Any, *arguments: Any, **named: Any) -> Any:
        return change_report(await right_begin(self, *arguments, **named))

    async def play(self: Any, *arguments: Any, **named: Any) -> Any:
        return change_report(await right_play(self, *arguments, **named))

    async def observe(self: Any) -> Any:
        observation = await right_observe(self)
        change(observation)
        return observation

    put(SimulatorHandle, "begin", begin)
    put(SimulatorHandle, "play", play)
    put(SimulatorHandle, "observe", observe)


def _all(report: Any) -> list[Any]:
    # The last of all is the observation itself: changed once is enough.
    return (getattr(report, "observations", None) or [])[:-1]


def spoil_image(change: Callable[[dict[str, Any]], None], codec: str) -> None:
    def wrong(observation: dict[str, Any]) -> None:
        for image in observation["images"].values():
            if image["codec"] == codec:
                change(image)

    spoil_observations(wrong)


@mutant(
    "ATR-004",
    "ATR-006",
    "CAL-007",
    "CAL-008",
    "CAL-011",
    "FAULT-012",
    "PRED-001",
    "PRED-006",
    "PRED-007",
    "PRED-012",
    "PRED-018",
    "PRED-021",
    "SCORE-002",
    "SCORE-003",
)
def executes_a_chunk_backwards() -> None:
    """The robot puts an object down before it picks it up."""
    spoil_play(lambda actions: actions[::-1])


@mutant(
    "ATR-004",
    "ATR-006",
    "CAL-003",
    "CAL-005",
    "CAL-008",
    "CAL-010",
    "ENC-005",
    "ENC-006",
    "PRED-001",
    "PRED-006",
    "PRED-012",
    "PRED-015",
    "PRED-018",
    "PRED-021",
)
def drops_the_last_action_of_long_chunks() -> None:
    """A chunk is cut without an error."""

    def cut(actions: Actions) -> Actions:
        # A long step stays: its time shows in whatever waits for it.
        is_cut = len(actions) > 2 and not actions[-1]["delay_s"][0]
        return actions[:-1] if is_cut else actions

    spoil_play(cut)


@mutant("PRED-016")
def accepts_numbers_that_are_not_finite() -> None:
    """A policy that has diverged continues to drive the robot."""
    every = {name: getattr(math, name) for name in dir(math)}
    fake = SimpleNamespace(**(every | {"isfinite": lambda _: True}))
    put(action_space, "math", fake)
    from reference_server.generated.models import Action, Predict

    for model in (Action, Predict):
        model.model_config["allow_inf_nan"] = True
        model.model_rebuild(force=True)


def _force_rule(rule: str) -> None:
    right = SimulatorHandle.begin

    async def wrong(self: Any, *arguments: Any, **named: Any) -> Any:
        return await right(self, *arguments, **named | {"success_rule": rule})

    put(SimulatorHandle, "begin", wrong)


@mutant("CAL-011", "SCORE-002")
def judges_only_the_last_step() -> None:
    """A cube that was lifted and put down again was never lifted."""
    _force_rule("last_step")


@mutant("CAL-011", "SCORE-003")
def judges_every_step() -> None:
    """A cube that was dropped in the end counts as lifted."""
    _force_rule("any_step")


@mutant("CAL-002", "CAL-011", "SCORE-001", "SVC-003")
def scores_more_than_one() -> None:
    """One episode can outweigh the others."""
    for module in (turn_view, run_views):
        right = module.result_view

        def wrong(episode: Any, right: Any = right) -> dict[str, Any]:
            body: dict[str, Any] = right(episode)
            return body | {"score": body["score"] * episode.result.steps}

        put(module, "result_view", wrong)


@mutant("CAL-002", "CAL-011", "CMP-004", "CMP-005", "CMP-008", "SCORE-006", "SCORE-011")
def scores_the_best_and_not_the_last_value() -> None:
    """The task `score` cannot be used to judge aggregation."""

    def wrong(played: Any, actions: Actions) -> Any:
        best = max(a["score"][0] for a in actions[: played.executed])
        return changed(played, score=best) if played.ended else played

    spoil_play(after=wrong)


@mutant(
    "ATT-004", "CAL-003", "FAULT-004", "PRED-001", "PRED-004", "PRED-012", "PRED-017"
)
def counts_one_action_too_many() -> None:
    """The kit cannot determine what was executed."""

    def wrong(observation: dict[str, Any]) -> None:
        if observation["state"]["count"][0] > 2:
            observation["state"]["count"][0] += 1

    spoil_observations(wrong)


@mutant("CAL-004")
def sleeps_less_than_commanded() -> None:
    """Leases and timeouts cannot be judged."""

    def shortened(delay_s: float, *, is_alone: bool) -> float:
        # Longer ones are not: EPI-011, which subtracts such a one, may then fail. Of
        # several none is left: what a busy machine takes for a turn is less than those.
        if delay_s >= 0.25:
            return delay_s
        return delay_s / 2 if is_alone else 0.0

    def spoil(acts: list[dict[str, list[float]]]) -> list[dict[str, list[float]]]:
        is_alone = len(acts) == 1
        return [
            {**a, "delay_s": [shortened(a["delay_s"][0], is_alone=is_alone)]}
            for a in acts
        ]

    spoil_play(spoil)


@mutant("CAL-005", "PRED-017")
def ends_an_episode_too_early() -> None:
    """`end` is rounded."""
    spoil_play(
        lambda acts: [{**a, "end": [1.0 if a["end"][0] > 0.5 else 0.0]} for a in acts]
    )


@mutant("CAL-006", "PRED-025")
def sends_a_tensor_in_every_task() -> None:
    """A policy that needs no tensors pays for them in every turn."""

    def wrong(observation: dict[str, Any]) -> None:
        tensor = {"dtype": "float64", "shape": [2, 3], "data": bytes(48)}
        observation["tensors"].setdefault("float64", tensor)

    spoil_observations(wrong)


@mutant("CAL-007")
def begins_an_episode_where_the_last_one_ended() -> None:
    """A policy sees the past of another episode."""
    right_begin, right_play = SimulatorHandle.begin, SimulatorHandle.play
    last: dict[int, list[float]] = {}

    async def begin(self: Any, *arguments: Any, **named: Any) -> Any:
        report = await right_begin(self, *arguments, **named)
        state = report.observation["state"]
        state["vector"] = last.get(id(self), state["vector"])
        return report

    async def play(self: Any, actions: Actions, **named: Any) -> Any:
        last[id(self)] = list(actions[-1]["vector"])
        return await right_play(self, actions, **named)

    put(SimulatorHandle, "begin", begin)
    put(SimulatorHandle, "play", play)


@mutant("CAL-007", "PRED-018")
def ignores_clipped_values_behind_the_first_action() -> None:
    """A robot that is sent to its limit stops half way."""

    def limited(action: Any) -> Any:
        clipped = [0.0 if abs(v) == 1 else v for v in action["clipped"]]
        return {**action, "clipped": clipped}

    spoil_play(lambda acts: [*acts[:1], *map(limited, acts[1:])])


@mutant("CAL-008")
def rounds_rewards() -> None:
    """Learning curves have steps."""
    spoil_play(
        after=lambda played, _: changed(
            played, rewards=[round(reward, 9) for reward in played.rewards]
        )
    )


@mutant("CAL-009")
def rounds_commanded_faults() -> None:
    """A fault that was not commanded disturbs the run."""
    spoil_play(lambda acts: [{**a, "fault": [round(a["fault"][0])]} for a in acts])


@mutant("CAL-010", "PRED-017")
def breaks_down_in_every_task() -> None:
    """An action that has no meaning in a task disturbs the run."""
    right_begin, right_play = SimulatorHandle.begin, SimulatorHandle.play
    tasks: dict[int, str] = {}

    async def begin(self: Any, task: str, *arguments: Any, **named: Any) -> Any:
        tasks[id(self)] = task
        return await right_begin(self, task, *arguments, **named)

    async def play(self: Any, actions: Actions, **named: Any) -> Any:
        if tasks[id(self)] != "fault" and any(a["fault"][0] >= 1 for a in actions):
            raise SimulatorFault("it was commanded to break")
        return await right_play(self, actions, **named)

    put(SimulatorHandle, "begin", begin)
    put(SimulatorHandle, "play", play)


@mutant("CAL-011")
def scores_echo_by_its_commanded_score() -> None:
    """A failure counts for more than nothing."""
    found = calibration.BENCHMARKS["calibration"]

    def wrong(images: Any) -> dict[str, Any]:
        return {**images, "success_scored_tasks": ["count", "delay", "fault"]}

    broken = replace(found, settings=wrong)
    put(
        benchmark_registry,
        "_BENCHMARKS",
        benchmark_registry._BENCHMARKS | {"calibration": broken},
    )


@mutant("CAL-011")
def scores_a_goal_that_was_lost_again() -> None:
    """With the rule `last_step` a failure counts as a success in the score."""

    def wrong(played: Any, actions: Actions) -> Any:
        executed = actions[: played.executed]
        held = any(action["success"][0] == 1 for action in executed)
        is_failure = played.ended and not played.score and executed[-1]["score"][0] > 0
        return changed(played, score=1.0) if held and is_failure else played

    spoil_play(after=wrong)


@mutant("CAL-007", "ENC-003", "ENC-012")
def sends_numbers_in_single_precision() -> None:
    """All positions are slightly wrong."""
    import numpy as np

    def wrong(observation: dict[str, Any]) -> None:
        vector = observation["state"]["vector"]
        observation["state"]["vector"] = [
            float(np.float32(v)) if abs(v) < 1e38 else v for v in vector
        ]

    spoil_observations(wrong)


@mutant("ENC-004")
def sends_tensors_big_endian() -> None:
    """Every tensor is noise on a little-endian machine."""

    def wrong(observation: dict[str, Any]) -> None:
        for tensor in observation["tensors"].values():
            tensor["data"] = bytes(tensor["data"])[::-1]

    spoil_observations(wrong)


@mutant("ENC-005", "PRED-012")
def sends_images_upside_down() -> None:
    """A policy sees every image upside down."""

    def wrong(image: dict[str, Any]) -> None:
        row = image["width"] * image["channels"]
        data = bytes(image["data"])
        rows = [data[i : i + row] for i in range(0, len(data), row)]
        image["data"] = b"".join(reversed(rows))

    spoil_image(wrong, "raw")


def _reencode(image: dict[str, Any], change: Callable[[Any], Any]) -> None:
    import io

    from PIL import Image

    picture = change(Image.open(io.BytesIO(bytes(image["data"]))))
    out = io.BytesIO()
    picture.save(out, image["codec"].upper())
    image["data"] = out.getvalue()


@mutant("ENC-006")
def loses_colours_in_png() -> None:
    """A lossless image has lost information."""

    def wrong(image: dict[str, Any]) -> None:
        _reencode(image, lambda picture: picture.convert("L").convert("RGB"))

    spoil_image(wrong, "png")


@mutant("ENC-007")
def halves_the_size_of_jpeg() -> None:
    """A policy is evaluated on images of another size than chosen."""

    def wrong(image: dict[str, Any]) -> None:
        _reencode(image, lambda p: p.resize((p.width // 2, p.height // 2)))

    spoil_image(wrong, "jpeg")


@mutant("CAL-004")
def sleeps_for_whole_milliseconds() -> None:
    """Many short delays come to half of what they should be."""

    def wrong(delay: list[float]) -> list[float]:
        return [int(delay[0] * 1000) / 1000]

    spoil_play(lambda acts: [{**a, "delay_s": wrong(a["delay_s"])} for a in acts])
