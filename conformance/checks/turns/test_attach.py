"""Sessions: attach, takeover, detach (ATT, CONV, DET)."""

import re
from functools import partial
from typing import Any

from conformance.checks.support.expected_states import expect_unchanged
from conformance.checks.support.given_states import (
    attach_workers,
    detach_only_worker,
    expect_pointer,
    require_not_state_refusal,
    require_worker_limit,
    start_drain,
    submit_and_attach,
)
from conformance.checks.support.long_turns import during_turn
from conformance.checks.support.submissions import NAMES_OF_LANGUAGES
from conformance.client.check_context import CheckContext
from conformance.client.run_client import WorkerClient
from conformance.runner.requirement import requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive

RACES = 5
MANY_WORKERS = 11


@requirement("ATT-001")
def test_att_001_session_begins_with_turn_0(context: CheckContext) -> None:
    """A worker attaches, plays, detaches, and attaches again; so do others with ids
    that objects of a language have. Expect all sessions to begin at seq 0 and step 0
    with nothing executed."""
    attaches_again = context.offers("sessions")
    run = context.submit("count", max_attempts=10 if attaches_again else None)
    for worker_id in ("worker", "worker", *NAMES_OF_LANGUAGES):
        worker = run.worker(worker_id)
        worker.attach()
        worker.predict(context.action(), context.action())
        if attaches_again:
            worker.detach()
        else:
            run = context.submit("count")


@requirement("ATT-002")
def test_att_002_can_repeat_attach(context: CheckContext) -> None:
    """The response to an attach was lost, at the beginning and again after a turn; or
    it is sent several times at once. Expect the same session and its latest turn for
    the same key, also a turn with a fault and one whose run got ten other workers
    since, and the session to continue."""
    worker = context.submit("count").worker()
    attach = partial(worker.try_attach, attach_key=worker.id)
    for answer in context.call_concurrently(*[attach] * 4):
        expect.ok(answer)
    many = context.worker_count(MANY_WORKERS)
    first, *_ = attach_workers(context.submit(*["score"] * many), many)
    expect.ok(first.try_attach(attach_key=first.attach_key))
    first.run.stop()
    if context.offers("faults"):
        broken = submit_and_attach(context, "fault")
        broken.predict(context.action())
        broken.predict(context.action(fault=1))
        expect.ok(broken.try_attach(attach_key=broken.attach_key))
    worker = submit_and_attach(context, "count")
    for _ in range(2):
        expect.ok(worker.try_attach(attach_key=worker.attach_key))
        worker.predict(context.action())


@requirement("ATT-003")
def test_att_003_cannot_attach_with_another_key(context: CheckContext) -> None:
    """Another client uses the id of a live worker, then again after its detach. Expect
    `worker_busy`, and the session unaffected."""
    run = context.submit("count")
    worker = run.worker("shared")
    worker.attach()
    worker.predict(context.action())
    require_not_state_refusal(run.worker("shared").try_attach())
    run.get()
    worker.predict(context.action())
    if context.offers("sessions"):
        worker.detach()
        run.worker("shared").attach()


@requirement("ATT-008")
def test_att_008_race_for_one_worker(context: CheckContext) -> None:
    """Several clients attach the same worker concurrently, several times. Expect
    exactly one of them to succeed each time."""
    for _ in range(RACES):
        run = context.submit(*["score"] * 8)
        clients = [run.worker("same") for _ in range(5)]
        answers = context.call_concurrently(*[client.try_attach for client in clients])
        opened = sum(answer.status == 200 for answer in answers)
        expect.equal(opened, 1, "sessions opened")


def return_to_a_full_run(context: CheckContext) -> None:
    """Attach a worker that was done in a drain, when another one has its slot."""
    run = context.submit("score", "score", "score", max_workers=1)
    done = run.worker("done")
    done.attach()
    start_drain(run)
    done.play()
    run.until("stopped")
    run.resume(until_ready=True)
    run.worker("playing").attach()
    done.try_attach()


@requirement("ATT-006")
def test_att_006_cannot_attach_more_workers_than_allowed(context: CheckContext) -> None:
    """One worker more than `max_workers` attaches, and again when a slot is free; one
    more attaches while the only one executes a turn; one returns that was done. Expect
    `worker_limit` where no slot is free, and as many as eleven where they are."""
    many = context.worker_count(MANY_WORKERS)
    run = context.submit(*["score"] * many, max_workers=many)
    for _ in range(many):
        run.worker().try_attach()
    run.stop()
    most = context.worker_count(2)
    run = context.submit(*["score"] * 4, max_workers=most)
    attached_workers = attach_workers(run, most)
    late = run.worker("late")
    for takeover in (False, True):  # of no session
        late.try_attach(takeover=takeover)
    attached_workers[0].detach()
    late.attach()
    if context.offers("control"):
        return_to_a_full_run(context)
    if not context.shared.settings.quick:
        busy = submit_and_attach(context, "delay", "delay", max_workers=1)
        during_turn(busy, busy.run.worker("late").try_attach)


