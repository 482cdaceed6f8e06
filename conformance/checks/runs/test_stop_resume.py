"""Stop, drain and resume of a run (STOP, RES)."""

import time
from typing import Any

from hypothesis import strategies as st

from conformance.checks.support.generated.generated_examples import for_all
from conformance.checks.support.given_states import (
    attach_workers,
    start_drain,
    submit_and_attach,
)
from conformance.checks.support.long_turns import long_turn_s
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient, WorkerClient
from conformance.exchanges.answer import Answer
from conformance.runner.requirement import requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive, SetUpFailed

# How long a stop is sent after an attach, so that some stops meet it halfway.
_DELAYS_S = (0.0, 0.001, 0.002, 0.004, 0.008, 0.016)


@requirement("STOP-001", "STOP-005")
def test_stop_001_abort_closes_the_attempts_in_play(context: CheckContext) -> None:
    """One episode is scored, others are in progress, when the run is aborted. Expect
    the others unscored, and none in progress; the scored one unchanged."""
    run = context.submit("score", "score", "score")
    workers = attach_workers(run, context.worker_count(2))
    workers[0].play(score=0.75)
    for worker in workers:
        worker.predict(context.action(score=1, success=1))
    for step in (run.get, run.stop, run.get):
        step()
        run.score()
        if context.offers("lists"):
            run.episodes()


@requirement("STOP-002")
def test_stop_002_abort_ends_the_sessions(context: CheckContext) -> None:
    """Two workers continue with predict and heartbeat after the run is aborted, which
    is what a stop without a mode does; another one, whose session is done, with both;
    one attaches while the run is stopped, again and again, and afterwards.
    Expect `session_ended` for requests that were accepted before."""
    run = context.submit("score", "score", "score")
    attached_workers = attach_workers(run, context.worker_count(2))
    has_heartbeat = context.offers("sessions")
    for worker in attached_workers:
        worker.predict(context.action())
        if has_heartbeat:
            worker.heartbeat()
    expect.ok(run.call("stop_run", json={}))
    for worker in attached_workers:
        worker.try_predict(context.action())
        if has_heartbeat:
            worker.try_heartbeat()
    if len(attached_workers) > 1:
        done, _ = attach_workers(context.submit("score", "score"), 2)
        done.play()
        accepted = done.try_heartbeat()
        done.run.stop()
        if accepted.status == 200:
            expect.refused(done.try_heartbeat(), "session_ended")
        expect.refused(done.try_predict(context.action()), "session_ended")
    late = run.worker("late")
    if late.try_attach().status == 200:
        expect.refused(late.try_predict(context.action()), "session_ended")
    for delay_s in _DELAYS_S:
        stop_beside_an_attach(context, delay_s)


def stop_beside_an_attach(context: CheckContext, delay_s: float) -> None:
    """Play on, if possible, in a run that is stopped while a worker attaches."""
    worker = context.submit("score").worker()

    def stop_later() -> None:
        time.sleep(delay_s)
        worker.run.stop()

    attached, _ = context.call_concurrently(worker.try_attach, stop_later)
    worker.run.get()
    for answer in (attached, worker.try_attach()):
        if answer.status == 200:  # else it came after the stop, or was ended by it
            worker.session_id = answer.json["session_id"]
            worker.try_predict(context.action())


@requirement("STOP-003")
def test_stop_003_drain_lets_episodes_end(context: CheckContext) -> None:
    """Episodes in progress continue after a drain, and after another one, which follows
    a resume. Expect their turns accepted, and each to end as a success."""
    run = context.submit(*["score"] * 5)
    for _ in range(2):
        workers = attach_workers(run, context.worker_count(2))
        for worker in workers:
            worker.predict(context.action())
        run.stop("drain")
        for worker in workers:
            worker.predict(context.action())
            worker.play(success=1)
            run.results()
        run.until("stopped")
        run.resume(until_ready=True)


@requirement("STOP-004")
def test_stop_004_draining_worker_is_done(context: CheckContext) -> None:
    """One episode ends before, and another after, the start of a drain; one ends in a
    turn in the middle of which a drain starts. Expect `done` in the turn that ends the
    second, although a third is pending, and in the one that the drain met."""
    worker = submit_and_attach(context, "score", "score", "score")
    expect.equal(worker.play()["done"], False, "done before the drain")
    worker.run.stop("drain")
    turn = expect.ok(worker.try_predict(context.action(end=1)))
    expect.equal(turn["done"], True, "done")
    if not context.shared.settings.quick:
        drain_during_a_turn(context)


