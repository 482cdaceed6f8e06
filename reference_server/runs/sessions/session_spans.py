"""The spans of the work of a session: whose it is, and its times."""

from __future__ import annotations

from reference_server.runs.sessions.session_resources import SessionResources
from reference_server.telemetry.spans import Span, session_name
from reference_sim.process.pool import Timing


def name_session(spent: Span, resources: SessionResources) -> None:
    """Add whose time it is: a request shows its run alone, and a push run has none."""
    if spent.is_recorded:
        session = resources.session
        spent.set("proctor.run_id", resources.run_id)
        spent.set("proctor.worker_id", session.worker_id)
        spent.set("proctor.session", session_name(session.session_id))
        spent.set("proctor.seq", session.seq)
        if session.episode is not None:
            spent.set("proctor.episode_id", session.episode.episode_id)


def add_times(spent: Span, timing: Timing, steps: int = 0) -> None:
    """Add the times of the simulator's process; the rest of the span is transport."""
    if spent.is_recorded:
        spent.set("proctor.steps", steps)
        spent.set("proctor.simulate_s", timing.simulate_s)
        spent.set("proctor.render_s", timing.render_s)
        spent.set("proctor.encode_s", timing.encode_s)
