"""Hands every exchange of a check to the judges: the universal rules, and the oracle.

Translates between the HTTP client, which knows bytes, and the oracle, which knows
requests and answers. Nothing is sent here.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from typing import Any

from conformance.client.exchange_log import ExchangeLog
from conformance.exchanges.answer import ParsedAnswer
from conformance.exchanges.exchange import Exchange
from conformance.oracle.history.facts.seen_exchange import (
    LOST,
    Difference,
    SeenExchange,
    read_body,
    read_path,
    read_query,
)
from conformance.oracle.history.service_history import ServiceHistory
from conformance.run_settings import Settings
from conformance.specification.document import JSON, Operation, Spec
from conformance.verdicts.expect import ANY_SEQUENCE
from conformance.verdicts.universal_rules import Tally


def new_history(spec: Spec, settings: Settings) -> ServiceHistory:
    """Begin the history of a service."""
    transitions: dict[tuple[str, str], tuple[str, ...]] = {}
    rules: dict[tuple[str, str], str] = {}
    for row in spec.lifecycle["transitions"]:
        place = row["from"], row["event"]
        rules[place] = row["id"]
        if row["to"] != "refused":
            transitions[place] = (*transitions.get(place, ()), row["to"])
    limits = settings.service.get("limits", {})
    has_sessions = settings.is_offered("sessions")
    return ServiceHistory(transitions, rules, limits, has_sessions)


def judged_rules(settings: Settings) -> frozenset[str]:
    """Name the rules that may be violated in a run of the kit."""
    return frozenset(
        row.id
        for row in settings.selected_rules
        if row.is_observable and settings.is_offered(row.profile)
    )


class ExchangeJudge:
    """The judges of the exchanges of one check; safe for several threads.

    rules: those that may be violated. A difference that none of them explains is one of
    all rules together.
    """

    def __init__(
        self,
        tally: Tally,
        history: ServiceHistory,
        rules: Collection[str],
        log: ExchangeLog,
    ) -> None:
        self.history = history
        self._tally = tally
        self._rules = rules
        self._log, self._check = log, log.name

    def begin(self, operation: Operation | None, exchange: Exchange) -> None:
        """Note that a request is sent."""
        if operation is not None:
            sent = self._sent(operation, exchange)
            self.history.begin(id(exchange), sent)

    def lose(self, operation: Operation | None, exchange: Exchange) -> None:
        """Note that a request has got no answer: it may have its effect any time."""
        if operation is not None:
            if exchange.leave_after_s is None:
                self._tally.served.lose(operation, exchange)
            self._end(self._sent(operation, exchange), exchange)

    def observe(
        self, operation: Operation | None, answer: ParsedAnswer, exchange: Exchange
    ) -> None:
        """Judge an exchange that has ended."""
        is_valid = self._tally.observe(operation, answer, exchange)
        if operation is None:
            if (
                exchange.method not in ("GET", "HEAD", "OPTIONS")
                and answer.status < 300
            ):
                self.history.note_unread(self._check)
            return
        sent = self.history.sent(id(exchange)) or self._sent(operation, exchange)
        if not is_valid or exchange.method in ("HEAD", "OPTIONS"):
            self._end(sent, exchange)
            return
        seen = replace(
            sent,
            ended_at=exchange.started_at + exchange.elapsed_s,
            status=answer.status,
            value=answer.value,
            answer_headers=answer.headers,
            media_type=answer.media_type,
        )
        self._end(seen, exchange)

    def observe_event(self, exchange: Exchange, run_id: str, body: Any) -> None:
        """Judge the body of an event; `exchange` shows it."""
        seen = SeenExchange(
            "stream_events",
            exchange.started_at,
            exchange.started_at + exchange.elapsed_s,
            200,
            body,
            {"run_id": run_id},
            check=self._check,
            evidence=exchange,
        )
        self._record(self.history.judge_event(seen))

    def _sent(self, operation: Operation, exchange: Exchange) -> SeenExchange:
        headers = {k.lower(): v for k, v in exchange.request_headers.items()}
        content = None if exchange.request_size is None else exchange.request_body
        media_type = headers.get("content-type", JSON).partition(";")[0].strip().lower()
        return SeenExchange(
            operation.operation_id,
            exchange.started_at,
            LOST,
            None,
            None,
            read_path(operation.path, exchange.url),
            read_query(exchange.url),
            headers,
            read_body(content, media_type),
            exchange.token_name,
            self._check,
            evidence=exchange,
        )

    def _end(self, seen: SeenExchange, exchange: Exchange) -> None:
        self._record(self.history.end(id(exchange), seen))
        self._tally.exercised.update(self.history.take_exercised())

    def _record(self, differences: list[Difference]) -> None:
        for difference in differences:
            rules = [rule for rule in difference.rules if rule in self._rules]
            if not rules and ANY_SEQUENCE in self._rules:
                rules = [ANY_SEQUENCE]
            if rules:
                self._tally.note_difference(
                    rules,
                    difference.expected,
                    difference.observed,
                    difference.observation.evidence,
                    self._leading_to(difference),
                )

    def _leading_to(self, difference: Difference) -> list[Exchange]:
        """Give the exchanges about the run before the judged one, and the witness."""
        judged, witness = difference.observation, difference.witness
        run_id = judged.params.get("run_id", "no run").encode()
        before = [
            exchange
            for exchange in self._log.exchanges
            if exchange.started_at < judged.started_at
            and (run_id in exchange.url.encode() or run_id in exchange.answer_body)
        ]
        if witness is not None and witness.evidence not in before:
            before.insert(0, witness.evidence)
        return before
