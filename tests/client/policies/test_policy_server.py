"""The client calls a policy server: the same turns, in the other direction."""

import contextlib
import json
import re
import threading
from collections.abc import Callable, Iterator
from types import SimpleNamespace
from typing import Any

import pytest
from starlette.applications import Starlette

from conformance.policy.scripted_chat import ScriptedChat
from conformance.policy.scripted_policy import (
    PolicyCall,
    PolicyReply,
    ScriptedPolicy,
    busy_reply,
)
from reference_client import ProctorError, evaluate
from reference_client.policies.policy_http_app import PolicyApp
from reference_client.policies.servers.policy_server_client import PolicyServerClient
from tests.support.client.policy_apps import (
    CountingPolicy,
    make_app,
    run_app,
    run_proctor,
)
from tests.support.ports import closed_port
from tests.support.push_runs import submit_push_run, wait_for_state
from tests.support.servers import TOKENS, ReferenceServer

pytestmark = pytest.mark.usefixtures("policy_key")


def evaluate_policy(
    server: ReferenceServer, url: str, *tasks: str, **members: Any
) -> Any:
    return evaluate(
        PolicyServerClient(url, retry_timeout_s=2.0),
        url=server.url,
        token=TOKENS["alice"],
        benchmark="calibration",
        options={"tasks": list(tasks), **members},
        workers=2,
        progress=lambda _: None,
    )


def test_the_same_turns_come_in_both_directions(push_server: ReferenceServer) -> None:
    """Requests of this client to a policy are those of the server."""
    bodies_by_direction: list[list[dict[str, Any]]] = []
    for direction in ("pull", "push"):
        with ScriptedPolicy() as policy, push_server.client() as client:
            if direction == "pull":
                evaluate_policy(push_server, policy.url, "echo")
            else:
                wait_for_state(client, submit_push_run(client, policy.url, "echo"))
            bodies = [c.body for c in policy.calls if c.body is not None]
            bodies_by_direction.append([_timeless(body) for body in bodies])
    assert bodies_by_direction[0] == bodies_by_direction[1]
    assert len(bodies_by_direction[0]) == 2


def _timeless(body: dict[str, Any]) -> dict[str, Any]:
    volatile = ("session_id", "run_id", "timing", "lease", "benchmark")
    spaces = body.get("benchmark", {}).get("action_space")
    stable = {name: value for name, value in body.items() if name not in volatile}
    return stable | {"spaces": spaces}


def test_an_unanswered_call_is_repeated(push_server: ReferenceServer) -> None:
    turned_away = threading.Event()

    def once(call: PolicyCall) -> PolicyReply:
        if turned_away.is_set():
            return policy.final_action_reply(call)
        turned_away.set()
        return busy_reply()

    with ScriptedPolicy() as policy:
        policy.on("predict", once)
        assert evaluate_policy(push_server, policy.url, "score").score == 0.5


@pytest.mark.parametrize(
    ("operation", "reply", "message"),
    [
        ("describe_policy", PolicyReply({}), "violates the schema of describe_policy"),
        ("describe_policy", PolicyReply(b"no"), "invalid JSON.*'no'"),
        ("describe_policy", PolicyReply([]), "not an object"),
        ("describe_policy", PolicyReply(b"", 404), "status 404 .it is empty"),
        ("describe_policy", PolicyReply(b"<p>x", 404), "it begins with '<p>x'"),
        ("reset", PolicyReply({"session_id": "x"}), "wrong reset"),
        (
            "predict",
            PolicyReply({"session_id": "x", "seq": 1}),
            "wrong session_id or seq",
        ),
        (
            "predict",
            PolicyReply(b"", 302, {"Location": "/"}),
            r"answered 302: it is at http://[\d.:]+/\.",
        ),
        ("predict", PolicyReply({"detail": "Too\nhot."}, 400), "Too\nhot."),
    ],
)
def test_faults_of_a_policy_server_are_reported(
    push_server: ReferenceServer, operation: str, reply: PolicyReply, message: str
) -> None:
    with ScriptedPolicy() as policy:
        policy.on(operation, lambda _: reply)
        with pytest.raises(ProctorError, match=message) as caught:
            evaluate_policy(push_server, policy.url, "score")
    assert caught.value.code == "policy_failed"


