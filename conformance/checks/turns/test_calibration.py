"""The benchmark `calibration` as calibration.md defines it (CAL)."""

import math
from collections.abc import Mapping
from typing import Any

from conformance.checks.support.expected_states import CLOCK_TOLERANCE
from conformance.checks.support.given_states import count, submit_and_attach
from conformance.checks.support.long_run import long_run
from conformance.client.check_context import CheckContext
from conformance.client.run_client import WorkerClient
from conformance.oracle.calibration_benchmark import (
    ACTIONS,
    IMAGES,
    SHAPE,
    STATES,
    TASKS,
    TENSORS,
    Vector,
    spaces_of,
)
from conformance.oracle.expected_manifest import digest_of, manifest_of
from conformance.runner.requirement import background, on_long_run, requirement
from conformance.verdicts import expect

# The last double below 1, the smallest of all, and some that no binary fraction holds.
BELOW_1 = math.nextafter(1, 0)
SCORES = [1 / 3, 0.1, BELOW_1, 5e-324, 0.7, 1.0, 0.0]
# So long would a turn be in which a delay is executed that has no effect.
NO_DELAY_S = [2.0] * 4
SIZES = [{"width": 16, "height": 12}, {"width": 64, "height": 48}]


def expect_declared_rules(context: CheckContext, benchmark: dict[str, Any]) -> None:
    """Expect the declared limits, lists and options of the benchmark."""
    offered = context.tasks(*TASKS)
    tasks = [task for task in benchmark["tasks"] if task in offered]
    expect.equal(tasks, offered, "tasks")
    for member, value in SHAPE.items():
        expect.equal(benchmark[member], value, member)
    expect.equal(benchmark["max_chunk"], context.limits["max_chunk"], "max_chunk")
    if not context.offers("observations"):
        return
    sizes, codecs = benchmark["image_sizes"], benchmark["image_codecs"]
    expect.equal(sizes[0], SIZES[0], "the first of image_sizes")
    expect.true(SIZES[1] in sizes, f"{SIZES[1]} in image_sizes", sizes)
    expect.equal(codecs[0], "raw", "the first of image_codecs")
    announced = sorted(context.service["image_codecs"])
    expect.equal(sorted(codecs), announced, "image_codecs")


def expect_vectors(
    shown: dict[str, Any], vectors: dict[str, Vector], kind: str
) -> None:
    """Expect the names of vectors, and the size, range and only part of each."""
    expect.equal(sorted(shown), sorted(vectors), f"names of each {kind}")
    for name, due in spaces_of(vectors).items():
        space, what = shown[name], f"of the {kind} {name}"
        for member in ("size", "out_of_range", "minimum", "maximum"):
            expect.equal(space.get(member), due.get(member), f"{member} {what}")
        expect.equal(sorted(space["parts"]), ["all"], f"names of the parts {what}")
        expect.members(
            space["parts"]["all"], due["parts"]["all"], f"of the part {what}"
        )


def expect_declared_spaces(context: CheckContext, benchmark: dict[str, Any]) -> None:
    """Expect the names, sizes and ranges of actions and observations."""
    observed = benchmark["observation_space"]
    expect_vectors(benchmark["action_space"], ACTIONS, "action")
    expect_vectors(observed["state"], STATES, "state")
    for kind, due in (("images", IMAGES), ("tensors", TENSORS)):
        if context.offers("observations"):
            expect.equal(sorted(observed[kind]), sorted(due), f"names of the {kind}")
            for name, members in due.items():
                expect.members(observed[kind][name], members, f"of {name}")


@on_long_run
@requirement("CAL-001")
def test_cal_001_has_the_shape_of_calibration_md(context: CheckContext) -> None:
    """The description of the benchmark, a run with one episode of every task, and one
    with a hundred and eighty episodes. Expect rules, spaces, tasks, splits, seeds and
    options of calibration.md."""
    benchmark = expect.ok(context.call("get_benchmark", benchmark_id="calibration"))
    expect_declared_rules(context, benchmark)
    expect_declared_spaces(context, benchmark)
    tasks = context.tasks(*TASKS)
    worker = submit_and_attach(context, *tasks, max_steps=4)
    results = [*long_run(context).results()]
    for _ in tasks:
        task = worker.turn["episode"]["task"]
        instruction = worker.turn["episode"]["instruction"]
        expect.equal(instruction, f"Calibration task {task}.", "instruction")
        results.append(worker.play()["episode_result"])
    for result in results:
        index = result["index"]
        expect.equal(result["seed"], index + 1000, f"seed of episode {index}")


