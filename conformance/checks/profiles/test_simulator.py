"""Simulators, as an evaluation server starts and asks them (SIM)."""

import itertools
import math
import time
from typing import Any

from conformance.client.check_context import CheckContext
from conformance.runner.requirement import requirement
from conformance.simulator.description_faults import description_faults
from conformance.simulator.picture_file import PictureFile
from conformance.simulator.process_under_test import LENGTH
from conformance.simulator.simulator_client import (
    PROTOCOL,
    STEPS,
    TASKS_MAX,
    Episode,
    SimulatorClient,
    action_of,
    names_of,
    reply_faults,
    simulator,
    socket_path,
    tasks_of,
)
from conformance.specification.tensor_formats import TENSOR_FORMATS, tensor_bytes
from conformance.verdicts import expect
from conformance.verdicts.expect import NotApplicable, SetUpFailed

_SILENCE_S = 0.2
_CLOSE_S, _END_OF_INPUT_S = 5.0, 2.0
_SIZES_MAX = 3
_SCORE_ERROR = 1e-6
_NOWHERE = "of_a_later_version"


def _benchmark(context: CheckContext) -> dict[str, Any]:
    benchmark: dict[str, Any] = context.shared.settings.simulator["benchmark"]
    return benchmark


def _require_deterministic(context: CheckContext) -> None:
    if not _is_deterministic(context):
        raise NotApplicable("the simulator declares that it is not deterministic")


def _require_equal(observed: Episode, expected: Episode, what: str) -> None:
    """Expect two episodes to have equal replies; the first difference is shown."""
    for step, (one, another) in enumerate(zip(observed, expected, strict=False)):
        changed = [n for n in {**one, **another} if one.get(n) != another.get(n)]
        text = f"{', '.join(changed)} differ at step {step}"
        expect.true(not changed, f"equal replies {what}", text)
    expect.equal(len(observed), len(expected), f"the steps {what}")


def _require_repeatable(one: Episode, another: Episode) -> None:
    """Raise SetUpFailed where equal seeds and actions gave other replies.

    A check that compares two episodes says nothing about its rule then.
    """
    if one != another:
        text = "equal seeds and actions give other episodes on this simulator"
        raise SetUpFailed(text, breaks="SIM-011")


def _is_deterministic(context: CheckContext) -> bool:
    return bool(_benchmark(context).get("deterministic", True))


def _play_twice(
    client: SimulatorClient, context: CheckContext, task: str, steps: int = STEPS
) -> Episode:
    """An episode, after the proof that this simulator can be compared with it."""
    seed = context.shared.settings.seed
    first = client.play(task, seed, steps=steps)
    _require_repeatable(client.play(task, seed, steps=steps), first)
    return first


def _call_everything(client: SimulatorClient, task: str, seed: int) -> None:
    client.play(task, seed, observed=True)


@requirement("SIM-001")
def test_sim_001_output_has_frames_alone(context: CheckContext) -> None:
    """Every call is made, with a pause behind each. Expect no byte but the replies."""
    with simulator(context) as client:
        for task in tasks_of(context):
            _call_everything(client, task, context.shared.settings.seed)
        client.call("close")
        rest = client.process.read_rest(_CLOSE_S)
        expect.true(not rest, "no byte that is not part of a reply", rest[:80])


@requirement("SIM-002")
def test_sim_002_each_request_has_one_reply(context: CheckContext) -> None:
    """An episode, then two requests at once. Expect two replies, in their order."""
    with simulator(context) as client:
        client.play(tasks_of(context)[0], 0)
        rest = client.process.read_rest(_SILENCE_S)
        expect.true(not rest, "one reply to each request", f"{rest[:80]!r} behind it")
        client.send("describe", protocols=[PROTOCOL])
        client.send("reset", task=tasks_of(context)[0], seed=0, split="test")
        expect.true("benchmark" in client.receive("describe"), "the description first")
        expect.true("instruction" in client.receive("reset"), "the episode then")
        rest = client.process.read_rest(_SILENCE_S)
        expect.true(not rest, "two replies to two requests", f"{rest[:80]!r} behind")


@requirement("SIM-003")
def test_sim_003_replies_are_in_time(context: CheckContext) -> None:
    """Every call is made. Expect each reply within its limit."""
    with simulator(context) as client:
        for task in tasks_of(context):
            _call_everything(client, task, context.shared.settings.seed)


