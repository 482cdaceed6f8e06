"""A client of policy servers on WebSocket: one frame per request and per answer.

openpi's protocol is one setting of it: the server's first frame is metadata,
MessagePack follows, and a text frame is the traceback of an error. The protocols have
no sequence number: a request contains all that the server needs, so a lost one is sent
again on a new connection.
"""

from __future__ import annotations

import contextlib
import ssl
import time
import weakref
from collections.abc import Callable, Mapping
from typing import Any, Self, TypeVar

from proctor_client import ProxyFault
from websockets.exceptions import (
    ConnectionClosed,
    InvalidHandshake,
    InvalidMessage,
    InvalidProxyStatus,
    InvalidStatus,
    InvalidURI,
    WebSocketException,
)
from websockets.frames import CLOSE_CODE_EXPLANATIONS, Close, CloseCode
from websockets.sync.client import ClientConnection, connect

from reference_client.errors import BadPolicy, ProctorError, innermost_reason
from reference_client.policies.servers.first_greeting import FirstGreeting
from reference_client.policies.servers.server_faults import (
    ONE_ANSWER,
    UNASKED,
    beginning,
    check_answer,
    describe_format,
    describe_key,
    failed,
    key_of,
    last_exception,
    moved,
    scheme_hint,
    status_text,
    text_of,
    who_speaks_at,
    with_key,
    without_numbers,
)
from reference_client.policies.servers.server_transport import (
    Silent,
    Unreached,
    fault_of,
    fault_on_the_way,
    first_contact,
    repeat_until_reached,
    report_answer_read,
    report_request_sent,
    reporting_wait,
    time_after,
    websocket_options,
)
from reference_client.policies.servers.wire_formats import (
    BadMessage,
    kind_of,
    pack,
    unpack,
)
from reference_client.policies.servers.wire_settings import (
    ANSWER_BYTES_MAX,
    FIRST_CONTACT_S,
    KEEPALIVE,
    LIMIT_OF_ANSWERS,
    ServerSettings,
)

OPEN_S = 5.0
CLOSE_S = 1.0  # a server that computes does not answer a close frame
GREETING_S = 10.0
UNASKED_S = 0.05  # a greeting that was not expected comes at once
# Close codes that the same request meets again; the others are of servers that end.
_FINAL_CODES = (1002, 1003, 1007, 1008, 1009, 1010, 1011)
_RETRY_STATUSES = (429, 500, 502, 503, 504)

Answer = TypeVar("Answer")


class _Moved(InvalidHandshake):
    """The server sends the client to another place, where it does not go."""

    def __init__(self, status: int, location: str | None) -> None:
        super().__init__(f"{status} {location}")
        self.status, self.location = status, location


class _StayingConnection(ClientConnection):
    """A connection to the server that was asked for, and to no other."""

    _fault: OSError | None = None

    def recv_events(self) -> None:
        try:
            super().recv_events()
        except OSError as error:  # this thread needs files, and may get none
            self._fault = error

    def handshake(self, *args: Any, **options: Any) -> None:
        try:
            super().handshake(*args, **options)
        except InvalidStatus as error:
            response = error.response
            if not 300 <= response.status_code < 400:
                raise
            location = response.headers.get("Location")
            raise _Moved(response.status_code, location) from error
        if self.response is None:  # the library takes the end of its thread for one
            self.recv_events_thread.join()
            raise self._fault or InvalidMessage("ended before the handshake")


