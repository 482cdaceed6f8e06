"""The scenarios: each judges the output of the program of a client.

A program plays a scenario and prints what it saw; here stands what it should have seen:
computed from the specification, or read from the server with a client that is none of
those under test. It must not know in which language a program is written.
"""

import itertools
import json
import socket
import struct
import subprocess
import time
from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import httpx

from tests.interop import expected_values
from tests.interop.later_version import NEW, extended
from tests.interop.wrong_answers import answers as wrong_bodies
from tests.interop.wrong_answers import wrong_answers as wrong_server
from tests.support.client.spelled_answers import spell
from tests.support.kit.null_servers import run_server
from tests.support.network.lossy_proxy import (
    ANSWERS_OF_OTHERS,
    SECRET,
    Proxy,
    WriteAnswer,
)
from tests.support.ports import closed_port
from tests.support.processes import run_program
from tests.support.sim.calibration_action import SIZES

TIMEOUT_S = 120.0
VECTORS = Path(__file__).resolve().parents[2] / "spec" / "vectors" / "wire"
VECTOR = [-0.0, 0.1, 5e-324, 1.7976931348623157e308, 2.0**53 - 1, 1 / 3, -2.5e-8, 1e22]
# The matrix shows why a language cannot do something.
LOST_SIGN = "JSON.stringify writes −0 as `0`: its sign is lost"
LIMITS = {
    ("typescript", "echo"): LOST_SIGN,
    ("typescript-evaluate", "echo"): LOST_SIGN,
    ("typescript", "spelling"): LOST_SIGN,
    ("typescript-evaluate", "spelling"): LOST_SIGN,
    ("go", "wrong_answers"): "a member that is missing reads as its zero value",
}
# Wrong answers that a language takes for right.
TAKEN = {"go": {"empty", "missing"}}
# The examples of these say which server named an endpoint that does not answer.
NAMES_ENDPOINT = {"go", "cpp-evaluate", "typescript-evaluate"}
# An answer of any server of Proctor counts as one of the address that is asked.
KNOWS_NO_ADDRESS = {"python", "rust", "typescript"}
# Those that read the variables of a proxy.
READ_PROXIES = {"python", "go", "rust", "cpp", "cpp-evaluate"}
FIRST_CONTACT_S = 30.0
PROXIES = dict.fromkeys(
    ("http_proxy", "HTTP_PROXY", "all_proxy", "ALL_PROXY"), "http://127.0.0.1:9"
)
# The generated clients alone play these, and the packages of clients/ those.
MESSAGES_ONLY = {"vectors"}
EVALUATION_ONLY = {"heartbeat"}
# Whose workers say why they leave an episode, as those in TypeScript do: a test of
# their own holds it.
SAY_WHY = {"go", "cpp-evaluate"}


class UnexpectedResult(Exception):
    """A program saw something else than it should have."""


@dataclass
class Server:
    """The server under which the programs run. restart: kills it, starts it again and
    returns its URL; None if it cannot be."""

    url: str
    token: str
    restart: Callable[[], str] | None = None

    def read(self, path: str) -> dict[str, Any]:
        """One GET by hand, outside every client."""
        return self._ask("GET", path)

    def write(self, path: str, body: dict[str, Any]) -> dict[str, Any]:
        """One POST by hand, outside every client."""
        return self._ask("POST", path, json=body)

    def _ask(self, method: str, path: str, **body: Any) -> dict[str, Any]:
        headers = {"Authorization": f"Bearer {self.token}"}
        how: dict[str, Any] = {"trust_env": False, "timeout": TIMEOUT_S, **body}
        answer = httpx.request(method, self.url + path, headers=headers, **how)
        content = answer.raise_for_status().json()
        assert isinstance(content, dict)
        return content

    def submit(self, **options: Any) -> str:
        """The id of a run of calibration that no client has submitted."""
        body: dict[str, Any] = {"benchmark_id": "calibration"}
        body |= {"policy": {"name": "interop"}, "options": options}
        return str(self.write("/v1/runs", body)["run_id"])


