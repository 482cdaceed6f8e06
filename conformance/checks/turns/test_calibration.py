"""The benchmark `calibration` as calibration.md defines it (CAL)."""

import math
from typing import Any

from conformance.checks.support.given_states import count, submit_and_attach
from conformance.client.check_context import CheckContext
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect

TASKS = ["score", "count", "echo", "delay", "fault"]
RULES = {
    "version": "1",
    "control_rate_hz": 10,
    "max_steps": 10,
    "max_attempts": 3,
    "max_faults": 3,
    "success_rule": "any_step",
    "episodes_total": 1,
    "tasks": TASKS,
    "splits": ["even", "odd"],
}
# name: size, unit, minimum, maximum, out of range
ACTIONS: dict[str, tuple[int, str, list[int] | None, list[int] | None, str]] = {
    "score": (1, "1", [0], [1], "refuse"),
    "success": (1, "1", [0], [1], "refuse"),
    "end": (1, "1", [0], [1], "refuse"),
    "delay_s": (1, "s", [0], [5], "refuse"),
    "fault": (1, "1", [0], [2], "refuse"),
    "vector": (8, "1", None, None, "unbounded"),
    "clipped": (2, "1", [-1, -1], [1, 1], "clip"),
}
STATES = {"count": 1, "vector": 8, "clipped": 2}
DTYPES = ["bool", "float16", "float32", "float64"]
DTYPES += [f"{sign}int{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64)]
SIZES = [{"width": 16, "height": 12}, {"width": 64, "height": 48}]


def expect_declared_rules(context: CheckContext, benchmark: dict[str, Any]) -> None:
    """Expect the declared limits, lists and options of the benchmark."""
    for member, value in RULES.items():
        expect.equal(benchmark[member], value, member)
    expect.equal(benchmark["max_chunk"], context.limits["max_chunk"], "max_chunk")
    sizes, codecs = benchmark["image_sizes"], benchmark["image_codecs"]
    expect.equal(sizes[0], SIZES[0], "the first of image_sizes")
    expect.true(SIZES[1] in sizes, f"{SIZES[1]} in image_sizes", sizes)
    expect.equal(codecs[0], "raw", "the first of image_codecs")
    announced = sorted(context.service["image_codecs"])
    expect.equal(sorted(codecs), announced, "image_codecs")


def expect_declared_spaces(benchmark: dict[str, Any]) -> None:
    """Expect the names, sizes and ranges of actions and observations."""
    actions, seen = benchmark["action_space"], benchmark["observation_space"]
    expect.equal(sorted(actions), sorted(ACTIONS), "names of the actions")
    plain = {"rotation": "none", "frame": "none", "relative": False}
    for name, (size, unit, low, high, beyond) in ACTIONS.items():
        action = actions[name]
        members = plain | {"size": size, "unit": unit, "out_of_range": beyond}
        for member, value in members.items():
            expect.equal(action[member], value, f"{member} of the action {name}")
        bounds = [action.get("minimum"), action.get("maximum")]
        expect.equal(bounds, [low, high], f"bounds of the action {name}")
    sizes = {name: state["size"] for name, state in seen["state"].items()}
    expect.equal(sizes, STATES, "sizes of the states")
    channels = {name: image["channels"] for name, image in seen["images"].items()}
    expect.equal(channels, {"pattern": 3}, "channels of the images")
    tensors = {n: (t["dtype"], t["shape"]) for n, t in seen["tensors"].items()}
    expected: dict[str, tuple[str, list[int]]] = {d: (d, [2, 3]) for d in DTYPES}
    expected["empty"] = ("float64", [0, 3])
    expect.equal(tensors, expected, "tensors")


@requirement("CAL-001")
def test_cal_001_has_the_shape_of_calibration_md(context: CheckContext) -> None:
    """The description of the benchmark, and a run with one episode of every task.

    Expect rules, spaces, tasks, splits, seeds and options of calibration.md.
    """
    answer = context.call("get_benchmark", benchmark_id="calibration")
    benchmark = expect.ok(answer)
    expect_declared_rules(context, benchmark)
    expect_declared_spaces(benchmark)
    worker = submit_and_attach(context, *TASKS, max_steps=4)
    for _ in TASKS:
        view = worker.turn["episode"]
        index, task = view["index"], view["task"]
        expect.equal(task, TASKS[index], f"task of episode {index}")
        expect.equal(view["max_steps"], 4, "max_steps")
        expect.equal(view["instruction"], f"Calibration task {task}.", "instruction")
        result = worker.play()["episode_result"]
        expect.equal(result["split"], ("even", "odd")[index % 2], "split")
        expect.equal(result["seed"], index + 1000, "seed")


@requirement("CAL-002")
def test_cal_002_score_is_the_last_commanded(context: CheckContext) -> None:
    """Rising and falling scores, with and without success, in one chunk and in many.

    Expect the last one in the result.
    """
    patterns = [[0.9, 0.25], [0.0, 0.1, 0.75], [1.0, 0.0], [0.5]]
    # Neighbours of short numbers, which a rounded number is not.
    patterns += [[1 / 3], [0.1 + 0.2], [math.nextafter(1, 0)], [math.nextafter(0, 1)]]
    worker = submit_and_attach(context, *["score"] * len(patterns))
    for index, pattern in enumerate(patterns):
        actions = [context.action(score=score, success=index % 2) for score in pattern]
        actions[-1]["values"]["end"] = [1]
        chunks = [actions] if index < 2 else [[action] for action in actions]
        for chunk in chunks:
            turn = worker.predict(*chunk)
        expect.equal(turn["episode_result"]["score"], pattern[-1], "score")


@requirement("CAL-003")
def test_cal_003_counts_in_every_task(context: CheckContext) -> None:
    """Every task is played, in chunks of one and two actions.

    Expect `count` to begin at 0 and to grow by the number of actions.
    """
    worker = submit_and_attach(context, *TASKS)
    for task in TASKS:
        expect.equal(count(worker.turn), [0], f"count at the beginning of {task}")
        turn = worker.predict(context.action())
        expect.equal(count(turn), [1], f"count after an action of {task}")
        turn = worker.predict(context.action(), context.action())
        expect.equal(count(turn), [3], f"count after three actions of {task}")
        worker.play()


@requirement("CAL-004")
@background
def test_cal_004_delay_is_executed(context: CheckContext) -> None:
    """Two steps of 0.2 s in one turn, then one of 0.3 s.

    Expect the turns to take at least as long.
    """
    worker = submit_and_attach(context, "delay")
    for chunk_s in ([0.2, 0.2], [0.3]):
        chunk = [context.action(delay_s=delay_s) for delay_s in chunk_s]
        answer = worker.try_predict(*chunk)
        expect.require(answer, 200, "predict")
        worker.seq += 1
        least_s = sum(chunk_s)
        expect.true(
            answer.elapsed_s >= least_s, f"a turn of {least_s} s", answer.elapsed_s
        )


@requirement("CAL-005")
def test_cal_005_end_ends_every_task(context: CheckContext) -> None:
    """In every task an action with `end` just below 1, then one with 1.

    Expect the episode to continue after the first, and to terminate with the second.
    """
    worker = submit_and_attach(context, *TASKS)
    for task in TASKS:
        turn = worker.predict(context.action(end=0.999))
        expect.equal(turn["terminated"], False, f"terminated in {task} below 1")
        turn = worker.predict(context.action(end=1))
        expect.equal(turn["terminated"], True, f"terminated in {task}")
        expect.equal(turn["truncated"], False, f"truncated in {task}")
        result = turn["episode_result"]
        expect.equal(result["terminated"], True, f"terminated in the result of {task}")
