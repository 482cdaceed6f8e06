"""Who played an episode, and how much was clipped: the profile `attribution` (ATR).

A result shows what its client declared; a server knows nothing else about the client.
"""

from typing import Any

from conformance.checks.support.submissions import submit_and_show
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient, WorkerClient
from conformance.runner.requirement import requirement
from conformance.verdicts import expect

POLICY = {"name": "Kit policy", "version": "1.0"}
# The sum of rewards of each episode that ATR-006 plays.
RETURNS = [2.375, 1.125, 0.375]
OTHER = {"name": "another policy", "version": "2", "client": "kit/1 (\u540d)"}


def attach(
    run: RunClient, player: dict[str, Any] | None, *, takeover: bool = False
) -> WorkerClient:
    worker = run.worker("worker")
    worker.attach(takeover, player=player)
    return worker


def play_part(worker: WorkerClient) -> None:
    """Play a step and detach, which costs the attempt."""
    worker.predict(worker.run.context.action())
    worker.detach()


def action(context: CheckContext, *clipped: float, **values: Any) -> dict[str, Any]:
    return context.action(clipped=list(clipped or (0.0, 0.0)), **values)


def players(run: RunClient) -> list[Any]:
    """Give the player of each result; None where a result has none."""
    return [result and result.get("player") for result in run.results()]


@requirement("ATR-001")
def test_atr_001_cannot_attach_for_another_policy(context: CheckContext) -> None:
    """A run of one policy; players with other names, then with another version. Expect
    `policy_mismatch` pointing at what differs, also for a second worker, in a takeover
    and with `any_policy` false; success for the run's own policy."""
    run = context.submit(*["count"] * 3, policy=POLICY, max_workers=1)
    for name in ("another policy", "kit policy", "Kit polic", "Kit policy 1.0", "1.0"):
        answer = run.worker().try_attach(player=POLICY | {"name": name})
        expect.refused(answer, "policy_mismatch", pointer="/player/name")
    for version in ("1", "1.00", ""):
        answer = run.worker().try_attach(player=POLICY | {"version": version})
        expect.refused(answer, "policy_mismatch", pointer="/player/version")
    worker = run.worker()
    expect.ok(worker.try_attach(player=POLICY))
    answer = worker.try_attach(takeover=True, player=OTHER)
    expect.refused(answer, "policy_mismatch", pointer="/player/name")
    expect.ok(worker.try_attach(takeover=True, player=POLICY))
    closed = context.submit(policy=POLICY, any_policy=False)
    answer = closed.worker().try_attach(player=OTHER)
    expect.refused(answer, "policy_mismatch", pointer="/player/name")


@requirement("ATR-002")
def test_atr_002_a_player_of_the_run_may_attach(context: CheckContext) -> None:
    """Players that say less or more than the run, none, and any with `any_policy`.
    Expect each to be attached, and another policy's not."""
    run = context.submit(*["count"] * 2, policy=POLICY, max_workers=1)
    for player in ({"name": "Kit policy"}, POLICY | {"client": "kit/1"}, None):
        worker = run.worker()
        expect.ok(worker.try_attach(player=player))
        worker.attach(takeover=True, player=player)
        worker.detach()
    expect.refused(run.worker().try_attach(player=OTHER), "policy_mismatch")
    nameless = context.submit(policy={"name": "Kit policy"})
    expect.ok(nameless.worker().try_attach(player=POLICY))
    for player in (OTHER, POLICY, None):
        open_run = context.submit(policy=POLICY, any_policy=True)
        expect.ok(open_run.worker().try_attach(player=player))


@requirement("ATR-003")
def test_atr_003_a_result_shows_who_played(context: CheckContext) -> None:
    """Episodes of one player, taken over by another and again by the first, taken over
    by the same, after the takeover, without a player, and taken over from none twice by
    another. Then two attempts of an episode by two players, the second time up to the
    end of the attempts. Then one player before a fault, and two. Expect the player of
    an attempt that one alone played, abandoned or not, and none in the others."""
    run = context.submit(*["count"] * 6, policy=POLICY, any_policy=True)
    worker = attach(run, POLICY)
    shown = worker.play()["episode_result"].get("player")
    expect.equal(shown, POLICY, "player in the turn that ends an episode")
    worker.predict(context.action())
    attach(run, OTHER, takeover=True)
    worker = attach(run, POLICY, takeover=True)
    worker.play()
    worker.predict(context.action())
    worker = attach(run, POLICY, takeover=True)
    worker.play()
    worker.play()
    worker.detach()
    worker = attach(run, None)
    worker.play()
    worker.predict(context.action())
    for _ in range(2):
        worker = attach(run, OTHER, takeover=True)
    worker.play()
    expected = [POLICY, None, POLICY, POLICY, None, None]
    expect.equal(players(run), expected, "players of the episodes")
    run = context.submit("count", "count", any_policy=True, max_attempts=2)
    play_part(attach(run, POLICY))
    worker = attach(run, OTHER)
    worker.play()
    play_part(worker)
    play_part(attach(run, POLICY))
    outcomes = [result and result["outcome"] for result in run.results()]
    expect.equal(outcomes[1], "abandoned", "outcome of the second episode")
    expect.equal(players(run), [OTHER, POLICY], "players of the attempts")
    run = context.submit("fault", "fault", any_policy=True)
    worker = attach(run, POLICY)
    worker.predict(context.action(fault=1))
    worker.play()
    worker.predict(context.action())
    worker = attach(run, OTHER, takeover=True)
    worker.predict(context.action(fault=1))
    worker.play()
    expect.equal(players(run), [POLICY, None], "players of attempts with a fault")