def calibration_manifest(
    context: CheckContext, benchmark: dict[str, Any], **options: Any
) -> dict[str, Any]:
    """Give the manifest that calibration.md defines for these options.

    benchmark: as it is described, which says what a Core server leaves out.
    """
    of_echo, observed = {"tasks": ["echo"]}, benchmark["observation_space"]
    images = {name: image | of_echo for name, image in IMAGES.items()}
    tensors = {name: tensor | of_echo for name, tensor in TENSORS.items()}
    tasks = [*TASKS]
    if not context.offers("observations"):
        images = {name: images[name] for name in images if name in observed["images"]}
        tensors = {n: tensors[n] for n in tensors if n in observed["tensors"]}
    if not context.offers("faults"):
        tasks = [task for task in TASKS if task in benchmark["tasks"]]
    spaces = {"state": spaces_of(STATES), "images": images, "tensors": tensors}
    episodes = [
        {"task": task, "split": ("even", "odd")[index % 2], "seed": index + 1000}
        for index, task in enumerate(options.get("tasks", ["score"]))
    ]
    described = SHAPE | {name: options[name] for name in options if name in SHAPE}
    return manifest_of(
        described
        | {"benchmark_id": "calibration", "tasks": tasks, "episodes": episodes}
        | {"action_space": spaces_of(ACTIONS), "observation_space": spaces}
    )


@requirement("BEN-006")
def test_ben_006_digest_is_that_of_the_manifest(context: CheckContext) -> None:
    """The description of `calibration`, and runs with several options. Expect the
    SHA-256 of the canonical bytes of the manifest of calibration.md."""
    benchmark = expect.ok(context.call("get_benchmark", benchmark_id="calibration"))
    expected = calibration_manifest(context, benchmark)
    shown = manifest_of(benchmark | {"episodes": expected["episodes"]})
    names = sorted({*expected, *shown})
    wrong = [name for name in names if shown.get(name) != expected.get(name)]
    what = f"manifest_sha256; description differs in {wrong}"
    tasks = context.tasks(*TASKS)
    more = {"max_attempts": 1} if context.offers("sessions") else {}
    more |= {"max_faults": 2} if context.offers("faults") else {}
    for options in (
        {},
        {"tasks": tasks, "max_steps": 10000, "success_rule": "last_step"},
        {"tasks": [tasks[-1]] * 300} | more,
    ):
        body = context.submit_body(options=options)
        run = context.adopt(expect.ok(context.call("submit_run", json=body), 201))
        digest = digest_of(calibration_manifest(context, benchmark, **options))
        expect.equal(run.body["manifest_sha256"], digest, f"{what}, run of {options}")


@requirement("CAL-002", "CAL-011")
def test_cal_002_scores_of_each_task(context: CheckContext) -> None:
    """Rising and falling scores, with and without success, in one chunk and in many.
    Every task but `score` is played with success and a low score, without success and a
    high score, and with a `success` just below 1; by both rules, with a success that is
    over in the last step. Expect the last score in the result of `score`, and elsewhere
    1 for each success, and 0 for each failure."""
    patterns = [[0.9, 0.25], [0.0, 0.1, 0.75], [1.0, 0.0], [0.5]]
    # Neighbours of short numbers, which a rounded number is not.
    patterns += [[1 / 3], [0.1 + 0.2], [math.nextafter(1, 0)], [math.nextafter(0, 1)]]
    patterns += [[score] for score in SCORES]
    worker = submit_and_attach(context, *["score"] * len(patterns))
    for index, pattern in enumerate(patterns):
        actions = [context.action(score=score, success=index % 2) for score in pattern]
        actions[-1]["values"]["end"] = [1]
        for chunk in [actions] if index < 2 else [[action] for action in actions]:
            worker.predict(*chunk)
    worker.run.results()
    others = [task for task in context.tasks(*TASKS) if task != "score"]
    worker = submit_and_attach(context, *others * 3)
    for number in range(3 * len(others)):
        success, score = ((1, 0.25), (0, 0.75), (BELOW_1, 1.0))[number % 3]
        worker.play(score=score, success=success)
    worker.run.results()
    for rule in ("any_step", "last_step"):
        worker = submit_and_attach(context, *others, success_rule=rule)
        for _ in others:
            worker.predict(context.action(success=1), context.action(score=0.5, end=1))


@requirement("CAL-003", "CAL-005", "CAL-007")
def test_cal_003_counts_in_every_task(context: CheckContext) -> None:
    """Every task is played in chunks, with `end` just below 1, and to an end alone and
    last; attempts begin after an end, a detach and a fault. Then one has more than 256
    actions, in the longest chunks. Expect `count` to grow by the number of actions, an
    end with `end` 1 alone, the vectors of the last executed action, and zeros at each
    beginning."""
    tasks, attaches_again = context.tasks(*TASKS), context.offers("sessions")
    max_attempts = 3 if attaches_again else None
    worker = submit_and_attach(
        context, *tasks, *tasks, max_steps=10000, max_attempts=max_attempts
    )
    first = context.action(vector=[float(n) for n in range(1, 9)], clipped=[0.5, -3])
    last = context.action(vector=[-n / 3 for n in range(8)], clipped=[2, 1 / 3])
    for task in tasks:
        worker.predict(first, last)
        if attaches_again:
            worker.detach()
            worker.attach()
        worker.predict(first)
        if task == "fault":
            worker.predict(context.action(fault=1))
        worker.predict(first, {"values": last["values"] | {"end": [1.0]}})
    for _ in tasks:
        for end in (0.999, BELOW_1, 1):
            worker.predict(context.action(end=end))
    worker = submit_and_attach(context, "count", max_steps=10000)
    chunk = [context.action()] * min(130, context.benchmark["max_chunk"])
    for _ in range(len(chunk), 257 + len(chunk), len(chunk)):
        worker.predict(*chunk)
    worker.play()


