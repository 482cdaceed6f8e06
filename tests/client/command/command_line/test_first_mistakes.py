"""The mistakes of a first hour, made on purpose: what is said, and what is left."""

import re
from pathlib import Path

import pytest

from conformance.specification.document import load_spec
from reference_client import ProctorError
from reference_client.command.exit_codes import message_of, with_flag_names
from reference_client.errors import from_failure
from reference_client.protocol.retry_policy import text_of_wait
from tests.support.client.api_exceptions import api_exception
from tests.support.client.command import Proctor, options
from tests.support.servers import ReferenceServer

pytestmark = pytest.mark.usefixtures("policy_folder")
EXPECTED = "score 1, success 1, end 1, delay_s 1, fault 1, vector 8, clipped 2, or an "
MISTAKES = """
import numpy as np
import policies


class Base:
    def reset(self, instruction):
        pass


class Short(Base):
    def act(self, observation):
        return np.zeros(14)


class Misspelt(Base):
    def act(self, observation):
        values = policies.action(end=1.0)
        values["sucess"] = values.pop("success")
        return values


class OneInstruction:
    def reset(self, instruction):
        self.plan = {"task score.": 1}[" ".join(instruction.split()[1:])]

    def act(self, observation):
        return np.array([1.0, 1.0, 1.0, *[0.0] * 12])


class Row(Base):
    def act(self, observation):
        return np.array([1.0, 1.0, 1.0, *[0.0] * 12])


class Rows(Base):
    def act(self, observation):
        return np.tile(Row().act(observation), (2, 1))


class TooMany(Base):
    def act(self, observation):
        return np.zeros((9000, 15))


class Quits(Base):
    def act(self, observation):
        raise SystemExit(0)


class Wordless(Exception):
    def __str__(self):
        raise ValueError


class RaisesWordless(Base):
    def act(self, observation):
        raise Wordless


class Loud(Base):
    def act(self, observation):
        return policies.action(clipped=90.0, success=1.0, end=observation.step > 2)
"""


WORDLESS = "Wordless: <its str() failed with ValueError>"


@pytest.fixture
def proctor(
    server: ReferenceServer, capsys: pytest.CaptureFixture[str], policy_folder: Path
) -> Proctor:
    (policy_folder / "mistakes.py").write_text(MISTAKES)
    return Proctor(server.url, capsys)


def play(name: str, *flags: str) -> list[str]:
    return ["run", "--policy", f"mistakes.py:{name}", *options("score"), *flags]


@pytest.mark.parametrize("processes", [[], ["--processes"]])
@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("Short", "/actions/0/values is an array of 14"),
        ("Misspelt", "has sucess, which is no name; did you mean success"),
        ("TooMany", "/actions has 9000 actions; a chunk holds at most "),
        ("Quits", "The policy raised SystemExit: 0 (mistakes.py:"),
        ("RaisesWordless", f"The policy raised {WORDLESS} (mistakes.py:"),
    ],
)
def test_a_mistaken_policy_leaves_no_run(
    proctor: Proctor, name: str, message: str, processes: list[str]
) -> None:
    """Expect 2, one line with the place of the mistake, and no run."""
    before = proctor.json("status")
    assert proctor(*play(name, *processes)) == 2
    assert message in proctor.err
    assert proctor.err.count("\n") == 1
    assert "no run was submitted" in proctor.err
    if name in ("Short", "Misspelt"):
        assert f"An action of calibration is: {EXPECTED}" in proctor.err
    assert proctor.json("status") == before


@pytest.mark.parametrize("name", ["Row", "Rows", "OneInstruction"])
def test_policies_without_a_mistake_are_scored(proctor: Proctor, name: str) -> None:
    """Rows of numbers; and one that knows only the instructions of the benchmark."""
    assert proctor.json(*play(name))["score"] == 1.0


@pytest.mark.parametrize("processes", [[], ["--processes"]])
def test_clipping_is_reported_at_once_and_at_the_end(
    proctor: Proctor, processes: list[str]
) -> None:
    """Every action of two episodes is outside. Expect one warning and one sum."""
    run = ["run", "--policy", "mistakes.py:Loud", *options("score", "score")]
    score = proctor.json(*run, *processes)
    assert score["clips"]["clipped"] == score["clips"]["actions"] > 0
    warnings = re.findall(r"^warning: (.*)$", proctor.err, re.MULTILINE)
    assert len(warnings) == 1
    assert re.match(r"e0000: \d of \d actions were clipped", warnings[0])
    assert "Declared: clipped [-1, 1]" in warnings[0]
    assert re.search(r"^Clipped: (\d+) of \1 actions", proctor.err, re.MULTILINE)


