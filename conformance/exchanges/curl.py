"""Writes the exchanges of a check as a shell script that repeats them on any server.

The script needs bash, curl and python3. Ids that the server generated (runs, sessions,
cursors) are stored in variables, so that the script works on a fresh server; tokens and
the URL are variables, too. Concurrent requests are concurrent in the script, and where
the check waited for a state, the script waits for it. Events are read for as long as
the check read them; their ids come from the output.
"""

import base64
import json
import math
import re
from collections.abc import Iterable, Iterator
from typing import Any

from conformance.exchanges.exchange import Exchange
from conformance.specification.document import EVENT_STREAM

_CAPTURED_MEMBERS = {"run_id": "RUN", "session_id": "SESSION", "next_cursor": "CURSOR"}
_BLANKS = 64  # at the end of what is stored: the rest of the body is blanks, too
_MIN_PAUSE_S = 0.3
_SHORTEST_S = 0.05  # that a program has to send a request and to leave
_HEAD_START_S = 0.02  # of one request before another that runs beside it
_ID_MIN_LENGTH = 4
_TOKENS = {
    "TOKEN": "${TOKEN:?a token with the scopes read and run}",
    "TOKEN_2": "${TOKEN_2:?a token of another account}",
    "TOKEN_READ": "${TOKEN_READ:?a token that may only read}",
    "WRONG_TOKEN": "${WRONG_TOKEN:=wrong}",
}
_CURL = r"""curl() { command curl -w '\n→ %{http_code}\n' "$@"; }"""
_KEEP = (
    "keep() { python3 -c 'import json, sys; text = sys.stdin.read(); "
    r'sys.stderr.write(text); print(json.loads(text.split("\n→")[0])[sys.argv[1]])'
    '\' "$1"; }'
)
_NTH_ID = (
    "nth_id() { python3 -c 'import re, sys; text = open(sys.argv[2]).read(); "
    'print(re.findall(r"(?m)^id: *(\\S+)", text)[int(sys.argv[1]) - 1])'
    '\' "$1" "$2"; }'
)
_WAIT_FOR = (
    "wait_for() { for _ in {1..100}; do "
    '[ "$("${@:3}" 2>&1 | keep "$1" 2>/dev/null)" = "$2" ] && return; '
    "sleep 0.1; done; }"
)


