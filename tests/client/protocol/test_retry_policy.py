"""Which failures are retried, how often, and for how long."""

import ssl
import threading
from collections.abc import Callable, Iterator

import pytest
import urllib3.exceptions
from proctor_client import ApiException

from reference_client import ProctorError
from reference_client.protocol.connection import Connection
from reference_client.protocol.retry_policy import (
    Contact,
    Interrupted,
    RetryPolicy,
)
from tests.support.client.api_exceptions import api_exception

URL = "http://127.0.0.1:1"
OWN = {"proctor-version": "1.0"}
FULL = ("quota_exceeded", 429)


class FakeClock(threading.Event):
    """A stop that is not set and whose waits pass at once, on a clock of their own."""

    def __init__(self) -> None:
        super().__init__()
        self.now = 0.0
        self.waits: list[float] = []

    def wait(self, timeout: float | None = None) -> bool:
        assert timeout is not None
        self.waits.append(timeout)
        self.now += timeout
        return self.is_set()


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> FakeClock:
    clock = FakeClock()
    monkeypatch.setattr(
        "reference_client.protocol.retry_policy.time.monotonic", lambda: clock.now
    )
    return clock


def fail_then_answer(*failures: Exception, then: str = "answer") -> Callable[[], str]:
    """Fails with each of them, then answers; the last is repeated for `then` empty."""
    left: Iterator[Exception] = iter(failures)

    def send(**_: object) -> str:
        failure = next(left, None if then else failures[-1])
        if failure is not None:
            raise failure
        return then

    return send


def test_retry_delays_grow_and_are_reported_once(clock: FakeClock) -> None:
    reported: list[str | None] = []
    silence = urllib3.exceptions.ProtocolError("Connection aborted.")
    retry_policy = RetryPolicy(URL, 100.0, clock, reported.append)
    assert retry_policy.call(fail_then_answer(*[silence] * 9)) == "answer"
    ideal = [0.1, 0.2, 0.4, 0.8, 1.6, 3.2, 5.0, 5.0, 5.0]
    assert all(w / 2 <= wait <= w for wait, w in zip(clock.waits, ideal, strict=True))
    assert len(reported) == 2
    assert reported[-1] is None


def test_retry_after_is_honoured_and_a_full_server_waited_for(clock: FakeClock) -> None:
    full = api_exception("no_capacity", 503, retryable=True, retry_after_s=7)
    retry_policy = RetryPolicy(URL, 1.0, clock, lambda _why: None)
    assert retry_policy.call(fail_then_answer(*[full] * 100)) == "answer"
    assert min(clock.waits) >= 7.0


@pytest.mark.parametrize(
    ("failure", "retried_s"),
    [
        (api_exception("unavailable", 503, retryable=True, retry_after_s=1), 20.0),
        (api_exception("internal_error", 500, retryable=True), 10.0),
        (api_exception("worker_busy", 409, retryable=True), 3.0),
        (api_exception("not_found", 404, retryable=False), 0.0),
        (urllib3.exceptions.ProtocolError("gone"), 20.0),
        (api_exception(*FULL, retryable=True, limit="per_day"), 20.0),
        (api_exception(*FULL, retryable=True, limit="at_once"), 20.0),
        (api_exception(*FULL, retryable=True, limit="total"), 0.0),
        (api_exception(*FULL, retryable=True, limit="keys"), 0.0),
        (api_exception(*FULL, retryable=True, limit="stored_bytes"), 0.0),
        (api_exception(*FULL, retryable=True, limit="changes"), 0.0),
    ],
)
def test_retrying_ends_after_the_time_limit(
    clock: FakeClock, failure: Exception, retried_s: float
) -> None:
    retry_policy = RetryPolicy(URL, 20.0, clock, lambda _why: None)
    with pytest.raises(ProctorError):
        retry_policy.call(
            fail_then_answer(failure, then=""), limits_s={"worker_busy": 3.0}
        )
    assert retried_s - 5.0 <= clock.now <= retried_s


PAGE = ApiException(reason="no JSON", headers={"Content-Type": "text/html"})
MESSAGE = ApiException(reason="another", headers={"Content-Type": "application/json"})
UNPASSABLE = (400, 405, 411, 413, 414, 415, 416, 417, 421, 426, 431, 501, 505)


def elsewhere(status: int, method: str = "GET") -> ApiException:
    """An answer without the mark of Proctor."""
    answer = ApiException(status, "No", headers={})
    answer.method = method
    return answer