@dataclass(frozen=True)
class Program:
    """The interop program of one language, and its example."""

    language: str
    command: Sequence[str]
    env: Mapping[str, str]
    example: Sequence[str] = ()

    def play(self, scenario: str, url: str, token: str) -> dict[str, Any]:
        """Return its output; UnexpectedResult has its last words if it failed."""
        done = self._run([*self.command, scenario, url, token])
        if done.returncode != 0:
            said = (done.stdout + done.stderr)[-1500:]
            raise UnexpectedResult(f"exit {done.returncode}: {said}")
        try:
            observed = json.loads(done.stdout)
        except ValueError:
            raise UnexpectedResult(f"no JSON: {done.stdout[-500:]!r}") from None
        if not isinstance(observed, dict):
            raise UnexpectedResult(f"no object: {done.stdout[-500:]!r}")
        return observed

    def play_example(
        self, url: str = "", token: str = "", *run_id: str
    ) -> subprocess.CompletedProcess[str]:
        """Its exit code and what it printed, as a user of the example sees them.

        The token is in its environment, which other users of a machine do not see.
        """
        program = replace(self, env={**self.env, "PROCTOR_TOKEN": token})
        return program._run([*self.example, *filter(None, [url]), *run_id])

    @contextmanager
    def start_example(self, url: str, token: str) -> Iterator[subprocess.Popen[str]]:
        """The example, which runs until the context ends."""
        with subprocess.Popen(
            [*self.example, url],
            env={**self.env, "PROCTOR_TOKEN": token},
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        ) as process:
            try:
                yield process
            finally:
                process.kill()

    def _run(self, command: list[str]) -> subprocess.CompletedProcess[str]:
        try:
            return run_program(command, env=dict(self.env), timeout=TIMEOUT_S)
        except subprocess.TimeoutExpired:
            raise UnexpectedResult(f"no answer within {TIMEOUT_S:.0f} s") from None


def expect(what: str, observed: object, wanted: object) -> None:
    if observed != wanted:
        raise UnexpectedResult(f"{what} is {observed!r}, expected {wanted!r}")


def expect_refusal(
    observed: Mapping[str, Any], status: int, code: str, **more: Any
) -> None:
    wanted = {"status": status, "code": code, "side_effects": "none"} | more
    expect("the problem", {name: observed.get(name) for name in wanted}, wanted)


def expect_run(server: Server, observed: Mapping[str, Any], score: float) -> list[Any]:
    """The run is complete with this score, here and there; returns its episodes."""
    expect("score", observed["score"], score)
    expect("complete", observed["complete"], True)
    reported = server.read(f"/v1/runs/{observed['run_id']}/score")
    expect("the server's score", reported["score"], score)
    page = server.read(f"/v1/runs/{observed['run_id']}/episodes")
    episodes = page["episodes"]
    assert isinstance(episodes, list)
    return episodes


def submit(server: Server, program: Program) -> None:
    observed = program.play("submit", server.url, server.token)
    first, second = observed["run_ids"]
    expect("the run of the repeated submit", second, first)
    expect("runs listed under this id", observed["listed"], 1)
    limits = server.read("/v1")["limits"]
    expect("limits.max_workers", observed["max_workers"], limits["max_workers"])
    expect("sizes of the action space", observed["action_sizes"], SIZES)


def two_workers(server: Server, program: Program) -> None:
    observed = program.play("two_workers", server.url, server.token)
    expect_run(server, observed, 0.5)
    played = observed["played"]
    expect("workers", sorted(played), ["worker-0", "worker-1"])
    expect("episodes played", sorted(itertools.chain(*played.values())), list(range(8)))
    if not all(played.values()):
        raise UnexpectedResult(f"one worker played all episodes: {played}")


def chunks(server: Server, program: Program) -> None:
    observed = program.play("chunks", server.url, server.token)
    wanted = {
        "executed": [4, 4, 2],
        "counts": [[1, 2, 3, 4], [5, 6, 7, 8], [9, 10]],
        "rewards": [4, 4, 2],
        "stopped_early": [False, False, True],
        "truncated": [False, False, True],
        "done": True,
        "steps": 10,
    }
    expect("the turns", observed, wanted)


def echo(server: Server, program: Program, write: WriteAnswer | None = None) -> None:
    with Proxy(server.url, write=write) as proxy:
        observed = program.play("echo", proxy.url, server.token)
    expect("codec", observed["codec"], "raw")
    expect("size", observed["size"], [48, 64, 3])
    expect("image", observed["image"], expected_values.pattern(48, 64, count=1).hex())
    expect("tensors", observed["tensors"], expected_values.tensors())
    wanted = [struct.pack(">d", number).hex() for number in VECTOR]
    numbers = apply_known_limits(program.language, observed["vector"], wanted)
    expect("vector", numbers, wanted)


