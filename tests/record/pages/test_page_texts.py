"""Numbers as the pages write them for people."""

import math
import shlex
from datetime import UTC, datetime, timedelta
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from reference_client.command.command_line.arguments import parse
from reference_record.command_line.default_server import DEFAULT_URL
from reference_record.pages.comparison_page import (
    compare_while_played,
    comparison_document,
    pair_episodes,
    release_of,
)
from reference_record.pages.page_templates import duration, make_environment
from reference_record.pages.run_page import RunPace as Pace
from reference_record.pages.run_page import (
    around,
    commands,
    failures_first,
    pace_of,
    pictures_of,
    snapshot,
    task_table,
)
from reference_server.rules.comparison import compare
from reference_server.rules.scoring import ScoredEpisode


@pytest.mark.parametrize(
    ("seconds", "text"),
    [
        (None, "–"),
        (math.inf, "–"),
        (0.0, "0 s"),
        (0.00123, "1.23 ms"),
        (0.4, "400 ms"),
        (1.0, "1 s"),
        (3.24, "3.2 s"),
        (12.6, "13 s"),
        (95.0, "1 min 35 s"),
        (7261.0, "2 h 1 min"),
        (90061.0, "1 d 1 h"),
    ],
)
def test_a_duration_is_short_and_never_loses_what_is_small(
    seconds: float | None, text: str
) -> None:
    assert duration(seconds) == text


@pytest.mark.parametrize(
    ("state", "at_once", "ends_s", "now_s", "pace"),
    [
        ("running", 1, [0, 2, 4], 5, Pace(left_s=8.0)),
        ("running", 1, [0, 2, 4], 34, Pace(still_s=30.0)),
        ("running", 1, [0, 20, 40], 60, Pace(left_s=80.0)),
        ("running", 1, [0, 0.1, 0.2], 60, Pace(still_s=59.8)),
        ("running", 1, [0], 1, Pace()),
        ("running", 1, [0, 9], 10, Pace()),
        ("running", 1, [0], 60, Pace(still_s=60.0)),
        ("running", 1, [], 60, Pace()),
        ("stopped", 1, [0, 2, 4], 60, Pace()),
        # Rounds of three: one alone says nothing, as they began together.
        ("running", 3, [0, 0, 0], 1, Pace()),
        ("running", 3, [9, 9, 9, 18], 18, Pace(left_s=9.0)),
        ("running", 3, [9, 9, 9, 18, 18], 18, Pace(left_s=6.0)),
        ("running", 3, [0, 1, 2, 3, 4, 5], 9, Pace(left_s=1.0)),
    ],
    ids=str,
)
def test_the_time_left_is_that_of_a_run_that_goes_on(
    state: str, at_once: int, ends_s: list[float], now_s: float, pace: Pace
) -> None:
    start = datetime(2026, 11, 29, tzinfo=UTC)
    episodes = [
        {"result": {"finished_at": (start + timedelta(seconds=at)).isoformat()}}
        for at in ends_s
    ]
    progress = {"episodes_total": 7, "episodes_scored": len(ends_s)}
    progress["episodes_in_progress"] = at_once
    run = {"state": state, "progress": progress}
    assert pace_of(run, episodes, start + timedelta(seconds=now_s)) == pace


RUN: dict[str, Any] = {
    "run_id": "run_1",
    "benchmark_id": "b",
    "policy": {"name": "my policy"},
    "manifest_sha256": "1",
    "progress": {"episodes_scored": 1, "episodes_total": 2},
}
DEFAULT = {
    "manifest_sha256": "1",
    "image_codecs": ["png"],
    "image_sizes": [{"width": 2, "height": 1}],
}
SAME = "proctor run --policy POLICY --benchmark b --name 'my policy'"