class Script:
    """The commands so far, and the variables that they set."""

    def __init__(self, base_url: str) -> None:
        self._base_url = base_url
        self._variables: dict[str, str] = {}
        self._counts: dict[str, int] = {}
        self._states: dict[str, str] = {}

    def lines(self, exchanges: Iterable[Exchange]) -> Iterator[str]:
        """Give the commands, each followed by the response as a comment."""
        groups = list(_without_polls(exchanges))
        texts = [_text_of(polls[-1]) for polls in groups]
        free_at = beside_until = groups[0][-1].started_at if groups else 0.0
        is_alone = True
        for index, polls in enumerate(groups):
            exchange = polls[-1]
            pause_s = exchange.started_at - free_at
            ended_at = exchange.started_at + exchange.elapsed_s
            is_last = index + 1 == len(groups)
            state = None if is_last else self._new_state(exchange)
            min_pause_s = _MIN_PAUSE_S if is_alone else _HEAD_START_S
            if pause_s > min_pause_s and state is None:
                yield f"sleep {max(pause_s, 0.1):.1f}"
            if _is_truncated(exchange):
                yield self._body_file(exchange)
            overlaps_next = not is_last and groups[index + 1][0].started_at < ended_at
            later = "\n".join(texts[index + 1 :])
            command = self._capture_ids(exchange, self._command(exchange), later)
            if state is not None:
                command = f"wait_for state {state} {command}"
            elif overlaps_next and command.startswith("curl"):
                # The check sent the next request before this one was answered.
                beside_until = max(beside_until, ended_at)
                command, is_alone, ended_at = f"{command} &", False, exchange.started_at
            yield command
            mark = "   ← judged" if exchange.is_judged else ""
            yield f"# → {outcome_of(exchange)}{mark}"
            if not is_alone and (
                is_last or groups[index + 1][0].started_at >= beside_until
            ):
                yield "wait"
                is_alone = True
            free_at = ended_at

    def _new_state(self, exchange: Exchange) -> str | None:
        """Give the new state of a run, if this exchange is a read that shows one."""
        body = _read(exchange)
        run_id, state = body.get("run_id"), body.get("state")
        if not isinstance(run_id, str) or not isinstance(state, str):
            return None
        before = self._states.get(run_id)
        self._states[run_id] = state
        is_new = before not in (None, state) and re.fullmatch("[a-z_]+", state)
        is_look = exchange.method == "GET" and exchange.url.endswith(run_id)
        return state if is_look and is_new else None

    def _command(self, exchange: Exchange) -> str:
        parts = ["curl", "-sS"]
        if _is_stream(exchange):
            parts.append(f"-N --max-time {math.ceil(exchange.elapsed_s) + 1}")
        if exchange.leave_after_s is not None:
            parts.append(f"--max-time {max(exchange.leave_after_s, _SHORTEST_S):g}")
        if exchange.method == "HEAD":
            parts.append("--head")
        elif exchange.method != "GET":
            parts += ["-X", exchange.method]
        url = re.sub(r"([\"\\$`])", r"\\\1", exchange.url)
        if url.startswith(self._base_url):
            url = "$URL" + url.removeprefix(self._base_url)
        parts.append(f'"{self._with_variables(url, quoted=False)}"')
        if exchange.token_name is not None:
            parts.append(f'-H "Authorization: Bearer ${exchange.token_name}"')
        for name, value in exchange.request_headers.items():
            parts.append(f"-H {self._quoted(f'{name}: {value}')}")
        if _is_truncated(exchange):
            parts.append("--data-binary @body")
        elif exchange.request_body:
            parts.append(self._body(exchange.request_body))
        return " ".join(parts)

    def _body(self, body: bytes) -> str:
        try:
            text = body.decode()
        except UnicodeDecodeError:
            text = ""
        if text.isprintable() and text:
            return f"--data-binary {self._quoted(text)}"
        ids = [value for value in self._variables if value.encode() in body]
        if not ids:
            encoded = base64.b64encode(body).decode()
            return f"--data-binary @<(echo {encoded} | base64 -d)"
        # Bytes around ids, as in MessagePack: a fresh server's ids are as long.
        pattern = "|".join(re.escape(value) for value in ids).encode()
        parts = []
        for part in re.split(b"(" + pattern + b")", body):
            name = self._variables.get(part.decode("latin-1"))
            octal = "".join(f"\\{byte:03o}" for byte in part)
            parts.append(f'printf %s "${name}"' if name else f"printf '{octal}'")
        return f"--data-binary @<({'; '.join(parts)})"

    def _body_file(self, exchange: Exchange) -> str:
        """Write the file of a long body; the kit makes most of them long by blanks."""
        size, body = exchange.request_size, exchange.request_body
        text = body.decode("latin-1").rstrip(" ")
        is_padded = len(body) - len(text) > _BLANKS and text.isprintable()
        if size is None or not (is_padded and text.isascii()):
            size_text = "streamed" if size is None else f"{size} bytes"
            return f"# create the file `body` first ({size_text})"
        blanks = f"head -c {size - len(text)} /dev/zero | tr '\\0' ' '"
        return f"{{ printf %s {self._quoted(text)}; {blanks}; }} >body"

    def _quoted(self, text: str) -> str:
        return self._with_variables("'" + text.replace("'", "'\\''") + "'", quoted=True)

    def _with_variables(self, text: str, *, quoted: bool) -> str:
        for value in sorted(self._variables, key=len, reverse=True):
            name = self._variables[value]
            text = text.replace(value, f"'\"${name}\"'" if quoted else f"${{{name}}}")
        return text

    def _capture_ids(self, exchange: Exchange, command: str, later: str) -> str:
        """Store an id that the server generated, if later requests need it."""
        if _is_stream(exchange):
            return self._capture_event_ids(exchange, command, later)
        for member, value in _server_made_ids(exchange):
            if value in self._variables or value not in later:
                continue
            stem = _CAPTURED_MEMBERS[member]
            self._counts[stem] = self._counts.get(stem, 0) + 1
            name = f"{stem}_{self._counts[stem]}"
            self._variables[value] = name
            return f"{name}=$({command} | keep {member})"
        return command

    def _capture_event_ids(self, exchange: Exchange, command: str, later: str) -> str:
        """Store events in a file, if later requests use the id of one of them."""
        text = exchange.answer_body.decode("utf-8", "replace")
        event_ids = re.findall(r"^id: *(\S+)", text, re.MULTILINE)
        new = {
            id_: number
            for number, id_ in enumerate(event_ids, start=1)
            if f": {id_}" in later and len(id_) >= _ID_MIN_LENGTH
        }
        if not new.keys() - self._variables.keys():
            return f"{command} || :"  # --max-time ends it with an error, as intended
        self._counts["events"] = self._counts.get("events", 0) + 1
        file = f"events_{self._counts['events']}"
        for id_, number in new.items():
            self._variables.setdefault(id_, f"(nth_id {number} {file})")
        return f"{command} | tee {file}"


