# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from pydantic import BaseModel, ConfigDict, Field, field_validator
from typing import Any, ClassVar, Dict, List, Optional
from typing_extensions import Annotated
from proctor_client.models.board_entry import BoardEntry
from proctor_client.models.rank_interval import RankInterval
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class RankedEntry(BaseModel):
    """
    RankedEntry
    """ # noqa: E501
    entry: BoardEntry
    rank: Optional[RankInterval] = None
    better: Annotated[int, Field(strict=True, ge=0)] = Field(description="How many entries are significantly better; 0 without a rank.")
    worse: Annotated[int, Field(strict=True, ge=0)] = Field(description="How many entries are significantly worse; 0 without a rank.")
    letters: Annotated[List[Annotated[str, Field(strict=True)]], Field(max_length=100000)] = Field(description="Entries that cannot be distinguished have a letter in common, others have none in common; empty without a rank.")
    additional_properties: Dict[str, Any] = {}
    __properties: ClassVar[List[str]] = ["entry", "rank", "better", "worse", "letters"]

    model_config = ConfigDict(
        validate_by_name=True,
        validate_by_alias=True,
        validate_assignment=True,
        protected_namespaces=(),
    )


    def to_str(self) -> str:
        """Returns the string representation of the model using alias"""
        return pprint.pformat(self.model_dump(by_alias=True))

    def to_json(self) -> str:
        """Returns the JSON representation of the model using alias"""
        return json.dumps(to_jsonable_python(self.to_dict()))

    @classmethod
    def from_json(cls, json_str: str) -> Optional[Self]:
        """Create an instance of RankedEntry from a JSON string"""
        return cls.from_dict(json.loads(json_str))

    def to_dict(self) -> Dict[str, Any]:
        """Return the dictionary representation of the model using alias.

        This has the following differences from calling pydantic's
        `self.model_dump(by_alias=True)`:

        * `None` is only added to the output dict for nullable fields that
          were set at model initialization. Other fields with value `None`
          are ignored.
        * Fields in `self.additional_properties` are added to the output dict.
        """
        excluded_fields: Set[str] = set([
            "additional_properties",
        ])

        _dict = self.model_dump(
            by_alias=True,
            exclude=excluded_fields,
            exclude_none=True,
        )
        # override the default output from pydantic by calling `to_dict()` of entry
        if self.entry:
            _dict['entry'] = self.entry.to_dict()
        # override the default output from pydantic by calling `to_dict()` of rank
        if self.rank:
            _dict['rank'] = self.rank.to_dict()
        # puts key-value pairs in additional_properties in the top level
        if self.additional_properties is not None:
            for _key, _value in self.additional_properties.items():
                _dict[_key] = _value

        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of RankedEntry from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "entry": BoardEntry.from_dict(obj["entry"]) if obj.get("entry") is not None else None,
            "rank": RankInterval.from_dict(obj["rank"]) if obj.get("rank") is not None else None,
            "better": obj.get("better"),
            "worse": obj.get("worse"),
            "letters": obj.get("letters")
        })
        # store additional fields in additional_properties
        for _key in obj.keys():
            if _key not in cls.__properties:
                _obj.additional_properties[_key] = obj.get(_key)

        return _obj
