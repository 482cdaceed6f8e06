"""The generated client keeps what its README says, where no server is needed."""

import json

import pydantic
import pytest
import urllib3
from proctor_client import (
    ApiClient,
    ApiException,
    Configuration,
    ControlApi,
    GroupScore,
    OutcomeCounts,
    PolicyInfo,
)

COUNTS = OutcomeCounts(total=1, success=0, failure=0, abandoned=0, unscored=1)


def control_answered_by(
    monkeypatch: pytest.MonkeyPatch, status: int, body: bytes
) -> ControlApi:
    """The control plane of a server that answers every request with this body."""
    client = ApiClient()
    answer = urllib3.HTTPResponse(body, {"Retry-After": "7"}, status, reason="Why")
    monkeypatch.setattr(client.pool_manager, "request", lambda *_, **__: answer)
    return ControlApi(client)


def test_only_members_that_may_be_null_are_sent_as_null() -> None:
    assert PolicyInfo(name="p", version=None).to_dict() == {"name": "p"}
    group = GroupScore(counts=COUNTS, mean=None, success_rate=None)
    assert json.loads(group.to_json())["mean"] is None


def test_members_of_a_later_version_are_kept() -> None:
    members = {"name": "p", "added_later": [1]}
    policy = PolicyInfo.from_dict(members)
    assert policy.additional_properties == {"added_later": [1]}
    assert policy.to_dict() == members


def test_a_gateway_refuses_without_a_problem(monkeypatch: pytest.MonkeyPatch) -> None:
    control = control_answered_by(monkeypatch, 502, b"<html>")
    with pytest.raises(ApiException) as refusal:
        control.describe_service()
    error = refusal.value
    assert (error.status, error.data, error.retry_after_s) == (502, None, 7.0)


@pytest.mark.parametrize("body", [b"", b"null", b"<x>", b'{"run_id": 1}', b"[" * 9999])
def test_a_success_that_is_no_message_has_no_status(
    monkeypatch: pytest.MonkeyPatch, body: bytes
) -> None:
    with pytest.raises(ApiException, match="the message Run: ") as refusal:
        control_answered_by(monkeypatch, 200, body).get_run("run")
    assert refusal.value.status == 0


def test_an_argument_out_of_range_is_not_sent(monkeypatch: pytest.MonkeyPatch) -> None:
    control = control_answered_by(monkeypatch, 204, b"")
    control.delete_run("run")
    for run_id in ("", "a/b"):
        with pytest.raises(pydantic.ValidationError):
            control.delete_run(run_id)


@pytest.mark.parametrize(
    ("named", "proxy"),
    [
        ({}, "http://proxy:1"),
        ({"no_proxy": "robots.example"}, None),
        ({"proxy": "http://other:2"}, "http://other:2"),
        ({"proxy": ""}, None),
    ],
)
def test_a_proxy_is_that_of_the_settings_or_of_the_environment(
    monkeypatch: pytest.MonkeyPatch, named: dict[str, str], proxy: str | None
) -> None:
    monkeypatch.setenv("https_proxy", "http://proxy:1")
    monkeypatch.setenv("no_proxy", named.get("no_proxy", ""))
    settings = Configuration("https://robots.example", proxy=named.get("proxy"))
    url = settings.pool_manager().proxy
    assert (None if url is None else url.url) == proxy
