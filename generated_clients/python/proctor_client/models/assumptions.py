# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from pydantic import BaseModel, ConfigDict, Field
from typing import Any, ClassVar, Dict, List, Optional, Union
from typing_extensions import Annotated
from proctor_client.models.assumption import Assumption
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class Assumptions(BaseModel):
    """
    What the policy takes for granted; refused when the benchmark says otherwise (ATT-010).
    """ # noqa: E501
    control_rate_hz: Optional[Union[Annotated[float, Field(strict=True, ge=0)], Annotated[int, Field(strict=True, ge=0)]]] = None
    action: Optional[Dict[str, Assumption]] = None
    state: Optional[Dict[str, Assumption]] = None
    __properties: ClassVar[List[str]] = ["control_rate_hz", "action", "state"]

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
        """Create an instance of Assumptions from a JSON string"""
        return cls.from_dict(json.loads(json_str))

    def to_dict(self) -> Dict[str, Any]:
        """Return the dictionary representation of the model using alias.

        This has the following differences from calling pydantic's
        `self.model_dump(by_alias=True)`:

        * `None` is only added to the output dict for nullable fields that
          were set at model initialization. Other fields with value `None`
          are ignored.
        """
        excluded_fields: Set[str] = set([
        ])

        _dict = self.model_dump(
            by_alias=True,
            exclude=excluded_fields,
            exclude_none=True,
        )
        # override the default output from pydantic by calling `to_dict()` of each value in action (dict)
        _field_dict = {}
        if self.action:
            for _key_action in self.action:
                _field_dict[_key_action] = self.action[_key_action].to_dict() if self.action[_key_action] is not None else None
            _dict['action'] = _field_dict
        # override the default output from pydantic by calling `to_dict()` of each value in state (dict)
        _field_dict = {}
        if self.state:
            for _key_state in self.state:
                _field_dict[_key_state] = self.state[_key_state].to_dict() if self.state[_key_state] is not None else None
            _dict['state'] = _field_dict
        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of Assumptions from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "control_rate_hz": obj.get("control_rate_hz"),
            "action": dict(
                (_k, Assumption.from_dict(_v))
                for _k, _v in obj["action"].items()
            )
            if obj.get("action") is not None
            else None,
            "state": dict(
                (_k, Assumption.from_dict(_v))
                for _k, _v in obj["state"].items()
            )
            if obj.get("state") is not None
            else None
        })
        return _obj
