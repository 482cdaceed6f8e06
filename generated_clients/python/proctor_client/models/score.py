# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from pydantic import BaseModel, ConfigDict, Field, StrictBool, StrictFloat, StrictInt, StrictStr, field_validator
from typing import Any, ClassVar, Dict, List, Optional, Union
from typing_extensions import Annotated
from proctor_client.models.group_score import GroupScore
from proctor_client.models.interval import Interval
from proctor_client.models.outcome_counts import OutcomeCounts
from proctor_client.models.run_state import RunState
from proctor_client.models.selection_view import SelectionView
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class Score(BaseModel):
    """
    See scoring.md for every number here.
    """ # noqa: E501
    run_id: StrictStr
    benchmark_id: StrictStr
    manifest_sha256: Annotated[str, Field(strict=True)] = Field(description="The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.")
    select: Optional[SelectionView] = None
    state: RunState
    complete: StrictBool
    score: Optional[Union[StrictFloat, StrictInt]] = Field(description="Null until complete.")
    score_low: Union[StrictFloat, StrictInt]
    score_high: Union[StrictFloat, StrictInt]
    counts: OutcomeCounts
    success_rate: Optional[Union[StrictFloat, StrictInt]]
    success_interval: Interval
    mean: Optional[Union[StrictFloat, StrictInt]] = Field(description="Mean over the scored episodes.")
    mean_interval: Interval
    by_task: Dict[str, GroupScore]
    by_split: Dict[str, GroupScore]
    additional_properties: Dict[str, Any] = {}
    __properties: ClassVar[List[str]] = ["run_id", "benchmark_id", "manifest_sha256", "select", "state", "complete", "score", "score_low", "score_high", "counts", "success_rate", "success_interval", "mean", "mean_interval", "by_task", "by_split"]

    @field_validator('manifest_sha256', mode="before")
    def manifest_sha256_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if isinstance(value, str) and not re.match(r"^[0-9a-f]{64}$", value):
            raise ValueError(r"must validate the regular expression /^[0-9a-f]{64}$/")
        return value

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
        """Create an instance of Score from a JSON string"""
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
        # override the default output from pydantic by calling `to_dict()` of select
        if self.select:
            _dict['select'] = self.select.to_dict()
        # override the default output from pydantic by calling `to_dict()` of counts
        if self.counts:
            _dict['counts'] = self.counts.to_dict()
        # override the default output from pydantic by calling `to_dict()` of success_interval
        if self.success_interval:
            _dict['success_interval'] = self.success_interval.to_dict()
        # override the default output from pydantic by calling `to_dict()` of mean_interval
        if self.mean_interval:
            _dict['mean_interval'] = self.mean_interval.to_dict()
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

        # set to None if score (nullable) is None
        # and model_fields_set contains the field
        if self.score is None and "score" in self.model_fields_set:
            _dict['score'] = None

        # set to None if success_rate (nullable) is None
        # and model_fields_set contains the field
        if self.success_rate is None and "success_rate" in self.model_fields_set:
            _dict['success_rate'] = None

        # set to None if mean (nullable) is None
        # and model_fields_set contains the field
        if self.mean is None and "mean" in self.model_fields_set:
            _dict['mean'] = None

        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of Score from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "run_id": obj.get("run_id"),
            "benchmark_id": obj.get("benchmark_id"),
            "manifest_sha256": obj.get("manifest_sha256"),
            "select": SelectionView.from_dict(obj["select"]) if obj.get("select") is not None else None,
            "state": obj.get("state"),
            "complete": obj.get("complete"),
            "score": obj.get("score"),
            "score_low": obj.get("score_low"),
            "score_high": obj.get("score_high"),
            "counts": OutcomeCounts.from_dict(obj["counts"]) if obj.get("counts") is not None else None,
            "success_rate": obj.get("success_rate"),
            "success_interval": Interval.from_dict(obj["success_interval"]) if obj.get("success_interval") is not None else None,
            "mean": obj.get("mean"),
            "mean_interval": Interval.from_dict(obj["mean_interval"]) if obj.get("mean_interval") is not None else None,
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
