"""The parts of the reference client that need no server."""

from __future__ import annotations

import io
import threading
from collections.abc import Callable, Iterator
from types import ModuleType
from typing import Any

import msgspec
import numpy as np
import PIL.Image
import pytest
import urllib3.exceptions
from proctor_client import ApiException, Problem

import reference_client
from reference_client import ProctorError
from reference_client.api.observation import observation_of
from reference_client.api.policy import Vector, chunk_of
from reference_client.errors import from_failure
from reference_client.evaluation.status_board import Progress, ProgressLine, StatusBoard
from reference_client.generated.messages import Turn
from reference_client.protocol.connection import Connection
from reference_client.protocol.heartbeat import HeartbeatThread
from reference_client.protocol.retry_policy import Interrupted, RetryPolicy
from reference_sim.process.encoding import encode_image

URL = "http://127.0.0.1:1"
BLACK = np.zeros((2, 2, 3), np.uint8)


def test_the_public_names_are_those_of_all() -> None:
    exported = {name for name in dir(reference_client) if name[0] != "_"}
    modules = {
        n for n in exported if isinstance(getattr(reference_client, n), ModuleType)
    }
    assert exported - modules == set(reference_client.__all__)


# Actions


def test_numpy_vectors_become_a_chunk() -> None:
    actions: list[dict[str, Vector]] = [
        {"a": np.array([0.5, 1.0], np.float32), "b": [1, 2.5]},
        {"a": (0.0,), "b": []},
    ]
    values = [action["values"] for action in chunk_of(actions)]
    assert values == [{"a": [0.5, 1.0], "b": [1.0, 2.5]}, {"a": [0.0], "b": []}]


@pytest.mark.parametrize(
    ("actions", "pointer", "text"),
    [
        ({"a": [1.0]}, "/actions", "a dict, not a list"),
        ([], "/actions", "is empty"),
        ([[1.0]], "/actions/0/values", "not a dict of vectors"),
        ([{"a": 1.0}], "/actions/0/values/a", "has 0 dimensions"),
        ([{"a": ["one"]}], "/actions/0/values/a", "no number"),
        ([{"a": [1.0, np.nan]}], "/actions/0/values/a/1", "not finite"),
        ([{"a/b~": [np.inf]}], "/actions/0/values/a~1b~0/0", "not finite"),
    ],
)
def test_an_invalid_action_is_refused_with_its_pointer(
    actions: Any, pointer: str, text: str
) -> None:
    with pytest.raises(ProctorError, match=text) as caught:
        chunk_of(actions)
    assert (caught.value.code, caught.value.side_effects) == ("invalid_request", "none")
    assert [at for at, _ in caught.value.errors] == [pointer]


# Observations


def turn_with(**parts: Any) -> Turn:
    """A turn whose observation has these parts."""
    return msgspec.convert(
        {
            "session_id": "s",
            "seq": 0,
            "episode": {
                "episode_id": "e1",
                "index": 1,
                "task": "lift_cube",
                "instruction": "Lift it.",
                "attempt": 1,
                "step": 3,
                "max_steps": 10,
            },
            "observation": {"state": {}, "images": {}, "tensors": {}} | parts,
            "executed_steps": 0,
            "stopped_early": False,
            "rewards": [],
            "terminated": False,
            "truncated": False,
            "done": False,
            "lease": {"expires_at": "2026-01-01T00:00:00Z", "idle_timeout_s": 1},
            "timing": dict.fromkeys(
                ("total_s", "queue_s", "simulate_s", "render_s", "encode_s"), 0
            ),
        },
        Turn,
    )


def image(codec: str, width: int, height: int, channels: int, data: bytes) -> Any:
    size = {"width": width, "height": height, "channels": channels}
    return {"camera": {"codec": codec, "data": memoryview(data), **size}}


def compressed(pixels: Any, codec: str) -> bytes:
    file = io.BytesIO()
    PIL.Image.fromarray(pixels).save(file, codec)
    return file.getvalue()


def test_an_observation_knows_its_episode() -> None:
    observation = observation_of(turn_with(state={"joints": [1, 0.5]}))
    assert observation.state == {"joints": (1.0, 0.5)}
    assert (observation.episode_id, observation.step) == ("e1", 3)
    assert observation.instruction == "Lift it."


@pytest.mark.parametrize("channels", [1, 2, 3, 4])
def test_pixels_arrive_in_rows_columns_and_channels(channels: int) -> None:
    pixels = np.arange(5 * 4 * channels, dtype=np.uint8).reshape(5, 4, channels)
    png = compressed(pixels.squeeze(), "png")
    for codec, data in (("raw", pixels.tobytes()), ("png", png)):
        images = image(codec, 4, 5, channels, data)
        seen = observation_of(turn_with(images=images)).images["camera"]
        assert np.array_equal(seen, pixels)
        assert not seen.flags.writeable


@pytest.mark.parametrize("channels", [1, 3])
def test_a_jpeg_keeps_its_colours(channels: int) -> None:
    pixels = np.zeros((48, 64, channels), np.uint8)
    pixels[:24, :, 0] = 200  # of three channels the red one
    data = bytes(encode_image(pixels[::-1], "jpeg")["data"])
    assert data.startswith(b"\xff\xd8\xff")
    images = image("jpeg", 64, 48, channels, data)
    seen = observation_of(turn_with(images=images)).images["camera"]
    assert not seen.flags.writeable
    assert seen.shape == pixels.shape
    assert np.abs(seen[:16].astype(int)).max() < 8
    assert np.abs(seen[32:].astype(int) - pixels[:16]).max() < 8


