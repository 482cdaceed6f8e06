"""The packages of clients/: `evaluate` where answers are lost, wrong or do not come.

Each is judged as the Python client is, on the same server: exactly once, resume, and
errors that say what is wrong, whether to repeat and what to do.
"""

import socket
from collections.abc import Callable

import pytest

from reference_client import ProctorError
from tests.interop.clients import PACKAGES, Language
from tests.interop.scenarios import Program, Server
from tests.support.client.evaluations import play
from tests.support.client.policies import GradedPolicy
from tests.support.network.lossy_proxy import Proxy

pytestmark = pytest.mark.slow("starts servers, compiles packages")

SAFE = "to repeat it as it was is safe. [bad_answer]"


@pytest.fixture(params=PACKAGES)
def program(
    request: pytest.FixtureRequest, built: Callable[[Language], Program]
) -> Program:
    return built(PACKAGES[request.param])


def runs_of(server: Server) -> set[str]:
    return {run["run_id"] for run in server.read("/v1/runs?limit=1000")["runs"]}


def test_an_evaluation_executes_nothing_twice(server: Server, program: Program) -> None:
    lost = ("submit", "attach", "predict")
    before = runs_of(server)
    with Proxy(server.url, drop=lost) as proxy:
        observed = program.play("score", proxy.url, server.token)
    assert sorted(proxy.dropped_answers) == sorted(lost)
    for kind in lost:
        assert len(proxy.repeats(kind)) == 1, kind
    assert runs_of(server) - before == {observed["run_id"]}
    episodes = server.read(f"/v1/runs/{observed['run_id']}/episodes")["episodes"]
    played = [(one["attempt"], one["result"]["steps"]) for one in episodes]
    assert played == [(1, 2)] * 5


def test_the_example_continues_a_complete_run(server: Server, program: Program) -> None:
    done = program.play_example(server.url, server.token)
    run_id = done.stdout.split()[1].rstrip(":")
    again = program.play_example(server.url, server.token, run_id)
    assert again.stdout.splitlines()[-1] == "score 0.40625", again.stderr


def test_errors_are_for_people(server: Server, program: Program) -> None:
    refused = program.play_example(server.url, "not-a-token")
    assert refused.returncode == 1
    assert "[unauthenticated]" in refused.stderr
    assert "In this " in refused.stderr, "it names what to change in the program"
    assert "    at " not in refused.stderr, "a stack trace"
    with socket.create_server(("127.0.0.1", 0)) as closed:
        port = closed.getsockname()[1]
    away = program.play_example(f"http://127.0.0.1:{port}", "token")
    assert away.returncode == 1
    assert f"http://127.0.0.1:{port} is unreachable (" in away.stderr
    assert away.stderr.rstrip().endswith("[unreachable]")


def test_a_server_without_tls_is_called_one(server: Server, program: Program) -> None:
    url = server.url.replace("http://", "https://")
    said = program.play_example(url, "token").stderr
    assert "does not speak TLS" in said
    assert "whether the URL begins with http:// instead" in said
    assert "openssl" not in said, "words of a library"


def with_wrong_rewards(answer: object) -> object:
    """A turn whose rewards are no list; what is no turn stays as it is."""
    if isinstance(answer, dict) and "rewards" in answer:
        return {**answer, "rewards": "none"}
    return answer


WRONG: dict[str, Callable[[object], object]] = {
    "a service": lambda _answer: {},
    "a turn": with_wrong_rewards,
}


@pytest.mark.parametrize("what", WRONG)
def test_wrong_answer_is_explained(what: str, server: Server, program: Program) -> None:
    with Proxy(server.url, alter=WRONG[what]) as proxy:
        done = program.play_example(proxy.url, server.token)
    assert done.returncode == 1
    assert "sent an invalid response (" in done.stderr
    assert ("rewards" if what == "a turn" else "is missing") in done.stderr
    assert "Check that the URL is that of a Proctor server" in done.stderr
    assert what == "a service" or SAFE in done.stderr
    assert "    at " not in done.stderr, "a stack trace"


@pytest.mark.parametrize("what", WRONG)
def test_the_python_client_explains_it_alike(what: str, server: Server) -> None:
    """Its turns are MessagePack, so this is wrong in the other encoding."""
    with (
        Proxy(server.url, alter=WRONG[what]) as proxy,
        pytest.raises(ProctorError) as caught,
    ):
        play(proxy, GradedPolicy, "score", dry_turn=True)
    error = caught.value
    found = (error.code, error.retryable, error.side_effects)
    is_turn = what == "a turn"  # the other is a GET, which has no effect
    assert found == ("bad_answer", False, "possible" if is_turn else "none")
    assert "sent an invalid response (" in str(error)
    assert (SAFE in str(error)) == is_turn