def apply_known_limits(
    language: str, observed: list[str], wanted: list[str]
) -> list[str]:
    """The numbers seen, as bits in hexadecimal digits; what LIMITS allows is mended."""
    if (language, "echo") not in LIMITS or len(observed) != len(wanted):
        return observed
    minus_zero, zero = "8" + "0" * 15, "0" * 16
    return [
        want if want == minus_zero and bits == zero else bits
        for bits, want in zip(observed, wanted, strict=True)
    ]


def lost_answer(server: Server, program: Program) -> None:
    losses = ["lose_answer", "cut_head", "cut_open_answer"]
    play_with_faults(
        server, program, dict.fromkeys(("attach", "predict", "submit"), losses)
    )


def answers_of_others(server: Server, program: Program) -> None:
    """What answers in the place of the server is waited out in the middle of a run."""
    faults = {
        "submit": ["gateway"],
        "attach": ["page", "empty"],
        "predict": ["sign_in", "problem", "pass", "page", "cut_answer"],
    }
    play_with_faults(server, program, faults)
    for name in ("page", "sign_in", "refused"):
        first_contact_with(name, program)


def first_contact_with(name: str, program: Program) -> None:
    reply = ANSWERS_OF_OTHERS[name]
    with run_server(lambda _: reply) as url:
        expect_named(program, url, url)
        if program.language in READ_PROXIES:
            proxy = url.replace("//", f"//me:{SECRET}@")
            env = {**program.env, "http_proxy": proxy, "HTTP_PROXY": proxy}
            behind = replace(program, env=env)
            expect_named(behind, "http://proctor.invalid", f"or the proxy {url}")


def expect_named(program: Program, url: str, who: str, token: str = SECRET) -> None:
    """The first contact ends soon, and names who has answered, and no secret."""
    started = time.monotonic()
    played = program.play_example(url, token)
    output = played.stdout + played.stderr
    if played.returncode != 1 or who not in played.stderr:
        raise UnexpectedResult(f"no {who!r} is named: {output[-1500:]}")
    expect("that a secret was printed", token in output, False)
    expect("that it was repeated", time.monotonic() - started > FIRST_CONTACT_S, False)


def play_with_faults(
    server: Server, program: Program, faults: Mapping[str, Sequence[str]]
) -> None:
    """Requests are repeated as they were for each fault, and executed once."""
    with Proxy(server.url) as proxy:
        proxy.faults |= {kind: deque(names) for kind, names in faults.items()}
        observed = program.play("lost_answer", proxy.url, server.token)
    expect("faults to come", [kind for kind in faults if proxy.faults[kind]], [])
    wanted = {kind: len(names) - names.count("pass") for kind, names in faults.items()}
    repeats = {kind: len(proxy.repeats(kind)) for kind in faults}
    expect("the repeats with the same body and key", repeats, wanted)
    expect("counts", observed["counts"], [1, 2, 3, 4, 5, 6])
    expect("done", observed["done"], True)
    (episode,) = server.read(f"/v1/runs/{observed['run_id']}/episodes")["episodes"]
    expect("steps", episode["result"]["steps"], 6)
    expect("attempt", episode["attempt"], 1)


def lost_session(server: Server, program: Program) -> None:
    with Proxy(server.url, lose=["heartbeat"]) as proxy:
        observed = program.play("lost_session", proxy.url, server.token)
    (episode,) = expect_run(server, observed, 1.0)
    expect("sessions", observed["sessions"], 2)
    expect("attempt", observed["attempt"], 2)
    expect("the server's attempt", episode["result"]["attempt"], 2)


def heartbeat(server: Server, program: Program) -> None:
    with Proxy(server.url) as proxy:
        observed = program.play("heartbeat", proxy.url, server.token)
    (episode,) = expect_run(server, observed, 1.0)
    if not any(one.kind == "heartbeat" for one in proxy.recorded):
        raise UnexpectedResult("no heartbeat was sent")
    expect("sessions", observed["sessions"], 1)
    expect("attempt", observed["attempt"], 1)
    expect("the server's attempt", episode["result"]["attempt"], 1)


