"""Traces for a collector of OpenTelemetry: the one user of its library, an extra.

Which requests are recorded is decided here, before the library is asked for anything: a
request that is not costs one random number. Recorded spans wait in memory for a thread
that sends them; if that is not fast enough, the oldest ones are dropped. No request
waits for a collector.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import random
import secrets
import threading
from collections.abc import Sequence
from contextvars import ContextVar, Token
from typing import Self
from urllib.parse import urlsplit

from opentelemetry import trace
from opentelemetry.context import Context
from opentelemetry.exporter.otlp.proto.http.trace_exporter import OTLPSpanExporter
from opentelemetry.sdk.resources import OTELResourceDetector, Resource
from opentelemetry.sdk.trace import ReadableSpan, TracerProvider
from opentelemetry.sdk.trace.export import (
    BatchSpanProcessor,
    SpanExporter,
    SpanExportResult,
)
from opentelemetry.sdk.trace.sampling import ALWAYS_ON

from reference_server.monitoring.request_spans import TraceParent
from reference_server.telemetry import spans
from reference_server.telemetry.spans import NOT_RECORDED, Span, Value

log = logging.getLogger("proctor.traces")

PATH = "/v1/traces"
# After the last turn; a collector that takes longer loses what is left.
FLUSH_S = 2.0
_NO_PARENT = Context()
# They log each failure of a batch, and that spans are dropped; ours is logged once.
_EXPORTER_LOG = "opentelemetry.exporter.otlp.proto.http.trace_exporter"
_QUEUE_LOG = "opentelemetry.sdk._shared_internal"
_REASON_CHARS_MAX = 300


class _Recorded:
    """A span that is recorded; parts of it, from its beginning to its end."""

    __slots__ = ("_token", "recorded")

    def __init__(self, recorded: trace.Span) -> None:
        self.recorded = recorded

    @property
    def is_recorded(self) -> bool:
        return self.recorded.is_recording()

    def set(self, name: str, value: Value) -> None:
        if name == "name":
            self.recorded.update_name(str(value))
        else:
            self.recorded.set_attribute(name, value)
        if name == "http.response.status_code" and int(value) >= 500:
            self.recorded.set_status(trace.StatusCode.ERROR)

    def __enter__(self) -> Self:
        self._token: Token[_Recorded | None] = _CURRENT.set(self)
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        _CURRENT.reset(self._token)
        if kind is not None:  # its text may be of a client, or have a sealed seed
            self.recorded.set_attribute("error.type", kind.__name__)
            self.recorded.set_status(trace.StatusCode.ERROR)
        self.recorded.end()


class _Hidden:
    """A block that is not recorded, nor are its parts."""

    __slots__ = ("_token",)
    is_recorded = False

    def set(self, name: str, value: Value) -> None:
        pass

    def __enter__(self) -> Self:
        self._token: Token[_Recorded | None] = _CURRENT.set(None)
        return self

    def __exit__(self, *_: object) -> None:
        _CURRENT.reset(self._token)


# Tasks and threads of asyncio that a request begins inherit it.
_CURRENT: ContextVar[_Recorded | None] = ContextVar("span", default=None)


def _not_recorded() -> Span:
    """Clear the current span: the task may have begun inside another request's span."""
    if _CURRENT.get() is not None:
        _CURRENT.set(None)
    return NOT_RECORDED


