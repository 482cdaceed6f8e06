"""Leases: how long a session lives without a request (LEASE).

These checks use their own clock. A server is judged only by responses that were surely
inside or outside a lease, whatever the network delay; if the kit was late, the check is
repeated, at most three times.
"""

import math
import time
import uuid
from collections.abc import Callable
from datetime import datetime, timedelta
from functools import partial
from typing import Any

from conformance.checks.support.generated.mixed_histories import (
    expect_histories_with_pauses,
)
from conformance.checks.support.given_states import count, index_of, require_duration
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient, WorkerClient
from conformance.exchanges.answer import Answer
from conformance.runner.private_server import open_quiet_server
from conformance.runner.requirement import background, plays_histories, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive, SetUpFailed

CLOCK_ERROR_S = 1.0
LONG_TURN_S = 3.0
LONG_LEASE_S = 10.5
NOTICE_S = 5
# So long after its begin a second lease is renewed: it ends after the first one has
# to be noticed.
RENEWED_S = 6.5

# A worker and the answer with which its lease began.
Opened = tuple[WorkerClient, Answer]


def lease_of(context: CheckContext) -> float:
    """Give a short lease, of which a request can surely use nine tenths.

    No whole number, so that a server which rounds it up or down is seen; the longest
    of a server that has none as long.
    """
    shortest_s: float = context.limits["idle_timeout_s_min"]
    longest_s: float = context.limits["idle_timeout_s_max"]
    needed_s = context.least_lease_s
    if needed_s > longest_s:
        raise Inconclusive(
            f"no lease of this server is longer than {longest_s:g} s, and with its "
            f"times to answer the kit needs {needed_s:.1f} s: announce a longer "
            "`idle_timeout_s_max`, or judge it from nearer"
        )
    return min(max(2.4, shortest_s, needed_s), longest_s)


def attach_with_lease(context: CheckContext, *tasks: str, **options: Any) -> Opened:
    """Attach a worker with a short lease; give the answer that started it."""
    lease_s = lease_of(context)
    run = context.submit(*(tasks or ("count",)), idle_timeout_s=lease_s, **options)
    worker = run.worker()
    worker.attach_key = uuid.uuid4().hex
    answer = worker.try_attach(attach_key=worker.attach_key)
    worker.turn = expect.require(answer, 200, "attach_worker")
    worker.session_id = worker.turn["session_id"]
    return worker, answer


def play_turn(worker: WorkerClient) -> Answer:
    """Play one action inside the lease, as set-up."""
    answer = worker.try_next()
    if answer.code == "session_ended":
        raise Inconclusive("a turn of the kit came too late to be inside the lease")
    expect.require(answer, 200, "predict")
    return answer


def sleep_until(moment: float) -> None:
    """Sleep until a time of the monotonic clock."""
    time.sleep(max(0.0, moment - time.monotonic()))


def sleep_past(answer: Answer, context: CheckContext) -> None:
    """Sleep until the lease that an answer started is surely over."""
    sleep_until(answer.ended_at + lease_of(context) + context.tolerance_s)


def sleep_nearly_through(answer: Answer, context: CheckContext) -> None:
    """Sleep until the lease that an answer started is nearly, surely not yet over."""
    margin_s = 0.1 + context.tolerance_s / 2
    sleep_until(answer.started_at + lease_of(context) - margin_s)


def expect_inside_lease(probe: Answer, began: Answer, context: CheckContext) -> None:
    """Expect a request near the end of a lease to be accepted."""
    if probe.status != 200:
        require_inside_lease(probe, began, context)
    expect.ok(probe)


def require_inside_lease(probe: Answer, began: Answer, context: CheckContext) -> None:
    """Require that a request was answered surely inside the lease."""
    if probe.ended_at > began.started_at + lease_of(context):
        raise Inconclusive("a request of the kit came too late to be inside the lease")


def require_ended_session(worker: WorkerClient) -> None:
    """Require that leases end at all; LEASE-001 judges that."""
    expect.require(worker.try_heartbeat(), 409, "a session that is over")


