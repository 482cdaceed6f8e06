# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from pydantic import BaseModel, ConfigDict, Field, StrictFloat, StrictInt
from typing import Any, ClassVar, Dict, List, Optional, Union
from proctor_client.models.group_score import GroupScore
from proctor_client.models.interval import Interval
from proctor_client.models.outcome_counts import OutcomeCounts
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class EntryScore(BaseModel):
    """
    Of the `get_score` of the run.
    """ # noqa: E501
    score: Union[StrictFloat, StrictInt]
    success_rate: Union[StrictFloat, StrictInt]
    success_interval: Interval
    mean_interval: Interval
    counts: OutcomeCounts
    by_task: Optional[Dict[str, GroupScore]] = Field(default=None, description="Absent where the server does not show it, such as for many tasks.")
    by_split: Optional[Dict[str, GroupScore]] = Field(default=None, description="Absent where the server does not show it, such as for many splits.")
    additional_properties: Dict[str, Any] = {}
    __properties: ClassVar[List[str]] = ["score", "success_rate", "success_interval", "mean_interval", "counts", "by_task", "by_split"]

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
        """Create an instance of EntryScore from a JSON string"""
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
        # override the default output from pydantic by calling `to_dict()` of success_interval
        if self.success_interval:
            _dict['success_interval'] = self.success_interval.to_dict()
        # override the default output from pydantic by calling `to_dict()` of mean_interval
        if self.mean_interval:
            _dict['mean_interval'] = self.mean_interval.to_dict()
        # override the default output from pydantic by calling `to_dict()` of counts
        if self.counts:
            _dict['counts'] = self.counts.to_dict()
        # override the default output from pydantic by calling `to_dict()` of each value in by_task (dict)
        _field_dict = {}
        if self.by_task:
            for _key_by_task in self.by_task:
                _field_dict[_key_by_task] = self.by_task[_key_by_task].to_dict() if self.by_task[_key_by_task] is not None else None
            _dict['by_task'] = _field_dict
        # override the default output from pydantic by calling `to_dict()` of each value in by_split (dict)
        _field_dict = {}
        if self.by_split:
            for _key_by_split in self.by_split:
                _field_dict[_key_by_split] = self.by_split[_key_by_split].to_dict() if self.by_split[_key_by_split] is not None else None
            _dict['by_split'] = _field_dict
        # puts key-value pairs in additional_properties in the top level
        if self.additional_properties is not None:
            for _key, _value in self.additional_properties.items():
                _dict[_key] = _value

        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of EntryScore from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "score": obj.get("score"),
            "success_rate": obj.get("success_rate"),
            "success_interval": Interval.from_dict(obj["success_interval"]) if obj.get("success_interval") is not None else None,
            "mean_interval": Interval.from_dict(obj["mean_interval"]) if obj.get("mean_interval") is not None else None,
            "counts": OutcomeCounts.from_dict(obj["counts"]) if obj.get("counts") is not None else None,
            "by_task": dict(
                (_k, GroupScore.from_dict(_v))
                for _k, _v in obj["by_task"].items()
            )
            if obj.get("by_task") is not None
            else None,
            "by_split": dict(
                (_k, GroupScore.from_dict(_v))
                for _k, _v in obj["by_split"].items()
            )
            if obj.get("by_split") is not None
            else None
        })
        # store additional fields in additional_properties
        for _key in obj.keys():
            if _key not in cls.__properties:
                _obj.additional_properties[_key] = obj.get(_key)

        return _obj
