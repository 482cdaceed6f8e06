"""Failures of requests become a `ProctorError`."""

import copy
import errno
import multiprocessing
import ssl
from types import SimpleNamespace
from typing import Any

import pytest
import urllib3.exceptions
from proctor_client import ApiException, ControlApi, ProxyFault

from reference_client.errors import (
    BadPolicy,
    PolicyFailed,
    ProctorError,
    RunFailed,
    RunStopped,
    from_failure,
)
from reference_client.gymnasium_env.remote_env import RunDone
from reference_client.protocol.http_connection import CutConnection
from reference_record.broken import UNPACK, BrokenRecord
from reference_sim.benchmark_registry import InvalidChoice
from tests.support.client.api_exceptions import api_exception

URL = "http://127.0.0.1:1"
POOL: Any = None
LATE = "did not answer in time. The server may be busy"


def test_a_problem_is_reported_with_its_pointers() -> None:
    error = from_failure(api_exception("invalid_request", 422, retryable=False), URL)
    assert str(error) == "It is invalid_request. [invalid_request]\n  /a: is wrong"
    assert error.errors == (("/a", "is wrong"),)
    assert error.problem is not None


@pytest.mark.parametrize(
    ("pointer", "is_of_client"),
    [("/any_policy", True), ("/player/client", True), ("/options/tusks", False)],
)
def test_a_member_of_a_newer_client_is_said_to_be_one(
    pointer: str, is_of_client: bool
) -> None:
    """Options are the user's, who may have mistyped one."""
    fault = pointer, "Extra inputs are not permitted"
    refused = api_exception("invalid_request", 422, retryable=False, fault=fault)
    ((at, said),) = from_failure(refused, URL).errors
    assert (at, "is older than this client: leave it" in said) == (
        pointer,
        is_of_client,
    )


def test_a_connection_lost_in_its_handshake_counts_as_unreachable() -> None:
    failure = urllib3.exceptions.SSLError("EOF occurred")
    inner = ssl.SSLEOFError(8, "EOF occurred in violation of protocol")
    failure.__context__ = inner
    for one in (failure, inner):
        error = from_failure(one, URL)
        assert (error.code, error.retryable) == ("unreachable", True)


@pytest.mark.parametrize(
    ("failure", "said"),
    [
        (TimeoutError("timed out"), LATE),
        (urllib3.exceptions.ReadTimeoutError(POOL, "/", "Read timed out."), LATE),
        (urllib3.exceptions.ConnectTimeoutError(POOL, "t"), "is unreachable ("),
        (ConnectionRefusedError(111, "Refused"), "is unreachable (Refused). Check the"),
        (CutConnection("it is closed"), "was cut (it is closed). If that"),
        (
            ConnectionResetError(104, "Connection reset by peer"),
            "was cut (Connection reset by peer). If that lasts, check the URL (https:",
        ),
        (
            urllib3.exceptions.ProtocolError("Connection broken: 3 bytes read"),
            "was cut (Connection broken: 3 bytes read). If that lasts, check the URL,",
        ),
    ],
)
def test_a_late_answer_is_no_wrong_address(failure: Exception, said: str) -> None:
    error = from_failure(failure, URL)
    assert (error.code, error.retryable) == ("unreachable", True)
    assert said in error.detail


def test_a_program_without_free_files_accuses_no_server() -> None:
    cause = OSError(errno.EMFILE, "Too many open files")
    failure = urllib3.exceptions.NewConnectionError(POOL, "no connection")
    failure.__cause__ = cause
    for one in (failure, cause):
        detail = from_failure(one, URL).detail
        assert f"{URL} was not reached: this program can open no more" in detail


@pytest.mark.parametrize(("status", "is_sign_in"), [(511, True), (502, False)])
def test_a_network_that_wants_a_sign_in_says_so_by_its_status(
    status: int, is_sign_in: bool
) -> None:
    detail = from_failure(ApiException(status, "No"), URL).detail
    assert ("A network that wants a sign-in answers so" in detail) is is_sign_in


def test_a_failed_certificate_is_reported_as_such() -> None:
    failure = urllib3.exceptions.SSLError("certificate verify failed")
    inner = ssl.SSLCertVerificationError(1, "certificate verify failed")
    inner.verify_message = "self-signed certificate"
    failure.__context__ = inner
    for one in (failure, inner):
        error = from_failure(one, URL)
        assert (error.code, error.retryable) == ("not_trusted", False)
        assert "is not accepted: self-signed certificate" in error.detail


def test_an_answer_that_is_not_json_is_an_error() -> None:
    error = from_failure(ValueError("Expecting value"), URL)
    assert (error.code, error.retryable) == ("bad_answer", False)
    assert URL in str(error)


@pytest.mark.parametrize(
    ("operation", "arguments", "said"),
    [
        ("get_ranking", ("calibration", "abc"), "does not take the argument 'abc'"),
        ("get_ranking", ("calibration", ""), "does not take the argument ''"),
        ("get_ranking", ("Calibration",), "'Calibration': String should match"),
        ("get_run", ("x y",), "get_run does not take the argument 'x y'"),
        ("get_run", ("x" * 9000,), "xxxx: String should match"),
    ],
)
def test_a_wrong_argument_is_not_the_server_s_fault(
    operation: str, arguments: tuple[str, ...], said: str
) -> None:
    """No server is there, and none is needed to refuse it."""
    with pytest.raises(ValueError, match="validation error") as caught:
        getattr(ControlApi(), operation)(*arguments)
    error = from_failure(caught.value, URL)
    found = (error.code, error.retryable, error.side_effects)
    assert found == ("invalid_request", False, "none")
    assert said in error.detail
    assert len(error.detail) < 300
    assert "operator" not in error.detail


RUN: Any = SimpleNamespace(run_id="run_1", reason="It broke.", retryable=True)


@pytest.mark.parametrize(
    "error",
    [
        ProctorError("late", "Too late.", errors=[("/a", "is wrong")], retryable=True),
        from_failure(api_exception("invalid_request", 422, retryable=False), URL),
        RunFailed(RUN),
        RunStopped(RUN),
        PolicyFailed("It raised.", "Traceback"),
        RunDone("r1"),
        BadPolicy("No."),
        api_exception("invalid_request", 422, retryable=False),
        ProxyFault("refused", 407, ["Basic"]),
        InvalidChoice("/options/tusks", "has none"),
        BrokenRecord("run.json", "REC-001", "is empty", way_out=UNPACK),
    ],
    ids=lambda error: type(error).__name__,
)
def test_an_error_comes_whole_out_of_another_process(error: Exception) -> None:
    """Such as out of a pool of workers, which hangs or dies if it cannot."""
    error.add_note("In worker 3.")
    here, there = multiprocessing.Pipe()
    with here, there:
        there.send(error)
        received = here.recv()
    for again in (received, copy.copy(error), copy.deepcopy(error)):
        assert (type(again), str(again)) == (type(error), str(error))
        assert vars(again) == vars(error)