@requirement("ATT-007")
def test_att_007_race_for_the_last_slots(context: CheckContext) -> None:
    """More workers than allowed attach concurrently, several times. Expect exactly
    `max_workers` of them to succeed each time."""
    most = context.worker_count(3)
    for _ in range(RACES):
        run = context.submit(*["score"] * 8, max_workers=most)
        workers = [run.worker() for _ in range(most + 4)]
        answers = context.call_concurrently(*[worker.try_attach for worker in workers])
        opened = sum(require_not_state_refusal(a).status == 200 for a in answers)
        expect.true(opened == most, f"{most} sessions opened", opened)


WRONG: list[tuple[dict[str, Any], str]] = [
    ({"control_rate_hz": 20}, "/assumes/control_rate_hz"),
    ({"control_rate_hz": 10.4}, "/assumes/control_rate_hz"),
    ({"control_rate_hz": 9.99}, "/assumes/control_rate_hz"),
    # Values that some languages take for no value.
    ({"control_rate_hz": 0}, "/assumes/control_rate_hz"),
    ({"action": {"score": {"unit": ""}}}, "/assumes/action/score"),
    ({"state": {"count": {"frame": ""}}}, "/assumes/state/count"),
    # The name of an action as a state, and the name of a state as an action.
    ({"state": {"score": {"size": 1}}}, "/assumes/state/score"),
    ({"action": {"count": {"size": 1}}}, "/assumes/action/count"),
    ({"action": {"vector": {"size": 7}}}, "/assumes/action/vector"),
    ({"action": {"delay_s": {"unit": "ms"}}}, "/assumes/action/delay_s"),
    ({"action": {"vector": {"rotation": "euler_xyz"}}}, "/assumes/action/vector"),
    ({"action": {"clipped": {"frame": "base"}}}, "/assumes/action/clipped"),
    ({"action": {"clipped": {"relative_to": "measured"}}}, "/assumes/action/clipped"),
    ({"action": {"clipped": {"quantity": "position"}}}, "/assumes/action/clipped"),
    ({"action": {"clipped": {"scale": 0.5}}}, "/assumes/action/clipped"),
    # No vector of the benchmark declares a gripper.
    ({"action": {"clipped": {"gripper_open": 0}}}, "/assumes/action/clipped"),
    # Any text is a unit or a frame, whatever the names of this API look like.
    ({"action": {"clipped": {"frame": "Welt, von oben"}}}, "/assumes/action/clipped"),
    ({"state": {"count": {"unit": "\U0001f916" * 64}}}, "/assumes/state/count"),
    ({"state": {"vector": {"size": 9}}}, "/assumes/state/vector"),
    ({"state": {"count": {"unit": "m"}}}, "/assumes/state/count"),
    ({"state": {"clipped": {"relative_to": "commanded"}}}, "/assumes/state/clipped"),
    (
        {"action": {"vector": {"size": 8}, "clipped": {"size": 3}}},
        "/assumes/action/clipped",
    ),
    # Vectors that are not there, some named as a member of objects in a language.
    ({"action": {"gripper": {"size": 1}}}, "/assumes/action/gripper"),
    ({"state": {"gripper": {}}}, "/assumes/state/gripper"),
    ({"state": {"left/arm~1/~": {}}}, "/assumes/state/left~1arm~01~1~0"),
    ({"action": {"constructor": {}}}, "/assumes/action/constructor"),
    ({"state": {"__class__": {}}}, "/assumes/state/__class__"),
]
_PART = "/assumes/action/clipped/parts"
WRONG_PARTS: list[tuple[dict[str, Any], str]] = [
    ({"all": {"start": 1}}, f"{_PART}/all/start"),
    ({"all": {"size": 1}}, f"{_PART}/all/size"),
    ({"all": {"quantity": "position"}}, f"{_PART}/all/quantity"),
    ({"all": {"unit": "m"}}, f"{_PART}/all/unit"),
    ({"all": {"scale": 0.05}}, f"{_PART}/all/scale"),
    ({"all": {"frame": "tool"}}, f"{_PART}/all/frame"),
    ({"all": {"rotation": "yaw"}}, f"{_PART}/all/rotation"),
    ({"all": {"relative_to": "measured"}}, f"{_PART}/all/relative_to"),
    ({"all": {"gripper_open": 1}}, f"{_PART}/all/gripper_open"),
    ({"all": {"gripper_closed": 0}}, f"{_PART}/all/gripper_closed"),
    ({"all": {"start": 0, "size": 2, "unit": "rad"}}, f"{_PART}/all/unit"),
    ({"position": {}}, f"{_PART}/position"),
    ({"all": {}, "a/b": {"unit": "1"}}, f"{_PART}/a~1b"),
    ({"constructor": {}}, f"{_PART}/constructor"),
]


