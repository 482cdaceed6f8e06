# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import json
from enum import Enum
from typing_extensions import Self


class PolicyProtocol(str, Enum):
    """
    `proctor` is policy.yaml. `openai_chat` asks for a chat completion at `chat/completions` below the URL, for benchmarks that are answered in words. `openai_completions` asks for the completion of a text at `completions` below the URL, for such benchmarks without images.
    """

    """
    allowed enum values
    """
    PROCTOR = 'proctor'
    OPENAI_CHAT = 'openai_chat'
    OPENAI_COMPLETIONS = 'openai_completions'

    @classmethod
    def from_json(cls, json_str: str) -> Self:
        """Create an instance of PolicyProtocol from a JSON string"""
        return cls(json.loads(json_str))
