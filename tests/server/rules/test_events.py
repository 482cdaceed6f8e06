"""Which events a reader gets next: none lost, none twice, from any cursor."""

from __future__ import annotations

import json
import typing
from collections.abc import Iterator
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from conformance.client.event_reader import Event, EventParser
from reference_server.rules.runs.events import Cursor, EventBatch, is_final, next_batch
from reference_server.rules.runs.lifecycle import Event as LifecycleEvent
from reference_server.rules.runs.lifecycle import legal
from reference_server.rules.runs.run import Run, State
from tests.support.server.runs import make_run
from tests.support.server.server_parts import RESULT, record_score

LENGTH = 6
AT_ONCE = 2


def run_body(run: Run) -> bytes:
    """A run as a reader sees it: its state and what is scored."""
    return json.dumps({"state": run.state, "scored": run.scored}).encode()


def read_batch(run: Run, cursor: Cursor) -> EventBatch:
    window = run.window(cursor.results_sent, cursor.results_sent + AT_ONCE, scored=True)
    entries = [json.dumps(episode.index).encode() for episode in window]
    return next_batch(cursor, run, run_body(run), entries, run_body(run))


def read_all_events(run: Run, cursor: Cursor) -> tuple[list[Event], Cursor]:
    """All events after a cursor, and the cursor after them."""
    parser, events = EventParser(), []
    while True:
        batch = read_batch(run, cursor)
        events += parser.feed(batch.text)
        cursor = batch.cursor
        if not batch.is_behind:
            return events, cursor


def episodes(events: list[Event]) -> list[int]:
    return [json.loads(event.data[0]) for event in events if event.kind == "episode"]


# --- ids ---


@given(
    results_sent=st.integers(0, 10**9 - 1),
    run_digest=st.sampled_from(["none", "0" * 16]),
)
def test_an_event_id_is_valid_only_in_its_run(
    results_sent: int, run_digest: str
) -> None:
    cursor = Cursor(results_sent, run_digest)
    assert Cursor.parse(cursor.event_id("run_1"), "run_1") == cursor
    assert Cursor.parse(cursor.event_id("run_1"), "run_2") is None


@pytest.mark.parametrize("wrong", ["", "x", "1", "1-none", "1-none-00000000", "-1"])
def test_an_invalid_event_id_has_no_cursor(wrong: str) -> None:
    assert Cursor.parse(wrong, "run_1") is None


def test_an_event_id_has_one_spelling() -> None:
    id_ = Cursor(7).event_id("run_1")
    assert Cursor.parse(f"0{id_}", "run_1") is None
    assert Cursor.parse(id_.replace("7", "8", 1), "run_1") is None


# --- what is sent ---


@pytest.mark.parametrize("retryable", [True, False, None])
@pytest.mark.parametrize("state", typing.get_args(State))
def test_a_run_is_final_when_no_event_is_legal(
    state: State, retryable: bool | None
) -> None:
    run = make_run(state=state, retryable=retryable)
    lifecycle_events = typing.get_args(LifecycleEvent)
    assert is_final(run) == (not any(legal(run, one) for one in lifecycle_events))


Change = int | State


def changes() -> st.SearchStrategy[list[Change]]:
    """An order of scoring, with changes of state at any place in it."""
    states: list[State] = ["running", "ready", "stopped"]
    return st.permutations(range(LENGTH)).flatmap(
        lambda order: st.lists(st.sampled_from(states), max_size=4).flatmap(
            lambda more: st.permutations([*order, *more])
        )
    )


def apply_changes(run: Run, order: list[Any]) -> Iterator[None]:
    for change in order:
        if isinstance(change, int):
            record_score(run, change)
        else:
            run.state = change
        yield


@given(order=changes(), read_points=st.lists(st.booleans(), min_size=12, max_size=12))
def test_a_stream_can_resume_after_any_event(
    order: list[Any], read_points: list[bool]
) -> None:
    """One reads at any time; then one goes on behind each event that was sent."""
    run, cursor = make_run(LENGTH), Cursor()
    received: list[Event] = []
    for _, has_time in zip(apply_changes(run, order), read_points, strict=False):
        if has_time:
            events, cursor = read_all_events(run, cursor)
            received += events
    events, cursor = read_all_events(run, cursor)
    received += events
    scored = [change for change in order if isinstance(change, int)]
    assert episodes(received) == scored
    for number, event in enumerate(received):
        place = Cursor.parse(str(event.id), run.run_id)
        assert place is not None
        again, _ = read_all_events(run, place)
        assert episodes(again) == scored[place.results_sent :]
        assert place.results_sent == len(episodes(received[: number + 1]))
        if event.kind == "run":
            assert json.loads(event.data[0])["scored"] == place.results_sent


# --- the order of results ---


def test_results_keep_their_order_however_the_run_is_made() -> None:
    """Loaded episodes have their places; those of an old database have none."""
    run = make_run(LENGTH)
    for index in (3, 1, 5):
        record_score(run, index)
    again = make_run(LENGTH, episodes=run.episodes)
    assert again.scored_order == [3, 1, 5]
    old = make_run(LENGTH)
    for index in (4, 2):
        old.episodes[index].result = RESULT
    old = make_run(LENGTH, episodes=old.episodes)
    record_score(old, 0)
    assert old.scored_order == [2, 4, 0]
    assert make_run(LENGTH, episodes=old.episodes).scored_order == [2, 4, 0]