@pytest.mark.parametrize(
    ("members", "command"),
    [
        ({}, SAME),
        ({"policy": {"name": "my policy", "version": "2"}}, " --policy-version 2"),
        ({"select": {"tasks": ["a", "b"], "splits": ["c"]}}, " --tasks a,b --split c"),
        ({"options": {"tasks": ["it's"]}}, """ --options '{"tasks": ["it'"'"'s"]}'"""),
        ({"images": {"codec": "png", "width": 2, "height": 1}}, SAME),
        ({"images": {"codec": "jpeg", "width": 2, "height": 1}}, " --images jpeg:2x1"),
        ({"any_policy": True}, " --any-policy"),
        (
            {"policy_server": {"url": "http://p", "model": "m"}},
            "proctor submit --push http://p --model m --benchmark b --name 'my policy'",
        ),
        (
            {"policy_server": {"url": "http://p", "protocol": "openai_completions"}},
            (
                "proctor submit --push http://p --protocol openai_completions "
                "--benchmark b --name 'my policy'"
            ),
        ),
        (
            {
                "policy_server": {
                    "url": "http://p",
                    "protocol": "openai_chat",
                    "model": "m",
                    "generation": {"temperature": 0},
                },
                "policy": {"name": "m", "version": "2"},
                "select": {"tasks": ["a"], "splits": ["c"]},
                "any_policy": True,
            },
            (
                "proctor submit --push http://p --model m --generation "
                "'{\"temperature\": 0}' --benchmark b --name m --policy-version 2 "
                "--tasks a --split c --any-policy"
            ),
        ),
        ({"options": {"a": "x" * 9000}}, " --options JSON"),
    ],
)
def test_runs_are_repeated_with_options(members: dict[str, Any], command: str) -> None:
    ((title, shown),) = commands(RUN | members, DEFAULT)
    assert shown == (SAME + command if command.startswith(" ") else command)
    words = shlex.split(shown.replace("--options JSON", ""))
    assert parse(words[1:]).benchmark == "b"
    assert title == "Evaluate a policy in the same way"


@pytest.mark.parametrize("images", [{}, {"front": {}}])
def test_only_a_run_with_cameras_has_a_format_of_pictures(
    images: dict[str, Any],
) -> None:
    chosen = {"codec": "jpeg", "width": 2, "height": 1}
    described = DEFAULT | {"observation_space": {"images": images}}
    run = RUN | {"images": chosen}
    assert pictures_of(run, described) == (chosen if images else None)
    assert ("--images" in commands(run, described)[0][1]) is bool(images)


@pytest.mark.parametrize(
    ("members", "has_failures", "images", "is_named"),
    [
        ({}, True, {"front": {}}, True),
        ({}, True, None, True),
        ({}, True, {}, False),
        ({"benchmark_id": "tabletop_state"}, True, {}, True),
        ({}, False, {"front": {}}, False),
        ({"state": "running"}, True, {"front": {}}, False),
        ({"judged": {"cells": {}}}, True, {"front": {}}, False),
    ],
    ids=str,
)
def test_one_command_draws_all_failures_that_a_camera_sees(
    members: dict[str, Any],
    has_failures: bool,
    images: dict[str, Any] | None,
    is_named: bool,
) -> None:
    run = RUN | {"state": "completed"} | members
    described = None if images is None else {"observation_space": {"images": images}}
    shown = [line for _, line in commands(run, described, has_failures=has_failures)]
    assert ("proctor video run_1 --failures" in shown) is is_named


def test_commands_of_a_page_name_its_server() -> None:
    """At a server where the command does not look by itself."""
    run = RUN | {"state": "completed", "retryable": True}
    run |= {"endpoint": "http://127.0.0.1:8471/"}
    run["progress"] = {"episodes_scored": 2, "episodes_total": 2}
    shown = [line for _, line in commands(run, None, has_failures=True)]
    asking = [line.partition(" && ")[0] for line in shown]
    assert [line.split()[1] for line in asking] == ["resume", "run", "export", "video"]
    assert all(line.endswith(" --url http://127.0.0.1:8471") for line in asking)
    run |= {"endpoint": DEFAULT_URL}
    assert not any("--url" in line for _, line in commands(run, None))