@requirement("LEASE-001")
@background
def test_lease_001_session_ends(context: CheckContext) -> None:
    """A worker plays a turn, another one all there is, and then they send nothing for
    longer than their lease. Expect `session_ended` for the next predict and the next
    heartbeat of the first, and for the repeat of the other's last turn."""
    finished, _ = attach_with_lease(context)
    end_last_episode(finished)
    worker, _ = attach_with_lease(context)
    sleep_past(play_turn(worker), context)
    expect.refused(worker.try_next(), "session_ended")
    expect.refused(worker.try_heartbeat(), "session_ended")
    expect.refused(finished.try_predict(context.action(end=1), seq=1), "session_ended")


@requirement("LEASE-002")
@background
def test_lease_002_session_lives_for_its_lease(context: CheckContext) -> None:
    """A worker sends nothing for nearly its whole lease, and so do one whose run is
    completed and one that took over in the middle of another lease; one more is silent
    for all of it. Then one is silent in a longer lease. Expect the turn of the first,
    the repeat of the second and the turns of the third and the last to be accepted."""
    silent, silent_began = attach_with_lease(context)
    finished, _ = attach_with_lease(context)
    end = context.action(end=1)
    last = finished.try_predict(end)
    expect.require(last, 200, "the last turn")
    worker, began = attach_with_lease(context)
    later, middle = attach_with_lease(context)
    sleep_until(middle.started_at + 0.5 * lease_of(context))
    taken = later.try_attach(takeover=True)
    later.session_id = expect.require(taken, 200, "a takeover")["session_id"]
    sleep_nearly_through(last, context)
    expect_inside_lease(finished.try_predict(end, seq=1), last, context)
    sleep_nearly_through(began, context)
    expect_inside_lease(worker.try_next(), began, context)
    sleep_past(silent_began, context)
    require_ended_session(silent)
    sleep_nearly_through(taken, context)
    expect_inside_lease(later.try_next(), taken, context)
    if not context.shared.settings.quick:
        expect_long_lease_kept(context)


def expect_long_lease_kept(context: CheckContext) -> None:
    """Expect a turn to be accepted when a longer lease is over but for a fiftieth."""
    limits, lease_s = context.limits, LONG_LEASE_S
    if not limits["idle_timeout_s_min"] <= lease_s <= limits["idle_timeout_s_max"]:
        return
    worker = context.submit("count", idle_timeout_s=lease_s).worker()
    began_at = time.monotonic()
    worker.attach()
    sleep_until(began_at + 0.98 * lease_s - context.tolerance_s / 2)
    probe = worker.try_next()
    if probe.status != 200 and probe.ended_at > began_at + lease_s:
        raise Inconclusive("a request of the kit came too late to be inside the lease")
    expect.ok(probe)


def extensions_without_turn(context: CheckContext, wanted: int) -> int:
    """Give how many times a session that plays no turn can have its lease extended.

    LIM-006 ends it when `limits.heartbeat_s_max` has passed, however short that is.
    """
    longest_s = context.limits.get("heartbeat_s_max", math.inf) - context.tolerance_s
    if longest_s < 2 * lease_of(context):
        raise SetUpFailed("`limits.heartbeat_s_max` is under two leases", allowed=True)
    return int(min(wanted, longest_s / lease_of(context)))


def attach_two_with_lease(context: CheckContext) -> list[Opened]:
    """Attach two workers with a short lease, the second one in a run that drains."""
    opened = [attach_with_lease(context) for _ in range(2)]
    worker, began = opened[1]
    if context.offers("control"):
        drain(context, worker, began)
    return opened


def drain(context: CheckContext, worker: WorkerClient, began: Answer) -> None:
    """Start a drain, which waits for a worker whose lease began with an answer."""
    answer = worker.run.call("stop_run", json={"mode": "drain"})
    if expect.require(answer, 200, "a drain")["state"] != "stopping":
        require_inside_lease(answer, began, context)
        raise SetUpFailed("a run in play is drained at once", breaks="LIFE-303")


def end_last_episode(worker: WorkerClient) -> Answer:
    """End the episode after which none is left; give the answer."""
    last = worker.try_predict(worker.run.context.action(end=1))
    if not expect.require(last, 200, "the last turn")["done"]:
        raise SetUpFailed("the turn after the last episode is not `done`; see PRED-009")
    return last


