"""The kit reads events like any client: however they are cut, over every end."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from itertools import count, pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from conformance.client import event_reader
from conformance.client.check_context import CheckContext
from conformance.client.event_reader import Event, EventParser, follow_run
from conformance.client.request_context import SharedContext
from conformance.client.run_client import RunClient
from conformance.run_settings import Settings
from conformance.runner.preflight import inspect
from conformance.verdicts.expect import SetUpFailed, TooLate, Violation
from tests.support.kit import null_servers
from tests.support.kit.endless_answers import FLOODS, serve_parts
from tests.support.kit.null_servers import Reply, Request, run_server
from tests.support.servers import TIMEOUT_S

HEADERS = {"Content-Type": "text/event-stream; charset=utf-8", "Proctor-Version": "1.0"}
TEXT = """\ufeff: a comment
retry: 100

event: episode
id: one
data: {"index": 0}

event: unknown
id

: no data, no event
id: two

data: first
data:second: é
other: field

data: is cut off"""
# kind, id and data of each.
READ = [("episode", "one", ['{"index": 0}']), ("message", None, ["first", "second: é"])]


def read(events: list[Event]) -> list[tuple[str, str | None, list[str]]]:
    return [(event.kind, event.id, event.data) for event in events]


@given(
    end=st.sampled_from(["\n", "\r", "\r\n"]),
    cuts=st.lists(st.integers(0, 2 * len(TEXT)), max_size=12),
)
def test_events_are_read_however_they_are_cut(end: str, cuts: list[int]) -> None:
    sent, parser, events = (
        TEXT.replace("\n", end).encode(),
        EventParser(),
        list[Event](),
    )
    places = [0, *sorted(cuts), len(sent)]
    for first, last in pairwise(places):
        events += parser.feed(sent[first:last])
    assert read(events) == READ


@pytest.mark.parametrize("data", ["{", "1", '"text"', "[]"])
def test_event_data_must_be_an_object(data: str) -> None:
    with pytest.raises(SetUpFailed, match="EVT-001"):
        assert Event("run", "one", [data], 0.0).body


class OneEventPerStream:
    """A server that ends each stream after one event, of which it has three."""

    def __init__(self, last: int = 3) -> None:
        self._numbers = count(1)
        self._last = last

    def __call__(self, request: Request) -> Reply:
        if not request.path.endswith("/events"):
            return null_servers.canned_answers(request)
        number = next(self._numbers)
        if number > self._last:
            return 204, {"Proctor-Version": "1.0"}, b""
        event = f"id: {number}\ndata: {{}}\n\n".encode()
        return 200, HEADERS, event


def run_of(shared: SharedContext) -> RunClient:
    context = CheckContext(shared, "TEST-001")
    return RunClient(context, null_servers.RUN, context.http_client)


@contextlib.contextmanager
def run_on(behaviour: OneEventPerStream) -> Iterator[RunClient]:
    with run_server(behaviour) as url:
        settings = Settings(url=url, token="secret")
        inspect(settings)
        settings.service["profiles"].append("events")
        with contextlib.closing(SharedContext.of(settings)) as shared:
            yield run_of(shared)


def test_a_reader_reconnects_until_status_204() -> None:
    with run_on(OneEventPerStream()) as run:
        with follow_run(run) as reader:
            reader.until(lambda event: event.id == "3", "with the id 3")
            assert reader.first_status() == 200
            reader.expect_end("the end of the stream")
            with pytest.raises(Violation, match="status 204"):
                reader.until(lambda _: True, "after the last")
        assert [event.id for event in reader.received] == ["1", "2", "3"]
        asked = [one.request_headers for one in run.context.exchange_log.exchanges]
        assert [one.get("Last-Event-ID") for one in asked] == [None, "1", "2", "3"]
        assert run.context.tally.broken["SVC-003"] == 0


def test_a_first_answer_of_204_is_accepted() -> None:
    with run_on(OneEventPerStream(last=0)) as run, follow_run(run, "1") as reader:
        assert reader.first_status() == 204


def test_the_beginning_of_a_stream_is_judged_as_an_answer() -> None:
    """It is judged by the rules for all answers."""
    with run_on(OneEventPerStream()) as run:
        answer = run.call("stream_events")
        assert (answer.status, answer.json) == (200, "id: 1\ndata: {}\n\n")
        assert run.context.tally.broken["SVC-003"] == 0


@pytest.mark.parametrize("what", FLOODS)
def test_a_flood_of_events_is_read_to_a_limit(
    what: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Expect a rule that needs the stream to be not verified, with the reason."""
    monkeypatch.setattr(event_reader, "_STREAMED_BYTES_MAX", 2**20)
    monkeypatch.setattr(event_reader, "_LINE_BYTES_MAX", 2**17)
    with (
        serve_parts(FLOODS[what]) as url,
        contextlib.closing(SharedContext.of(Settings(url=url))) as shared,
        follow_run(run_of(shared)) as events,
    ):
        is_slow = what == "slow line"
        text = "no event in" if is_slow else "event stream"
        with pytest.raises(TooLate if is_slow else SetUpFailed, match=text):
            events.until(
                lambda event: event.kind == "run",
                "of a run",
                within_s=0.3 if is_slow else TIMEOUT_S,
            )
