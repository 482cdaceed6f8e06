# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import json
from enum import Enum
from typing_extensions import Self


class EntryState(str, Enum):
    """
    EntryState
    """

    """
    allowed enum values
    """
    PUBLISHED = 'published'
    WITHDRAWN = 'withdrawn'

    @classmethod
    def from_json(cls, json_str: str) -> Self:
        """Create an instance of EntryState from a JSON string"""
        return cls(json.loads(json_str))
