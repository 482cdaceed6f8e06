# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from pydantic import BaseModel, ConfigDict, Field, StrictBool, StrictStr, field_validator
from typing import Any, ClassVar, Dict, List, Optional
from typing_extensions import Annotated
from proctor_client.models.problem_item import ProblemItem
from proctor_client.models.run_state import RunState
from proctor_client.models.side_effects import SideEffects
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class Problem(BaseModel):
    """
    RFC 9457, with what a client needs to decide on a retry.
    """ # noqa: E501
    type: StrictStr
    title: StrictStr
    status: Annotated[int, Field(le=599, strict=True, ge=400)]
    detail: StrictStr = Field(description="What happened and what to do about it.")
    code: StrictStr = Field(description="One of x-problems, or one of a later version.")
    retryable: StrictBool = Field(description="Whether the same request can succeed later.")
    side_effects: SideEffects
    errors: Optional[Annotated[List[ProblemItem], Field(max_length=1000000)]] = None
    requirement: Optional[Annotated[str, Field(strict=True)]] = Field(default=None, description="Id of the rule that was enforced.")
    state: Optional[RunState] = None
    expected_seq: Optional[Annotated[int, Field(strict=True, ge=1)]] = None
    ended_by: Optional[Annotated[str, Field(strict=True)]] = Field(default=None, description="What ended the session, as far as the server still knows; `unknown` after a restart, and for a session that was taken over and whose successor has ended.")
    additional_properties: Dict[str, Any] = {}
    __properties: ClassVar[List[str]] = ["type", "title", "status", "detail", "code", "retryable", "side_effects", "errors", "requirement", "state", "expected_seq", "ended_by"]

    @field_validator('requirement', mode="before")
    def requirement_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if value is None:
            return value

        if isinstance(value, str) and not re.match(r"[A-Z]+-[0-9]+", value):
            raise ValueError(r"must validate the regular expression /[A-Z]+-[0-9]+/")
        return value

    @field_validator('ended_by', mode="before")
    def ended_by_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if value is None:
            return value

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
        """Create an instance of Problem from a JSON string"""
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
        # override the default output from pydantic by calling `to_dict()` of each item in errors (list)
        _items = []
        if self.errors:
            for _item_errors in self.errors:
                _items.append(_item_errors.to_dict() if _item_errors is not None else None)
            _dict['errors'] = _items
        # puts key-value pairs in additional_properties in the top level
        if self.additional_properties is not None:
            for _key, _value in self.additional_properties.items():
                _dict[_key] = _value

        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of Problem from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "type": obj.get("type"),
            "title": obj.get("title"),
            "status": obj.get("status"),
            "detail": obj.get("detail"),
            "code": obj.get("code"),
            "retryable": obj.get("retryable"),
            "side_effects": obj.get("side_effects"),
            "errors": [ProblemItem.from_dict(_item) for _item in obj["errors"]] if obj.get("errors") is not None else None,
            "requirement": obj.get("requirement"),
            "state": obj.get("state"),
            "expected_seq": obj.get("expected_seq"),
            "ended_by": obj.get("ended_by")
        })
        # store additional fields in additional_properties
        for _key in obj.keys():
            if _key not in cls.__properties:
                _obj.additional_properties[_key] = obj.get(_key)

        return _obj
