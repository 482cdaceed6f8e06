"""Answers that broke off, or that a gateway gave: faults of the way or the server.

A way loses any answer, now and then. A server that loses one by itself loses that of
the same request again, each time that its check is judged again. Between the kit and a
server that it has started itself there is no way that loses anything.
"""

import threading
from collections import Counter
from dataclasses import dataclass

from conformance.client.connections.kept_connection import EndlessAnswer, can_be_stale
from conformance.client.connections.transport.fault_texts import (
    WITHOUT_SERVER,
    is_of_proctor,
)
from conformance.exchanges.answer import ParsedAnswer
from conformance.exchanges.exchange import Exchange
from conformance.specification.document import Operation
from conformance.verdicts.expect import Violation


@dataclass(frozen=True)
class WayFault:
    """A request without an answer of the server; page: what a gateway answered."""

    place: tuple[str, int]  # the operation, and how many requests of it were before
    text: str
    operation: Operation | None
    exchange: Exchange
    page: ParsedAnswer | None
    is_of_stream: bool  # it ended an answer that has no end by itself


def is_broken_answer(error: BaseException) -> bool:
    """Say whether an error of a connection is one that any network may cause."""
    return can_be_stale(error) and not isinstance(error, EndlessAnswer)


def is_gateway_page(answer: ParsedAnswer) -> bool:
    """Say whether an answer may be of a gateway that got none from the server."""
    is_problem = isinstance(answer.value, dict) and "code" in answer.value
    is_of_server = is_problem or is_of_proctor(answer.headers)
    return answer.status in WITHOUT_SERVER and not is_of_server


class WayFaults:
    """Those of one check, which is judged several times; safe for several threads."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self.has_way = True  # whether a network may be between kit and server
        self.is_restarting = False  # whether the kit kills the server just now
        self.begin()

    def begin(self) -> None:
        """Forget everything: the check begins."""
        self._recurring: set[tuple[str, int]] | None = None
        self._of_last_try: set[tuple[str, int]] = set()
        self._lost = Counter[str]()
        self.latest: list[WayFault] = []
        self.begin_try()

    def begin_try(self) -> None:
        """Begin to judge the check, or begin again."""
        with self._lock:
            self._requests = Counter[str]()
            self._places: dict[int, tuple[str, int]] = {}
            self.latest = []

    def end_try(self) -> None:
        """Keep the places at which every try so far had a fault."""
        self._of_last_try = places = {fault.place for fault in self.latest}
        seen = self._recurring
        self._recurring = places if seen is None else seen & places
        self._lost.update(name for name, _ in places)

    def may_cause(self, error: Exception) -> bool:
        """Whether a fault of this try may be the reason of its error.

        A lost answer raises by itself; a stream that breaks off only ends. A violation
        by an answer that came is none of a lost one.
        """
        if not isinstance(error, Violation):
            return bool(self.latest)
        return any(
            fault.is_of_stream or fault.exchange.number == error.exchange
            for fault in self.latest
        )

    def recur_in_spite(self) -> bool:
        """Whether a try passed with all faults of the one before, which failed.

        They are the server's own, and were not the reason.
        """
        places = {fault.place for fault in self.latest}
        return bool(self._of_last_try) and self._of_last_try <= places

    def of_server(self) -> list[WayFault]:
        """Give the faults of the last try that all had: they are the server's own."""
        recurring = self._recurring or set()
        return [fault for fault in self.latest if fault.place in recurring]

    def lost_on_the_way(self) -> Counter[str]:
        """Count the lost answers of all tries that ended, by operation."""
        return self._lost

    def count(self, operation: Operation | None, exchange: Exchange) -> None:
        """Count a request that is sent."""
        name = operation.operation_id if operation is not None else exchange.method
        with self._lock:
            self._places[exchange.number] = name, self._requests[name]
            self._requests[name] += 1

    def note(
        self,
        operation: Operation | None,
        exchange: Exchange,
        text: str,
        page: ParsedAnswer | None = None,
        *,
        is_of_stream: bool = False,
    ) -> None:
        """Note a fault, unless the kit itself is restarting the server."""
        with self._lock:
            place = self._places.get(exchange.number)
            if self.has_way and place is not None and not self.is_restarting:
                fault = WayFault(
                    *(place, text, operation, exchange, page), is_of_stream
                )
                self.latest.append(fault)