def clipped_actions(run: RunClient) -> list[Any]:
    """Those of each result; None where a result has none."""
    return [result and result.get("clipped_actions") for result in run.results()]


@requirement("ATR-004")
def test_atr_004_clipped_actions_are_counted(context: CheckContext) -> None:
    """Actions outside of a range in one number or in both, at its ends, below and
    above; actions behind the end of an episode; several turns; a takeover. Then such
    actions before a stop, before a fault, and in an abandoned attempt. Expect each
    executed one that was outside to count once, in the attempt that has the result,
    from its last beginning."""
    run = context.submit(*["count"] * 4)
    worker = attach(run, None)
    outside = [action(context, *v) for v in ((1.5, -2.0), (0.0, 1.0001), (-1e9, 0.0))]
    inside = [action(context, *v) for v in ((1.0, -1.0), (-0.0, 5e-324))]
    worker.predict(outside[0], inside[0], outside[1])
    worker.predict(inside[1], outside[2], action(context, 0.0, 7.0, end=1))
    worker.predict(action(context, end=1), *outside)
    worker.predict(outside[0], inside[0])
    worker = attach(run, None, takeover=True)
    worker.predict(outside[1], action(context, end=1), outside[2])
    worker.play()
    expect.equal(clipped_actions(run), [4, 0, 2, 0], "clipped_actions of turns")
    run = context.submit("count", "fault", "count", max_attempts=2)
    clipped = action(context, 2.0, 0.0)
    attach(run, None).predict(*[clipped] * 3)
    run.stop()
    run.resume(until_ready=True)
    worker = attach(run, None)
    worker.predict(action(context, 2.0, 0.0, end=1))
    worker.predict(*[clipped] * 2)
    worker.predict(action(context, 2.0, 0.0, fault=1))
    worker.predict(action(context), action(context, 2.0, 0.0, end=1))
    worker.predict(*[clipped] * 3)
    worker.detach()
    worker = attach(run, None)
    worker.predict(clipped)
    play_part(worker)
    expect.equal(clipped_actions(run), [1, 1, 1], "clipped_actions of attempts")


@requirement("ATR-005")
def test_atr_005_a_run_shows_whether_others_may_play(context: CheckContext) -> None:
    """Runs with `any_policy` true, false and absent. Expect each to show it, in every
    operation that shows a run."""
    for sent, shown in ((True, True), (False, False), (None, False)):
        _, views = submit_and_show(context, any_policy=sent)
        shown_values = {name: view.get("any_policy") for name, view in views.items()}
        expect.equal(shown_values, dict.fromkeys(views, shown), f"shown for {sent}")


@requirement("ATR-006")
def test_atr_006_rewards_are_added_up(context: CheckContext) -> None:
    """Episodes of several turns, one of which ends before its chunk does, a takeover,
    and a fault. Expect the sum of the rewards of the executed actions of each."""
    run = context.submit("score", "count", "fault")
    worker = attach(run, None)
    rewarded = [context.action(score=number) for number in (0.5, 0.25, 1.0)]
    last = context.action(score=0.125, end=1)
    worker.predict(*rewarded)
    worker.predict(rewarded[0], last, *rewarded[:2])
    worker.predict(rewarded[2])
    worker = attach(run, None, takeover=True)
    worker.predict(last)
    worker.predict(*rewarded)
    worker.predict(context.action(score=1, fault=1))
    worker.predict(rewarded[1], last)
    added = [result and result.get("total_reward") for result in run.results()]
    expect.true(
        len(added) == len(RETURNS)
        and all(
            isinstance(total, int | float) and abs(total - wanted) <= 1e-9 * wanted
            for total, wanted in zip(added, RETURNS, strict=True)
        ),
        f"total_reward {RETURNS}",
        added,
    )