def test_a_file_alone_is_answered_with_a_name_in_it(proctor: Proctor) -> None:
    Path("alone.py").write_text(
        "raise SystemExit\n\n\ndef _x():\n    pass\n\n\nclass Mine:\n    pass\n"
    )
    run = ["run", "--benchmark", "calibration", "--policy"]
    assert proctor(*run, "alone.py") == 2
    assert "takes a name like alone.py:Mine, not 'alone.py'" in proctor.err
    assert proctor(*run, "missing.py") == 2
    assert "takes a name like my_module:MyPolicy" in proctor.err


def test_waiting_is_not_giving_up(proctor: Proctor) -> None:
    """A closed port is tried again for a while. Expect the advice once, at last."""
    place = ["--url", "http://127.0.0.1:9", "--retry-timeout-s", "0.5"]
    assert proctor("status", *place) == 2
    first, last = proctor.err.splitlines()
    fact, _, advice = last.partition("). ")
    assert first == f"{fact}). Trying again …"
    assert advice == "Check the URL, and that the server runs. [unreachable]"


@pytest.mark.parametrize(
    ("flag", "known"), [("--tasks", "reach, push"), ("--split", "val_train, val_unse")]
)
def test_a_part_that_does_not_exist_is_named_by_its_flag(
    proctor: Proctor, flag: str, known: str
) -> None:
    """Expect the flag and what there is, and no word about the request."""
    run = ["run", "--policy", "policies:best", "--benchmark", "tabletop_state"]
    assert proctor(*run, "--no-dry-turn", flag, "nonsense") == 2
    assert f"{flag} 'nonsense': there is {known}" in proctor.err
    assert "`errors`" not in proctor.err
    assert "/select" not in proctor.err


def test_only_what_a_flag_says_is_named_by_it() -> None:
    """Expect the flag, what lies deeper behind it, and other pointers as they are."""
    errors = [("/policy_server/url", "a"), ("/images/width", "b"), ("/selection", "c")]
    error = ProctorError("invalid_request", "No. Correct what `errors` points at.",
                         errors=errors)  # fmt: skip
    said = "No. – --push a – --images /width b – /selection c [invalid_request]"
    assert message_of(error) == said


@pytest.mark.parametrize(
    ("retry_after_s", "said"),
    [(60.0, r"runs\. \["), (1.0, r"runs\. Waiting does not help"), (None, "not help")],
)
def test_a_limit_says_in_a_terminal_whether_waiting_helps(
    retry_after_s: float | None, said: str
) -> None:
    """Without the members of a response, which a terminal does not show."""
    advice = load_spec().problems["quota_exceeded"]["act"]
    error = ProctorError(
        "quota_exceeded", f"It allows 5 runs. {advice}", retry_after_s=retry_after_s
    )
    assert re.search(said, message_of(error))
    assert "Retry-After" not in message_of(error)


@pytest.mark.parametrize(
    "code", [code for code, one in load_spec().problems.items() if one["retryable"]]
)
@pytest.mark.parametrize("is_waiting", [True, False])
def test_no_advice_to_programs_is_given_to_people(code: str, is_waiting: bool) -> None:
    """The command itself decides when it repeats a request.

    One that waits asks for no other command, and one that has ended does not wait.
    """
    detail = f"It is full. {load_spec().problems[code]['act']}"
    error = ProctorError(code, detail)
    said = with_flag_names(text_of_wait(detail)) if is_waiting else message_of(error)
    assert said.startswith("It is full. ")
    false = "the command again" if is_waiting else "waits by itself"
    assert false not in said
    members = ("Retry-After", "attach_key", "Idempotency-Key", "seq", "`detail`")
    assert [member for member in members if member in said] == []


def test_a_second_program_of_a_run_learns_how_it_can_share_it() -> None:
    """Its worker has the name of the first one's."""
    busy = api_exception("worker_busy", 409, retryable=True)
    said = with_flag_names(text_of_wait(from_failure(busy, "http://127.0.0.1").detail))
    assert "a second program that plays the run needs another --worker-prefix." in said


@pytest.mark.parametrize("code", load_spec().problems)
def test_no_advice_names_a_member_of_a_response(code: str) -> None:
    """A terminal shows none. Expect words and flags alone."""
    advice = load_spec().problems[code]["act"]
    said = with_flag_names(message_of(ProctorError(code, f"It is so. {advice}")))
    assert re.findall("`[a-z_]+`", said) == []