@requirement("ATT-010")
def test_att_010_cannot_attach_with_a_wrong_assumption(context: CheckContext) -> None:
    """Wrong assumptions of the rate, of vectors and of parts, also of absent ones.
    Expect `convention_mismatch` pointing at the wrong value, and no session; the right
    rate is accepted."""
    worker = context.submit("score").worker()
    worker.attach(assumes={"control_rate_hz": 10})
    detach_only_worker(worker)
    of_parts = [({"action": {"clipped": {"parts": p}}}, at) for p, at in WRONG_PARTS]
    with expect_unchanged(worker.run):
        for assumes, pointer in WRONG + of_parts:
            answer = worker.try_attach(assumes=assumes)
            expect_pointer(expect.refused(answer, "convention_mismatch"), pointer)


CONVENTIONS = ("quantity", "unit", "frame", "rotation", "relative_to")


def assumptions(space: dict[str, Any], *, by_part: bool) -> dict[str, Any]:
    """Give all possible assumptions about the vectors of a space.

    by_part: about each part by its name; otherwise about all parts at once, which is
    possible where a vector has one.
    """
    if by_part:
        members = ("start", "size", "scale", *CONVENTIONS)
        parts = {
            name: {part: {m: ({"scale": 1} | v)[m] for m in members} for part, v in of}
            for name, of in (
                (n, vector["parts"].items()) for n, vector in space.items()
            )
        }
        return {n: {"size": v["size"], "parts": parts[n]} for n, v in space.items()}
    return {
        name: {"size": vector["size"]}
        | {member: part[member] for member in CONVENTIONS}
        for name, vector in space.items()
        for part in vector["parts"].values()
        if len(vector["parts"]) == 1
    }


@requirement("ATT-011")
def test_att_011_can_attach_with_right_assumptions(context: CheckContext) -> None:
    """A policy with exactly the declarations of the benchmark, or a part of them.
    Expect a session each time."""
    answer = context.call("get_benchmark", benchmark_id="calibration")
    benchmark = expect.require(answer, 200, "get_benchmark")
    rate = {"control_rate_hz": benchmark["control_rate_hz"]}
    spaces = {
        "action": benchmark["action_space"],
        "state": benchmark["observation_space"]["state"],
    }
    whole: list[dict[str, Any]] = [
        {name: assumptions(space, by_part=by_part) for name, space in spaces.items()}
        for by_part in (True, False)
    ]
    for assumes in ({}, rate, *whole, rate | whole[0]):
        expect.ok(context.submit("score").worker().try_attach(assumes=assumes))


@requirement("CONV-004")
def test_conv_004_an_assumption_is_about_each_part(context: CheckContext) -> None:
    """Assumptions beside `parts`, which the part of the vector confirms or contradicts.
    Expect a session, or `convention_mismatch`, also where `parts` has the right value.
    """
    worker = context.submit("score").worker()
    worker.attach(assumes={"action": {"delay_s": {"unit": "s", "quantity": "time"}}})
    detach_only_worker(worker)
    for members in (
        {"unit": "ms"},
        {"quantity": "number"},
        {"unit": "1", "parts": {"all": {"unit": "s"}}},
    ):
        answer = worker.try_attach(assumes={"action": {"delay_s": members}})
        expect.refused(answer, "convention_mismatch")