class WebsocketClient:
    """The server at `url`, ws:// or wss://; connects at the first request.

    key: the variable of the environment that has the key, empty for none; its value is
    sent after `key_scheme` in the header Authorization. first: the first greeting of
    the run. retry_timeout_s: how long an unreachable server is retried.
    """

    def __init__(
        self,
        url: str,
        settings: ServerSettings,
        *,
        key: str = "",
        key_scheme: str = "Bearer",
        first: FirstGreeting | None = None,
        retry_timeout_s: float = 60.0,
    ) -> None:
        self.url = url
        self._settings = settings
        self._key = key
        value = key_of(key)
        self._headers = {"Authorization": f"{key_scheme} {value}"} if value else None
        self._first = first or FirstGreeting(settings.varying)
        self._retry_timeout_s = retry_timeout_s
        self._greeting_s = settings.answer_s  # a busy server greets when it is free
        self._socket: ClientConnection | None = None
        self._connection_stack = contextlib.ExitStack()
        self._is_closed = False
        # Also where nothing calls `close`, at the latest at the end of the program.
        weakref.finalize(self, self._connection_stack.close)
        self.metadata: Any = None

    def connected(self) -> Self:
        """Itself, connected. Raises ProctorError `policy_failed` if no server is there.

        Raises BadPolicy if the server's greeting is not the one that is expected.
        """
        self._greeting_s = min(GREETING_S, self._settings.answer_s)
        with first_contact(self.url):
            self._retry(self._ensure_connected, FIRST_CONTACT_S)
        self._greeting_s = self._settings.answer_s
        return self

    def infer(self, request: Mapping[str, Any]) -> Any:
        """Raises ProctorError `policy_failed`, with the error text of the server."""
        frame = self.read(self._exchange(request))
        check_answer(self.url, frame, self._key)
        return frame

    def begin_episode(self, message: Mapping[str, Any] | None) -> None:
        """message: what the server is sent before the first request of an episode."""
        if self._settings.new_connection and self._socket is not None:
            self._drop()
        if message is None:
            return
        frame = self._exchange(message)
        if isinstance(frame, bytes):
            check_answer(self.url, self.read(frame), self._key)
        elif "Traceback (most recent call last)" in frame:
            raise self.failed_with(frame)  # other text acknowledges the message

    def without_numbers(self, answer: Any, why: str) -> ProctorError:
        return without_numbers(self.url, answer, why, self._key)

    def close(self) -> None:
        """Leave with a close frame; a request in progress fails."""
        self._is_closed = True
        self._drop()

    def _exchange(self, message: Mapping[str, Any]) -> str | bytes:
        settings = self._settings
        if settings.envelope is not None:
            text = pack(message, _json_format(settings.format)).decode()
            message = {settings.envelope: text}
        packed = pack(message, settings.format)
        is_text = settings.format.startswith("json")

        def exchange() -> str | bytes:
            socket = self._ensure_connected()
            self.send(socket, packed.decode() if is_text else packed)
            return self.receive(socket)

        return self._retry(exchange, self._retry_timeout_s)

    def send(self, socket: ClientConnection, data: str | bytes) -> None:
        """Send a request where no message waits, which would be taken for its answer.

        Raises ProctorError `policy_failed` for such a message.
        """
        try:
            frame = socket.recv(timeout=0)
        except TimeoutError:
            report_request_sent(self.url, len(data))
            socket.send(data)
            return
        raise self.failed(f"{UNASKED} ({_preview(frame)}). {ONE_ANSWER}")

    def receive(self, socket: ClientConnection) -> str | bytes:
        """The next frame, within the limit for an answer."""
        try:
            frame = socket.recv(timeout=self._settings.answer_s)
        except TimeoutError as error:
            limit_s = self._settings.answer_s
            what = f"did not answer within {limit_s:g} s; {LIMIT_OF_ANSWERS}"
            raise Silent(what) from error
        report_answer_read(self.url, len(frame))
        return frame

    def _retry(self, attempt: Callable[[], Answer], retry_timeout_s: float) -> Answer:
        def try_once() -> Answer:
            try:
                return attempt()
            except InvalidURI as error:
                raise self.failed(f"has an invalid WebSocket URL: {error}") from error
            except (OSError, WebSocketException) as error:
                self._drop()
                if self._is_closed:
                    raise self.failed("was left") from error
                raise _fault_of(error, self.url, self._key) from error
            except (ProctorError, BadPolicy, Silent):
                self._drop()  # an answer that comes later is not the next one's
                raise

        return repeat_until_reached(try_once, self.url, retry_timeout_s)

    def _ensure_connected(self) -> ClientConnection:
        if self._socket is None:
            socket = self._connection_stack.enter_context(self._open())
            greeting = self.greet(socket)
            self._first.check(self.url, greeting)
            self._settings.check_greeting(greeting, self.url)
            self.metadata, self._socket = greeting, socket
        return self._socket

    def _open(self) -> ClientConnection:
        try:
            socket: ClientConnection = connect(
                self.url,
                compression=None,
                max_size=ANSWER_BYTES_MAX,
                create_connection=_StayingConnection,
                open_timeout=OPEN_S,
                close_timeout=CLOSE_S,
                # openpi's server computes in the event loop that would answer pings.
                ping_interval=None,
                additional_headers=self._headers,
                **websocket_options(self.url),
            )
        except AssertionError as error:  # of the library: words before the handshake
            raise InvalidMessage("spoke before the handshake") from error
        with contextlib.suppress(OSError):  # it is closed already; a read says why
            for option in KEEPALIVE:
                socket.socket.setsockopt(*option)
        return socket

    def greet(self, socket: ClientConnection) -> Any:
        """The server's first message; None for one that waits for the client."""
        if not self._settings.greeting:
            self.expect_silence(socket)
            return None
        with reporting_wait(self.url) as say:
            return self._ready_greeting(socket, say)

    def _ready_greeting(
        self, socket: ClientConnection, say: Callable[[str], None]
    ) -> Any:
        deadline = time.monotonic() + self._settings.answer_s
        until = time_after(self._settings.answer_s)
        while True:
            try:
                greeting = self.read(socket.recv(timeout=self._greeting_s))
            except TimeoutError as error:
                raise self.failed(
                    f"sent no greeting within {self._greeting_s:g} s. It is busy with "
                    "another client, or waits for this one to speak first: model "
                    "servers of vla-eval do "
                    "(--policy vla-eval:URL), and others are --policy ws://… with "
                    "`greeting = false` in [server]"
                ) from error
            check_answer(self.url, greeting, self._key)
            ready = self._settings.ready
            if not ready or (
                isinstance(greeting, Mapping)
                and all(greeting.get(name) == value for name, value in ready.items())
            ):
                return greeting
            said = status_text(greeting)
            if time.monotonic() > deadline:
                raise self.failed(f"is still not ready: {said}")
            say(f"is not ready. It says: {said}. It is waited for until {until}")

    def expect_silence(self, socket: ClientConnection) -> None:
        """Raises ProctorError if the server speaks first."""
        try:
            frame = socket.recv(timeout=UNASKED_S)
        except TimeoutError:
            return
        raise self.failed(
            f"speaks first ({_preview(frame)}): servers of openpi's protocol do "
            "(--policy openpi:URL), and others are --policy ws://… with "
            "`greeting = true` in [server]"
        )

    def read(self, frame: str | bytes) -> Any:
        """A decoded frame. Raises ProctorError `policy_failed`."""
        wire_format = self._settings.format
        is_text = isinstance(frame, str) and not wire_format.startswith("json")
        try:
            if not is_text:
                return unpack(frame, wire_format)
        except BadMessage as error:
            other = describe_format(self.url, frame, wire_format)
            what = f"sent a frame that {error}; {beginning(frame)}"
            raise self.failed(other or what) from error
        if kind_of(frame) == "json":
            check_answer(self.url, unpack(frame, "json"), self._key)
        if other := describe_format(self.url, frame, wire_format):
            raise self.failed(other)
        raise self.failed_with(str(frame))

    def _drop(self) -> None:
        self._socket = None
        self._connection_stack.close()

    def failed(self, what: str) -> ProctorError:
        return failed(self.url, what)

    def failed_with(self, text: str) -> ProctorError:
        said = with_key(last_exception(text), self._key)
        return failed(self.url, f"failed: {said}", text)