@pytest.mark.parametrize(
    ("members", "first"),
    [
        ({"state": "failed", "retryable": True}, "proctor resume run_1"),
        ({"state": "failed", "retryable": False}, "proctor run --policy POLICY"),
        ({"state": "running"}, "proctor run --policy POLICY"),
        ({"state": "ready"}, "proctor run --run-id run_1 --policy POLICY"),
        ({"state": "stopped"}, "proctor run --run-id run_1 --policy POLICY"),
        ({"state": "ready", "policy_server": {"url": "http://p"}}, "proctor submit"),
    ],
    ids=str,
)
def test_a_run_without_a_score_says_how_it_goes_on(
    members: dict[str, Any], first: str
) -> None:
    shown = commands(RUN | members, DEFAULT)
    assert shown[0][1].startswith(first)


@pytest.mark.parametrize(
    ("members", "said"),
    [
        ({"state": "ready"}, True),
        ({"state": "ready", "reason": "It waits for its robot."}, False),
        ({"state": "running"}, False),
        ({"state": "completed"}, False),
    ],
    ids=str,
)
def test_a_run_that_no_worker_plays_says_since_when(
    members: dict[str, Any], said: bool
) -> None:
    """The server cannot know that a policy raised, but where to read that it did."""
    run = RUN | {"reason": None, "updated_at": "2026-11-30T12:34:56Z"} | members
    episodes = [{"task": "a", "split": "c"}]
    shown_run, score = snapshot(run | {"progress": {}}, episodes)
    template = make_environment().get_template("parts/summary.html.j2")
    table = task_table(episodes)
    shown = template.render(run=shown_run, score=score, pace=Pace(), table=table)
    note = "No worker has played this run since 2026-11-30 12:34:56 UTC: "
    assert (note in shown) == said


CHANGED = "The benchmark has changed since this run"


@pytest.mark.parametrize(
    ("members", "described", "said"),
    [
        ({}, DEFAULT, f"{CHANGED}, or this run had options (--options), which"),
        ({"options": None}, DEFAULT, f"{CHANGED}: the command names another"),
        ({"options": {}}, DEFAULT, f"{CHANGED}: the command names another"),
        ({"options": {"a": 1}}, DEFAULT, ""),
        ({"select": {"tasks": ["a"]}}, DEFAULT, ""),
        ({}, None, ""),
        ({"manifest_sha256": "1"}, DEFAULT, ""),
    ],
)
def test_why_a_run_has_another_manifest_is_said_as_far_as_it_is_known(
    members: dict[str, Any], described: dict[str, Any] | None, said: str
) -> None:
    """A server knows the options of its runs, a report does not."""
    other = RUN | {"manifest_sha256": "2"} | members
    ((title, _),) = commands(other, described)
    assert (said in title) if said else (title == "Evaluate a policy in the same way")


@pytest.mark.parametrize(
    ("episode_id", "ids"),
    [("e0", [None, "e2"]), ("e2", ["e0", "e1"]), ("e1", ["e2", None])],
)
def test_walk_from_failure_to_failure(episode_id: str, ids: list[str | None]) -> None:
    results = {"e0": "failure", "e1": "success", "e2": "failure"}
    episodes = [
        {"episode_id": name, "index": index, "result": {"outcome": outcome}}
        for index, (name, outcome) in enumerate(results.items())
    ]
    walked = around(failures_first(episodes), episode_id)
    assert [one and one["episode_id"] for one in walked] == ids
    assert around([], episode_id) == [None, None]