def expect_lease_extension(
    context: CheckContext,
    extend: Callable[[WorkerClient], Answer],
    opened: list[Opened],
    times: int = 3,
) -> None:
    """Expect requests to extend the leases by their full length, and by no more."""
    silent, _ = attach_with_lease(context)
    last = [answer for _, answer in opened]
    for _ in range(times):
        for number, (worker, _) in enumerate(opened):
            sleep_nearly_through(last[number], context)
            answer = extend(worker)
            expect_inside_lease(answer, last[number], context)
            last[number] = answer
    sleep_past(last[-1], context)
    require_ended_session(silent)
    for worker, _ in opened:
        expect.refused(extend(worker), "session_ended")


@requirement("LEASE-003")
@background
def test_lease_003_heartbeat_extends(context: CheckContext) -> None:
    """A worker sends three heartbeats, each when its lease is nearly over; two where
    `limits.heartbeat_s_max` leaves no time for a third. So does one whose run is
    `stopping`, and one that is done. Expect them accepted, and the sessions ended one
    lease after the last."""
    times = extensions_without_turn(context, 3)
    opened = attach_two_with_lease(context)
    done, _ = attach_with_lease(context)
    end_last_episode(done)
    heartbeat = done.try_heartbeat()
    if heartbeat.status == 200:  # whether one that is done sends any is not said
        opened.append((done, heartbeat))
    expect_lease_extension(context, WorkerClient.try_heartbeat, opened, times)


@requirement("LEASE-013")
def test_lease_013_can_send_heartbeats_when_done(context: CheckContext) -> None:
    """A session that is done sends heartbeats, while another worker plays its run, if
    it may have two, and when that is completed. Expect a lease each time."""
    count_of_workers = context.worker_count(2)
    run = context.submit(*["score"] * count_of_workers, max_workers=count_of_workers)
    *others, done = [run.worker() for _ in range(count_of_workers)]
    for worker in (*others, done):
        worker.attach()
    end_last_episode(done)
    expect.ok(done.try_heartbeat())
    for worker in others:
        worker.play()
    for _ in range(2):
        expect.ok(done.try_heartbeat())


@requirement("LEASE-004")
@background
def test_lease_004_predict_extends(context: CheckContext) -> None:
    """A worker plays three turns, each when its lease is nearly over; so does one whose
    run is `stopping`. Expect them accepted, and the sessions ended one lease after the
    last."""
    opened = attach_two_with_lease(context)
    expect_lease_extension(context, WorkerClient.try_next, opened)


@requirement("LEASE-005")
@background
def test_lease_005_execution_does_not_count(context: CheckContext) -> None:
    """A turn takes more than two leases; a heartbeat comes in the first, the run is
    read when that would be over, another heartbeat comes when the second would be, and
    the next turn at once. Expect turns and heartbeat to be accepted."""
    lease_s = lease_of(context)
    worker, began = attach_with_lease(context, "delay", max_steps=100)
    turn_s = 2.4 * lease_s
    steps = int(turn_s / 5) + 1
    if steps > context.benchmark["max_chunk"]:
        text = f"with its times to answer the kit needs a turn of {turn_s:.0f} s"
        raise Inconclusive(f"{text}, and no chunk of this server lasts as long")
    long = [context.action(delay_s=turn_s / steps)] * steps

    def send_heartbeat() -> Answer:
        time.sleep(0.5 * lease_s)
        worker.try_heartbeat()
        time.sleep(0.7 * lease_s)
        worker.run.get()
        time.sleep(lease_s)
        return worker.try_heartbeat()

    turn, heartbeat = context.call_concurrently(
        lambda: worker.try_predict(*long, timeout_s=30 + turn_s), send_heartbeat
    )
    surely_sent_in = began.started_at + lease_s - 2 * context.tolerance_s
    if turn.status != 200 and turn.started_at > surely_sent_in:
        raise Inconclusive("the long turn of the kit came too late for its lease")
    expect.ok(turn)
    require_duration(turn, turn_s)
    worker.seq += 1
    probe = worker.try_predict(context.action())
    # When the answer to the long turn left the server is not known, but no sooner.
    surely_until = turn.started_at + turn_s + lease_s
    late_s = max(probe.ended_at, heartbeat.ended_at) - surely_until
    if late_s > 0 and not probe.status == heartbeat.status == 200:
        raise Inconclusive("the turn after the long one came late")
    expect.ok(probe)
    expect.ok(heartbeat)


