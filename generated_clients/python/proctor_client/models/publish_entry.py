# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from pydantic import BaseModel, ConfigDict, Field, StrictBool, field_validator
from typing import Any, ClassVar, Dict, List, Optional
from typing_extensions import Annotated
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class PublishEntry(BaseModel):
    """
    What an entry says of itself; a member that is absent is not shown.
    """ # noqa: E501
    model_name: Annotated[str, Field(min_length=1, strict=True, max_length=200)]
    is_public: StrictBool = Field(description="Whether others see the entry, and whether it has a rank.")
    model_type: Optional[Annotated[str, Field(min_length=1, strict=True, max_length=64)]] = Field(default=None, description="What kind of model it is, for example `VLA` or `diffusion policy`.")
    organisation: Optional[Annotated[str, Field(min_length=1, strict=True, max_length=200)]] = None
    homepage: Optional[Annotated[str, Field(strict=True, max_length=500)]] = None
    code_url: Optional[Annotated[str, Field(strict=True, max_length=500)]] = None
    notes: Optional[Annotated[str, Field(strict=True, max_length=2000)]] = None
    __properties: ClassVar[List[str]] = ["model_name", "is_public", "model_type", "organisation", "homepage", "code_url", "notes"]

    @field_validator('homepage', mode="before")
    def homepage_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if value is None:
            return value

        if isinstance(value, str) and not re.match(r"^https?:\/\/[!-~]+$", value):
            raise ValueError(r"must validate the regular expression /^https?:\/\/[!-~]+$/")
        return value

    @field_validator('code_url', mode="before")
    def code_url_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if value is None:
            return value

        if isinstance(value, str) and not re.match(r"^https?:\/\/[!-~]+$", value):
            raise ValueError(r"must validate the regular expression /^https?:\/\/[!-~]+$/")
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
        """Create an instance of PublishEntry from a JSON string"""
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
        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of PublishEntry from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "model_name": obj.get("model_name"),
            "is_public": obj.get("is_public"),
            "model_type": obj.get("model_type"),
            "organisation": obj.get("organisation"),
            "homepage": obj.get("homepage"),
            "code_url": obj.get("code_url"),
            "notes": obj.get("notes")
        })
        return _obj
