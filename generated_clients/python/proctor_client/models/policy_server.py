# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from pydantic import BaseModel, ConfigDict, Field, StrictFloat, StrictInt, field_validator
from typing import Any, ClassVar, Dict, List, Optional, Union
from typing_extensions import Annotated
from proctor_client.models.policy_protocol import PolicyProtocol
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class PolicyServer(BaseModel):
    """
    Where the server finds the policy of a run with mode `push`, and how it calls it.
    """ # noqa: E501
    url: Annotated[str, Field(strict=True, max_length=500)] = Field(description="Base URL, without user, query or fragment; the path of an operation is appended to it.")
    protocol: PolicyProtocol
    api_key: Optional[Annotated[str, Field(min_length=1, strict=True, max_length=4096)]] = Field(default=None, description="Sent as bearer token with every call, and never shown.")
    model: Optional[Annotated[str, Field(min_length=1, strict=True, max_length=200)]] = Field(default=None, description="Which model is asked, where a protocol knows several.")
    call_timeout_s: Optional[Union[Annotated[float, Field(le=600, strict=True, ge=0.1)], Annotated[int, Field(le=600, strict=True, ge=1)]]] = Field(default=None, description="Time for one call, from connecting to the last byte of its answer; 30 when absent.")
    max_concurrent: Optional[Annotated[int, Field(le=1024, strict=True, ge=1)]] = Field(default=None, description="Most episodes played and calls made at a time; as many as the policy, the run and the server allow when absent.")
    max_retries: Optional[Annotated[int, Field(le=10, strict=True, ge=0)]] = Field(default=None, description="How often a call that was not answered is repeated; 3 when absent.")
    generation: Optional[Dict[str, Union[StrictFloat, StrictInt]]] = Field(default=None, description="Numbers that a chat completion is asked with, such as `temperature` and `max_tokens`; for `openai_chat` and `openai_completions` alone.")
    __properties: ClassVar[List[str]] = ["url", "protocol", "api_key", "model", "call_timeout_s", "max_concurrent", "max_retries", "generation"]

    @field_validator('url', mode="before")
    def url_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if isinstance(value, str) and not re.match(r"^https?:\/\/[A-Za-z0-9.:_\[\]-]+(\/[A-Za-z0-9._~%\/-]*)?$", value):
            raise ValueError(r"must validate the regular expression /^https?:\/\/[A-Za-z0-9.:_\[\]-]+(\/[A-Za-z0-9._~%\/-]*)?$/")
        return value

    @field_validator('api_key', mode="before")
    def api_key_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if value is None:
            return value

        if isinstance(value, str) and not re.match(r"^[!-~]+$", value):
            raise ValueError(r"must validate the regular expression /^[!-~]+$/")
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
        """Create an instance of PolicyServer from a JSON string"""
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
        """Create an instance of PolicyServer from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "url": obj.get("url"),
            "protocol": obj.get("protocol"),
            "api_key": obj.get("api_key"),
            "model": obj.get("model"),
            "call_timeout_s": obj.get("call_timeout_s"),
            "max_concurrent": obj.get("max_concurrent"),
            "max_retries": obj.get("max_retries"),
            "generation": obj.get("generation")
        })
        return _obj
