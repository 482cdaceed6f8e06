# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from pydantic import BaseModel, ConfigDict, Field
from typing import Any, ClassVar, Dict, List, Optional
from typing_extensions import Annotated
from proctor_client.models.action import Action
from proctor_client.models.observe import Observe
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class Predict(BaseModel):
    """
    Predict
    """ # noqa: E501
    session_id: Annotated[str, Field(min_length=1, strict=True, max_length=128)]
    seq: Annotated[int, Field(le=9007199254740991, strict=True, ge=1)]
    actions: Annotated[List[Action], Field(min_length=1, max_length=65536)]
    observe: Optional[Observe] = None
    __properties: ClassVar[List[str]] = ["session_id", "seq", "actions", "observe"]

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
        """Create an instance of Predict from a JSON string"""
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
        # override the default output from pydantic by calling `to_dict()` of each item in actions (list)
        _items = []
        if self.actions:
            for _item_actions in self.actions:
                _items.append(_item_actions.to_dict() if _item_actions is not None else None)
            _dict['actions'] = _items
        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of Predict from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "session_id": obj.get("session_id"),
            "seq": obj.get("seq"),
            "actions": [Action.from_dict(_item) for _item in obj["actions"]] if obj.get("actions") is not None else None,
            "observe": obj.get("observe")
        })
        return _obj