def _fault_of(error: Exception, url: str, key: str) -> Exception:
    """Unreached, or a ProctorError if the next attempt will meet the same."""
    if isinstance(error, InvalidProxyStatus):
        status, phrase = error.response.status_code, error.response.reason_phrase
        return fault_on_the_way(url, ProxyFault(f"{status} {phrase}", status))
    if isinstance(error, InvalidHandshake):
        what, is_final = _failed_handshake(error, url, key)
    elif isinstance(error, ConnectionClosed):
        if _was_too_big(error):
            return failed(url, f"sends an answer of more than {ANSWER_BYTES_MAX} bytes")
        if error.rcvd is None:
            what = f"closed the connection ({innermost_reason(error)}); "
            return Unreached(what, lambda: who_speaks_at(url))
        what = with_key(_closing(error.rcvd), key)
        is_final = error.rcvd.code in _FINAL_CODES
    elif isinstance(error, ssl.SSLError) and error.reason == "WRONG_VERSION_NUMBER":
        what = "does not speak TLS there: the URL begins with ws://, not wss://"
        is_final = True
    elif isinstance(error, TimeoutError) and "handshake" in str(error):
        # A server that computes in its event loop answers later.
        what = "did not answer the WebSocket handshake: "
        return Unreached(what, lambda: who_speaks_at(url))
    else:
        return fault_of(url, error)
    return failed(url, what) if is_final else Unreached(what)


