"""Request bodies that are invalid on purpose, with the places that are changed.

Contains requests only; the checks state the expected responses.
"""

import json
from collections.abc import Iterator
from typing import Any


def replace_at(body: Any, pointer: str, value: Any) -> Any:
    """Replace the value at a JSON pointer."""
    head, _, rest = pointer[1:].partition("/")
    if isinstance(body, list):
        inner = replace_at(body[int(head)], f"/{rest}", value) if rest else value
        return [*body[: int(head)], inner, *body[int(head) + 1 :]]
    if rest:
        value = replace_at(body[head], f"/{rest}", value)
    return body | {head: value}


def pad_body(body: dict[str, Any], size: int) -> Iterator[bytes]:
    """Give a JSON body that is made as large as wanted by trailing blanks."""
    text = json.dumps(body).encode()
    yield text
    blanks = size - len(text)
    while blanks > 0:
        yield b" " * min(blanks, 2**16)
        blanks -= 2**16


# Operation → pointers of a text and of a number in its body.
_PLACES = {
    "submit_run": ("/policy/name", "/idle_timeout_s"),
    "predict": ("/session_id", "/actions/0/values/score/0"),
}
# Invalid JSON strings, and lone surrogates, which JSON can write and few programs hold.
_NO_TEXT: tuple[bytes, ...] = (
    rb'"\ud83d"',
    rb'"\udd16"',
    rb'"a\udc00b"',
    rb'"\udd16\ud83d"',
    b'"\xed\xa0\xbd"',
    b'"\xff"',
)
_NO_TEXT += (b'"\x01"', b'"a\nb"', b"'a'", b'"\\x41"', b'"\\u12"', b'"\\ud83dx"', b'"a')
_NO_DOUBLES: tuple[bytes, ...] = (
    b"1e999",
    b"-1e999",
    b"1" + b"0" * 400,
    b"01",
    b"+1",
    b".5",
    b"1.",
    b"1e",
)
_NO_DOUBLES += (b"0x1", b"-", b"1_0", b"tru", b"True", b"None", b"undefined", b"1 2")


def unrepresentable_json(operation_id: str, how: dict[str, Any]) -> Iterator[bytes]:
    """Give bodies with a text, number or name that JSON or programs cannot hold."""
    if operation_id not in _PLACES:
        return
    text, number = _PLACES[operation_id]
    for pointer, wrongs in ((text, _NO_TEXT), (number, _NO_DOUBLES)):
        whole = json.dumps(replace_at(how["json"], pointer, "HERE")).encode()
        for wrong in wrongs:
            yield whole.replace(b'"HERE"', wrong)
    whole = json.dumps(how["json"]).encode()
    for wrong in _NO_TEXT:
        yield b"{" + wrong + b": 1, " + whole[1:]
