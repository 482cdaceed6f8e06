"""Why a worker has left an episode, or a run was stopped: the profile `reasons` (RSN).

A server cannot know whether a reason is true; it shows what it was given.
"""

from typing import Any

from conformance.checks.support.given_states import submit_and_attach
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient, WorkerClient
from conformance.runner.private_server import open_server_of_its_own
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect

_LONGEST = 500
_MARKUP = '<b>&amp;</b> "\u00e9"\t\\ \u540d \U0001f916 '
_OF_ONE_RUN = ("run_id", "finished_at", "think_s")


def give(worker: WorkerClient, reason: str) -> None:
    """Send a heartbeat with a reason."""
    expect.ok(worker.try_heartbeat(reason=reason))


def expect_left(run: RunClient, *expected: tuple[int, str] | None) -> None:
    """Expect the attempts and reasons of `last_left`; None where it is absent."""
    lefts = [episode.get("last_left") for episode in run.episodes()]
    shown = [left and (left["attempt"], left["reason"]) for left in lefts]
    expect.equal(shown, list(expected), "last_left of each episode")


@requirement("RSN-001")
def test_rsn_001_an_episode_shows_why_it_was_left(context: CheckContext) -> None:
    """Heartbeats without a reason, with one, with another one, and refused ones; then
    the attempt goes on, ends by a detach, is left again, and the episode is played to
    its end. The next one is left with the longest text, with markup; the session is
    done at last. Expect the latest reason of each, character for character, with its
    attempt, and no other."""
    worker = submit_and_attach(context, "count", "count")
    run = worker.run
    worker.heartbeat()
    expect_left(run, None, None)
    give(worker, "first")
    expect_left(run, (1, "first"), None)
    too_long = worker.try_heartbeat(reason="x" * (_LONGEST + 1))
    expect.refused(too_long, "invalid_request", pointer="/reason")
    worker.predict(context.action())
    give(worker, "second")
    worker.heartbeat()
    worker.predict(context.action())
    expect_left(run, (1, "second"), None)
    worker.detach()
    expect.refused(worker.try_heartbeat(reason="late"), "session_ended")
    worker.attach()
    expect_left(run, (1, "second"), None)
    give(worker, "second")
    worker.play()
    expect_left(run, (2, "second"), None)
    longest = (_MARKUP * _LONGEST)[: _LONGEST - 1] + "."
    give(worker, longest)
    worker.play()
    worker.try_heartbeat(reason="done")
    expect_left(run, (2, "second"), (1, longest))


@requirement("RSN-002")
def test_rsn_002_a_reason_changes_nothing_else(context: CheckContext) -> None:
    """Two runs are played alike: an episode goes on after a heartbeat, the attempt of
    another one is given up after one; in the second run the heartbeats have a reason.
    Expect the same turns, attempts, results and scores."""
    played = []
    for reason in (None, "The policy raised ValueError."):
        worker = submit_and_attach(context, "count", "count", "count")
        turns = [worker.turn]
        for leaves in (False, True):
            turns.append(worker.predict(context.action()))
            expect.ok(worker.try_heartbeat(reason=reason))
            expect.equal(worker.run.get()["live_workers"], 1, "live_workers")
            if leaves:
                worker.detach()
                turns.append(worker.attach())
            turns.append(worker.play())
        steps = [turn["episode"] for turn in turns]
        shown = (worker.run.episodes(), worker.run.score())
        played.append((steps, worker.run.get()["state"], *map(comparable, shown)))
    names = ("episodes in turns", "state", "episodes", "score")
    for name, without, with_reason in zip(names, *played, strict=True):
        expect.equal(with_reason, without, f"{name}, with reasons")


def comparable(value: Any) -> Any:
    """Leave out what two runs differ in, and the reasons."""
    if isinstance(value, list):
        return [comparable(item) for item in value]
    if not isinstance(value, dict):
        return value
    left_out = (*_OF_ONE_RUN, "last_left")
    return {k: comparable(v) for k, v in value.items() if k not in left_out}


@background
@requirement("RSN-003")
def test_rsn_003_reasons_survive_a_crash(context: CheckContext) -> None:
    """A private server is killed when it has shown the reasons of an episode in play
    and of one that was given up. Expect both after the restart."""
    with open_server_of_its_own(context) as server:
        playing, left = (submit_and_attach(server.context, "count") for _ in range(2))
        for worker in (playing, left):
            worker.predict(server.context.action())
            give(worker, f"reason of {worker.run.id}")
        left.detach()
        for restarts in (False, True):
            if restarts:
                server.kill9()
                server.restart()
            for worker in (playing, left):
                expect_left(worker.run, (1, f"reason of {worker.run.id}"))


@requirement("RSN-004")
def test_rsn_004_a_run_shows_why_it_was_stopped(context: CheckContext) -> None:
    """A run in play is stopped with the longest reason, with markup; another one
    without a reason. With `control` a third is drained with it, and its worker
    detaches. Expect it in `reason` of the first and the third, then and later."""
    reason = (_MARKUP * _LONGEST)[: _LONGEST - 1] + "."
    afterwards = {"abort": "stopped"}
    if context.offers("control"):
        afterwards["drain"] = "stopping"
    for mode, state in afterwards.items():
        worker = submit_and_attach(context, "count")
        worker.run.stop(mode, reason=reason)
        expect_reason(worker.run.until(state), reason)
        worker.detach()
        expect_reason(worker.run.until("stopped"), reason)
    without = context.submit("count").stop()
    expect.true(reason not in (without["reason"] or ""), "another reason", without)


def expect_reason(run: dict[str, Any], reason: str) -> None:
    """Expect the text in what the run says of its state."""
    shown = run["reason"]
    expect.true(reason in (shown or ""), "the reason of the stop in `reason`", shown)
