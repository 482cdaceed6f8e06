"""The values of the options of `proctor`, checked as far as no server is needed."""

from __future__ import annotations

import json
import re
from typing import Any

from reference_record.command_line.click_commands import checked

SIDE_MIN, SIDE_MAX = 16, 4096  # pixels of a video


@checked
def sha256(text: str) -> str:
    if not re.fullmatch("[0-9a-f]{64}", text):
        shown = text or "it is empty"
        raise ValueError(f"{shown}: expected a SHA-256, 64 digits of 0-9 and a-f")
    return text


@checked
def names(text: str) -> list[str]:
    listed = [name for part in text.split(",") if (name := part.strip())]
    if not listed:
        raise ValueError("expected names with commas between them")
    return listed


@checked
def size(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"(\d{2,4})x(\d{2,4})", text)
    width, height = map(int, match.groups()) if match else (0, 0)
    if not (min(width, height) >= SIDE_MIN and max(width, height) <= SIDE_MAX):
        raise ValueError(
            f"{text}: expected WIDTHxHEIGHT, for example 640x480, "
            f"each from {SIDE_MIN} to {SIDE_MAX}"
        )
    if width % 2 or height % 2:
        raise ValueError(f"{text}: a video has even sides")
    return width, height


@checked
def json_object(text: str) -> dict[str, Any]:
    try:
        value = json.loads(text)
    except json.JSONDecodeError as error:
        raise ValueError(
            f"invalid JSON at character {error.pos + 1}: {text}"
        ) from error
    if not isinstance(value, dict):
        raise ValueError("expected a JSON object")  # noqa: TRY004 - of a command line
    return value


@checked
def images(text: str) -> dict[str, Any]:
    match = re.fullmatch(r"([a-z]+):(\d{1,4})x(\d{1,4})", text)
    if match is None:
        raise ValueError(
            f"{text}: expected CODEC:WIDTHxHEIGHT, for example jpeg:224x224"
        )
    codec, width, height = match.groups()
    return {"codec": codec, "width": int(width), "height": int(height)}