@requirement("SIM-004")
def test_sim_004_replies_have_their_members(context: CheckContext) -> None:
    """Every call is made. Expect the members of each reply, with their types."""
    with simulator(context) as client:
        for task in tasks_of(context):
            for reply in client.play(task, 0, observed=True):
                call = "step" if "success" in reply else "reset"
                faults = list(reply_faults(call, reply))
                expect.true(not faults, f"the members of a reply to {call}", faults)
        if _benchmark(context).get("digest"):
            client.call("digest")
        client.call("close")


@requirement("SIM-005")
def test_sim_005_unknown_call_is_a_fault(context: CheckContext) -> None:
    """An unknown call, then a known one. Expect a fault, then a reply."""
    with simulator(context) as client:
        reply = client.ask(_NOWHERE)
        expect.true(isinstance(reply.get("fault"), str), "a fault with a text", reply)
        client.reset(tasks_of(context)[0], 0)


@requirement("SIM-006")
def test_sim_006_unknown_members_are_ignored(context: CheckContext) -> None:
    """Every request has a member more. Expect the same replies as without."""
    task, more = tasks_of(context)[0], {_NOWHERE: [1, {"a": None}]}
    with simulator(context) as client:
        if _is_deterministic(context):
            _play_twice(client, context, task, steps=1)
        reply = client.ask("describe", protocols=[PROTOCOL], **more)
        expect.true("fault" not in reply, "a description", reply)
        split = (_benchmark(context).get("splits") or [{"name": "test"}])[0]["name"]
        reply = client.ask("reset", task=task, seed=0, split=split, **more)
        expect.true("fault" not in reply, "an episode", reply)
        first = client.step(task, 0)
        client.reset(task, 0)
        action = action_of(_benchmark(context), task, 0)
        reply = client.ask("step", action=action, **more)
        expect.true("fault" not in reply, "a step", reply)
        if _is_deterministic(context):
            expect.equal(reply, first, "the step")


@requirement("SIM-007")
def test_sim_007_protocol_is_one_of_those_offered(context: CheckContext) -> None:
    """`describe` offers one protocol, and two. Expect the one that this document is."""
    with simulator(context) as client:
        for offered in ([PROTOCOL], [PROTOCOL, 99]):
            reply = client.call("describe", protocols=offered)
            expect.equal(reply["protocol"], PROTOCOL, "protocol")


@requirement("SIM-008")
def test_sim_008_description_is_whole(context: CheckContext) -> None:
    """Expect the required members, and spaces that fit their schemas."""
    faults = description_faults(_benchmark(context))
    expect.true(not faults, "a description with all that is required", faults[:3])


@requirement("SIM-009")
def test_sim_009_description_is_always_the_same(context: CheckContext) -> None:
    """Two processes are asked twice each. Expect four equal descriptions."""
    first = _benchmark(context)
    for _ in range(2):
        with simulator(context) as client:
            expect.equal(client.describe(), first, "the description")


