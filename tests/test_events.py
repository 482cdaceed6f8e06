"""What a reader of events is told next: nothing lost, nothing twice, from any place."""

from __future__ import annotations

import json
import typing
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from conformance.client.event_reader import Event, EventParser
from reference_server.rules.events import Cursor, EventBatch, is_final, next_batch
from reference_server.rules.lifecycle import Event as Happening
from reference_server.rules.lifecycle import legal
from reference_server.rules.run import Run, State
from tests.conftest import a_run
from tests.parts import RESULT, score

LENGTH = 6
AT_ONCE = 2


def shown(run: Run) -> bytes:
    """A run as a reader sees it: its state and what is scored."""
    return json.dumps({"state": run.state, "scored": run.scored}).encode()


def results_sent(run: Run, cursor: Cursor) -> EventBatch:
    window = run.window(cursor.results_sent, cursor.results_sent + AT_ONCE, scored=True)
    entries = [json.dumps(episode.index).encode() for episode in window]
    return next_batch(cursor, run, shown(run), entries, shown(run))


def caught_up(run: Run, cursor: Cursor) -> tuple[list[Event], Cursor]:
    """All that there is to tell behind a cursor, and the place behind that."""
    parser, events = EventParser(), []
    while True:
        batch = results_sent(run, cursor)
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
def test_an_id_is_its_place_in_its_run_and_in_no_other(
    results_sent: int, run_digest: str
) -> None:
    cursor = Cursor(results_sent, run_digest)
    assert Cursor.parse(cursor.event_id("run_1"), "run_1") == cursor
    assert Cursor.parse(cursor.event_id("run_1"), "run_2") is None


@pytest.mark.parametrize("wrong", ["", "x", "1", "1-none", "1-none-00000000", "-1"])
def test_what_is_no_id_is_no_place(wrong: str) -> None:
    assert Cursor.parse(wrong, "run_1") is None


def test_a_place_is_written_in_one_way() -> None:
    id_ = Cursor(7).event_id("run_1")
    assert Cursor.parse(f"0{id_}", "run_1") is None
    assert Cursor.parse(id_.replace("7", "8", 1), "run_1") is None


# --- what is told ---


def test_the_run_is_told_at_first_and_not_again() -> None:
    run = a_run()
    events, cursor = caught_up(run, Cursor())
    assert [event.kind for event in events] == ["run"]
    assert results_sent(run, cursor) == EventBatch(
        b"", cursor, is_behind=False, is_last=False
    )
    run.state = "stopped"
    again, _ = caught_up(run, cursor)
    assert [json.loads(event.data[0])["state"] for event in again] == ["stopped"]


def test_the_run_is_told_when_all_that_it_counts_is() -> None:
    run = a_run(LENGTH)
    for index in (4, 0, 2):
        score(run, index)
    first = results_sent(run, Cursor())
    assert first.is_behind
    assert first.cursor == Cursor(AT_ONCE, "none")
    events, cursor = caught_up(run, Cursor())
    assert [event.kind for event in events] == ["episode"] * 3 + ["run"]
    assert episodes(events) == [4, 0, 2]
    assert [Cursor.parse(str(e.id), run.run_id) for e in events][-1] == cursor


def test_the_last_is_the_run_that_can_change_no_more() -> None:
    run = a_run(AT_ONCE + 1)
    for episode in run.episodes:
        score(run, episode.index)
    run.state = "completed"
    first = results_sent(run, Cursor())
    assert (first.is_behind, first.is_last) == (True, False)
    last = results_sent(run, first.cursor)
    assert (last.is_behind, last.is_last) == (False, True)
    assert results_sent(run, last.cursor) == replace(last, text=b"")


@pytest.mark.parametrize("retryable", [True, False, None])
@pytest.mark.parametrize("state", typing.get_args(State))
def test_a_run_is_final_when_nothing_is_legal(
    state: State, retryable: bool | None
) -> None:
    run = a_run(state=state, retryable=retryable)
    happenings = typing.get_args(Happening)
    assert is_final(run) == (not any(legal(run, one) for one in happenings))


Change = int | State


def changes() -> st.SearchStrategy[list[Change]]:
    """An order of scoring, with changes of state at any place in it."""
    states: list[State] = ["running", "ready", "stopped"]
    return st.permutations(range(LENGTH)).flatmap(
        lambda order: st.lists(st.sampled_from(states), max_size=4).flatmap(
            lambda more: st.permutations([*order, *more])
        )
    )


def happen(run: Run, order: list[Any]) -> Iterator[None]:
    for change in order:
        if isinstance(change, int):
            score(run, change)
        else:
            run.state = change
        yield


@given(order=changes(), looks=st.lists(st.booleans(), min_size=12, max_size=12))
def test_a_reader_may_break_off_behind_any_event(
    order: list[Any], looks: list[bool]
) -> None:
    """One looks when it will; then one goes on behind each event that was told."""
    run, cursor = a_run(LENGTH), Cursor()
    heard: list[Event] = []
    for _, has_time in zip(happen(run, order), looks, strict=False):
        if has_time:
            events, cursor = caught_up(run, cursor)
            heard += events
    events, cursor = caught_up(run, cursor)
    heard += events
    scored = [change for change in order if isinstance(change, int)]
    assert episodes(heard) == scored
    for number, event in enumerate(heard):
        place = Cursor.parse(str(event.id), run.run_id)
        assert place is not None
        again, _ = caught_up(run, place)
        assert episodes(again) == scored[place.results_sent :]
        assert place.results_sent == len(episodes(heard[: number + 1]))
        if event.kind == "run":
            assert json.loads(event.data[0])["scored"] == place.results_sent


# --- the order of results ---


def test_results_keep_their_order_however_the_run_is_made() -> None:
    """Loaded episodes have their places; those of an old database have none."""
    run = a_run(LENGTH)
    for index in (3, 1, 5):
        score(run, index)
    again = a_run(LENGTH, episodes=run.episodes)
    assert again.scored_order == [3, 1, 5]
    old = a_run(LENGTH)
    for index in (4, 2):
        old.episodes[index].result = RESULT
    old = a_run(LENGTH, episodes=old.episodes)
    score(old, 0)
    assert old.scored_order == [2, 4, 0]
    assert a_run(LENGTH, episodes=old.episodes).scored_order == [2, 4, 0]