@pytest.mark.parametrize(
    ("failure", "has_answered", "retried_s"),
    [
        (PAGE, True, 60.0),
        (ssl.SSLError(1, "not the certificate of before"), True, 60.0),
        *((elsewhere(status), True, 60.0) for status in (302, 307, 401, 403, 404)),
        *((elsewhere(status), True, 100.0) for status in (429, 500, 502, 503, 504)),
        *((elsewhere(status), True, 0.0) for status in UNPASSABLE),
        (MESSAGE, True, 0.0),
        (PAGE, False, 0.0),
        (elsewhere(302), False, 0.0),
        (ssl.SSLError(1, "not the certificate of before"), False, 0.0),
        (ApiException(reason="wrong", headers=OWN), True, 0.0),
        (ApiException(404, "No", headers=OWN), True, 0.0),
    ],
)
def test_what_comes_in_the_place_of_a_server_that_has_answered_is_waited_out(
    clock: FakeClock, failure: Exception, has_answered: bool, retried_s: float
) -> None:
    """Pages of the network, and not the server's own faults, or refused requests."""
    reported: list[str | None] = []
    contact = Contact(has_answered=has_answered)
    retry_policy = RetryPolicy(URL, 100.0, clock, reported.append, contact=contact)
    with pytest.raises(ProctorError):
        retry_policy.call(fail_then_answer(failure, then=""))
    assert retried_s - 5.0 <= clock.now <= retried_s
    says_it = any(
        text and "repeats the request for up to 60 s" in text for text in reported
    )
    assert says_it == (retried_s == 60.0)


@pytest.mark.parametrize(
    ("failures", "passes"),
    [
        ([elsewhere(403, "POST")], True),
        ([elsewhere(403, "POST")] * 2, False),
        ([elsewhere(403, "GET")] * 9, True),  # of the request for its offset
        ([elsewhere(502, "POST")] * 9, True),
    ],
)
def test_a_large_body_is_sent_to_pages_twice_at_most(
    clock: FakeClock, failures: list[Exception], passes: bool
) -> None:
    contact = Contact(has_answered=True)
    retry_policy = RetryPolicy(URL, 100.0, clock, lambda _why: None, contact=contact)
    sent = fail_then_answer(*failures)
    if passes:
        assert retry_policy.call(sent, is_upload=True) == "answer"
    else:
        with pytest.raises(ProctorError, match="403"):
            retry_policy.call(sent, is_upload=True)


def test_a_page_after_a_gateway_without_its_server_has_its_own_time(
    clock: FakeClock,
) -> None:
    contact = Contact(has_answered=True)
    retry_policy = RetryPolicy(URL, 300.0, clock, lambda _why: None, contact=contact)
    failures = [elsewhere(502)] * 30 + [elsewhere(403)] * 5
    assert retry_policy.call(fail_then_answer(*failures)) == "answer"


def test_the_silence_of_a_first_contact_is_a_part_of_its_time(
    clock: FakeClock,
) -> None:
    """A server that has answered before may be silent, and the limit begins then."""

    def send() -> str:
        clock.now += 15.0
        raise urllib3.exceptions.ProtocolError("silent")

    for contact, tries in ((Contact(), 1), (Contact(has_answered=True), 2)):
        clock.now = 0.0
        retry_policy = RetryPolicy(URL, 10.0, clock, lambda _why: None, contact=contact)
        with pytest.raises(ProctorError):
            retry_policy.call(send)
        assert clock.now // 15.0 == tries


def test_the_last_error_names_the_error_that_was_retried(clock: FakeClock) -> None:
    defect = api_exception("internal_error", 500, retryable=True)
    ended = api_exception("session_ended", 409, retryable=False)
    with pytest.raises(ProctorError, match="session_ended") as caught:
        RetryPolicy(URL, 20.0, clock, lambda _why: None).call(
            fail_then_answer(defect, ended)
        )
    assert isinstance(caught.value.__cause__, ProctorError)
    assert caught.value.__cause__.code == "internal_error"


def test_a_stopped_evaluation_does_not_wait(clock: FakeClock) -> None:
    clock.set()
    retry_policy = RetryPolicy(URL, 20.0, clock, lambda _why: None)
    with pytest.raises(Interrupted):
        retry_policy.call(lambda: "answer")
    with pytest.raises(Interrupted):
        retry_policy.pause(1.0)


@pytest.mark.parametrize(
    ("given_s", "has_answered", "limit_s"),
    [(None, False, 3.0), (None, True, 300.0), (30.0, False, 30.0), (30.0, True, 30.0)],
)
def test_a_server_that_has_answered_is_waited_for_longer(
    clock: FakeClock, given_s: float | None, *, has_answered: bool, limit_s: float
) -> None:
    """By every command alike; what a user gives holds from the first contact."""
    with Connection(URL, "t", requests=1) as connection:
        connection.contact.has_answered = has_answered
        policy = connection.retry_policy(clock, lambda _: None, given_s)
        with pytest.raises(ProctorError, match="is unreachable"):
            policy.call(fail_then_answer(ConnectionRefusedError(), then=""))
    assert limit_s - 5.0 < clock.now <= limit_s


def test_a_server_that_has_answered_is_waited_for_without_advice_on_its_url(
    clock: FakeClock,
) -> None:
    reported: list[str | None] = []
    contact = Contact(has_answered=True)
    retry_policy = RetryPolicy(URL, 100.0, clock, reported.append, contact=contact)
    refused = ConnectionRefusedError(111, "Connection refused")
    with pytest.raises(ProctorError):
        retry_policy.call(fail_then_answer(refused, then=""))
    assert reported[0] == (
        f"{URL} is unreachable (Connection refused). This program repeats the request "
        "for up to 100 s. Episodes that are scored stay scored."
    )