def _was_too_big(error: ConnectionClosed) -> bool:
    """Whether this client has closed, for the size of an answer."""
    if error.sent is None or error.rcvd_then_sent:
        return False
    return error.sent.code == CloseCode.MESSAGE_TOO_BIG


def _closing(close: Close) -> str:
    """The words with which a server closed a connection, and what may help."""
    named = close.reason or CLOSE_CODE_EXPLANATIONS.get(close.code, "no reason")
    what = f"closed the connection: {named} (code {close.code})"
    if close.code != CloseCode.MESSAGE_TOO_BIG:
        return what
    return (
        f"{what}; let it take larger messages (`max_size` of its WebSocket library), "
        "or send smaller pictures (`resize`, `encode` in the mapping file)"
    )


def _failed_handshake(error: InvalidHandshake, url: str, key: str) -> tuple[str, bool]:
    if isinstance(error, _Moved):
        return moved(url, error.status, error.location), True
    if isinstance(error, InvalidStatus):
        return _refused_handshake(error, key)
    if not isinstance(error, InvalidMessage):
        return f"does not speak WebSocket as this client does: {error}", True
    if isinstance(error.__cause__, EOFError):
        what = "closes connections without an answer to the handshake"
        return f"{what}{scheme_hint(url)}", False
    said = innermost_reason(error)
    speaks = f"it answers {said}" if "HTTP/" in said else who_speaks_at(url)
    return f"is no WebSocket server: {speaks}", True


def _refused_handshake(error: InvalidStatus, key: str) -> tuple[str, bool]:
    """The HTTP answer to a handshake, and whether it will be the same again."""
    response = error.response
    status = response.status_code
    media_type = response.headers.get("Content-Type")
    body = text_of(bytes(response.body or b"")[:2000], media_type).strip()
    said = f"{status} {response.reason_phrase}" + (f": {body:.200}" if body else "")
    if status in _RETRY_STATUSES:
        return f"answered the WebSocket handshake with {said}", False
    if status in (401, 403):
        return f"refused the handshake with {said}; {describe_key(key)}", True
    return (
        f"is an HTTP server without a WebSocket at this path: it answered {said}. "
        "Check the path; policies over HTTP are --policy http://… or proctor:http://…"
    ), True


def _json_format(wire_format: str) -> str:
    return wire_format if wire_format.startswith("json") else "json-numpy"


def _preview(frame: str | bytes) -> str:
    return f"{frame[:40]!r}"
