"""Runs of a part of a benchmark: the profile `subsets` (SUB)."""

from collections.abc import Mapping
from typing import Any

from conformance.checks.support.given_states import expect_pointer, submit_and_attach
from conformance.checks.support.submissions import submit, submit_and_show
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient
from conformance.runner.requirement import requirement
from conformance.verdicts import expect

# Episodes 0 to 4; the even ones are of the split `even`, calibration.md says.
TASKS = ("score", "count", "count", "score", "echo")
SELECTIONS: list[tuple[dict[str, list[str]], list[int]]] = [
    ({"tasks": ["count"]}, [1, 2]),
    ({"tasks": ["echo", "score"]}, [0, 3, 4]),
    ({"splits": ["odd"]}, [1, 3]),
    ({"tasks": ["score", "echo"], "splits": ["even"]}, [0, 4]),
    ({"tasks": ["score", "fault"], "splits": ["odd", "even"]}, [0, 3]),
    ({}, [0, 1, 2, 3, 4]),
]


def submit_part(context: CheckContext, select: Mapping[str, Any] | None) -> RunClient:
    return context.submit(*TASKS, select=select, wait_ready=False)


def expect_selection_is_played(context: CheckContext) -> None:
    worker = submit_and_attach(context, *TASKS, select={"tasks": ["count"]})
    run = worker.run
    worker.play(success=1)
    expect.equal(worker.play()["done"], True, "done after the last selected episode")
    seeds = [result and result["seed"] for result in run.results()]
    expect.equal(seeds, [1001, 1002], "seeds of the episodes")
    score = expect.ok(run.call("get_score"))
    actual = (score["complete"], score["score"], score["counts"]["total"])
    expect.equal(actual, (True, 0.5, 2), "complete, score and total")
    expect.equal(run.get()["state"], "completed", "state")


@requirement("SUB-001")
def test_sub_001_a_run_has_the_selected_episodes(context: CheckContext) -> None:
    """Selections of tasks, of splits, of both, and of nothing in particular; then one
    is played. Expect the episodes of each in the benchmark's order, counted from 0, as
    many in `progress`, the seeds of the benchmark, and a complete score of the part
    alone."""
    for select, wanted in SELECTIONS:
        run = submit_part(context, select)
        episodes = expect.ok(run.call("list_episodes"))["episodes"]
        actual = [(e["index"], e["task"], e["split"]) for e in episodes]
        expected = [
            (index, TASKS[place], ("even", "odd")[place % 2])
            for index, place in enumerate(wanted)
        ]
        expect.equal(actual, expected, f"episodes of {select}")
        total = expect.ok(run.call("get_run"))["progress"]["episodes_total"]
        expect.equal(total, len(wanted), f"episodes_total of {select}")
    expect_selection_is_played(context)


@requirement("SUB-002")
def test_sub_002_cannot_select_what_is_not_there(context: CheckContext) -> None:
    """Unknown tasks and splits, alone and beside known ones; tasks and splits that the
    run has no episode of. Expect `invalid_request` pointing at the selection; success
    for the known ones."""
    options = {"tasks": list(TASKS)}
    for select in (
        {"tasks": ["juggle"]},
        {"tasks": ["count", "juggle"]},
        {"tasks": ["odd"]},
        {"splits": ["Even"]},
        {"splits": ["even", "test"]},
        {"tasks": ["fault"]},
        {"tasks": ["echo"], "splits": ["odd"]},
    ):
        body = context.submit_body(options=options, select=select)
        problem = expect.refused(submit(context, body), "invalid_request")
        expect_pointer(problem, "/select")
    body = context.submit_body(options=options, select={"tasks": ["count"]})
    expect.ok(submit(context, body), 201)


@requirement("SUB-003")
def test_sub_003_a_selection_is_shown(context: CheckContext) -> None:
    """Runs with a selection, with an empty one, and without. Expect `select` as it was
    sent in every operation that shows the run and in the score, and in none of them
    without it."""
    both = {"tasks": ["score", "echo"], "splits": ["even"]}
    for select in (both, {"tasks": ["count"]}, {}, None):
        options = {"tasks": list(TASKS)}
        run, views = submit_and_show(context, options=options, select=select)
        views["get_score"] = expect.ok(run.call("get_score"))
        selections = {name: view.get("select") for name, view in views.items()}
        expect.equal(selections, dict.fromkeys(views, select), f"select, sent {select}")


@requirement("SUB-004")
def test_sub_004_the_digest_is_of_the_episodes(context: CheckContext) -> None:
    """Runs of the same episodes, selected in several ways, and of other ones. Expect
    one digest for all ways to the same episodes, and another for each other selection.
    """
    same: list[list[dict[str, list[str]] | None]] = [
        [None, {}, {"tasks": ["score", "count", "echo"]}, {"splits": ["even", "odd"]}],
        [{"tasks": ["count"]}, {"tasks": ["fault", "count"]}],
        [{"tasks": ["echo"]}, {"tasks": ["echo"], "splits": ["even"]}],
        [{"splits": ["odd"]}],
    ]
    digests = []
    for ways in same:
        of_ways = [submit_part(context, way).body["manifest_sha256"] for way in ways]
        expect.equal(len(set(of_ways)), 1, f"number of digests of {ways}")
        digests.append(of_ways[0])
    expect.equal(len(set(digests)), len(same), "number of digests of all selections")


@requirement("SUB-005")
def test_sub_005_a_session_begins_the_wanted_episodes_alone(
    context: CheckContext,
) -> None:
    """A worker wants the first two episodes of a run; another one, where two may play,
    wants all and has the second. They are ended; workers attach for the first two and
    for four. Expect `done` for those that want two, and the next episode for others."""
    slots = context.worker_count(2)
    run = context.submit(*TASKS[:4], max_workers=slots)
    bounded, other, end = run.worker(), run.worker(), context.action(end=1)
    first = bounded.attach(first_episodes=2)
    expect.equal(first["episode"]["index"], 0, "index of the first episode")
    if slots > 1:
        other.attach()
    else:
        bounded.predict(end)
    ended = expect.ok(bounded.try_predict(end))
    expect.equal(ended["done"], True, "done, while no other episode is wanted")
    if slots > 1:
        goes_on = expect.ok(other.try_predict(end))
        expect.equal(goes_on["done"], False, "done of a session that wants all")
        expect.equal(goes_on["episode"]["index"], 2, "index of its next episode")
    late = expect.ok(run.worker().try_attach(first_episodes=2))
    expect.equal(late["done"], True, "done, when all wanted episodes are scored")
    more = expect.ok(run.worker().try_attach(first_episodes=4))
    expect.equal(more["episode"]["index"], slots + 1, "index of one that is wanted")