def test_invalid_actions_are_reported(push_server: ReferenceServer) -> None:
    with ScriptedPolicy() as policy:

        def nothing(call: PolicyCall) -> PolicyReply:
            body = dict(policy.actions_reply(call).body)
            return PolicyReply(body | {"actions": [7]})

        policy.on("predict", nothing)
        with pytest.raises(ProctorError, match="answered without actions"):
            evaluate_policy(push_server, policy.url, "score")


def test_each_check_asks_the_server_again() -> None:
    """It has ended between two runs. Expect this before the second one is created."""
    benchmark: Any = SimpleNamespace(to_dict=dict)
    with ScriptedPolicy() as policy:
        client = PolicyServerClient(policy.url)
        assert client.described_name()
        client.check(benchmark)
        policy.on("describe_policy", lambda _: PolicyReply(b"", 404))
        with pytest.raises(ProctorError, match="status 404"):
            client.check(benchmark)


@pytest.mark.parametrize("member", ["name", "version", "assumes"])
def test_another_policy_at_a_later_episode_ends_the_run(
    push_server: ReferenceServer, member: str
) -> None:
    """It says so from the second episode on. Expect no turn of that one."""
    with ScriptedPolicy() as policy:

        def describe(call: PolicyCall) -> PolicyReply:
            has_played = bool(policy.calls_of("predict"))
            other: dict[str, Any] = {member: "y"} if has_played else {}
            return PolicyReply(dict(policy.description(call).body) | other)

        policy.on("describe_policy", describe)
        said = f"says {member}.* on a new connection"
        with pytest.raises(ProctorError, match=said):
            evaluate_policy(push_server, policy.url, "score", "score", "score")


def test_the_command_calls_a_policy_server(push_server: ReferenceServer) -> None:
    with run_app(make_app().app) as url:
        play = ["--benchmark", "calibration", "--policy-url", url]
        done = run_proctor(push_server, *play)
    assert done.returncode == 0, done.stderr
    assert "0.3" in done.stdout
    assert "played by counting with proctor-eval" in " ".join(done.stdout.split())


