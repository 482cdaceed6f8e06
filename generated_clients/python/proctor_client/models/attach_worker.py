# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from pydantic import BaseModel, ConfigDict, Field, StrictBool
from typing import Any, ClassVar, Dict, List, Optional
from typing_extensions import Annotated
from proctor_client.models.assumptions import Assumptions
from proctor_client.models.player import Player
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class AttachWorker(BaseModel):
    """
    AttachWorker
    """ # noqa: E501
    attach_key: Annotated[str, Field(min_length=1, strict=True, max_length=128)] = Field(description="New for every attachment; repeated only to repeat a lost request.")
    takeover: Optional[StrictBool] = Field(default=None, description="Fence out a live session; false when absent.")
    assumes: Optional[Assumptions] = None
    player: Optional[Player] = None
    __properties: ClassVar[List[str]] = ["attach_key", "takeover", "assumes", "player"]

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
        """Create an instance of AttachWorker from a JSON string"""
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
        # override the default output from pydantic by calling `to_dict()` of assumes
        if self.assumes:
            _dict['assumes'] = self.assumes.to_dict()
        # override the default output from pydantic by calling `to_dict()` of player
        if self.player:
            _dict['player'] = self.player.to_dict()
        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of AttachWorker from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "attach_key": obj.get("attach_key"),
            "takeover": obj.get("takeover"),
            "assumes": Assumptions.from_dict(obj["assumes"]) if obj.get("assumes") is not None else None,
            "player": Player.from_dict(obj["player"]) if obj.get("player") is not None else None
        })
        return _obj
