# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import json
from enum import Enum
from typing_extensions import Self


class RunMode(str, Enum):
    """
    `pull` when absent: workers attach and predict. `push`: the server calls the policy itself, and workers of the run are its own.
    """

    """
    allowed enum values
    """
    PULL = 'pull'
    PUSH = 'push'

    @classmethod
    def from_json(cls, json_str: str) -> Self:
        """Create an instance of RunMode from a JSON string"""
        return cls(json.loads(json_str))
