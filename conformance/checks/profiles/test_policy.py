"""What a policy server has to do, for servers that call it (POL)."""

from conformance.client.check_context import Story
from conformance.policy import turns
from conformance.policy.policy_client import Asked
from conformance.runner.requirement import requirement
from conformance.specification.document import JSON
from conformance.verdicts import expect
from conformance.verdicts.expect import NotApplicable, Violation

_TURNS = 5
_SESSIONS = 4
# What the rules for all answers are about; a policy server has them in POL-002.
_FOR_ALL = ("SVC-003", "ERR-001", "ERR-011")


def _ready(story: Story) -> Asked:
    """Give a session whose attempt has begun."""
    asked = Asked(story)
    asked.reset()
    return asked


@requirement("POL-001")
def test_pol_001_protocol_range_holds_this_version(story: Story) -> None:
    """Expect a range that contains the version of policy.yaml."""
    told = expect.ok(story.call("describe_policy"))["protocol"]

    def number(version: str) -> list[int]:
        return [int(part) for part in version.split(".")]

    here = story.spec.version.rpartition(".")[0]
    holds = number(told["min"]) <= number(here) <= number(told["max"])
    expect.true(holds, f"a range that contains {here}", dict(told))


@requirement("POL-002")
def test_pol_002_answers_are_as_described(story: Story) -> None:
    """Every operation is called, rightly and wrongly.

    Expect statuses and bodies as the description has them, and problems as problems.
    """
    asked = _ready(story)
    story.call("describe_policy")
    asked.try_predict()
    asked.try_reset(benchmark=7)
    story.call("predict", json={})
    story.call("predict", content=b"{", headers={"Content-Type": JSON})
    story.wire.request("GET", "/v1/policy/nowhere")
    for breach in story.tally.breaches:
        if breach.requirement_id in _FOR_ALL:
            raise Violation(breach.expected, breach.observed, breach.exchange.number)


@requirement("POL-003")
def test_pol_003_reset_is_acknowledged_as_sent(story: Story) -> None:
    """Two attempts of different episodes begin. Expect each acknowledged as itself."""
    for index, attempt in ((0, 1), (3, 2)):
        asked = Asked(story)
        told = expect.ok(asked.try_reset(index, attempt))
        expect.equal(told["session_id"], asked.session_id, "session_id")
        expect.equal(told["episode_id"], asked.view["episode_id"], "episode_id")
        expect.equal(told["attempt"], attempt, "attempt")


@requirement("POL-004")
def test_pol_004_answer_is_for_its_turn(story: Story) -> None:
    """A few turns are played. Expect the session of each, and its seq plus one."""
    asked = _ready(story)
    for _ in range(_TURNS):
        told = expect.ok(asked.try_predict())
        expect.equal(told["session_id"], asked.session_id, "session_id")
        expect.equal(told["seq"], asked.seq + 1, "seq")
        asked.seq += 1


@requirement("POL-005")
def test_pol_005_actions_fit_the_benchmark(story: Story) -> None:
    """A few turns are played. Expect actions that the benchmark would not refuse."""
    asked = _ready(story)
    for _ in range(_TURNS):
        misfits = turns.misfits(asked.benchmark, asked.predict())
        expect.true(not misfits, "actions that fit the benchmark", misfits[:3])


@requirement("POL-006")
def test_pol_006_repeated_turn_has_the_same_answer(story: Story) -> None:
    """Each of a few turns is sent twice. Expect the same answer twice."""
    asked = _ready(story)
    for _ in range(_TURNS):
        first = expect.ok(asked.try_predict())
        expect.equal(expect.ok(asked.try_predict()), first, "the answer")
        asked.seq += 1
        asked.view = asked.view | {"step": min(asked.seq, asked.view["max_steps"] - 1)}


@requirement("POL-007")
def test_pol_007_session_begins_with_a_reset(story: Story) -> None:
    """A session that nobody reset is asked. Expect `session_ended`."""
    _ready(story).predict()
    expect.refused(Asked(story).try_predict(), "session_ended")


@requirement("POL-008")
def test_pol_008_session_is_reset_at_any_time(story: Story) -> None:
    """A session is reset after its reset, in the middle, and for another episode.

    Expect every reset and the turn after it accepted.
    """
    asked = _ready(story)
    for index, attempt in ((0, 1), (0, 2), (1, 1)):
        expect.ok(asked.try_reset(index, attempt))
        expect.ok(asked.try_predict())
        asked.seq += 1


@requirement("POL-009")
def test_pol_009_sessions_are_played_side_by_side(story: Story) -> None:
    """As many sessions as it has room for (at most four) begin, then play in turn.

    Expect all of them answered, each for itself.
    """
    room = expect.ok(story.call("describe_policy"))["max_sessions"]
    sessions = [Asked(story) for _ in range(min(room, _SESSIONS))]
    for index, asked in enumerate(sessions):
        expect.ok(asked.try_reset(index))
    for _ in range(2):
        answers = story.together(*(asked.try_predict for asked in sessions))
        for asked, answer in zip(sessions, answers, strict=True):
            told = expect.ok(answer)["session_id"]
            expect.equal(told, asked.session_id, "session_id")
            asked.seq += 1


@requirement("POL-010")
def test_pol_010_broken_json_is_refused(story: Story) -> None:
    """Bodies break off. Expect `malformed_body`."""
    _ready(story)
    for operation in ("reset", "predict"):
        for body in (b'{"session_id": ', b""):
            headers = {"Content-Type": JSON}
            answer = story.call(operation, content=body, headers=headers)
            expect.refused(answer, "malformed_body")


@requirement("POL-011")
def test_pol_011_missing_member_is_refused(story: Story) -> None:
    """Bodies lack a member. Expect `invalid_request`, and with it an answer."""
    asked, other = Asked(story), Asked(story)
    expect.ok(asked.try_reset())
    expect.ok(asked.try_predict())
    lacking = [
        ("reset", other.reset_body(), "session_id"),
        ("reset", other.reset_body(), "episode"),
        ("predict", asked.turn(), "session_id"),
        ("predict", asked.turn(), "seq"),
    ]
    for operation, body, name in lacking:
        del body[name]
        expect.refused(story.call(operation, json=body), "invalid_request")


@requirement("POL-012")
def test_pol_012_key_is_asked_for(story: Story) -> None:
    """Calls carry no key, or a wrong one. Expect `unauthenticated`."""
    if story.wire.token is None:
        raise NotApplicable("no key was given, so that it may have none")
    asked = _ready(story)
    for wrong in (None, "not-the-key"):
        wire = story.wire_of(wrong)
        expect.refused(story.call("describe_policy", wire=wire), "unauthenticated")
        expect.refused(asked.try_predict(wire=wire), "unauthenticated")
    expect.ok(asked.try_predict())


@requirement("POL-013")
def test_pol_013_unknown_members_are_passed_over(story: Story) -> None:
    """A later version has more to say. Expect it passed over."""
    asked = Asked(story)
    expect.ok(asked.try_reset(of_a_later_version={"deep": [1]}))
    expect.ok(asked.try_predict(asked.turn(of_a_later_version=None)))
