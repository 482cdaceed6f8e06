"""Messages of recordings, for tests."""

import msgspec

from reference_record.recordings.recording import Turn
from reference_record.recordings.recording_parts import ExecutedTurn, TurnCommand


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


def make_executed(seq: int, state: bytes = b"s") -> ExecutedTurn[msgspec.Raw]:
    """Of a command of two actions, of which one was executed."""
    command = TurnCommand([{"arm": [1, 0.5]}, {"arm": [9.0, 9.0]}], seq, 1.23456)
    coded = msgspec.Raw(msgspec.msgpack.encode(command))
    return ExecutedTurn(1, [0.5], 0.25, False, True, state, None, 0.00123456, coded)