class Traces:
    """Records spans from `open` to `close`.

    url: of the collector, as OTEL_EXPORTER_OTLP_ENDPOINT has it. ratio: of the traces
    that begin here, how many are recorded, 0 to 1. instance: the address of this node.
    Raises ValueError for variables OTEL_… that cannot be used.
    """

    def __init__(self, url: str, ratio: float, *, version: str, instance: str) -> None:
        self._ratio = ratio
        ours = {
            "service.name": "proctor-server",
            "service.version": version,
            "service.instance.id": instance,
        }
        # The operator's environment variables take precedence over these attributes.
        named = OTELResourceDetector().detect()
        self._provider = TracerProvider(
            resource=Resource.create(ours).merge(named),
            sampler=ALWAYS_ON,  # what is not to be recorded does not come so far
            shutdown_on_exit=False,
        )
        exporter = _ReportingExporter(endpoint_of(url))
        self._provider.add_span_processor(BatchSpanProcessor(exporter))
        self._tracer = self._provider.get_tracer("proctor")

    async def open(self) -> None:
        spans.record_with(self)

    async def close(self) -> None:
        """Send what is left, for a bounded time."""
        spans.record_with(None)
        loop, done = asyncio.get_running_loop(), asyncio.Event()
        shut_down = self._provider.shutdown

        def send_the_rest() -> None:
            shut_down()
            with contextlib.suppress(RuntimeError):  # the loop has ended meanwhile
                loop.call_soon_threadsafe(done.set)

        # Not one of the loop's threads: the process would wait for its end.
        threading.Thread(target=send_the_rest, daemon=True).start()
        try:
            async with asyncio.timeout(FLUSH_S):
                await done.wait()
        except TimeoutError:
            log.warning("the last traces could not be sent within %g s", FLUSH_S)

    # --- spans ---

    def request(self, parent: TraceParent | None, *, is_trusted: bool) -> Span:
        """The span of a request: in its parent's trace, or in a new linked one."""
        if parent is not None and is_trusted:
            if not parent.is_recorded:
                return _not_recorded()
            context = trace.set_span_in_context(
                trace.NonRecordingSpan(_context_of(parent)), _NO_PARENT
            )
            return self._begin("request", context, trace.SpanKind.SERVER)
        if not self._is_drawn():
            return _not_recorded()
        links = [] if parent is None else [trace.Link(_context_of(parent))]
        return self._begin("request", _NO_PARENT, trace.SpanKind.SERVER, links)

    def root(self, name: str) -> Span:
        if not self._is_drawn():
            return _Hidden()
        return self._begin(name, _NO_PARENT, trace.SpanKind.INTERNAL)

    def part(self, name: str, *, is_call: bool) -> Span:
        current = _CURRENT.get()
        if current is None or not current.is_recorded:  # it may have ended
            return NOT_RECORDED
        kind = trace.SpanKind.CLIENT if is_call else trace.SpanKind.INTERNAL
        context = trace.set_span_in_context(current.recorded, _NO_PARENT)
        return self._begin(name, context, kind)

    def traceparent(self, *, only_recorded: bool) -> str | None:
        current = _CURRENT.get()
        if current is not None:
            sent = current.recorded.get_span_context()
            return f"00-{sent.trace_id:032x}-{sent.span_id:016x}-01"
        if only_recorded:
            return None
        # The receiver must not draw again: it would record parts of traces.
        return f"00-{secrets.token_hex(16)}-{secrets.token_hex(8)}-00"

    def _is_drawn(self) -> bool:
        return random.random() < self._ratio

    def _begin(
        self,
        name: str,
        context: Context,
        kind: trace.SpanKind,
        links: Sequence[trace.Link] = (),
    ) -> Span:
        begun = self._tracer.start_span(
            name,
            context,
            kind,
            links=links,
            record_exception=False,
            set_status_on_exception=False,
        )
        return _Recorded(begun)


class _ReportingExporter(SpanExporter):
    """Logs once when the collector takes nothing any more, and when it does again."""

    def __init__(self, endpoint: str) -> None:
        self._exporter = OTLPSpanExporter(endpoint)
        self._is_failing = False
        self._reason = _LastReason()
        exporter_log = logging.getLogger(_EXPORTER_LOG)
        exporter_log.addHandler(self._reason)
        exporter_log.propagate = False
        logging.getLogger(_QUEUE_LOG).setLevel(logging.ERROR)

    def export(self, spans: Sequence[ReadableSpan]) -> SpanExportResult:
        result = self._exporter.export(spans)
        is_failing = result is not SpanExportResult.SUCCESS
        if is_failing and not self._is_failing:
            text = "the collector takes no traces; until it does they are lost: %s"
            log.warning(text, self._reason.text)
        elif self._is_failing and not is_failing:
            log.warning("the collector takes traces again")
        self._is_failing = is_failing
        return result

    def shutdown(self) -> None:
        self._exporter.shutdown()  # type: ignore[no-untyped-call]

    def force_flush(self, timeout_millis: int = 30_000) -> bool:
        return self._exporter.force_flush(timeout_millis)


class _LastReason(logging.Handler):
    """Why the exporter failed last, which it only logs."""

    text = "no answer in time"

    def emit(self, record: logging.LogRecord) -> None:
        # The exporter also logs that it has given up, but without the reason.
        if record.args is not None and len(record.args) > 1:
            self.text = record.getMessage()[:_REASON_CHARS_MAX]


def endpoint_of(url: str) -> str:
    """The URL to which traces are sent. Raises ValueError, without it in the text."""
    parts = urlsplit(url)
    is_url = parts.scheme in ("http", "https") and parts.hostname
    if not is_url or parts.query or parts.fragment:
        raise ValueError("it must be the URL of a collector, such as http://HOST:4318")
    return url if parts.path.endswith(PATH) else url.rstrip("/") + PATH


def _context_of(parent: TraceParent) -> trace.SpanContext:
    flags = trace.TraceFlags(trace.TraceFlags.SAMPLED * parent.is_recorded)
    return trace.SpanContext(parent.trace_id, parent.span_id, True, flags)