@requirement("LEASE-006")
@background
def test_lease_006_end_of_lease_frees_the_slot(context: CheckContext) -> None:
    """The worker in the last slot of a run stops sending requests; another worker, if
    the server allows one, is in a turn meanwhile. Expect a third to attach when the
    lease has ended."""
    slots = context.worker_count(2)
    silent, began = attach_with_lease(context, *["delay"] * 3, max_workers=slots)
    waiting, *others = [silent.run.worker() for _ in range(slots)]
    for busy in others:
        busy.attach()
    early = waiting.try_attach()
    if early.status == 200:
        require_inside_lease(early, began, context)
    expect.require(early, 429, "attaching to a full run")

    def attach_after_the_lease() -> Answer:
        sleep_past(began, context)
        return waiting.try_attach()

    steps = int((lease_of(context) + 2) / 2.5) + 1
    long = partial(WorkerClient.try_predict, timeout_s=30 + 2.5 * steps)
    chunk = [context.action(delay_s=2.5)] * steps
    turns = [partial(long, busy, *chunk) for busy in others]
    answer = context.call_concurrently(attach_after_the_lease, *turns)[0]
    require_ended_session(silent)
    expect.ok(answer)


@requirement("LEASE-008")
@background
def test_lease_008_refusals_do_not_extend(context: CheckContext) -> None:
    """A worker plays a turn; all that follows is refused: a wrong seq, another body, a
    bad action, its worker attached by others, the session that it took over. Expect the
    session ended one lease after the turn."""
    silent, _ = attach_with_lease(context)
    old, _ = attach_with_lease(context)
    worker = old.run.worker(old.id)
    worker.attach(takeover=True)
    action, second_action = context.action(), context.action(score=0.5)
    turn = play_turn(worker)
    sleep_until(turn.started_at + 0.6 * lease_of(context))
    refused = [
        *(worker.try_predict(action, seq=7), worker.try_predict(second_action, seq=1)),
        *(worker.try_predict(context.action(vector=[])), worker.try_attach()),
        *(worker.try_heartbeat(session_id="unknown"), old.try_predict(action)),
        *(old.try_heartbeat(), old.try_detach()),
    ]
    if context.offers("conventions"):
        wrong = {"control_rate_hz": 20}
        refused.append(worker.try_attach(takeover=True, assumes=wrong))
    if refused[-1].ended_at > turn.started_at + lease_of(context):
        raise Inconclusive("a request of the kit came too late to be inside the lease")
    if not all(400 <= answer.status < 500 for answer in refused):
        raise SetUpFailed("a wrong request was accepted")
    sleep_past(turn, context)
    probe = worker.try_predict(action)
    require_ended_session(silent)
    expect.refused(probe, "session_ended")


@requirement("LEASE-009")
@background
def test_lease_009_answers_show_the_whole_lease(context: CheckContext) -> None:
    """A worker attaches, plays turns (one with a fault, one of some seconds, two that
    end episodes), takes over, and sends a heartbeat, with a pause before each; the
    server's clock is read. Expect the lease of each answer to be that of the run, and
    to begin with the answer."""
    shortest, longest = (context.limits[f"idle_timeout_s_{m}"] for m in ("min", "max"))
    lease_s = min(longest, max(shortest, 61.5))
    pause_s = min(2.1 * CLOCK_ERROR_S, lease_s / 3)
    has_faults = context.offers("faults")
    tasks = ("fault" if has_faults else "score", "delay")
    worker = context.submit(*tasks, idle_timeout_s=lease_s, max_steps=100).worker()

    def read_clock() -> datetime:
        body = expect.require(context.call("describe_service"), 200, "describe_service")
        return datetime.fromisoformat(body["server_time"])

    def play(**values: float) -> Callable[[], Any]:
        return partial(worker.predict, context.action(**values))

    read_clock()
    worker.attach()
    for send in (play(), play(), play(fault=float(has_faults)), play(end=1)):
        time.sleep(pause_s)
        send()
    least_s = LONG_TURN_S + lease_s - CLOCK_ERROR_S
    earliest = read_clock() + timedelta(seconds=least_s)
    lease = worker.predict(context.action(delay_s=LONG_TURN_S))["lease"]
    expires_at = datetime.fromisoformat(lease["expires_at"])
    expect.true(expires_at >= earliest, f"expires_at from {earliest}", expires_at)
    for send in (worker.attach, worker.heartbeat, play(end=1)):
        time.sleep(pause_s)
        send(**({"takeover": True} if send == worker.attach else {}))
    read_clock()


