"""Things that a check makes for others to see are taken back when it ends."""

import contextlib
import re
from types import SimpleNamespace
from typing import Any, cast

import httpx
import pytest

from conformance.client.cleanup_requests import cleanup_after
from conformance.client.http_client import HttpClient
from conformance.client.request_context import RequestContext, SharedContext
from conformance.exchanges.answer import Answer
from conformance.run_settings import Settings
from conformance.runner import left_behind, pytest_plugin


def answer(status: int, json: object = None) -> Answer:
    return Answer(status, httpx.Headers(), b"", 0.0, 0.5, json, 7)


@pytest.mark.parametrize(
    ("operation_id", "status", "body", "expected"),
    [
        ("publish_entry", 201, {}, ("withdraw_entry", {"run_id": "run_1"})),
        ("publish_entry", 200, {}, None),
        (
            *("import_record", 202, {"import_id": "imp_1"}),
            ("delete_import", {"import_id": "imp_1"}),
        ),
        ("import_record", 202, [], None),
        ("import_record", 422, {"import_id": "imp_1"}, None),
        ("submit_run", 201, {}, None),
    ],
)
def test_entries_and_imports_are_taken_back(
    operation_id: str, status: int, body: object, expected: Any
) -> None:
    path = {"run_id": "run_1"} if operation_id == "publish_entry" else {}
    assert cleanup_after(operation_id, answer(status, body), path) == expected


class FakeContext:
    """Counts how often it was tidied up."""

    def __init__(self) -> None:
        self.times = 0

    def tidy_up(self) -> None:
        self.times += 1


def test_checks_that_were_interrupted_are_tidied_up() -> None:
    running, waiting = FakeContext(), FakeContext()
    item = SimpleNamespace(stash={pytest_plugin._CHECK_CONTEXT: running})
    background = SimpleNamespace(tidy_up=waiting.tidy_up)
    config = SimpleNamespace(stash={pytest_plugin._BACKGROUND: background})
    items = [item, SimpleNamespace(stash={})]
    session = SimpleNamespace(items=items, config=config)
    pytest_plugin.pytest_sessionfinish(cast(pytest.Session, session))
    assert (running.times, waiting.times) == (1, 1)


@pytest.mark.parametrize("is_adopted", [False, True])
@pytest.mark.parametrize(
    ("operation_id", "status", "body", "undone"),
    [
        ("submit_run", 201, {"run_id": "run_1"}, "stop_run"),
        ("publish_entry", 201, {}, "withdraw_entry"),
        ("import_record", 202, {"import_id": "i"}, "delete_import"),
    ],
)
def test_entries_of_adopted_runs_are_taken_back(
    *,
    operation_id: str,
    status: int,
    body: dict[str, Any],
    undone: str,
    is_adopted: bool,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The client of an adopted run stops it, and does nothing else."""
    sent: list[str] = []

    def request(*_: Any, operation: Any, **__: Any) -> Answer:
        sent.append(operation.operation_id)
        return answer(status, body)

    monkeypatch.setattr(HttpClient, "request", request)
    profiles = ["board", "record_import", "control"]
    settings = Settings(url="http://127.0.0.1:1", service={"profiles": profiles})
    with contextlib.closing(SharedContext.of(settings)) as shared:
        context = RequestContext(shared, "TEST-001")
        path: Any = {"run_id": "run_1"} if operation_id == "publish_entry" else {}
        context.call(operation_id, json={}, **path)
        if is_adopted:
            context.adopted.add("run_1")
        context.tidy_up()
    is_stopped_elsewhere = is_adopted and undone == "stop_run"
    assert sent == [operation_id, *([] if is_stopped_elsewhere else [undone])]


STAY = "stay on the server: it does not"


@pytest.mark.parametrize(
    ("statuses", "profiles", "start_cmd", "said"),
    [
        ([204, 404], ["deletion"], None, None),
        ([204, 409], ["deletion"], None, f"1 run of calibration.*{STAY} delete what"),
        ([], [], None, f"2 runs of calibration.*{STAY} offer the profile deletion.$"),
        ([], ["lists"], None, f"2 runs .*{STAY} offer .* `proctor status .*` lists"),
        ([], [], "./server", None),
    ],
)
def test_the_runs_of_the_checks_are_deleted_or_counted(
    statuses: list[int],
    profiles: list[str],
    start_cmd: str | None,
    said: str | None,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    left = iter(statuses)

    def request(*_: Any, **__: Any) -> Answer:
        return answer(next(left))

    monkeypatch.setattr(HttpClient, "request", request)
    service = {"profiles": profiles}
    settings = Settings(url="http://127.0.0.1:1", service=service, start_cmd=start_cmd)
    text = left_behind.delete_runs(settings, [("token", "run_1"), (None, "run_2")])
    assert (text is None) == (said is None)
    assert re.search(said or "", text or "")
    assert next(left, None) is None


def test_what_stays_at_a_host_is_named_with_the_commands_that_remove_it() -> None:
    left = [("account", "kit1"), ("key", ""), ("account", "kit2"), ("entry", "run_1")]
    settings = Settings(url="http://127.0.0.1:1")
    text = left_behind.describe_left(settings, left) or ""
    assert "2 pending accounts, which `proctor admin account delete kit1 kit2`" in text
    assert "; 1 revoked key, which `proctor admin platform clean" in text
    assert "; 1 withdrawn entry, of which the history" in text
    assert "submission" not in text
    assert left_behind.describe_left(settings, []) is None
    started = Settings(url="http://127.0.0.1:1", start_cmd="./server")
    assert left_behind.describe_left(started, left) is None


def test_an_interrupted_step_is_taken_again() -> None:
    context = RequestContext.__new__(RequestContext)
    context._clean_ups, taken = [], []

    def interrupted_once() -> None:
        taken.append(1)
        if len(taken) == 1:
            raise KeyboardInterrupt

    context.clean_up_with(interrupted_once)
    with pytest.raises(KeyboardInterrupt):
        context.tidy_up()
    context.tidy_up()
    context.tidy_up()
    assert len(taken) == 2
