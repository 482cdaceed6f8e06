"""Whether answers to requests sent at the same time can be explained. Pure.

A search for an order of the requests in which the model gives their answers, and in
which none stands before one that was answered before it was sent (Wing and Gong, with
a memory of what led nowhere).
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from conformance.oracle.allowed_answers import (
    Deviation,
    Models,
    advance,
    demands,
    opened,
    played,
)
from conformance.oracle.run_model import (
    Attach,
    Predict,
    Read,
    Request,
    Resume,
    Rules,
    Seen,
    Session,
    Stop,
    closure,
)


@dataclass(frozen=True, slots=True)
class Exchanged:
    """A request with its answer, sent and answered at these times."""

    request: Request
    seen: Seen
    started_at: float
    ended_at: float


def parts(request: Request, seen: Seen) -> Iterator[Request]:
    """Split a command that answers with the run "as it is now" from that look at it."""
    yield request
    if isinstance(request, Stop | Resume) and seen.status == 200:
        yield Read()


def explained(rules: Rules, models: Models, history: Sequence[Exchanged]) -> Models:
    """Give the runs in which an order of the history may end; none if it has none."""
    pieces = [list(parts(one.request, one.seen)) for one in history]
    dead: set[tuple[tuple[int, ...], Models]] = set()

    def search(placed: tuple[int, ...], now: Models) -> Models:
        left = [i for i, n in enumerate(placed) if n < len(pieces[i])]
        if not left:
            return frozenset(m for m in now if not _cut_and_live(m.sessions))
        if (placed, now) in dead:
            return frozenset()
        first_end = min(history[i].ended_at for i in left)
        for i in left:
            if history[i].started_at > first_end:
                continue
            piece, seen = pieces[i][placed[i]], history[i].seen
            after = _after(rules, now, piece, seen)
            if not after and seen.code in ("seq_conflict", "seq_out_of_order"):
                begun = [history[j] for j in left if history[j] is not history[i]]
                after = _beside(rules, now, history[i], begun)
            if not after:
                continue
            more = (*placed[:i], placed[i] + 1, *placed[i + 1 :])
            if found := search(more, after):
                return found
        dead.add((placed, now))
        return frozenset()

    return search((0,) * len(history), models)


def _cut_and_live(sessions: Sequence[Session]) -> bool:
    return any(session.is_cut and session.status == "live" for session in sessions)


def _beside(
    rules: Rules, models: Models, refused: Exchanged, begun: Sequence[Exchanged]
) -> Models:
    """A turn takes its seq when it begins and has its effect when it ends: another
    seq, or another body, may be refused in between, and the refusal changes nothing."""
    after = set()
    for model in models:
        for one in begun:
            turn, request = one.request, refused.request
            if not isinstance(turn, Predict) or not isinstance(request, Predict):
                continue
            if turn.session != request.session or one.started_at > refused.ended_at:
                continue
            session = model.session(turn.session)
            has_begun = one.seen.code in (None, "session_ended")
            if not has_begun or turn.seq != session.seq + 1:
                continue
            taken = replace(session, seq=turn.seq, request=turn.steps)
            in_play = frozenset({model.with_session(taken)})
            if _after(rules, in_play, request, refused.seen):
                after.add(model)
    return frozenset(after)


def _after(rules: Rules, models: Models, request: Request, seen: Seen) -> Models:
    try:
        after = advance(rules, models, request, seen)
    except Deviation:
        after = frozenset()
    if seen.code == "session_ended" and isinstance(request, Attach | Predict):
        after |= _cut(rules, models, request)
    return after


def _cut(rules: Rules, models: Models, request: Attach | Predict) -> Models:
    """A session may end while its request is carried out: the request is refused, but
    what it had done by then stays done, wholly or in part."""
    after = set()
    for model in (late for before in models for late in closure(rules, before)):
        for demand in demands(rules, model, request):
            if demand.code is not None or demand.same_turn is not None:
                continue
            if isinstance(request, Attach):
                then = demand.after(Seen(200, None, {}))
                name = opened(request, Seen(200, None, {}), len(model.sessions)).id
                after.add(then.with_session(replace(then.session(name), is_cut=True)))
                continue
            whole, _ = played(rules, model, request)
            before_it = model.session(request.session)
            begun = replace(before_it, seq=request.seq, steps=before_it.steps + 1)
            for then, session in (
                (whole, whole.session(request.session)),
                (model, begun),
            ):
                after.add(then.with_session(replace(session, is_cut=True)))
    return frozenset(after)
