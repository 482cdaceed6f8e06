"""Messages of recordings, for tests."""

from __future__ import annotations

from reference_record.recording import Turn


def make_turn(seq: int) -> Turn:
    return Turn(
        attempt=1,
        seq=seq,
        actions=[{"arm": [0.1 * seq, -1.0]}],
        rewards=[0.5],
        steps=1,
        score=0.25,
        success=False,
        ended=False,
        state_digest=f"{seq:02x}",
        simulate_ms=float(seq),
        think_ms=2.0 * seq,
        at="t",
    )