def drain_during_a_turn(context: CheckContext) -> None:
    """Expect `done` in the turn in the middle of which a drain starts."""
    worker = submit_and_attach(context, "delay", "delay")
    turn_s = long_turn_s(context)

    def drain_later() -> Answer:
        time.sleep(turn_s / 4)
        return worker.run.call("stop_run", json={"mode": "drain"})

    last, drain = context.call_concurrently(
        lambda: worker.try_predict(context.action(delay_s=turn_s, end=1)), drain_later
    )
    if expect.require(drain, 200, "a drain")["state"] != "stopping":
        raise Inconclusive("the drain came after the turn")
    expect.equal(expect.ok(last)["done"], True, "done in the turn that the drain met")


def scored(run: RunClient) -> dict[int, Any]:
    """Read the existing results, by position in the manifest."""
    return {i: result for i, result in enumerate(run.results()) if result is not None}


@requirement("RES-001")
def test_res_001_resume_keeps_results(context: CheckContext) -> None:
    """A run with two scored episodes and an abandoned one is stopped, resumed, and
    played to its end. Expect the three results unchanged after the resume and in the
    completed run."""
    worker = submit_and_attach(context, *["score"] * 5, max_attempts=2)
    run = worker.run
    worker.play(score=0.25)
    for _ in range(2):
        worker.predict(context.action(score=1))
        worker.detach()
        worker.attach()
    worker.play(score=0.75)
    worker.predict(context.action(score=1))
    run.stop()
    run.results()
    run.resume()
    run.results()
    run.until("ready")
    worker.attach()
    worker.play()
    worker.play()
    run.results()


@requirement("RES-002")
def test_res_002_resume_assigns_unscored_episodes(context: CheckContext) -> None:
    """A run of seven episodes is stopped three times, the last time by a drain, with
    one more scored each time, and another one begun. Expect exactly the unscored ones
    to be assigned after the last resume."""
    run = context.submit(*["score"] * 7, max_attempts=10)
    for mode in ("abort", "abort", "drain"):
        workers = attach_workers(run, context.worker_count(2))
        workers[-1].predict(context.action())
        if mode == "drain":
            start_drain(run)
        workers[0].play()
        if mode == "drain":
            workers[-1].detach()
        else:
            run.stop()
        run.resume(until_ready=True)
    worker = run.worker()
    turn = worker.attach()
    for _ in range(7):
        turn = turn if turn["done"] else worker.play()


class InterruptedRun:
    """A run that is played to a plan and interrupted."""

    def __init__(
        self, context: CheckContext, plan: list[list[float]], workers: int
    ) -> None:
        self.context = context
        self.plan = plan
        self.run = context.submit(*["score"] * len(plan), max_attempts=10)
        self.attached_workers = [self.run.worker() for _ in range(workers)]
        self.live: list[WorkerClient] = []

    def step(self, worker: WorkerClient) -> bool:
        """Play one action of the plan; False when the worker has no episode."""
        if worker not in self.live:
            worker.attach()
            self.live.append(worker)
        if worker.turn["done"]:
            return False
        view = worker.turn["episode"]
        scores = self.plan[int(view["index"])]
        score = scores[view["step"]]
        is_last = view["step"] == len(scores) - 1
        worker.predict(
            self.context.action(score=score, success=int(score > 0.5), end=int(is_last))
        )
        return True

    def interrupt(self, mode: str) -> bool:
        """Stop and resume; False when the run was already complete."""
        self.run.stop(mode)
        if mode == "drain":
            for worker in self.live:
                while self.step(worker):
                    pass
                worker.try_detach()  # some servers let go of it already
        self.live.clear()
        if self.run.get()["state"] == "completed":
            return False
        self.run.until("stopped")
        self.run.resume(until_ready=True)
        return True


OFTEN_STOPPED = ["0", "abort", "0", "drain", "0", "abort", "0", "drain", "abort"]
MOVES = st.lists(st.sampled_from(["0", "1", "0", "1", "abort", "drain"]), max_size=9)
# Sums of these are exact, in whatever order a server adds them.
PLAN = [[0.25, 0.75], [1.0], [0.5, 0.875, 0.125], [0.0625]]


@requirement("RES-003")
def test_res_003_stops_do_not_change_the_score(context: CheckContext) -> None:
    """Runs with two workers are aborted or drained and resumed: five times, and at
    random points. Expect the score and the results of a run that is played at once."""

    def play(moves: list[str]) -> None:
        played = InterruptedRun(context, PLAN, workers=context.worker_count(2))
        is_open = True
        for move in moves:
            if is_open and move in ("abort", "drain"):
                is_open = played.interrupt(move)
            elif is_open:
                worker = int(move) % len(played.attached_workers)
                played.step(played.attached_workers[worker])
                is_open = played.run.get()["state"] != "completed"
        while is_open and any(map(played.step, played.attached_workers)):
            is_open = played.run.get()["state"] != "completed"
        if not all(played.run.results()) or not played.run.score()["complete"]:
            raise SetUpFailed("an episode has no result", breaks="EPI-005")

    play(OFTEN_STOPPED)
    for_all(context, MOVES, play, times=7)