@requirement("LEASE-010")
@background
def test_lease_010_repeats_extend(context: CheckContext) -> None:
    """Two workers repeat their attach, one of them in a run that is `stopping`; another
    one repeats its turn, and one the turn that was its last; twice, each time when the
    lease of the answer before is nearly over. Expect the repeats answered, and the
    sessions ended one lease after the last."""
    times = extensions_without_turn(context, 2)
    silent, _ = attach_with_lease(context)
    repeats: list[tuple[WorkerClient, partial[Answer]]] = []
    last: list[Answer] = []
    for is_draining in (False, True) if context.offers("control") else (False,):
        worker, answer = attach_with_lease(context)
        if is_draining:
            drain(context, worker, answer)
        again = partial(worker.try_attach, attach_key=worker.attach_key)
        repeats.append((worker, again))
        last.append(answer)
    for action in (context.action(), context.action(end=1)):
        worker, _ = attach_with_lease(context)
        repeats.append((worker, partial(worker.try_predict, action, seq=1)))
        last.append(worker.try_predict(action))
        expect.require(last[-1], 200, "predict")
    for _ in range(times):
        for number, (worker, repeat) in enumerate(repeats):
            sleep_nearly_through(last[number], context)
            answer = repeat()
            expect_inside_lease(answer, last[number], context)
            session_id = expect.ok(answer)["session_id"]
            if session_id != worker.session_id:  # right where the lease was over
                require_inside_lease(answer, last[number], context)
            expect.equal(session_id, worker.session_id, "the session of a repeat")
            last[number] = answer
    sleep_past(last[-1], context)
    require_ended_session(silent)
    for worker, repeat in repeats:
        expect.refused(worker.try_heartbeat(), "session_ended")
        if repeat.func == worker.try_predict:
            expect.refused(repeat(), "session_ended")


@requirement("LEASE-011")
@plays_histories
@background
def test_lease_011_end_of_lease_is_shown(context: CheckContext) -> None:
    """A worker plays a turn, sends a heartbeat, with a pause before each, and falls
    silent while `get_run` waits for a change. Where the kit starts servers, no other
    check sends requests to this one. Then leases end in generated histories, beside a
    worker that sends heartbeats. Expect the wait to end with the lease, in a run that
    is `ready` with the episode pending; no worker has sent anything. Then expect each
    wait to end with a change, and every answer and event as the oracle allows."""
    if not context.offers("waiting"):
        raise expect.NotApplicable("server does not announce the profile waiting")
    if not context.round_number:
        with open_quiet_server(context) as quiet:
            wait_for_the_end_of_a_lease(quiet)
            wait_for_the_first_of_two_leases(quiet)
    expect_histories_with_pauses(context, lease_of(context))


def wait_for_the_first_of_two_leases(context: CheckContext) -> None:
    """Expect a wait to end with a lease, while another one was renewed since."""
    lease_s = RENEWED_S + 1 + NOTICE_S
    if context.worker_count(2) < 2 or context.limits["idle_timeout_s_max"] < lease_s:
        return
    run = context.submit("count", "count", idle_timeout_s=lease_s)
    opened = [run.worker() for _ in range(2)]
    until = opened[0].try_attach().ended_at + lease_s + NOTICE_S
    opened[1].attach()
    time.sleep(RENEWED_S)
    opened[1].heartbeat()
    until += context.tolerance_s
    wait_s = min(context.limits["wait_s_max"], int(2 * lease_s))
    what = "a change with the first of two leases"
    wait_until(run, lambda shown: shown["live_workers"] < 2, wait_s, until, what)


def wait_until(
    run: RunClient,
    is_it: Callable[[dict[str, Any]], bool],
    wait_s: int,
    until: float,
    what: str,
) -> Answer:
    """Read the run with waits of `wait_s` until it is shown so; give that answer.

    Expect the answer to each wait by the time `until`.
    """
    read = run.call("get_run")
    while not is_it(expect.require(read, 200, "get_run")):
        headers = {"If-None-Match": read.headers["etag"], "Prefer": f"wait={wait_s}"}
        waited = run.call("get_run", headers=headers, timeout_s=wait_s + 30)
        expect.true(waited.ended_at <= until, what, waited.status)
        read = waited if waited.status == 200 else read
        time.sleep(0.05)  # where the wait ends for another reason
    return read


