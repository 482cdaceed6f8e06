# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import json
from enum import Enum
from typing_extensions import Self


class Observe(str, Enum):
    """
    `last` when absent; `all` adds the observation after every executed action.
    """

    """
    allowed enum values
    """
    LAST = 'last'
    ALL = 'all'

    @classmethod
    def from_json(cls, json_str: str) -> Self:
        """Create an instance of Observe from a JSON string"""
        return cls(json.loads(json_str))
