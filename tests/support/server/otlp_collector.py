"""A collector of traces: OTLP over HTTP, decoded with the exporter's own classes."""

from __future__ import annotations

import contextlib
import threading
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from opentelemetry.proto.collector.trace.v1.trace_service_pb2 import (
    ExportTraceServiceRequest,
)
from opentelemetry.proto.common.v1.common_pb2 import KeyValue

from tests.support.kit.null_servers import Reply, Request, run_server
from tests.support.waiting import wait_until

Values = dict[str, str | int | float]


@dataclass(frozen=True)
class ReceivedSpan:
    """Ids are in hex; parent is empty for the first of a trace. instance: its node."""

    name: str
    kind: int
    trace_id: str
    span_id: str
    parent: str
    links: tuple[str, ...]
    instance: str
    values: Values = field(compare=False)


class Collector:
    """What was received. status: what it answers. go_on: unset, it does not answer."""

    def __init__(self) -> None:
        self.status = 200
        self.go_on = threading.Event()
        self.go_on.set()
        self.paths: list[str] = []
        self.bodies: list[bytes] = []
        self.url = ""

    def spans(self, name: str = "") -> list[ReceivedSpan]:
        """All that were taken, or those of a name."""
        found = [one for body in list(self.bodies) for one in _spans_of(body)]
        return [one for one in found if name in ("", one.name)]

    def wait_for(self, name: str, count: int = 1) -> list[ReceivedSpan]:
        """The spans of a name, once there are so many."""
        wait_until(lambda: len(self.spans(name)) >= count, f"{count} spans {name!r}")
        return self.spans(name)

    def parts_of(self, span: ReceivedSpan) -> list[ReceivedSpan]:
        return [one for one in self.spans() if one.parent == span.span_id]

    def settings(self, **others: str) -> dict[str, str]:
        """Of a server that records all and sends it here at once."""
        return {
            "PROCTOR_TRACES": self.url,
            "PROCTOR_TRACES_RATIO": "1",
            "OTEL_BSP_SCHEDULE_DELAY": "10",
            "NO_PROXY": "127.0.0.1",
        } | others


@contextlib.contextmanager
def collecting() -> Iterator[Collector]:
    """A collector at a free port of this machine."""
    collector = Collector()

    def receive(request: Request) -> Reply:
        collector.paths.append(request.path)
        collector.go_on.wait()
        if collector.status == 200:
            collector.bodies.append(request.body)
        return collector.status, {}, b""

    with run_server(receive) as collector.url:
        try:
            yield collector
        finally:
            collector.go_on.set()


def _spans_of(body: bytes) -> Iterator[ReceivedSpan]:
    request = ExportTraceServiceRequest.FromString(body)
    for of_resource in request.resource_spans:
        resource = _values(of_resource.resource.attributes)
        for of_scope in of_resource.scope_spans:
            for one in of_scope.spans:
                yield ReceivedSpan(
                    one.name,
                    one.kind,
                    one.trace_id.hex(),
                    one.span_id.hex(),
                    one.parent_span_id.hex(),
                    tuple(link.trace_id.hex() for link in one.links),
                    str(resource["service.instance.id"]),
                    _values(one.attributes),
                )


def _values(attributes: Iterable[KeyValue]) -> Values:
    found: Values = {}
    for one in attributes:
        which = one.value.WhichOneof("value")
        assert which is not None
        found[one.key] = getattr(one.value, which)
    return found
