"""Other legal spellings of a request: the table of spellings of http.md.

The same seed gives the same spelling.
"""

import json
import random
from typing import Any

from conformance.client.connections.kept_connection import BodyInTwoParts

_TYPE = "application/json"
CONTENT_TYPES = (
    *(_TYPE, "Application/JSON", f"{_TYPE};charset=utf-8", f"{_TYPE} ; charset=UTF-8"),
    *(f'{_TYPE}; charset="utf-8"', f"{_TYPE}\t;\tCharset=utf-8"),
)
ACCEPTED = (
    *(_TYPE, "APPLICATION/json", f"{_TYPE};q=0.5", f"{_TYPE} ; Q=1.000", "*/*"),
    *("application/*;q=0.001", f"text/html, {_TYPE}", f"text/html;q=1,,{_TYPE} ;q=0.1"),
    f"{_TYPE}, */*;q=0",
)
VERSIONS = ("1.0", "01.0", "1.0000")
# Refusal → the rule whose own check sends these spellings of its header.
RULES_OF_HEADERS = {
    "unsupported_media_type": ("ERR-007", "Content-Type"),
    "not_acceptable": ("ERR-008", "Accept"),
    "unsupported_version": ("VER-002", "Proctor-Version"),
}
_SPACES = ("", " ", "\n", "\t ", "\r\n")


def spell_request(
    seed: int, body: Any, headers: dict[str, str] | None
) -> tuple[bytes | None, dict[str, str]]:
    """Give the content and the headers of a request, spelled otherwise.

    body: what is sent as JSON; None for a request without a body.
    """
    chance = random.Random(seed)
    spelled = {"Accept": chance.choice(ACCEPTED), **(headers or {})}
    if chance.random() < 0.25:
        spelled["Proctor-Version"] = chance.choice(VERSIONS)
    if body is None:
        return None, spelled
    spelled["Content-Type"] = chance.choice(CONTENT_TYPES)
    content = _spell(body, chance).encode()
    inside = [at for at, byte in enumerate(content) if 0x80 <= byte < 0xC0]
    if chance.random() < 0.2:  # the second part begins inside of a letter, if it can
        cut = chance.choice(inside or range(1, len(content)))
        content = BodyInTwoParts.cut_at(cut, content)
    return content, spelled


def _spell(value: Any, chance: random.Random) -> str:
    """Write a value as JSON, with spaces, escapes and orders that are drawn."""
    before, after = chance.choice(_SPACES), chance.choice(_SPACES)
    return f"{before}{_spell_bare(value, chance)}{after}"


def _spell_bare(value: Any, chance: random.Random) -> str:
    if isinstance(value, dict):
        members = [
            f"{_spell(name, chance)}:{_spell(item, chance)}"
            for name, item in value.items()
        ]
        chance.shuffle(members)
        return f"{{{','.join(members)}}}"
    if isinstance(value, list):
        return f"[{','.join(_spell(item, chance) for item in value)}]"
    if isinstance(value, str):
        return f'"{"".join(_spell_letter(letter, chance) for letter in value)}"'
    if isinstance(value, float):
        return _spell_number(value, chance)
    return json.dumps(value)


def _spell_letter(letter: str, chance: random.Random) -> str:
    plain = json.dumps(letter, ensure_ascii=False)[1:-1]
    if chance.random() < 0.9:
        return plain
    if letter == "/":
        return "\\/"
    units = letter.encode("utf-16-be")
    pairs = [units[at : at + 2].hex() for at in range(0, len(units), 2)]
    return "".join(f"\\u{chance.choice((pair, pair.upper()))}" for pair in pairs)


def _spell_number(value: float, chance: random.Random) -> str:
    """Write a number; each spelling is read as the same double."""
    spellings = [repr(value), f"{value!r}0" if "e" not in repr(value) else repr(value)]
    mantissa, exponent = f"{value:.17e}".split("e")
    spellings += [f"{mantissa}e{int(exponent)}", f"{mantissa}E{int(exponent):+d}"]
    if value.is_integer() and abs(value) < 1e15:
        spellings.append(str(int(value)))
    return chance.choice([text for text in spellings if float(text) == value])
