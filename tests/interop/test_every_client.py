"""Every client plays every scenario, as in `make interop`.

The gate plays the committed clients and one of those that are generated for the build;
all others are left to `make test-all`.
"""

from collections.abc import Callable

import pytest

from tests.interop.clients import LANGUAGES, Language
from tests.interop.scenarios import SCENARIOS, Program, Server
from tools.interop import scenarios_of

pytestmark = pytest.mark.slow("starts servers, compiles clients")

IN_GATE = {"python", "typescript", "cpp", "go"}
# In the gate the packages of clients/ play only their example and these scenarios, in
# which the server fails: their other scenarios repeat those of the generated client.
FAULTS = {"lost_answer", "lost_session", "restart", "stop_resume", "wrong_answers"}
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