@requirement("CAL-004")
@background
def test_cal_004_delay_is_executed(context: CheckContext) -> None:
    """Two steps of 0.2 s in one turn, one of 0.3 s, and many of 0.9 ms and of 0.4 ms.
    Expect the turns to take at least as long."""
    worker = submit_and_attach(context, "delay", max_steps=1000)
    many = min(64, context.limits["max_chunk"])
    for chunk_s in ([0.2, 0.2], [0.3], [0.0009] * many, [0.0004] * many):
        worker.predict(*[context.action(delay_s=delay_s) for delay_s in chunk_s])


def expect_pictures(observation: Mapping[str, Any], task: str) -> None:
    """Expect the image and the tensors in the task `echo`, and none elsewhere."""
    for kind, names in (("images", IMAGES), ("tensors", TENSORS)):
        named = [name for name in names if name in observation[kind]]
        expected = [*names] if task == "echo" else []
        expect.equal(named, expected, f"{kind} of an observation in {task}")


@requirement("CAL-006")
def test_cal_006_only_echo_has_images_and_tensors(context: CheckContext) -> None:
    """Every task is played, and all observations are asked for. Expect the image and
    the tensors in each one of `echo`, and in no other."""
    worker = submit_and_attach(context, *TASKS, "echo", "score")
    while not worker.turn["done"]:
        task = worker.turn["episode"]["task"]
        expect_pictures(worker.turn["observation"], task)
        turn = worker.predict(*[context.action()] * 2, observe="all")
        for observation in (turn["observation"], *turn["observations"]):
            expect_pictures(observation, task)
        worker.play()


@requirement("CAL-008")
def test_cal_008_reward_is_the_commanded_score(context: CheckContext) -> None:
    """Scores that lose bits easily are commanded in every task, one by one, in chunks,
    and in every encoding. Expect each of them as the reward of its step."""
    tasks = context.tasks(*TASKS)
    worker = submit_and_attach(context, *tasks, max_steps=1000)
    actions = [context.action(score=score) for score in SCORES]
    for task in tasks:
        for is_msgpack in (False, True) if context.speaks_msgpack else (False,):
            for first in range(0, len(SCORES), 4):
                worker.predict(*actions[first : first + 4], msgpack=is_msgpack)
        rewards = worker.predict(context.action(score=-0.0))["rewards"]
        signs = [math.copysign(1, reward) for reward in rewards]
        expect.equal(signs, [-1], f"the sign of the reward -0 in {task}")
        worker.predict(context.action(score=0.3, end=1))
    worker = submit_and_attach(context, "score", max_steps=2)
    worker.predict(*[context.action(score=0.7)] * 2)


@requirement("CAL-009")
def test_cal_009_fault_below_2_is_not_rounded(context: CheckContext) -> None:
    """In the task `fault` values just below 1, and between 1 and 2. Expect steps as any
    other; then faults of a run that goes on."""
    worker = submit_and_attach(context, "fault", max_faults=3)
    for fault in (0.5, BELOW_1):
        turn = expect.ok(worker.try_predict(context.action(fault=fault)))
        worker.seq += 1
        expect.true("fault" not in turn, f"no fault at {fault}", turn.get("fault"))
    expect.equal(count(turn), [2], "count")
    for fault in (1.5, math.nextafter(2, 0)):
        turn = expect.ok(worker.try_predict(context.action(fault=fault)))
        worker.seq += 1
        expect.true("fault" in turn, f"a fault at {fault}", sorted(turn))
    worker.play(success=1)


def expect_no_effect(worker: WorkerClient, task: str, **values: float) -> None:
    """Expect a chunk to be executed as if these values were 0."""
    context = worker.run.context
    answer = worker.try_predict(*[context.action(**values)] * len(NO_DELAY_S))
    turn = expect.ok(answer)
    worker.seq += 1
    expect.true("fault" not in turn, f"no fault in {task}", turn.get("fault"))
    expect.equal(turn["executed_steps"], len(NO_DELAY_S), f"steps in {task}")
    limit_s, what = CLOCK_TOLERANCE * sum(NO_DELAY_S), f"a turn in {task}"
    expect.in_time(answer.elapsed_s, limit_s, what, may_be_noise=False)


@requirement("CAL-010")
def test_cal_010_delay_and_fault_are_ignored_elsewhere(context: CheckContext) -> None:
    """Delays are commanded in every other task, and faults in every other task. Expect
    all actions executed, at once and without a fault."""
    tasks = context.tasks(*TASKS)
    worker = submit_and_attach(context, *tasks, max_steps=100)
    for task in tasks:
        if task != "delay":
            expect_no_effect(worker, task, delay_s=NO_DELAY_S[0])
        if task != "fault":
            for fault in (1, 2):
                expect_no_effect(worker, task, fault=fault)
        worker.play()