def test_tensors_are_little_endian_views() -> None:
    data = bytes([1, 0, 2, 0])
    tensor = {"dtype": "uint16", "shape": [2, 1], "data": memoryview(data)}
    seen = observation_of(turn_with(tensors={"t": tensor})).tensors["t"]
    assert seen.tolist() == [[1], [2]]
    assert np.shares_memory(seen, np.frombuffer(data, np.uint8))
    assert not seen.flags.writeable


@pytest.mark.parametrize(
    ("parts", "text"),
    [
        ({"images": image("raw", 2, 2, 3, bytes(11))}, "its declared size"),
        ({"images": image("png", 2, 2, 3, b"no png")}, "is not a valid png"),
        (
            {"images": image("png", 2, 2, 3, compressed(BLACK[:1], "png"))},
            "declared as",
        ),
        (
            {"images": image("png", 2, 2, 3, compressed(BLACK, "gif"))},
            "is not a valid png",
        ),
        ({"images": image("jpeg", 2, 2, 3, b"no jpeg")}, "is not a valid jpeg"),
        (
            {"images": image("jpeg", 2, 2, 3, compressed(BLACK, "jpeg")[:-2])},
            "is not a valid jpeg",
        ),
        (
            {"images": image("jpeg", 2, 2, 3, compressed(BLACK[:1], "jpeg"))},
            "declared as",
        ),
        (
            {"images": image("jpeg", 2, 2, 2, compressed(BLACK, "jpeg"))},
            "is not a valid jpeg",
        ),
        (
            {"images": image("jpeg", 2, 2, 3, compressed(BLACK, "png"))},
            "is not a valid jpeg",
        ),
    ],
)
def test_an_undecodable_observation_is_an_error(parts: Any, text: str) -> None:
    with pytest.raises(ProctorError, match=text) as caught:
        observation_of(turn_with(**parts))
    assert caught.value.code == "bad_answer"


# Failures


def api_exception(
    code: str, status: int, *, retryable: bool, retry_after_s: int | None = None
) -> ApiException:
    problem = Problem.from_dict(
        {
            "type": "about:blank",
            "title": code,
            "status": status,
            "detail": f"It is {code}.",
            "code": code,
            "retryable": retryable,
            "side_effects": "none",
            "errors": [{"pointer": "/a", "detail": "is wrong"}],
        }
    )
    error = ApiException(status=status, reason="No", data=problem)
    error.headers = {"Retry-After": str(retry_after_s)} if retry_after_s else {}
    return error


def test_a_problem_is_reported_with_its_pointers() -> None:
    error = from_failure(api_exception("invalid_request", 422, retryable=False), URL)
    assert str(error) == "It is invalid_request. [invalid_request]\n  /a: is wrong"
    assert error.errors == (("/a", "is wrong"),)
    assert error.problem is not None


def test_a_failed_certificate_counts_as_unreachable() -> None:
    failure = ApiException(status=0, reason="SSLError\ncertificate verify failed")
    assert from_failure(failure, URL).code == "unreachable"


def test_an_answer_that_is_not_json_is_an_error() -> None:
    error = from_failure(ValueError("Expecting value"), URL)
    assert (error.code, error.retryable) == ("bad_answer", False)
    assert URL in str(error)


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

    def send() -> str:
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


def test_a_token_is_not_sent_unencrypted() -> None:
    with Connection("https://example.org", "t", requests=1) as connection:
        connection.data("https://other.example.org/")
        with pytest.raises(ProctorError, match="not HTTPS"):
            connection.data("http://example.org")


# Heartbeats and progress


def test_heartbeats_are_sent_only_while_the_policy_thinks() -> None:
    beats = threading.Semaphore(0)

    def send_heartbeat() -> bool:
        beats.release()
        return True

    with HeartbeatThread(0.12, send_heartbeat) as heartbeat:
        assert not beats.acquire(timeout=0.2)
        with heartbeat.keep_alive():
            assert beats.acquire(timeout=5.0)
            assert beats.acquire(timeout=5.0)


def test_heartbeats_stop_when_the_session_has_ended() -> None:
    beaten = threading.Event()

    def send_heartbeat() -> bool:
        assert not beaten.is_set()
        beaten.set()
        return False

    with HeartbeatThread(0.06, send_heartbeat) as heartbeat, heartbeat.keep_alive():
        assert beaten.wait(5.0)
        heartbeat._thread.join(5.0)
        assert not heartbeat._thread.is_alive()


def test_progress_is_one_line_that_fits(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "60")
    stream = io.StringIO()
    line = ProgressLine(stream)
    line(Progress("run_1", 20, 0, None, None))
    line(Progress("run_1", 20, 7, 0.5, "worker-0: no answer " * 9))
    line.end()
    first, second = stream.getvalue().split("\r\x1b[2K")[1:]
    assert first.startswith("run_1  0/20 episodes  mean –  0:0")
    assert second.startswith("run_1  7/20 episodes  mean 0.500  0:0")
    assert "worker-0: no" in second
    assert len(second) == 60  # 59 and the line's end


def test_the_status_board_shows_one_waiting_worker() -> None:
    board = StatusBoard()
    first, second = (
        board.waiting_reporter("worker-0"),
        board.waiting_reporter("worker-1"),
    )
    first("a")
    second("b")
    assert board.wait(0.0)
    assert board.waiting() == "worker-0: a"
    first(None)
    assert board.waiting() == "worker-1: b"
    second(None)
    assert board.waiting() is None
    assert not board.pop_scored()
    board.on_scored()
    assert board.pop_scored()
    assert not board.pop_scored()
