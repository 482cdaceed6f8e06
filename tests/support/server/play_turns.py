"""Steps that tests of effects repeat: open a session, play a turn."""

from dataclasses import dataclass
from typing import Any

from reference_server.rules.runs import effects
from reference_server.rules.runs import run as run_state
from reference_server.rules.runs.effects import ChunkOutcome
from reference_server.rules.runs.lifecycle import Attach, Predict
from reference_server.rules.runs.run import Run, Session
from reference_server.views.turn_view import turn_view
from tests.support.server.runs import ACTION, NOW

WALL = 5000.0


@dataclass(frozen=True)
class Played:
    executed: int
    rewards: tuple[float, ...]
    ended: bool
    terminated: bool
    truncated: bool
    success: bool
    score: float


def chunk_result(
    executed: int = 1, *, ended: bool = False, **changes: Any
) -> ChunkOutcome:
    facts = {"terminated": ended, "truncated": False, "success": False, "score": 0.5}
    rewards = (0.5,) * executed
    return Played(executed, rewards, ended, **facts | changes)


def start_session(run: Run, worker_id: str = "w") -> Session:
    session = effects.open_session(run, Attach(worker_id, "key"), "s", NOW)
    effects.store_answer(session, turn_view(session, observation=None), NOW)
    return session


def play_turn(
    run: Run, session: Session, outcome: ChunkOutcome
) -> run_state.Episode | None:
    command = Predict(session.worker_id, session.session_id, session.seq + 1, [ACTION])
    effects.begin_turn(session, command, NOW)
    ended = effects.end_turn(run, session, outcome, WALL)
    effects.store_answer(session, turn_view(session, observation=None), NOW)
    return ended