def left(server: Server, program: Program) -> None:
    """A policy raises in the middle of an episode, which says so without secrets."""
    run_id = program.play("left", server.url, server.token)["run_id"]
    episode = server.read(f"/v1/runs/{run_id}/episodes")["episodes"][0]
    expect("the attempt", episode["last_left"]["attempt"], 1)
    _, _, said = episode["last_left"]["reason"].partition(": ")
    expect("the reason", said, "no answer of http://host/?… with (token)")


def restart(server: Server, program: Program) -> None:
    if server.restart is None:
        raise ScenarioNotRunnable("this scenario needs RESTART_CMD")

    failures: list[Exception] = []

    def crash() -> str:
        assert server.restart is not None
        try:
            server.url = server.restart()
        except (OSError, subprocess.SubprocessError) as error:
            failures.append(error)
        return server.url

    with Proxy(server.url, crash_at=6, crash=crash) as proxy:
        observed = program.play("restart", proxy.url, server.token)
    if failures:
        raise ScenarioNotRunnable(f"the server was not restarted: {failures[0]}")
    expect("crashes", proxy.dropped_answers, ["crash"])
    episodes = expect_run(server, observed, 0.625)
    scores = [episode["result"]["score"] for episode in episodes]
    expect("scores", scores, [0.25, 0.5, 0.75, 1.0])
    expect("attempts", [e["result"]["attempt"] for e in episodes], [1, 1, 1, 1])


def worker_limit(server: Server, program: Program) -> None:
    observed = program.play("worker_limit", server.url, server.token)
    expect_refusal(observed["problem"], 429, "worker_limit", retryable=True)
    wait_s = observed["problem"]["retry_after_s"]
    if not (wait_s or 0) > 0:
        raise UnexpectedResult(f"Retry-After is {wait_s!r}")
    expect_run(server, observed, 1.0)


def stop_resume(server: Server, program: Program) -> None:
    observed = program.play("stop_resume", server.url, server.token)
    expect("state after the stop", observed["stopped"], "stopped")
    expect_refusal(observed["problem"], 409, "session_ended", ended_by="run_stopped")
    expect("episodes after the resume", observed["after"], [1, 2])
    episodes = expect_run(server, observed, (0.5 + 0.25 + 1.0) / 3)
    scores = [episode["result"]["score"] for episode in episodes]
    expect("scores", scores, [0.5, 0.25, 1.0])


def problems(
    server: Server, program: Program, write: WriteAnswer | None = None
) -> None:
    with Proxy(server.url, write=write) as proxy:
        observed = program.play("problems", proxy.url, server.token)["problems"]
    unknown, missing, unauthenticated, vector, order = observed
    never = {"retryable": False}
    expect_refusal(unknown, 422, "invalid_request", pointers=["/benchmark_id"], **never)
    expect_refusal(missing, 404, "not_found", **never)
    expect_refusal(unauthenticated, 401, "unauthenticated", **never)
    expect_refusal(vector, 422, "invalid_request", **never)
    expect("pointers", vector["pointers"], ["/actions/0/values/vector"])
    expect_refusal(order, 409, "seq_out_of_order", expected_seq=1, **never)


def score(server: Server, program: Program, write: WriteAnswer | None = None) -> None:
    with Proxy(server.url, write=write) as proxy:
        observed = program.play("score", proxy.url, server.token)
    reported = server.read(f"/v1/runs/{observed['run_id']}/score")
    expect("score", observed["score"], 0.4)
    expect("success rate", observed["success_rate"], 0.2)
    expect("successes", observed["success"], 1)
    interval = reported["success_interval"]
    expect("interval", observed["interval"], [interval["low"], interval["high"]])
    expect("splits", observed["splits"], {"even": 0.5, "odd": 0.25})
    pages = sum(one.kind == "episodes" for one in proxy.recorded)
    expect("requests for episodes", pages, 3)
    # The packages of clients/ give the episodes without their pages.
    expect("pages", observed.get("pages", pages), 3)
    scores = [1.0, 0.5, 0.25, 0.0, 0.25]
    wanted = [[index, scores[index], 1000 + index] for index in range(5)]
    expect("episodes", observed["episodes"], wanted)


