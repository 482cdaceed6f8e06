# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from pydantic import BaseModel, ConfigDict, Field, field_validator
from typing import Any, ClassVar, Dict, List, Optional
from typing_extensions import Annotated
from proctor_client.models.replay_divergence import ReplayDivergence
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class RecordReplay(BaseModel):
    """
    As in a verdict (record.md); absent before the end of the replay, and where there is none.
    """ # noqa: E501
    result: Annotated[str, Field(strict=True)] = Field(description="`exact`, `outcome` or `diverged`.")
    episodes: Annotated[int, Field(strict=True, ge=1)]
    exact: Annotated[int, Field(strict=True, ge=0)]
    outcome: Annotated[int, Field(strict=True, ge=0)]
    diverged: Annotated[int, Field(strict=True, ge=0)]
    first_divergence: Optional[ReplayDivergence] = None
    additional_properties: Dict[str, Any] = {}
    __properties: ClassVar[List[str]] = ["result", "episodes", "exact", "outcome", "diverged", "first_divergence"]

    @field_validator('result', mode="before")
    def result_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if isinstance(value, str) and not re.match(r"^[a-z][a-z0-9_]{0,63}$", value):
            raise ValueError(r"must validate the regular expression /^[a-z][a-z0-9_]{0,63}$/")
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
        """Create an instance of RecordReplay from a JSON string"""
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
        # override the default output from pydantic by calling `to_dict()` of first_divergence
        if self.first_divergence:
            _dict['first_divergence'] = self.first_divergence.to_dict()
        # puts key-value pairs in additional_properties in the top level
        if self.additional_properties is not None:
            for _key, _value in self.additional_properties.items():
                _dict[_key] = _value

        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of RecordReplay from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "result": obj.get("result"),
            "episodes": obj.get("episodes"),
            "exact": obj.get("exact"),
            "outcome": obj.get("outcome"),
            "diverged": obj.get("diverged"),
            "first_divergence": ReplayDivergence.from_dict(obj["first_divergence"]) if obj.get("first_divergence") is not None else None
        })
        # store additional fields in additional_properties
        for _key in obj.keys():
            if _key not in cls.__properties:
                _obj.additional_properties[_key] = obj.get(_key)

        return _obj