@requirement("CONV-005")
def test_conv_005_each_contradiction_has_its_pointer(context: CheckContext) -> None:
    """Several wrong values beside right ones, a part and a vector that are absent.
    Expect a pointer at each wrong value and absent name, and at nothing else."""
    at = "/assumes/action/clipped"
    parts = {"all": {"size": 2, "start": 1, "frame": "base"}, "x": {"unit": "1"}}
    clipped = {"size": 3, "unit": "m", "rotation": "none", "parts": parts}
    assumes = {"action": {"clipped": clipped, "y": {"unit": "1"}}}
    answer = context.submit("score").worker().try_attach(assumes=assumes)
    problem = expect.refused(answer, "convention_mismatch")
    pointers = sorted(str(item["pointer"]) for item in problem["errors"])
    wrong = ["parts/all/frame", "parts/all/start", "parts/x", "size", "unit"]
    due = [*(f"{at}/{member}" for member in wrong), "/assumes/action/y"]
    expect.equal(pointers, sorted(due), "pointers of `errors`")


@requirement("CONV-006")
def test_conv_006_detail_has_part_and_values(context: CheckContext) -> None:
    """A part is assumed to have another unit and frame, and an action another quantity.
    Expect the name of the part, the assumed and the declared value in each detail."""
    parts = {"all": {"unit": "ms", "frame": "tool"}}
    assumes = {"action": {"delay_s": {"quantity": "length", "parts": parts}}}
    answer = context.submit("score").worker().try_attach(assumes=assumes)
    problem = expect.refused(answer, "convention_mismatch")
    details = {str(item["pointer"]): str(item["detail"]) for item in problem["errors"]}
    at = "/assumes/action/delay_s"
    for pointer, texts in {
        f"{at}/parts/all/unit": ("all", "ms", "s"),
        f"{at}/parts/all/frame": ("all", "tool", "none"),
        f"{at}/quantity": ("all", "length", "time"),
    }.items():
        detail = details.get(pointer, "")
        words = re.findall(r"[\w/*^]+", detail)
        missing = [text for text in texts if text not in words]
        expect.equal(missing, [], f"missing in the detail {detail!r} at {pointer}")


@requirement("ATT-012")
def test_att_012_attach_without_an_episode_left(context: CheckContext) -> None:
    """The only episode is in progress when a second worker attaches. Expect a session
    whose turn 0 is `done`, with neither observation nor episode."""
    require_worker_limit(context, 2)
    first = submit_and_attach(context, "score")
    turn = expect.ok(require_not_state_refusal(first.run.worker().try_attach()))
    expect.equal(turn["done"], True, "done")


@requirement("ATT-013")
def test_att_013_cannot_attach_with_a_bad_worker_id(context: CheckContext) -> None:
    """Worker ids with a space, a dot, an end of line, another alphabet, and one with a
    character too many. Expect `invalid_request`; the longest valid id is accepted."""
    run = context.submit("score")
    for worker_id in ("a b", "a.b", "ä", "a:b", "a\n", "w" * 65):
        expect.refused(run.worker(worker_id).try_attach(), "invalid_request")
    expect.ok(run.worker("-_A0z" + "w" * 59).try_attach())


@requirement("DET-001")
def test_det_001_detach_frees_the_slot(context: CheckContext) -> None:
    """`max_workers` is 1; a second worker attaches before and after the first detaches,
    in another run while the first has a turn. Expect a refusal, then success at once.
    """
    run = context.submit("score", "score", max_workers=1)
    first, second = run.worker(), run.worker()
    first.attach()
    expect.require(second.try_attach(), 429, "attaching to a full run")
    expect.ok(first.try_detach(), 204)
    expect.ok(second.try_attach())
    if not context.shared.settings.quick:
        first = submit_and_attach(context, "delay", "delay", max_workers=1)
        second = first.run.worker()
        turn, (detached, attached) = during_turn(
            first, lambda: [first.try_detach(), second.try_attach()]
        )
        if turn.status == 200 and detached.started_at >= turn.ended_at:
            raise Inconclusive("the detach came after the turn")
        expect.ok(detached, 204)
        expect.ok(attached)


def end_and_reattach(worker: WorkerClient) -> None:
    """End the session and open another one for the same worker."""
    worker.detach()
    worker.run.worker(worker.id).attach()


@requirement("DET-002")
def test_det_002_can_detach_twice(context: CheckContext) -> None:
    """A session that ended by a detach (with or without a successor) or by a stop is
    detached again. Its heartbeat is refused by then. Expect 204 and no change."""
    for end in (WorkerClient.detach, end_and_reattach, lambda w: w.run.stop()):
        worker = submit_and_attach(context, "count", "count")
        worker.predict(context.action())
        end(worker)
        expect.require(worker.try_heartbeat(), 409, "a session that has ended")
        worker.run.get()
        expect.ok(worker.try_detach(), 204)
        worker.run.snapshot()