def example(server: Server, program: Program) -> None:
    """The first program that a user runs: a run, a stopped run, and two mistakes."""
    played = program.play_example(server.url, server.token)
    expect_example(played, 0, "score 0.40625")
    stopped = server.submit(tasks=["score"] * 8)
    server.write(f"/v1/runs/{stopped}/stop", {"mode": "abort"})
    resumed = program.play_example(server.url, server.token, stopped)
    expect_example(resumed, 0, "score 0.40625")
    seen = {"run_id": stopped, "score": 0.40625, "complete": True}
    expect("episodes of the resumed run", len(expect_run(server, seen, 0.40625)), 8)
    refused = program.play_example(server.url, "not-a-token")
    expect_example(refused, 1, "[unauthenticated]")
    expect_example(program.play_example(), 1, "the token is PROCTOR_TOKEN")


def expect_example(
    played: subprocess.CompletedProcess[str], exit_code: int, end: str
) -> None:
    """It ended so, and the last thing that it printed is the score or the error."""
    printed = (played.stdout if exit_code == 0 else played.stderr).rstrip()
    if played.returncode != exit_code or not printed.endswith(end):
        output = (played.stdout + played.stderr)[-1500:]
        raise UnexpectedResult(
            f"the example ended with {played.returncode}, not with {exit_code} "
            f"and {end!r}: {output}"
        )


def spelling(server: Server, program: Program) -> None:
    """Answers in spellings that the specification allows are read alike."""
    for play in (echo, problems, score):
        play(server, program, spell)


def settings(server: Server, program: Program) -> None:
    """The example cleans or refuses a URL and a token, and says what it waits for. No
    proxy of the environment is asked for this machine."""
    program = replace(program, env={**program.env, **PROXIES})
    with (
        closed_port() as port,
        program.start_example(f"http://127.0.0.1:{port}", "token") as waiting,
    ):
        settings_that_work(server, program)
        settings_that_do_not(server, program)
        expect_wait(waiting, port)


def settings_that_work(server: Server, program: Program) -> None:
    token = f"\ufeff\u201cBearer {server.token}\u201d\r\n"
    played = program.play_example(f" {server.url}/", token)
    expect_example(played, 0, "score 0.40625")
    if has_ipv6():
        with Proxy(server.url, host="::1") as proxy:
            played = program.play_example(proxy.url, f"'{server.token}'")
        expect_example(played, 0, "score 0.40625")


def settings_that_do_not(server: Server, program: Program) -> None:
    new = "https://new.example/base"
    with run_server(lambda sent: (308, {"Location": new + sent.path}, b"")) as old:
        for url, token, reason in (
            (server.url, f"{SECRET}\u200b{SECRET}", "has an invisible"),
            (server.url, f"{SECRET} {SECRET}", "has a space at"),
            (server.url, f"{SECRET}é", "has a character that is not ASCII"),
            (f"http://me:{SECRET}@127.0.0.1", "t", "a password"),
            (f"http://127.0.0.1/?key={SECRET}", "t", "ends with a query"),
            ("http://[fe80::1%25eth0]:8460", "t", "a zone id"),
            ("http://::1:8460", "t", "an IPv6 address without brackets"),
            ("127.0.0.1:8460", "t", "must be like http://"),
            (f"{server.url}/v1", server.token, "The base URL ends with /v1"),
            (old, SECRET, f"The server has moved to {new}: give that as the base URL"),
        ):
            played = program.play_example(url, token)
            output = played.stdout + played.stderr
            if played.returncode != 1 or reason not in played.stderr:
                raise UnexpectedResult(f"no {reason!r} of {url!r}: {output[-1500:]}")
            expect("that a secret was printed", SECRET in output, False)


def endpoint_that_leads_elsewhere(server: Server, program: Program) -> None:
    """Another port of this machine, at which no server of Proctor has answered: its
    page is not waited out."""
    page = 404, {"Content-Type": "text/html"}, b"<h1>Not Found</h1>"
    with run_server(lambda _: page) as elsewhere:

        def misled(body: object) -> object:
            if isinstance(body, dict) and "endpoint" in body:
                return {**body, "endpoint": elsewhere}
            return body

        with Proxy(server.url, alter=misled) as proxy:
            who = elsewhere
            if program.language in NAMES_ENDPOINT:
                who += f" is the endpoint of the run, which {proxy.url} has named"
            expect_named(program, proxy.url, who, server.token)


def expect_wait(waiting: subprocess.Popen[str], port: int) -> None:
    """The example says within seconds what it waits for, before it ends."""
    assert waiting.stderr is not None
    line = waiting.stderr.readline()
    # A package ends its first contact after 3 s.
    is_said = line.startswith("waiting: ") or line.endswith("[unreachable]\n")
    if not is_said or str(port) not in line:
        raise UnexpectedResult(f"at a closed port the example says {line!r}")


