"""Whether an order of concurrent requests explains their answers. Pure.

Searches an order in which the model gives the observed answers, and in which no request
precedes one that was answered before it was sent (Wing and Gong, with a memory of
failed branches).
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from conformance.oracle.allowed_answers import (
    Deviation,
    PossibleRuns,
    advance,
    allowed_answers,
    new_session,
    play_chunk,
)
from conformance.oracle.run_model import (
    AnswerSummary,
    Attach,
    Predict,
    Read,
    Request,
    Resume,
    Rules,
    SessionModel,
    Stop,
    closure,
)

# Codes of the answer to a turn that may have begun: a command ended its session.
_OF_A_BEGUN_TURN = (None, "session_ended", "session_superseded")


@dataclass(frozen=True, slots=True)
class TimedExchange:
    """A request with its answer, sent and answered at these times."""

    request: Request
    summary: AnswerSummary
    started_at: float
    ended_at: float


def split_command(request: Request, summary: AnswerSummary) -> Iterator[Request]:
    """Split a command that returns the run into the command and a read of the run."""
    yield request
    if isinstance(request, Stop | Resume) and summary.status == 200:
        yield Read()


def explain(
    rules: Rules, models: PossibleRuns, history: Sequence[TimedExchange]
) -> PossibleRuns:
    """Give the runs in which an order of the history may end; none if it has none."""
    pieces = [list(split_command(call.request, call.summary)) for call in history]
    without_explanation: set[tuple[tuple[int, ...], PossibleRuns]] = set()

    def search(placed: tuple[int, ...], now: PossibleRuns) -> PossibleRuns:
        left = [i for i, n in enumerate(placed) if n < len(pieces[i])]
        if not left:
            return frozenset(m for m in now if not _has_live_interrupted(m.sessions))
        if (placed, now) in without_explanation:
            return frozenset()
        first_end = min(history[i].ended_at for i in left)
        for i in left:
            if history[i].started_at > first_end:
                continue
            piece, summary = pieces[i][placed[i]], history[i].summary
            after = _advance_or_interrupt(rules, now, piece, summary)
            if not after and summary.code in ("seq_conflict", "seq_out_of_order"):
                begun = [history[j] for j in left if history[j] is not history[i]]
                after = _refused_during_turn(rules, now, history[i], begun)
            if not after:
                continue
            more = (*placed[:i], placed[i] + 1, *placed[i + 1 :])
            if explanation := search(more, after):
                return explanation
        without_explanation.add((placed, now))
        return frozenset()

    return search((0,) * len(history), models)


def _has_live_interrupted(sessions: Sequence[SessionModel]) -> bool:
    return any(
        session.is_interrupted and session.status == "live" for session in sessions
    )


def _refused_during_turn(
    rules: Rules,
    models: PossibleRuns,
    refused: TimedExchange,
    begun: Sequence[TimedExchange],
) -> PossibleRuns:
    """A turn takes its seq when it begins and has its effect when it ends: another
    seq or another body may be refused in between; the refusal changes nothing."""
    after = set()
    for model in models:
        for call in begun:
            turn, request = call.request, refused.request
            if not isinstance(turn, Predict) or not isinstance(request, Predict):
                continue
            if turn.session != request.session or call.started_at > refused.ended_at:
                continue
            session = model.session(turn.session)
            has_begun = call.summary.code in _OF_A_BEGUN_TURN
            if not has_begun or turn.seq != session.seq + 1:
                continue
            taken = replace(session, seq=turn.seq, request=turn.steps)
            in_play = frozenset({model.with_session(taken)})
            is_allowed = _is_old_seq_refused_by(turn, request, refused.summary)
            if is_allowed or _advance_or_interrupt(
                rules, in_play, request, refused.summary
            ):
                after.add(model)
    return frozenset(after)


def _is_old_seq_refused_by(
    turn: Predict, request: Predict, summary: AnswerSummary
) -> bool:
    """While a turn is executed, `expected_seq` may be its seq as well as the next."""
    return (
        summary.code == "seq_out_of_order"
        and request.seq < turn.seq
        and summary.body.get("expected_seq") == turn.seq
    )


def _advance_or_interrupt(
    rules: Rules, models: PossibleRuns, request: Request, summary: AnswerSummary
) -> PossibleRuns:
    try:
        after = advance(rules, models, request, summary)
    except Deviation:
        after = frozenset()
    if summary.code == "session_ended" and isinstance(request, Attach | Predict):
        after |= _interrupted_runs(rules, models, request)
    return after


def _interrupted_runs(
    rules: Rules, models: PossibleRuns, request: Attach | Predict
) -> PossibleRuns:
    """A session may end while its request is executed: the request is refused, but
    its effects so far remain, wholly or in part."""
    after = set()
    for model in (late for before in models for late in closure(rules, before)):
        for allowed in allowed_answers(rules, model, request):
            if allowed.code is not None or allowed.same_turn is not None:
                continue
            if isinstance(request, Attach):
                then = allowed.after(AnswerSummary(200, None, {}))
                name = new_session(
                    request, AnswerSummary(200, None, {}), len(model.sessions)
                ).id
                after.add(
                    then.with_session(replace(then.session(name), is_interrupted=True))
                )
                continue
            whole, _ = play_chunk(rules, model, request)
            before_it = model.session(request.session)
            begun = replace(before_it, seq=request.seq, steps=before_it.steps + 1)
            for then, session in (
                (whole, whole.session(request.session)),
                (model, begun),
            ):
                after.add(then.with_session(replace(session, is_interrupted=True)))
    return frozenset(after)
