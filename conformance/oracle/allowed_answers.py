"""The answers to a request that the rules allow, given a run of the model. Pure.

run_model.py defines runs, requests and allowed answers.
"""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from conformance.oracle.run_model import (
    ABSENT,
    AllowedAnswer,
    AnswerSummary,
    Attach,
    Detach,
    Heartbeat,
    Predict,
    Read,
    ReadEpisodes,
    Request,
    Resume,
    Rules,
    RunModel,
    SessionModel,
    Step,
    Stop,
    apply_automatic_events,
    close_session,
    closure,
    hand_out,
    turn_text,
)

PossibleRuns = frozenset[RunModel]


class Deviation(Exception):
    """An answer that the rules do not allow."""

    def __init__(self, expected: str) -> None:
        super().__init__(expected)
        self.expected = expected


def advance(
    rules: Rules, models: PossibleRuns, request: Request, summary: AnswerSummary
) -> PossibleRuns:
    """Give the runs that the server may be in after an answer, or raise Deviation."""
    after: set[RunModel] = set()
    mismatches: dict[str, None] = {}
    for before in models:
        for model in closure(rules, before):
            for allowed in allowed_answers(rules, model, request):
                text = allowed.mismatch(summary)
                if text is None:
                    after.add(allowed.after(summary))
                else:
                    mismatches[text] = None
    if not after:
        raise Deviation("; or ".join(mismatches))
    return frozenset(after)


def allowed_answers(
    rules: Rules, model: RunModel, request: Request
) -> Iterator[AllowedAnswer]:
    """Give every answer that is allowed."""
    match request:
        case Attach():
            yield from _attach(rules, model, request)
        case Predict():
            yield from _predict(rules, model, request)
        case Heartbeat() | Detach():
            yield from _heartbeat_or_detach(rules, model, request)
        case Stop(mode):
            yield from _command(rules, model, f"stop_{mode}")
        case Resume():
            yield from _command(rules, model, "resume_run")
        case Read():
            yield from _read(model)
        case ReadEpisodes():
            yield from _read_episodes(model)


def refusal(rule: str, model: RunModel, code: str, **members: Any) -> AllowedAnswer:
    """Allow a refusal, which changes nothing."""
    status = 429 if code == "worker_limit" else 409
    return AllowedAnswer(rule, status, lambda _: model, code, members)


# --- attach ---


def _attach(rules: Rules, model: RunModel, request: Attach) -> Iterator[AllowedAnswer]:
    rule, to = rules.table[model.state, "attach_worker"]
    current = model.live(request.worker)
    is_busy = current is not None and not current.is_done
    is_repeat = current is not None and current.key == request.key
    if to == "refused" and not (is_busy and is_repeat):
        yield refusal(rule, model, "illegal_transition", state=model.state)
    is_full = len(model.holders) >= rules.max_workers
    if is_full and (to == "refused" or is_busy) and not (is_repeat or request.takeover):
        # Where several refusals apply, any of them is in order.
        yield refusal("ATT-006", model, "worker_limit")
    if current is not None and is_repeat:
        yield AllowedAnswer("ATT-002", 200, lambda _: model, same_turn=current.turn)
    elif current is not None and not request.takeover:
        # A session that is done may count as live or not.
        yield refusal("ATT-003", model, "worker_busy")
    elif current is not None and is_busy:
        yield from _take_over(model, current, request)
    for old in model.sessions:
        # One that is done, and whose worker attached again, may count as live for its
        # key, too.
        is_left = old.status == "superseded" and old.is_done
        if is_left and (old.worker, old.key) == (request.worker, request.key):
            yield AllowedAnswer("ATT-002", 200, lambda _: model, same_turn=old.turn)
    if to != "refused" and not is_busy:
        yield from _enter(rules, model, request, to)


def _take_over(
    model: RunModel, old: SessionModel, request: Attach
) -> Iterator[AllowedAnswer]:
    assert old.episode is not None, "a session that holds a slot plays an episode"
    episode = _view(model, old)

    def after(summary: AnswerSummary) -> RunModel:
        new = replace(
            new_session(request, summary, len(model.sessions)),
            episode=old.episode,
            is_done=False,
            steps=old.steps,
            success=old.success,
        )
        superseded = replace(old, status="superseded", episode=None)
        return model.with_session(superseded).with_session(new)

    earlier_ids = [s.id for s in model.sessions]
    members = {"seq": 0, "done": False, **episode}
    yield AllowedAnswer("ATT-004", 200, after, members=members, new_among=earlier_ids)