def _text_of(exchange: Exchange) -> str:
    headers = "".join(f" {n}: {v}" for n, v in exchange.request_headers.items())
    return f"{exchange.url}{headers} {exchange.request_body.decode('latin-1')}"


def _is_stream(exchange: Exchange) -> bool:
    return exchange.answer_headers.get("content-type", "").startswith(EVENT_STREAM)


def _is_truncated(exchange: Exchange) -> bool:
    size = exchange.request_size
    return size is None or size > len(exchange.request_body)


def _without_polls(exchanges: Iterable[Exchange]) -> Iterator[list[Exchange]]:
    """Group repeated reads of one state without another request in between."""
    group: list[Exchange] = []
    for exchange in sorted(exchanges, key=lambda item: item.started_at):
        if group and _is_repeated_poll(exchange, group[-1]):
            group.append(exchange)
            continue
        if group:
            yield group
        group = [exchange]
    if group:
        yield group


def _is_repeated_poll(exchange: Exchange, before: Exchange) -> bool:
    return (
        exchange.method == before.method == "GET"
        and exchange.url == before.url
        and exchange.request_headers == before.request_headers
        and exchange.token_name == before.token_name
        and before.status == exchange.status == 200
        and exchange.started_at >= before.started_at + before.elapsed_s
        and "state" in _read(exchange)
    )


def _read(exchange: Exchange) -> dict[str, Any]:
    try:
        body: Any = json.loads(exchange.answer_body)
    except ValueError:
        return {}
    return body if isinstance(body, dict) else {}


def _server_made_ids(exchange: Exchange) -> Iterator[tuple[str, str]]:
    if exchange.status is None or exchange.status >= 300:
        return
    body = _read(exchange)
    for member in _CAPTURED_MEMBERS:
        value = body.get(member)
        if isinstance(value, str) and len(value) >= _ID_MIN_LENGTH:
            yield member, value


def outcome_of(exchange: Exchange) -> str:
    """Give status, problem code and duration of the response."""
    if exchange.status is None:
        return f"no response: {exchange.error}"
    code = _read(exchange).get("code")
    code_text = f" {code}" if exchange.status >= 400 and isinstance(code, str) else ""
    return f"{exchange.status}{code_text} after {1000 * exchange.elapsed_s:.0f} ms"


def select_exchanges_for(
    number: int | None, exchanges: Iterable[Exchange]
) -> list[Exchange]:
    """Select one exchange, and those whose responses contain its ids."""
    sent = list(exchanges)
    wanted = [exchange for exchange in sent if exchange.number == number]
    text = "".join(_text_of(exchange) for exchange in wanted)
    id_sources: dict[str, Exchange] = {}
    for exchange in sent:
        for _, value in _server_made_ids(exchange):
            if value in text:
                id_sources.setdefault(value, exchange)
    return [
        *id_sources.values(),
        *(exchange for exchange in wanted if exchange not in id_sources.values()),
    ]


def script(exchanges: Iterable[Exchange], base_url: str) -> list[str]:
    """Write exchanges as a shell script; nothing for none."""
    sent = list(exchanges)
    commands = list(Script(base_url).lines(sent))
    if not commands:
        return []
    names = {exchange.token_name for exchange in sent}
    tokens = [f'"{text}"' for name, text in _TOKENS.items() if name in names]
    head = [" ".join([': "${URL:?base URL of the server}"', *tokens]), _CURL]
    if any("| keep " in line or line.startswith("wait_for") for line in commands):
        head.append(_KEEP)
    if any(line.startswith("wait_for") for line in commands):
        head.append(_WAIT_FOR)
    if any("$(nth_id " in line for line in commands):
        head.append(_NTH_ID)
    return [*head, *commands]
