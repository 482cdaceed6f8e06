"""Every client plays every scenario, as in `make interop`.

The gate plays the committed clients and one of those that are generated for the build;
all others are left to `make test-all`.
"""

import time
from collections import deque
from collections.abc import Callable
from contextlib import ExitStack

import pytest

from tests.interop.clients import LANGUAGES, Language
from tests.interop.scenarios import SCENARIOS, Program, Server
from tests.support.network.lossy_proxy import Proxy
from tools.interop import scenarios_of

pytestmark = pytest.mark.slow("starts servers, compiles clients")

IN_GATE = {"python", "typescript", "cpp", "go"}
# In the gate the packages of clients/ play only their example and these scenarios, in
# which the server fails: their other scenarios repeat those of the generated client.
FAULTS = {
    *("lost_answer", "lost_session", "restart", "left", "stop_resume"),
    "wrong_answers",
}
# `settings` starts the example a dozen times, so the gate plays it where that is fast.
FAST_STARTS = {"go", "typescript"}


def cases(*, in_gate: bool) -> list[tuple[Language, str]]:
    return [
        (language, name)
        for language in LANGUAGES
        for name in scenarios_of(language)
        if in_gate == is_in_gate(language, name)
    ]


def is_in_gate(language: Language, name: str) -> bool:
    if name == "settings":
        return language.name in FAST_STARTS
    sample = FAULTS | {"example"} if language.evaluates else SCENARIOS.keys()
    return language.language in IN_GATE and name in sample


def name_of(value: Language | str) -> str:
    return value if isinstance(value, str) else value.name


@pytest.mark.parametrize(("language", "name"), cases(in_gate=True), ids=name_of)
def test_a_client_passes_a_scenario(
    language: Language, name: str, server: Server, built: Callable[[Language], Program]
) -> None:
    SCENARIOS[name](server, built(language))


@pytest.mark.release("clients in Rust, Java, Kotlin; packages where nothing fails")
@pytest.mark.parametrize(("language", "name"), cases(in_gate=False), ids=name_of)
def test_another_client_passes_a_scenario(
    language: Language, name: str, server: Server, built: Callable[[Language], Program]
) -> None:
    SCENARIOS[name](server, built(language))


@pytest.mark.release("waits for a minute, for clients in every language at once")
def test_a_page_that_stays_ends_every_client(
    server: Server, built: Callable[[Language], Program]
) -> None:
    """After the minute for which it may pass, with the address that answers so."""
    programs = [built(language) for language in LANGUAGES if not language.missing()]
    with Proxy(server.url) as proxy, ExitStack() as started:
        proxy.faults["attach"] = deque(["page"] * 100_000)
        start = time.monotonic()
        examples = [
            started.enter_context(program.start_example(proxy.url, server.token))
            for program in programs
        ]
        ends = {}
        for program, example in zip(programs, examples, strict=True):
            _, said = example.communicate(timeout=120)
            ends[program.language] = (example.returncode, proxy.url in said)
    assert time.monotonic() - start > 45, "no client waited"
    assert ends == {program.language: (1, True) for program in programs}