def _enter(
    rules: Rules, model: RunModel, request: Attach, to: str
) -> Iterator[AllowedAnswer]:
    others = [s for s in model.holders if s.worker != request.worker]
    if len(others) >= rules.max_workers:  # ATT-014: who is done does not count
        yield refusal("ATT-006", model, "worker_limit")
        return
    sessions = tuple(
        replace(s, status="superseded")
        if s.status == "live" and s.worker == request.worker
        else s
        for s in model.sessions
    )
    before = replace(model, state=to, sessions=sessions)

    def after(summary: AnswerSummary) -> RunModel:
        new = new_session(request, summary, len(model.sessions))
        return apply_automatic_events(rules, hand_out(before, new))

    shown = after(AnswerSummary(200, None, {"session_id": "new"}))
    session = shown.session("new")
    members = {
        "seq": 0,
        "executed_steps": 0,
        "rewards": [],
        "done": session.is_done,
        "episode_result": ABSENT,
        **_view(shown, session),
    }
    rule = "ATT-012" if session.is_done else "ATT-001, EPI-001"
    earlier_ids = [s.id for s in model.sessions]
    yield AllowedAnswer(rule, 200, after, members=members, new_among=earlier_ids)


def new_session(request: Attach, summary: AnswerSummary, number: int) -> SessionModel:
    """Make the session that an attach opened."""
    body = summary.body if isinstance(summary.body, dict) else {}
    return SessionModel(
        id=str(body.get("session_id", f"unnamed {number}")),
        worker=request.worker,
        key=request.key,
        episode=None,
        is_done=True,
        turn=turn_text(body),
    )


def _view(model: RunModel, session: SessionModel) -> dict[str, Any]:
    if session.episode is None:
        return {"episode": ABSENT, "observation": ABSENT}
    return {
        "episode.index": session.episode,
        "episode.attempt": model.episodes[session.episode].attempt,
        "episode.step": session.steps,
        "observation.state.count": [session.steps],
    }


# --- requests of a session ---


def _ended_session_refusals(
    model: RunModel, session: SessionModel
) -> Iterator[AllowedAnswer]:
    """Give the refusals of a request whose session is not the live one any more."""
    successor = model.live(session.worker)
    if session.status == "live":
        return
    if successor is not None or session.status == "superseded":
        yield refusal("ATT-005", model, "session_superseded")
    is_held = successor is not None and not (successor.is_done or session.is_done)
    if not (session.status == "superseded" and is_held):
        yield refusal("STOP-002, DET-001", model, "session_ended")


def _predict(
    rules: Rules, model: RunModel, request: Predict
) -> Iterator[AllowedAnswer]:
    session = model.session(request.session)
    yield from _ended_session_refusals(model, session)
    if session.status != "live" and not session.is_done:
        return
    if request.seq == session.seq:
        if request.steps != session.request:
            yield refusal("PRED-003", model, "seq_conflict")
            return
        rule = "PRED-010" if session.is_done else "PRED-002"
        yield AllowedAnswer(rule, 200, lambda _: model, same_turn=session.turn)
    elif request.seq != session.seq + 1:
        due = session.seq + 1
        yield refusal("PRED-004", model, "seq_out_of_order", expected_seq=due)
    elif session.is_done:
        yield refusal("PRED-011", model, "no_episode")
    else:
        yield _execute(rules, model, session, request)


def play_chunk(
    rules: Rules, model: RunModel, request: Predict
) -> tuple[RunModel, list[Step]]:
    """Execute a chunk; give the run afterwards and the executed actions."""
    session = model.session(request.session)
    index = session.episode
    assert index is not None, "a session that is not done plays an episode"
    done: list[Step] = []
    for step in request.steps:
        done.append(step)
        if step.end or session.steps + len(done) == rules.max_steps:
            break
    session = replace(
        session,
        seq=request.seq,
        request=request.steps,
        steps=session.steps + len(done),
        success=max(session.success, *(step.success for step in done)),
    )
    if not done[-1].end and session.steps < rules.max_steps:
        return model.with_session(session), done
    outcome = "success" if session.success else "failure"
    score = float(session.success) if rules.scores_success else done[-1].score
    model = model.with_episode(index, is_held=False, outcome=outcome, score=score)
    return apply_automatic_events(rules, hand_out(model, session)), done


