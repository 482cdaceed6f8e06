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


MALFORMED = "malformed_body"
# Operation → pointers of a text and of a number in its body, each with the codes of a
# value there that JSON has and few programs hold. The name of a policy and a `vector`
# may be anything; elsewhere such a value is a second fault, for which a server may
# refuse the body as well (OPT-041).
_ALONE = (MALFORMED,)
_PLACES: dict[str, tuple[tuple[str, tuple[str, ...]], ...]] = {
    "submit_run": (
        ("/policy/name", _ALONE),
        ("/max_workers", (MALFORMED, "invalid_request")),
    ),
    "predict": (
        ("/session_id", (MALFORMED, "session_ended")),
        ("/actions/0/values/vector/0", _ALONE),
    ),
}
_NAME_CODES = (MALFORMED, "invalid_request")
# Lone surrogates, and bytes that are not UTF-8, which some readers replace.
_UNHELD_TEXTS: tuple[bytes, ...] = (
    *(rb'"\ud83d"', rb'"\udd16"', rb'"a\udc00b"', rb'"\udd16\ud83d"', rb'"\ud83dx"'),
    *(b'"\xed\xa0\xbd"', b'"\xff"'),
)
_INVALID_TEXTS: tuple[bytes, ...] = (
    *(b'"\x01"', b'"a\nb"', b"'a'", b'"\\x41"', b'"\\u12"', b'"a'),
)
_UNHELD_NUMBERS: tuple[bytes, ...] = (b"1e999", b"-1e999", b"1" + b"0" * 400)
_INVALID_NUMBERS: tuple[bytes, ...] = (
    *(b"01", b"+1", b".5", b"1.", b"1e", b"0x1", b"-", b"1_0", b"1 2"),
    *(b"tru", b"True", b"None", b"undefined"),
)


def unrepresentable_json(
    operation_id: str, how: dict[str, Any]
) -> Iterator[tuple[bytes, tuple[str, ...]]]:
    """Give bodies with a text, number or name that JSON or programs cannot hold.

    Each comes with the codes with which a server may refuse it.
    """
    if operation_id not in _PLACES:
        return
    kinds = (_UNHELD_TEXTS, _INVALID_TEXTS), (_UNHELD_NUMBERS, _INVALID_NUMBERS)
    for (pointer, codes), (unheld, invalid) in zip(
        _PLACES[operation_id], kinds, strict=True
    ):
        whole = json.dumps(replace_at(how["json"], pointer, "HERE")).encode()
        for wrong in unheld:
            yield whole.replace(b'"HERE"', wrong), codes
        for wrong in invalid:
            yield whole.replace(b'"HERE"', wrong), _ALONE
    whole = json.dumps(how["json"]).encode()
    for wrong in _UNHELD_TEXTS:
        yield b"{" + wrong + b": 1, " + whole[1:], _NAME_CODES
    for wrong in _INVALID_TEXTS:
        yield b"{" + wrong + b": 1, " + whole[1:], _ALONE
