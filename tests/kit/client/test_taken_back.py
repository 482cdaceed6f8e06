"""Things that a check makes for others to see are taken back when it ends."""

from types import SimpleNamespace
from typing import Any, cast

import httpx
import pytest

from conformance.client.request_context import RequestContext
from conformance.client.taken_back import taken_back_by
from conformance.exchanges.answer import Answer
from conformance.runner import pytest_plugin


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
    assert taken_back_by(operation_id, answer(status, body), path) == expected


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
