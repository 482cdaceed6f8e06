"""What is wrong with settings, in sentences for the person who wrote them."""

from __future__ import annotations

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from reference_server.settings.server_settings import Settings

VALUE_CHARS_MAX = 80


def describe_faults(error: ValidationError) -> str:
    """One line: each fault with the name of its setting, or those that contradict."""
    return "; ".join(map(_describe, error.errors(include_url=False)))


def _describe(fault: ErrorDetails) -> str:
    context = fault.get("ctx", {})
    if fault["type"] == "value_error":
        text = str(context["error"])
    elif fault["type"] == "string_pattern_mismatch":
        text = f"{_shown(fault['input'])} does not fit"
        field = Settings.model_fields.get(str(fault["loc"][0]))
        if field is not None:
            text += f"; it stands for: {field.description}"
    else:
        wrong = fault["msg"].partition(", unable to parse")[0]
        text = wrong.replace("Input should be", f"{_shown(fault['input'])} must be")
    names = ".".join(map(str, fault["loc"]))
    # A fault between settings has no place; its text names all of them.
    return f"{names}: {text}" if names else text


def _shown(value: object) -> str:
    text = repr(value)
    return text if len(text) <= VALUE_CHARS_MAX else f"{text[:VALUE_CHARS_MAX]}…"
