# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from pydantic import BaseModel, ConfigDict, Field, StrictBool, StrictFloat, StrictInt, StrictStr
from typing import Any, ClassVar, Dict, List, Optional, Union
from typing_extensions import Annotated
from proctor_client.models.compared_task import ComparedTask
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class ComparedRun(BaseModel):
    """
    One run beside the baseline. A pair is an episode that both have scored.
    """ # noqa: E501
    run_id: StrictStr
    complete: StrictBool = Field(description="Both runs have scored every episode.")
    release: StrictBool = Field(description="Complete, and no difference, over all episodes or over those of a task, is beyond the tolerance.")
    paired: Annotated[int, Field(strict=True, ge=0)] = Field(description="Number of pairs.")
    baseline_mean: Optional[Union[StrictFloat, StrictInt]] = Field(description="Mean score of the baseline over the pairs.")
    mean: Optional[Union[StrictFloat, StrictInt]] = Field(description="Mean score of the run over the pairs.")
    difference: Optional[Union[StrictFloat, StrictInt]] = Field(description="Baseline minus run: positive when the run is worse.")
    wins: Annotated[int, Field(strict=True, ge=0)] = Field(description="Pairs in which the run alone succeeds.")
    losses: Annotated[int, Field(strict=True, ge=0)] = Field(description="Pairs in which the baseline alone succeeds.")
    ties: Annotated[int, Field(strict=True, ge=0)] = Field(description="Pairs in which both succeed or neither does.")
    p_value: Union[Annotated[float, Field(le=1, strict=True, ge=0)], Annotated[int, Field(le=1, strict=True, ge=0)]] = Field(description="McNemar's exact test, two-sided.")
    by_task: Dict[str, ComparedTask] = Field(description="Task → the pairs of its episodes.")
    additional_properties: Dict[str, Any] = {}
    __properties: ClassVar[List[str]] = ["run_id", "complete", "release", "paired", "baseline_mean", "mean", "difference", "wins", "losses", "ties", "p_value", "by_task"]

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
        """Create an instance of ComparedRun from a JSON string"""
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
        # override the default output from pydantic by calling `to_dict()` of each value in by_task (dict)
        _field_dict = {}
        if self.by_task:
            for _key_by_task in self.by_task:
                _field_dict[_key_by_task] = self.by_task[_key_by_task].to_dict() if self.by_task[_key_by_task] is not None else None
            _dict['by_task'] = _field_dict
        # puts key-value pairs in additional_properties in the top level
        if self.additional_properties is not None:
            for _key, _value in self.additional_properties.items():
                _dict[_key] = _value

        # set to None if baseline_mean (nullable) is None
        # and model_fields_set contains the field
        if self.baseline_mean is None and "baseline_mean" in self.model_fields_set:
            _dict['baseline_mean'] = None

        # set to None if mean (nullable) is None
        # and model_fields_set contains the field
        if self.mean is None and "mean" in self.model_fields_set:
            _dict['mean'] = None

        # set to None if difference (nullable) is None
        # and model_fields_set contains the field
        if self.difference is None and "difference" in self.model_fields_set:
            _dict['difference'] = None

        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of ComparedRun from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "run_id": obj.get("run_id"),
            "complete": obj.get("complete"),
            "release": obj.get("release"),
            "paired": obj.get("paired"),
            "baseline_mean": obj.get("baseline_mean"),
            "mean": obj.get("mean"),
            "difference": obj.get("difference"),
            "wins": obj.get("wins"),
            "losses": obj.get("losses"),
            "ties": obj.get("ties"),
            "p_value": obj.get("p_value"),
            "by_task": dict(
                (_k, ComparedTask.from_dict(_v))
                for _k, _v in obj["by_task"].items()
            )
            if obj.get("by_task") is not None
            else None
        })
        # store additional fields in additional_properties
        for _key in obj.keys():
            if _key not in cls.__properties:
                _obj.additional_properties[_key] = obj.get(_key)

        return _obj