def wait_for_the_end_of_a_lease(context: CheckContext) -> None:
    """Expect a wait for a change to end with the lease of the only worker."""
    worker, _ = attach_with_lease(context)
    run, lease_s = worker.run, lease_of(context)
    # So that who looks when the lease before would have ended finds it alive.
    time.sleep(lease_s / 8)
    play_turn(worker)
    time.sleep(lease_s / 8)
    last = worker.try_heartbeat()
    expect.require(last, 200, "a heartbeat")
    wait_s = min(context.limits["wait_s_max"], int(lease_s) + NOTICE_S + 5)
    until = last.ended_at + lease_s + NOTICE_S
    what = "a change with the end of the lease"
    read = wait_until(run, lambda body: body["state"] != "running", wait_s, until, what)
    shown = expect.ok(read)
    expect.members(shown, {"state": "ready", "live_workers": 0})
    expect.equal(shown["progress"]["episodes_in_progress"], 0, "episodes in progress")
    episode = run.episodes()[index_of(worker)]
    expect.equal(episode["status"], "pending", "status of the episode")


# Tasks, max_attempts, played steps, what then happens → state, status and attempt.
LEASE_ENDS: list[tuple[int, int, int, str, str, str, int]] = [
    (2, 1, 0, "", "ready", "pending", 1),
    (1, 3, 2, "", "ready", "pending", 2),
    (2, 1, 1, "", "ready", "scored", 1),
    (1, 1, 1, "", "completed", "scored", 1),
    (2, 3, 1, "drain", "stopped", "pending", 2),
    (2, 3, 1, "takeover", "ready", "pending", 2),
]


def expect_others_unaffected(context: CheckContext) -> None:
    """Expect a worker to live on when the lease of one that is done ends."""
    if context.limits["max_workers"] < 2:
        return
    done, _ = attach_with_lease(context, "score", "score")
    second = done.run.worker("other")
    second.attach()
    last = end_last_episode(done)
    sleep_until(last.started_at + 0.6 * lease_of(context))
    second.try_heartbeat()
    began = play_turn(second)
    sleep_past(last, context)
    run = done.run.get()
    expect_inside_lease(second.try_next(), began, context)
    expect.equal(run["state"], "running", "state beside a session that plays")


@requirement("LEASE-012")
@background
def test_lease_012_end_of_lease_closes_the_attempt(context: CheckContext) -> None:
    """Six workers fall silent: before the first action, after some, in the last attempt
    (with and without an episode left), in a drain, and after a takeover. Expect the
    attempts closed, and `abandoned` after the last; a session that is done ends without
    a change of its run."""
    ended: list[WorkerClient] = []
    ends = [end for end in LEASE_ENDS if end[3] != "drain" or context.offers("control")]
    for tasks, max_attempts, steps, then, *_ in ends:
        options = {"max_attempts": max_attempts}
        worker, last = attach_with_lease(context, *["count"] * tasks, **options)
        for _ in range(steps):
            last = play_turn(worker)
        if then == "drain":
            drain(context, worker, last)
        if then == "takeover":
            last = worker.try_attach(takeover=True)
            session = expect.require(last, 200, "a takeover")
            worker.session_id, worker.seq = session["session_id"], session["seq"]
        ended.append(worker)
    expect_others_unaffected(context)
    sleep_past(last, context)
    for worker, (*_, state, status, attempt) in zip(ended, ends, strict=True):
        what = f"the end of a lease that leaves `{state}` and `{status}`"
        run = worker.run.get()
        episode = worker.run.episodes()[index_of(worker)]
        shown = [run["state"], episode["status"], episode["attempt"]]
        expect.equal(shown, [state, status, attempt], what)
        outcome = episode.get("result", {}).get("outcome")
        expect.equal(outcome, "abandoned" if status == "scored" else None, "outcome")
        refused = worker.try_predict(context.action(), seq=worker.seq or 1)
        expect.refused(refused, "session_ended")
    worker = ended[1]
    answer = worker.try_attach(attach_key=worker.attach_key)
    turn = expect.ok(answer if answer.status == 200 else worker.try_attach())
    expect.true(turn["session_id"] != worker.session_id, "another session", turn)
    expect.equal(turn["episode"]["attempt"], 2, "attempt of the turn")
    expect.equal(count(turn), [0], "count in the turn")
