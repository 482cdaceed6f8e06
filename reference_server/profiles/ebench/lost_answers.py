"""Recognises a step that EBench's client sends again because its answer was lost.

Proctor's own requests count turns (`seq`), so that a repeat is known by its number.
EBench's do not: a step with an equal body is either the last one, whose answer did not
arrive, or a new one that happens to be equal. The delivery distinguishes them:
while the answer of a step is not known to have been sent to a connected client, an
equal step repeats it (EBE-013); afterwards it is a step of its own (EBE-014).

Keeps, for each session, the last step that was not confirmed. That is in memory only,
like the sessions themselves, and is dropped with them. Must not know requests, images
or encodings, and changes nothing of a run: whether the repeated turn may be answered is
decided by the rules, from the `seq` that is found here.
"""

from __future__ import annotations

from weakref import WeakKeyDictionary

from reference_server.rules.runs.lifecycle import Predict
from reference_server.rules.runs.run import Session


class LostAnswers:
    """The unconfirmed step of each session: its seq, and a digest of its actions."""

    def __init__(self) -> None:
        self._unconfirmed: WeakKeyDictionary[Session, tuple[int, str]] = (
            WeakKeyDictionary()
        )

    def __len__(self) -> int:
        """How many sessions have an unconfirmed step."""
        return len(self._unconfirmed)

    def find_repeated_turn(
        self, session: Session, request_digest: str
    ) -> Predict | None:
        """EBE-013: the last turn, if this request repeats it; else None.

        It does when it has the digest of that turn's request and the answer was not
        confirmed. Any other request is a turn of its own (EBE-014).
        """
        if session.request is None:
            return None
        if self._unconfirmed.get(session) != (session.seq, request_digest):
            return None
        return Predict(
            session.worker_id, session.session_id, session.seq, *session.request
        )

    def await_confirmation(
        self, session: Session, command: Predict, request_digest: str
    ) -> None:
        """Call before the turn is executed: its answer is not confirmed from here on.

        While another turn of the session is executed, that one stays the unconfirmed.
        """
        if not session.busy or command.seq == session.seq:
            self._unconfirmed[session] = (command.seq, request_digest)

    def confirm_delivery(self, session: Session, seq: int) -> None:
        """EBE-014: the answer to turn `seq` was sent while its client was connected."""
        if self._unconfirmed.get(session, (None, ""))[0] == seq:
            del self._unconfirmed[session]
