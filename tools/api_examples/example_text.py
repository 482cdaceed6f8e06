"""Writes `components/examples` of a document of the specification.

Values are JSON that fills its lines; parts of them that only repeat others are left
out. It must not know how an example came about.
"""

import json
import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import yaml

WIDTH = 104  # of a line
STEP = 2  # of the indentation
# More tensors and benchmarks are of the same kind.
ENTRIES_MAX = {"tensors": 2, "benchmarks": 2}
DIGITS = 4  # of the seconds of `timing`
COMPARED_BELOW = 1000  # a number of bytes differs from time to time


def outdated(file: Path, examples: Mapping[str, Mapping[str, Any]]) -> list[str]:
    """Names of the examples of which a document shows another one, or none.

    Ids, times, digests and durations are not compared: they are new each time.
    """
    present = yaml.safe_load(file.read_text())["components"]["examples"]
    played = {name: shortened(example) for name, example in examples.items()}
    names = dict.fromkeys([*present, *played])
    return [n for n in names if outline(present.get(n)) != outline(played.get(n))]


def outline(value: Any) -> Any:
    """The value without random ids, texts with digits, and large numbers."""
    if isinstance(value, Mapping):
        return {key: outline(item) for key, item in value.items()}
    if isinstance(value, list):
        return [outline(item) for item in value]
    if isinstance(value, str):
        is_random = re.fullmatch(r"[\w-]{32}", value) or re.search(r"\d", value)
        return "" if is_random else value
    is_small = isinstance(value, int) and value < COMPARED_BELOW
    return value if value is None or is_small else 0


def write_examples(file: Path, examples: Mapping[str, Mapping[str, Any]]) -> None:
    """Replace the examples of a document, which has a place for them."""
    text = file.read_text()
    place = re.compile(r"^  examples:\n(?:    .*\n|\n(?=    ))+", re.MULTILINE)
    head = "  examples:\n    # One story, written by `python -m tools examples`.\n"
    written = "".join(_example(name, one) for name, one in examples.items())
    assert place.search(text), f"{file.name} has no `examples`"
    file.write_text(place.sub(lambda _: head + written, text, count=1))


def _example(name: str, example: Mapping[str, Any]) -> str:
    value = example["value"]
    if isinstance(value, str):  # a stream of events
        lines = "".join(f"        {line}\n" if line else "\n" for line in _lines(value))
        shown = f"|\n{lines}"
    else:
        shown = f"{flow(shortened(value), 13, 6 + STEP)}\n"
    summary = json.dumps(example["summary"], ensure_ascii=False)
    return f"    {name}:\n      summary: {summary}\n      value: {shown}"


def _lines(text: str) -> list[str]:
    return text.rstrip("\n").split("\n")


def shortened(value: Any, name: str = "") -> Any:
    """The value without what its reader has seen; it fits the same schema."""
    if isinstance(value, Mapping):
        kept = list(value.items())[: ENTRIES_MAX.get(name)]
        return {
            key: round(item, DIGITS) if name == "timing" else shortened(item, key)
            for key, item in kept
            if not (name == "score" and key in ("by_task", "by_split"))
        }
    if isinstance(value, list):
        return [shortened(item) for item in value[: ENTRIES_MAX.get(name)]]
    return value


def flow(value: Any, column: int, indent: int) -> str:
    """JSON in as few lines as its items allow.

    column: where it begins. indent: of its further lines.
    """
    if column + len(plain(value)) <= WIDTH or not isinstance(value, list | dict):
        return plain(value)
    is_object = isinstance(value, dict)
    named: Iterable[tuple[str, Any]] = (
        [(f"{json.dumps(key)}: ", item) for key, item in value.items()]
        if isinstance(value, dict)
        else [("", item) for item in value]
    )
    lines, at = [""], column + 1
    for key, item in named:
        written = key + plain(item)
        is_long = indent + len(written) + 1 > WIDTH
        if is_long or at + len(written) + 2 > WIDTH:
            lines.append("")
            at = indent
        if is_long:
            written = key + flow(item, indent + len(key), indent + STEP)
        lines[-1] += f" {written}," if lines[-1] else f"{written},"
        at = WIDTH if is_long else at + len(written) + 2
    body = f"\n{' ' * indent}".join(lines).removesuffix(",")
    return f"{{{body}}}" if is_object else f"[{body}]"


def plain(value: Any) -> str:
    """JSON in one line; what YAML would read as a text, such as 1e-05, has a point."""
    text = json.dumps(value, ensure_ascii=False)
    return re.sub(r"(?<=[\[ :])(-?\d)e-", r"\1.0e-", text)
