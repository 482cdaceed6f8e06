"""Schema Turn as plain data, blobs as bytes.

Plain data and not models on purpose: a turn may carry megabytes of pixels, which pass
from the simulator to the socket unread.
"""

from __future__ import annotations

import time
from typing import Final, cast

from reference_record.generated import answers
from reference_record.texts.timestamps import timestamp
from reference_server.rules.runs.run import Episode, Session
from reference_server.views.run_views import result_view
from reference_sim.process.observation_encoding import EncodedObservation
from reference_sim.process.pool import ChunkReply, Timing

_NO_LEASE: Final[answers.Lease] = {"expires_at": "", "idle_timeout_s": 0.0}


def turn_view(
    session: Session,
    *,
    observation: EncodedObservation | None,
    observations: list[EncodedObservation] | None = None,
    played: ChunkReply | None = None,
    left: int = 0,
    ended: Episode | None = None,
    fault: answers.Fault | None = None,
    spent: answers.Timing | None = None,
) -> answers.Turn:
    """The turn of a session now; `add_lease_and_total` adds lease and total time.

    left: actions of the chunk that were not executed. ended: the episode that this
    turn ended; the session has the next one already. EPI-007: a seed is shown only in
    the result of an ended episode.
    """
    body: answers.Turn = {
        "session_id": session.session_id,
        "seq": session.seq,
        # PRED-001, ATT-001, ATT-022
        "executed_steps": played.executed if played else 0,
        "stopped_early": left > 0 and played is not None,  # PRED-028
        "rewards": list(played.rewards) if played else [],  # PRED-021
        "terminated": played.terminated if played else False,
        "truncated": played.truncated if played else False,
        "done": session.done,
        "lease": _NO_LEASE,
        "timing": timing(0.0) if spent is None else spent,
    }
    if session.episode is not None:
        body["episode"] = _episode_view(session, session.episode)
    if observation is not None:
        body["observation"] = cast("answers.Observation", observation)
    if observations is not None:
        # PRED-012
        body["observations"] = cast("list[answers.Observation]", observations)
    if ended is not None:
        body["episode_result"] = result_view(ended)
    if fault is not None:
        body["fault"] = fault
    return body


def add_lease_and_total(body: answers.Turn, session: Session, total_s: float) -> None:
    """Add what is only known when the turn leaves."""
    body["lease"] = lease_view(session)
    body["timing"]["total_s"] = total_s


def lease_view(session: Session) -> answers.Lease:
    """The lease (LEASE-009); it runs on the monotonic clock and shows wall time."""
    left_s = session.expires_at - time.monotonic()
    return {
        "expires_at": timestamp(time.time() + left_s),
        "idle_timeout_s": session.idle_timeout_s,
    }


def timing(queue_s: float, *spent: Timing) -> answers.Timing:
    """Schema Timing, its total still 0: the simulator's seconds, summed over calls.

    PRED-023: each part lies within the total, which is measured around all of them.
    """
    simulate_s = render_s = encode_s = 0.0
    for call in spent:
        simulate_s += call.simulate_s
        render_s += call.render_s
        encode_s += call.encode_s
    return {
        "total_s": 0.0,
        "queue_s": queue_s,
        "simulate_s": simulate_s,
        "render_s": render_s,
        "encode_s": encode_s,
    }


def _episode_view(session: Session, episode: Episode) -> answers.EpisodeView:
    return {
        "episode_id": episode.episode_id,
        "index": episode.index,
        "task": episode.task,
        "instruction": session.instruction,
        "attempt": episode.attempt,
        "step": session.steps,
        "max_steps": session.max_steps,  # EPI-013
    }