def _execute(
    rules: Rules, model: RunModel, session: SessionModel, request: Predict
) -> AllowedAnswer:
    after, done = play_chunk(rules, model, request)
    index = session.episode
    assert index is not None, "a session that is not done plays an episode"
    now = after.session(session.id)
    ended = after.episodes[index].outcome is not None
    steps = session.steps + len(done)
    members: dict[str, Any] = {
        "session_id": session.id,
        "seq": request.seq,
        "executed_steps": len(done),
        "stopped_early": len(done) < len(request.steps),
        "rewards": [step.score for step in done],
        "terminated": bool(done[-1].end),
        "truncated": steps == rules.max_steps and not done[-1].end,
        "done": now.is_done,
        **_view(after, now),
    }
    if not ended:
        members["episode_result"] = ABSENT
    else:
        result = after.episodes[index]
        expected = {
            "index": index,
            "outcome": result.outcome,
            "score": result.score,
            "steps": steps,
            "attempt": result.attempt,
        }
        members |= {f"episode_result.{k}": v for k, v in expected.items()}

    def then(summary: AnswerSummary) -> RunModel:
        return after.with_session(replace(now, turn=turn_text(summary.body)))

    rule = "PRED-007, PRED-008, PRED-009, STOP-004" if ended else "PRED-001, CAL-003"
    return AllowedAnswer(rule, 200, then, members=members)


def _heartbeat_or_detach(
    rules: Rules, model: RunModel, request: Heartbeat | Detach
) -> Iterator[AllowedAnswer]:
    session = model.session(request.session)
    refusals = list(_ended_session_refusals(model, session))
    if isinstance(request, Heartbeat):
        yield from refusals
        if session.status == "live" or session.is_done:
            yield AllowedAnswer("LEASE-003", 200, lambda _: model)
    elif session.status == "live":
        after = apply_automatic_events(rules, close_session(rules, model, session))
        yield AllowedAnswer("DET-001", 204, lambda _: after)
    else:
        if session.status == "superseded":
            yield from (r for r in refusals if r.code == "session_superseded")
        if session.status == "ended" or len(refusals) > 1:
            yield AllowedAnswer("DET-002", 204, lambda _: model)


# --- commands on the run, and reads ---


def _command(rules: Rules, model: RunModel, command: str) -> Iterator[AllowedAnswer]:
    rule, to = rules.table[model.state, command]
    if to == "refused":
        yield refusal(rule, model, "illegal_transition", state=model.state)
        return
    after = model
    if command == "stop_abort":
        for session in model.sessions:
            if session.status == "live":
                after = close_session(rules, after, session)
        if after.all_scored and not model.all_scored:
            complete = apply_automatic_events(rules, after)
            yield AllowedAnswer("EPI-009", 200, lambda _: complete)
            return
    moved = apply_automatic_events(rules, replace(after, state=to))
    yield AllowedAnswer(rule, 200, lambda _: moved)


def _read(model: RunModel) -> Iterator[AllowedAnswer]:
    holders = len(model.holders)
    live = sum(s.status == "live" for s in model.sessions)
    members = {
        "state": model.state,
        "live_workers": range(holders, live + 1),
        "progress.episodes_scored": sum(e.outcome is not None for e in model.episodes),
        "progress.episodes_in_progress": sum(e.is_held for e in model.episodes),
        "progress.episodes_pending": sum(e.is_pending for e in model.episodes),
    }
    yield AllowedAnswer("LIFE, RUN-014", 200, lambda _: model, members=members)


def _read_episodes(model: RunModel) -> Iterator[AllowedAnswer]:
    members: dict[str, Any] = {}
    for index, episode in enumerate(model.episodes):
        status = "in_progress" if episode.is_held else "scored"
        expected: dict[str, Any] = {
            "index": index,
            "status": "pending" if episode.is_pending else status,
            "attempt": episode.attempt,
        }
        if episode.outcome is None:
            expected["result"] = ABSENT
        else:
            expected["result.outcome"] = episode.outcome
            expected["result.score"] = episode.score
        members |= {f"{index}.{name}": value for name, value in expected.items()}
    members[str(len(model.episodes))] = ABSENT
    yield AllowedAnswer(
        "EPI-003, EPI-005, EPI-006", 200, lambda _: model, members=members
    )