@requirement("SIM-010")
def test_sim_010_reset_begins_an_episode_at_any_time(context: CheckContext) -> None:
    """`reset` follows a reset, a step and another task. Expect each to begin anew."""
    with simulator(context) as client:
        for task in _benchmark(context)["tasks"][:TASKS_MAX]:
            begun = client.reset(task, 1)
            second = client.reset(task, 1)
            expect.equal(second.keys(), begun.keys(), "the reply")
            client.play(task, 1, steps=STEPS // 4)
            again = client.reset(task, 1)
            if _is_deterministic(context):
                _require_repeatable([second], [begun])
                expect.equal(again, begun, "the beginning after a step")


@requirement("SIM-011")
def test_sim_011_equal_seeds_are_equal_episodes(context: CheckContext) -> None:
    """Each task with a seed, then with others, then with that seed again. Expect the
    first and the last episode to have equal replies."""
    _require_deterministic(context)
    seed, tasks = context.shared.settings.seed, tasks_of(context)
    with simulator(context) as client:
        first = {task: client.play(task, seed) for task in tasks}
        for task in tasks:
            client.play(task, seed + 1, steps=STEPS // 2)
        for task in tasks:
            _require_equal(client.play(task, seed), first[task], "for equal seeds")


@requirement("SIM-012")
def test_sim_012_processes_are_equal(context: CheckContext) -> None:
    """Two processes play the same, and draw it. Expect equal replies."""
    _require_deterministic(context)
    seed, episodes = context.shared.settings.seed, []
    for _ in range(2):
        with simulator(context) as client:
            episodes.append(client.play(tasks_of(context)[-1], seed, observed=True))
    _require_equal(episodes[1], episodes[0], "in two processes")


@requirement("SIM-013")
def test_sim_013_unknown_task_is_unplayable(context: CheckContext) -> None:
    """An unknown task, then another. Expect an unplayable fault, then a reply."""
    with simulator(context) as client:
        reply = client.ask("reset", task=_NOWHERE, seed=0, split="test")
        is_fault = isinstance(reply.get("fault"), str)
        is_whole = is_fault and reply.get("unplayable") is True
        expect.true(is_whole, "a fault that is unplayable", reply)
        client.reset(tasks_of(context)[0], 0)


@requirement("SIM-014")
def test_sim_014_nothing_is_played_before_a_reset(context: CheckContext) -> None:
    """`step`, `observe` and `digest` come first. Expect faults, then an episode."""
    task = tasks_of(context)[0]
    sizes = {"images": [], "tensors": [], "width": 64, "height": 64}
    action = action_of(_benchmark(context), task, 0)
    for call, members in (
        ("step", {"action": action}),
        ("observe", sizes),
        ("digest", {}),
    ):
        with simulator(context) as client:
            reply = client.ask(call, **members)
            expect.true("fault" in reply, f"a fault of {call}", reply)
            client.reset(task, 0)
            client.step(task, 0)


@requirement("SIM-015")
def test_sim_015_states_fit_the_space(context: CheckContext) -> None:
    """Every task is played. Expect declared entries and sizes, and finite numbers."""
    with simulator(context) as client:
        for task in tasks_of(context):
            spaces = _benchmark(context)["observation_space"].get("state", {})
            sizes = {
                name: spaces[name]["size"]
                for name in names_of(_benchmark(context), "state", task)
            }
            for reply in client.play(task, context.shared.settings.seed):
                state = reply["state"]
                seen = {name: len(numbers) for name, numbers in state.items()}
                expect.equal(seen, sizes, "the sizes of the state")
                numbers = [number for vector in state.values() for number in vector]
                expect.true(all(map(math.isfinite, numbers)), "finite numbers", state)


@requirement("SIM-016")
def test_sim_016_rewards_and_scores_are_numbers(context: CheckContext) -> None:
    """Every task is played. Expect finite rewards, and scores from 0 to 1."""
    is_graded = _benchmark(context).get("graded", False)
    with simulator(context) as client:
        for task in tasks_of(context):
            for step in client.play(task, context.shared.settings.seed)[1:]:
                is_finite = math.isfinite(step.get("reward", 0))
                expect.true(is_finite, "a finite reward", step)
                score = step.get("score", None if is_graded else 0)
                is_right = score is not None and 0 <= score <= 1
                expect.true(is_right or not is_graded, "a score from 0 to 1", score)


@requirement("SIM-037")
def test_sim_037_scores_count_the_stages(context: CheckContext) -> None:
    """Every task with stages is played. Expect scores that count them and the goal."""
    if not _benchmark(context).get("graded"):
        raise NotApplicable("the benchmark is not graded: the score is the success")
    has_stages = False
    with simulator(context) as client:
        for task in tasks_of(context):
            begun, *steps = client.play(task, context.shared.settings.seed)
            whole = len(begun.get("stages", ())) + 1
            has_stages = has_stages or whole > 1
            for step in steps if whole > 1 else ():
                score = step.get("score")
                if score is None or not 0 <= score <= 1:
                    client.broken("SIM-016", "a score from 0 to 1", str(score))
                count = min(round(score * whole), whole - 1)
                right = 1.0 if step["success"] else count / whole
                text = f"k/{whole}, and 1 with success alone"
                expect.true(abs(score - right) <= _SCORE_ERROR, text, step)
    if not has_stages:
        raise NotApplicable("no task of the simulator has stages")


@requirement("SIM-017")
def test_sim_017_images_are_as_requested(context: CheckContext) -> None:
    """Images are requested in each size, then one by one, then none. Expect those and
    no others, in their size, with their channels and bytes."""
    benchmark = _benchmark(context)
    spaces = benchmark["observation_space"].get("images", {})
    if not spaces:
        raise NotApplicable("the simulator has no images")
    with simulator(context) as client:
        for task in tasks_of(context):
            names = names_of(benchmark, "images", task)
            client.reset(task, 0)
            for size in benchmark["image_sizes"][:_SIZES_MAX]:
                for wanted in (names, *([name] for name in names), []):
                    seen = client.call("observe", images=wanted, tensors=[], **size)
                    images = seen.get("images", {})
                    expect.equal(sorted(images), sorted(wanted), "the images")
                    for name, image in images.items():
                        shape = [
                            size["height"],
                            size["width"],
                            spaces[name]["channels"],
                        ]
                        expect.equal(image["shape"], shape, f"the shape of {name}")
                        expect.equal(len(image["data"]), math.prod(shape), "its bytes")


@requirement("SIM-018")
def test_sim_018_tensors_are_as_declared(context: CheckContext) -> None:
    """Tensors are requested, then none. Expect those, as declared, and no others."""
    spaces = _benchmark(context)["observation_space"].get("tensors", {})
    if not spaces:
        raise NotApplicable("the simulator has no tensors")
    with simulator(context) as client:
        for task in tasks_of(context):
            client.reset(task, 0)
            for wanted in (names_of(_benchmark(context), "tensors", task), []):
                size = {"width": 64, "height": 64}
                seen = client.call("observe", images=[], tensors=wanted, **size)
                tensors = seen.get("tensors", {})
                expect.equal(sorted(tensors), sorted(wanted), "the tensors")
                for name, tensor in tensors.items():
                    space = spaces[name]
                    expect.true(space["dtype"] in TENSOR_FORMATS, "a dtype", space)
                    expect.equal(tensor["dtype"], space["dtype"], f"dtype of {name}")
                    expect.equal(tensor["shape"], space["shape"], f"shape of {name}")
                    expect.equal(len(tensor["data"]), tensor_bytes(space), "its bytes")


@requirement("SIM-019")
def test_sim_019_to_observe_changes_nothing(context: CheckContext) -> None:
    """An episode is observed twice at each step, and played again without. Expect equal
    observations, and equal states in both."""
    task, seed = tasks_of(context)[0], context.shared.settings.seed
    with simulator(context) as client:
        plain = (
            _play_twice(client, context, task) if _is_deterministic(context) else None
        )
        watched = [client.reset(task, seed)]
        for index in range(STEPS):
            first = client.observe(task)
            expect.equal(client.observe(task), first, "the observation again")
            if watched[-1].get("terminated"):
                break
            watched.append(client.step(task, index))
        if plain is not None:
            _require_equal(watched, plain, "with observations as without")


def _without_digests(played: Episode) -> Episode:
    return [{n: v for n, v in reply.items() if n != "digest"} for reply in played]


@requirement("SIM-020")
def test_sim_020_digests_follow_the_state(context: CheckContext) -> None:
    """An episode is played twice. Expect equal digests, and others for other states."""
    if not _benchmark(context).get("digest"):
        raise NotApplicable("the simulator declares no digests")
    task, seed = tasks_of(context)[0], context.shared.settings.seed
    with simulator(context) as client:
        first = client.play(task, seed, digested=True)
        if _is_deterministic(context):
            again = client.play(task, seed, digested=True)
            _require_repeatable(*map(_without_digests, (again, first)))
            digests = [reply["digest"] for reply in first]
            expect.equal([r["digest"] for r in again], digests, "the digests again")
        for before, after in itertools.pairwise(first):
            if before["state"] != after["state"]:
                is_other = before["digest"] != after["digest"]
                expect.true(is_other, "another digest after the state has changed")


@requirement("SIM-021")
def test_sim_021_images_are_written_to_their_offsets(context: CheckContext) -> None:
    """Images are requested as data, and into two files one after the other. Expect the
    pixels of the data at each offset, and nothing beside them."""
    if not _benchmark(context).get("shared_memory"):
        raise NotApplicable("the simulator declares no shared memory")
    task = tasks_of(context)[0]
    with simulator(context) as client:
        client.reset(task, 0)
        images = client.observe(task)["images"]
        for number in (1, 2):
            memory = PictureFile(number, {n: len(i["data"]) for n, i in images.items()})
            with memory:
                written = client.observe(task, memory=memory.offered())["images"]
                expected = {n: i["data"] for n, i in images.items()}
                sent = {n: i["data"] for n, i in written.items() if "data" in i}
                faults = memory.faults(expected.keys() - sent.keys(), expected)
                expect.true(not faults, "each image at its offset alone", faults)


@requirement("SIM-022")
def test_sim_022_close_ends_the_program(context: CheckContext) -> None:
    """`close` before an episode and within one. Expect a reply, and exit code 0."""
    for plays in (False, True):
        with simulator(context) as client:
            _ = client.started
            expect.equal(_close(client, context, plays=plays), 0, "exit code")


def _close(client: SimulatorClient, context: CheckContext, *, plays: bool) -> object:
    """Expect a reply to `close`, and the end in time; give the exit code."""
    if plays:
        client.play(tasks_of(context)[0], 0, steps=1)
    begun_at = time.monotonic()
    client.call("close")
    code = client.process.wait(2 * _CLOSE_S)
    took_s = time.monotonic() - begun_at
    expect.in_time(took_s, _CLOSE_S, "the end after `close`")
    return code


@requirement("SIM-023")
def test_sim_023_end_of_input_ends_the_program(context: CheckContext) -> None:
    """Standard input ends before an episode, within one, and within a request. Expect
    the program to end."""
    for begin in (b"", b"\x00", LENGTH.pack(100) + b"\x81"):
        with simulator(context) as client:
            client.play(tasks_of(context)[0], 0, steps=1)
            client.started.send(begin)
            client.started.close_input()
            begun_at = time.monotonic()
            client.process.wait(2 * _END_OF_INPUT_S)
            took_s = time.monotonic() - begun_at
            expect.in_time(took_s, _END_OF_INPUT_S, "the end of the program")


@requirement("SIM-024")
def test_sim_024_no_process_is_left(context: CheckContext) -> None:
    """An episode, then `close`. Expect no process that the program started."""
    with simulator(context) as client:
        client.play(tasks_of(context)[0], 0)
        client.call("close")
        client.started.wait(2 * _CLOSE_S)
        left = client.started.others()
        expect.true(not left, "no process of the program", f"{len(left)} processes")


@requirement("SIM-025")
def test_sim_025_replies_have_the_number_of_a_request(context: CheckContext) -> None:
    """An episode, an unknown call and an unknown task. Expect the number in each."""
    with simulator(context) as client:
        client.play(tasks_of(context)[0], 0, steps=1, observed=True)
        client.ask(_NOWHERE)
        client.ask("reset", task=_NOWHERE, seed=0, split="test")
        client.call("close")


def _require_socket(context: CheckContext) -> None:
    if socket_path(context) is None:
        raise NotApplicable("the simulator is not at a socket")


@requirement("SIM-026")
def test_sim_026_connections_are_independent(context: CheckContext) -> None:
    """An episode is played alone, and again beside one of a second connection. Expect
    equal replies. A simulator that has one world does not listen meanwhile."""
    _require_socket(context)
    _require_deterministic(context)
    task, seed = tasks_of(context)[0], context.shared.settings.seed
    with simulator(context) as client:
        alone = _play_twice(client, context, task)
        played = [client.reset(task, seed)]
        try:
            with simulator(context, away_s=_SILENCE_S) as other:
                other.reset(tasks_of(context)[-1], seed + 1)
                for index in range(len(alone) - 1):
                    other.step(tasks_of(context)[-1], index + 1)
                    played.append(client.step(task, index))
                beside = other.play(task, seed)
        except SetUpFailed as failed:
            if failed.breaks != "SIM-028":
                raise
            return  # it has one world
    _require_equal(played, alone, "beside another connection")
    _require_equal(beside, alone, "on the other connection")


@requirement("SIM-027")
def test_sim_027_close_ends_the_connection(context: CheckContext) -> None:
    """`close` before an episode and within one. Expect a reply, and the end."""
    _require_socket(context)
    for plays in (False, True):
        with simulator(context) as client:
            _close(client, context, plays=plays)


@requirement("SIM-028")
def test_sim_028_a_new_connection_is_played(context: CheckContext) -> None:
    """Connections end before an episode, within one, and within a request. Expect each
    time that another one is accepted, has no episode, and begins one."""
    _require_socket(context)
    task = tasks_of(context)[0]
    for begin in (None, b"", b"\x00", LENGTH.pack(100) + b"\x81"):
        with simulator(context) as client:
            if begin is not None:
                client.play(task, 0, steps=1)
                client.process.send(begin)
        with simulator(context) as client:
            reply = client.ask("step", action=action_of(_benchmark(context), task, 0))
            expect.true("fault" in reply, "a fault of a step before a reset", reply)
            client.reset(task, 0)