def test_the_command_says_why_a_policy_server_is_not_used(
    push_server: ReferenceServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nothing listens, and a wrong key. Expect a line without a library's sentence."""
    play = ["--benchmark", "calibration", "--policy-url"]
    with closed_port() as port:
        nowhere = f"http://127.0.0.1:{port}"
        done = run_proctor(push_server, *play, nowhere)
    assert (done.returncode, done.stdout) == (2, "")
    assert f"server at {nowhere} is unreachable (Connection refused)." in done.stderr
    monkeypatch.setenv("PROCTOR_POLICY_KEY", "wrong")
    with run_app(make_app().app) as url:
        done = run_proctor(push_server, *play, url)
    assert (done.returncode, done.stdout) == (2, "")
    assert "its key is taken from PROCTOR_POLICY_KEY" in done.stderr


def refused_calls() -> Iterator[str]:
    with closed_port() as port:
        yield f"http://127.0.0.1:{port}"


def wrong_key() -> Iterator[str]:
    with run_app(PolicyApp(CountingPolicy, "counting", key="other").app) as url:
        yield url


def other_website() -> Iterator[str]:
    with run_app(Starlette()) as url:
        yield url


def no_name() -> Iterator[str]:
    with ScriptedPolicy() as policy:
        policy.on("describe_policy", lambda _: PolicyReply({"max_sessions": 1}))
        yield policy.url


@pytest.mark.parametrize(
    ("place", "said"),
    [
        (refused_calls, "server at {url} is unreachable (Connection refused)."),
        (wrong_key, "server at {url} answered 401"),
        (other_website, "server at {url} answered with status 404"),
        (no_name, "{url} answers without a name."),
    ],
)
@pytest.mark.parametrize("name", [[], ["--name", "mine"]])
def test_a_push_run_says_what_its_policy_server_answered(
    push_server: ReferenceServer,
    place: Callable[[], Iterator[str]],
    said: str,
    name: list[str],
) -> None:
    """The server may reach what this machine does not, so the run is submitted."""
    with contextlib.contextmanager(place)() as url:
        arguments = ["--benchmark", "calibration", "--push", url, *name]
        done = run_proctor(push_server, *arguments, command="submit")
    assert done.returncode == 0
    is_about_the_name = place is no_name
    if not is_about_the_name:
        assert "is submitted" in done.stderr
        assert "proctor resume run_" in done.stderr
    if not (is_about_the_name and name):
        assert said.format(url=url) in done.stderr
    assert ("named unnamed" in done.stderr) == (not name)


def test_the_command_has_a_server_play_the_run(push_server: ReferenceServer) -> None:
    with run_app(make_app().app) as url, push_server.client() as client:
        arguments = ["--benchmark", "calibration", "--push", url, "--json"]
        done = run_proctor(push_server, *arguments, command="submit")
        assert done.returncode == 0, done.stderr
        run_id = json.loads(done.stdout)["run_id"]
        assert f"\n  proctor status {run_id} --watch\n" in done.stderr
        assert done.stderr.endswith(f"{push_server.url}/pages/runs/{run_id}\n")
        run = wait_for_state(client, run_id)
        assert (run["state"], run["mode"]) == ("completed", "push")
        assert run["policy_server"]["has_api_key"]


def test_status_of_a_failed_run_says_what_is_next(push_server: ReferenceServer) -> None:
    with closed_port() as port, push_server.client() as client:
        run_id = submit_push_run(client, f"http://127.0.0.1:{port}")
        assert wait_for_state(client, run_id)["state"] == "failed"
    done = run_proctor(push_server, run_id, command="status")
    assert "is unreachable" in done.stdout
    assert re.search(rf"\nto go on +.*proctor resume {run_id}\n", done.stdout)


def test_a_command_has_a_server_ask_a_chat_model(push_server: ReferenceServer) -> None:
    """Expect name, numbers and key in the calls, and the name in the run."""
    arguments = ["--benchmark", "question_answering", "--tasks", "count"]
    arguments += ["--split", "val"]
    arguments += ["--model", "my-model", "--generation", '{"temperature": 0}', "--json"]
    with ScriptedChat() as chat, push_server.client() as client:
        push = ["--push", chat.url, "--max-concurrent", "2"]
        done = run_proctor(push_server, *arguments, *push, command="submit")
        assert done.returncode == 0, done.stderr
        run = wait_for_state(client, json.loads(done.stdout)["run_id"])
    assert (run["state"], run["policy"]["name"]) == ("completed", "my-model")
    asked = chat.requests[0]
    assert (asked.body["model"], asked.body["temperature"]) == ("my-model", 0)
    assert asked.headers["authorization"].startswith("Bearer ")


def test_options_of_a_model_need_a_place_to_call(push_server: ReferenceServer) -> None:
    arguments = ["--benchmark", "question_answering", "--model", "my-model"]
    done = run_proctor(push_server, *arguments, command="submit")
    assert done.returncode == 2
    assert "--model needs --push URL" in done.stderr


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--policy", "proctor:host:1"], "takes a URL"),
        (["--policy-url", "http://h", "--policy", "a:b"], "mutually exclusive"),
        (["--policy-url", "http://h", "--processes"], "--processes"),
    ],
)
def test_the_command_refuses_contradicting_options(
    push_server: ReferenceServer, arguments: list[str], message: str
) -> None:
    done = run_proctor(push_server, "--benchmark", "calibration", *arguments)
    assert done.returncode == 2
    assert message in done.stderr
