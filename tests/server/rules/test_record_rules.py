"""When a run has a record, and which episodes have ids."""

import pytest

from reference_server.rules.runs.lifecycle import refuse_record
from reference_server.rules.runs.run import State, index_of
from tests.support.server.runs import make_run


@pytest.mark.parametrize("state", ["queued", "ready", "running", "stopped", "failed"])
def test_a_run_that_is_not_completed_has_no_record(state: State) -> None:
    refused = refuse_record(make_run(state=state))
    assert refused is not None
    assert (refused.code, refused.members) == ("illegal_transition", {"state": state})


def test_a_completed_run_has_a_record() -> None:
    assert refuse_record(make_run(state="completed")) is None


@pytest.mark.parametrize(
    ("episode_id", "index"), [("e0000", 0), ("e0042", 42), ("e12345", 12345)]
)
def test_an_episode_is_found_by_its_id(episode_id: str, index: int) -> None:
    assert index_of(episode_id) == index