def has_ipv6() -> bool:
    with suppress(OSError), socket.create_server(("::1", 0), family=socket.AF_INET6):
        return True
    return False


def vectors(_server: Server, program: Program) -> None:
    """The golden vectors need no server."""
    observed = program.play("vectors", str(VECTORS), "-")
    for file in sorted(VECTORS.glob("*.json")):
        for vector in json.loads(file.read_text())["vectors"]:
            if vector.get("refused"):
                continue  # what servers refuse
            decoded = observed.get(vector["id"], "refused")
            if decoded == "refused":
                raise UnexpectedResult(f"vector {vector['id']} does not decode")
            again, wanted = json.loads(decoded), json.loads(vector["json"])
            for name in vector.get("may_drop", ()):
                again.pop(name, None)
                wanted.pop(name)
            if not expected_values.values_equal(again, wanted):
                raise UnexpectedResult(f"vector {vector['id']} came back as {decoded}")


def wrong_answers(server: Server, program: Program) -> None:
    """Successes that are no message; the client's own error says so for each."""
    server.submit()
    if program.language not in KNOWS_NO_ADDRESS:
        endpoint_that_leads_elsewhere(server, program)
    page = server.read("/v1/runs?limit=1")
    with wrong_server(page) as url:
        errors = program.play("wrong_answers", url, server.token)["errors"]
    taken = TAKEN.get(program.language, set())
    wanted = {
        name: "accepted" if name in taken else "bad_answer"
        for name in wrong_bodies(page["runs"][0])
    }
    expect("the errors", errors, wanted)


def later_version(server: Server, program: Program) -> None:
    """Values and members that a client of today cannot know."""
    with Proxy(server.url, alter=extended) as proxy:
        observed = program.play("later_version", proxy.url, server.token)
    service = server.read("/v1")
    expect("profiles", observed["profiles"], [*service["profiles"], NEW])
    expect("image_codecs", observed["image_codecs"], [*service["image_codecs"], NEW])
    for name in ("success_rule", "rotation", "out_of_range", "mode", "codec", "dtype"):
        expect(name, observed[name], NEW)
    expect("policy", observed["policy"], "interop")
    expect_refusal(observed["problem"], 404, NEW, retryable=False)


class ScenarioNotRunnable(Exception):
    """A scenario cannot be played here."""


SCENARIOS: dict[str, Callable[[Server, Program], None]] = {
    "submit": submit,
    "two_workers": two_workers,
    "chunks": chunks,
    "echo": echo,
    "lost_answer": lost_answer,
    "answers_of_others": answers_of_others,
    "lost_session": lost_session,
    "heartbeat": heartbeat,
    "restart": restart,
    "left": left,
    "worker_limit": worker_limit,
    "stop_resume": stop_resume,
    "problems": problems,
    "score": score,
    "wrong_answers": wrong_answers,
    "later_version": later_version,
    "vectors": vectors,
    "spelling": spelling,
    "settings": settings,
    "example": example,
}
DESCRIPTIONS = {
    "submit": "a submit repeated with its Idempotency-Key makes one run",
    "two_workers": "two workers play one run at the same time",
    "chunks": "chunks of actions, all observations, the step limit",
    "echo": "image, tensors and numbers arrive bit for bit",
    "lost_answer": "lost answers to submit, attach and predict: nothing happens twice",
    "answers_of_others": "pages of gateways and networks are waited out, and named",
    "lost_session": "a lease that ends: the worker attaches again and continues",
    "heartbeat": "a policy that computes for longer than the lease keeps its session",
    "restart": "the server is killed in the middle and started again",
    "left": "a policy that raises: its episode says why its worker left",
    "worker_limit": "429 with Retry-After: the worker waits and retries",
    "stop_resume": "a run is stopped and resumed; scored episodes are kept",
    "problems": "refusals arrive as typed problems",
    "score": "the score, its interval and the pages of episodes",
    "wrong_answers": "successes that are no message are errors of the client's own",
    "later_version": "values and members of a later version are no error",
    "vectors": "golden vectors of spec/vectors/wire",
    "spelling": "numbers, times, media types, chunks in all spellings that are allowed",
    "settings": "URLs and tokens as people copy them; a server that moved or is away",
    "example": "the first program of a user: a run, a stopped run, two mistakes",
}