@pytest.mark.parametrize(
    ("run_id", "file"),
    [("run_1", "run_1.proctor"), ("1", "run-1.proctor"), ("-x", "run--x.proctor")],
)
def test_a_record_is_called_as_its_run(run_id: str, file: str) -> None:
    done = {"episodes_scored": 2, "episodes_total": 2}
    (_, (_, check)) = commands(RUN | {"run_id": run_id, "progress": done}, None)
    assert check == f"proctor export {run_id} && proctor verify {file}"


@pytest.mark.parametrize(
    ("url", "place"), [(DEFAULT_URL, ""), ("https://e.org", " --url https://e.org")]
)
def test_a_record_is_checked_with_the_keys_of_its_server(url: str, place: str) -> None:
    """Also with those of the default server, which `verify` does not ask by itself."""
    done = {"episodes_scored": 2, "episodes_total": 2}
    run = RUN | {"run_id": "run_1", "progress": done, "endpoint": url}
    (_, (_, check)) = commands(run, None)
    export = f"proctor export run_1{place}"
    assert check == f"{export} && proctor verify run_1.proctor --server {url}"


@pytest.mark.parametrize(
    ("baseline", "run", "verdict"),
    [
        ([1, 1, 1, 0], [1, 1, 1, 0], "yes: no difference exceeds 0.05"),
        ([0, 0, 1, 1], [1, 1, 1, 1], "yes: nothing is worse by more than 0.05; better"),
        ([1] * 20, [0] * 20, "no: worse by more than 0.05 overall and in lift"),
        ([1, 0, 1, 0], [0, 1, 0, 0], "not decided: worse by more than 0.05 overall"),
        ([1, 1], [1, None], "no: not every episode is scored in both"),
        ([None], [None], "no: not every episode is scored in both"),
    ],
)
def test_a_page_has_the_verdict_of_the_command(
    baseline: list[float | None], run: list[float | None], verdict: str
) -> None:
    pairs = pair_episodes(*map(episodes_with, (baseline, run)))
    assert release_of(pairs, compare_while_played(pairs)).startswith(verdict)


@given(
    st.lists(
        st.tuples(
            st.sampled_from(["lift", "push"]),
            *[st.sampled_from([None, "abandoned", 0.0, 0.5, 0.97, 1.0])] * 2,
        ),
        min_size=1,
        max_size=12,
    ),
    st.sampled_from([0.0, 0.05, 1.0]),
)
def test_records_are_compared_as_a_server_compares_runs(
    drawn: list[tuple[str, Any, Any]], tolerance: float
) -> None:
    """drawn: task, what the baseline got and what the run got."""
    sides = [
        [_played(index, row[0], row[side]) for index, row in enumerate(drawn)]
        for side in (1, 2)
    ]
    run = {"run_id": "r", "benchmark_id": "b", "manifest_sha256": "0"}
    document = comparison_document([(run, side) for side in sides], tolerance)
    (compared,) = document["runs"]
    scored = [
        [
            ScoredEpisode(one["task"], "val", got.get("outcome"), got.get("score", 0.0))
            for one in side
            for got in [one.get("result", {})]
        ]
        for side in sides
    ]
    assert compared == {"run_id": "r", **compare(scored[0], scored[1], tolerance)}


def _played(index: int, task: str, got: str | float | None) -> dict[str, Any]:
    episode: dict[str, Any] = {"index": index, "task": task, "split": "val"}
    if got is None:
        return episode
    if isinstance(got, str):  # counts 0, whatever was reached
        return episode | {"result": {"score": 0.5, "outcome": got}}
    return episode | {"result": result_of(got)}


def episodes_with(scores: list[float | None]) -> list[dict[str, Any]]:
    """Episodes of one task; one without a score has no result."""
    return [
        {"index": index, "task": "lift", "split": "val"}
        | ({} if score is None else {"result": result_of(score)})
        for index, score in enumerate(scores)
    ]


def result_of(score: float) -> dict[str, Any]:
    return {"score": score, "outcome": "success" if score == 1 else "failure"}
