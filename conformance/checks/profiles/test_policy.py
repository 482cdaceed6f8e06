"""Policy servers, as servers in push mode call them (POL)."""

from conformance.client.check_context import CheckContext
from conformance.policy import turn_builder
from conformance.policy.policy_client import PolicySession
from conformance.runner.requirement import requirement
from conformance.specification.document import JSON
from conformance.verdicts import expect
from conformance.verdicts.expect import NotApplicable, Violation

_TURNS = 5
_SESSIONS = 4
# Rules for all answers of a service. A policy server has POL-002 in their place.
_FOR_ALL = ("SVC-003", "ERR-001", "ERR-011")


def _start_attempt(context: CheckContext) -> PolicySession:
    session = PolicySession(context)
    session.reset()
    return session


@requirement("POL-001")
def test_pol_001_protocol_range_holds_this_version(context: CheckContext) -> None:
    """Expect a range that contains the version of policy.yaml."""
    body = expect.ok(context.call("describe_policy"))["protocol"]

    def number(version: str) -> list[int]:
        return [int(part) for part in version.split(".")]

    here = context.spec.version.rpartition(".")[0]
    holds = number(body["min"]) <= number(here) <= number(body["max"])
    expect.true(holds, f"a range that contains {here}", dict(body))


@requirement("POL-002")
def test_pol_002_answers_are_as_described(context: CheckContext) -> None:
    """Every operation is called with valid and invalid bodies. Expect statuses, bodies
    and problems that match policy.yaml."""
    session = _start_attempt(context)
    context.call("describe_policy")
    session.try_predict()
    session.try_reset(benchmark=7)
    context.call("predict", json={})
    context.call("predict", content=b"{", headers={"Content-Type": JSON})
    context.http_client.request("GET", "/v1/policy/nowhere")
    for breach in context.tally.breaches:
        if breach.requirement_id in _FOR_ALL:
            raise Violation(breach.expected, breach.observed, breach.exchange.number)


@requirement("POL-003")
def test_pol_003_reset_is_acknowledged_as_sent(context: CheckContext) -> None:
    """Two attempts of different episodes begin. Expect the ids of each echoed."""
    for index, attempt in ((0, 1), (3, 2)):
        session = PolicySession(context)
        body = expect.ok(session.try_reset(index, attempt))
        expect.equal(body["session_id"], session.session_id, "session_id")
        expect.equal(body["episode_id"], session.view["episode_id"], "episode_id")
        expect.equal(body["attempt"], attempt, "attempt")


@requirement("POL-004")
def test_pol_004_answer_is_for_its_turn(context: CheckContext) -> None:
    """A few turns are played. Expect the session of each, and its seq plus one."""
    session = _start_attempt(context)
    for _ in range(_TURNS):
        body = expect.ok(session.try_predict())
        expect.members(body, {"session_id": session.session_id, "seq": session.seq + 1})
        session.seq += 1


@requirement("POL-005")
def test_pol_005_actions_fit_the_benchmark(context: CheckContext) -> None:
    """A few turns are played. Expect actions inside the spaces of the benchmark."""
    session = _start_attempt(context)
    for _ in range(_TURNS):
        action_faults = turn_builder.action_faults(
            session.benchmark, session.beginning.task, session.predict()
        )
        expect.true(not action_faults, "fitting actions", action_faults[:3])


@requirement("POL-006")
def test_pol_006_repeated_turn_has_the_same_answer(context: CheckContext) -> None:
    """Each of a few turns is sent twice. Expect the same answer twice."""
    session = _start_attempt(context)
    for _ in range(_TURNS):
        first = expect.ok(session.try_predict())
        expect.equal(expect.ok(session.try_predict()), first, "the answer")
        session.seq += 1
        session.view = session.view | {
            "step": min(session.seq, session.view["max_steps"] - 1)
        }


@requirement("POL-007")
def test_pol_007_session_begins_with_a_reset(context: CheckContext) -> None:
    """A turn is sent without a reset. Expect `session_ended`."""
    _start_attempt(context).predict()
    expect.refused(PolicySession(context).try_predict(), "session_ended")


@requirement("POL-008")
def test_pol_008_session_is_reset_at_any_time(context: CheckContext) -> None:
    """A session is reset after a reset, during an episode, and for another episode.
    Expect every reset and the turn after it accepted."""
    session = _start_attempt(context)
    for index, attempt in ((0, 1), (0, 2), (1, 1)):
        expect.ok(session.try_reset(index, attempt))
        expect.ok(session.try_predict())
        session.seq += 1


@requirement("POL-009")
def test_pol_009_sessions_are_concurrent(context: CheckContext) -> None:
    """`max_sessions` sessions (at most four) begin, then play in turn. Expect a
    response for each session with its own ids."""
    max_sessions = expect.ok(context.call("describe_policy"))["max_sessions"]
    sessions = [PolicySession(context) for _ in range(min(max_sessions, _SESSIONS))]
    for index, session in enumerate(sessions):
        expect.ok(session.try_reset(index))
    for _ in range(2):
        answers = context.call_concurrently(*(s.try_predict for s in sessions))
        for session, answer in zip(sessions, answers, strict=True):
            body = expect.ok(answer)["session_id"]
            expect.equal(body, session.session_id, "session_id")
            session.seq += 1


@requirement("POL-010")
def test_pol_010_broken_json_is_refused(context: CheckContext) -> None:
    """Bodies are cut off. Expect `malformed_body`."""
    _start_attempt(context)
    for operation in ("reset", "predict"):
        for body in (b'{"session_id": ', b""):
            headers = {"Content-Type": JSON}
            answer = context.call(operation, content=body, headers=headers)
            expect.refused(answer, "malformed_body")


@requirement("POL-011")
def test_pol_011_missing_member_is_refused(context: CheckContext) -> None:
    """Bodies lack a member. Expect `invalid_request`; complete bodies succeed."""
    session, second = PolicySession(context), PolicySession(context)
    expect.ok(session.try_reset())
    expect.ok(session.try_predict())
    lacking = [
        ("reset", second.reset_body(), "session_id"),
        ("reset", second.reset_body(), "episode"),
        ("predict", session.turn(), "session_id"),
        ("predict", session.turn(), "seq"),
    ]
    for operation, body, name in lacking:
        del body[name]
        expect.refused(context.call(operation, json=body), "invalid_request")


@requirement("POL-012")
def test_pol_012_key_is_required(context: CheckContext) -> None:
    """Calls carry no key, or a wrong one. Expect `unauthenticated`."""
    if context.http_client.token is None:
        raise NotApplicable(
            "no API key given (PROCTOR_POLICY_KEY); the policy server may have none"
        )
    session = _start_attempt(context)
    for wrong in (None, "not-the-key"):
        http_client = context.client_with_token(wrong)
        for answer in (
            context.call("describe_policy", http_client=http_client),
            context.call("reset", json=session.reset_body(), http_client=http_client),
            session.try_predict(http_client=http_client),
        ):
            expect.refused(answer, "unauthenticated")
    expect.ok(session.try_predict())


@requirement("POL-013")
def test_pol_013_unknown_members_are_ignored(context: CheckContext) -> None:
    """Requests with members of a later version. Expect them ignored."""
    session = PolicySession(context)
    expect.ok(session.try_reset(of_a_later_version={"deep": [1]}))
    expect.ok(session.try_predict(session.turn(of_a_later_version=None)))
