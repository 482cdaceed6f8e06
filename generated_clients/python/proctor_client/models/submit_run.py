# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from pydantic import BaseModel, ConfigDict, Field, StrictBool, field_validator
from typing import Any, ClassVar, Dict, List, Optional, Union
from typing_extensions import Annotated
from proctor_client.models.calibration_options import CalibrationOptions
from proctor_client.models.episode_selection import EpisodeSelection
from proctor_client.models.image_choice import ImageChoice
from proctor_client.models.policy_info import PolicyInfo
from proctor_client.models.policy_server import PolicyServer
from proctor_client.models.run_mode import RunMode
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class SubmitRun(BaseModel):
    """
    SubmitRun
    """ # noqa: E501
    benchmark_id: Annotated[str, Field(strict=True)]
    policy: PolicyInfo
    max_workers: Optional[Annotated[int, Field(le=1024, strict=True, ge=1)]] = Field(default=None, description="Most live workers wanted; the server's limit when absent.")
    idle_timeout_s: Optional[Union[Annotated[float, Field(le=86400, strict=True, ge=1)], Annotated[int, Field(le=86400, strict=True, ge=1)]]] = Field(default=None, description="Lease of a session; the server's maximum when absent.")
    images: Optional[ImageChoice] = None
    options: Optional[CalibrationOptions] = None
    mode: Optional[RunMode] = None
    policy_server: Optional[PolicyServer] = None
    any_policy: Optional[StrictBool] = Field(default=None, description="Workers may play for another policy than `policy`; false when absent; for the profile `attribution`.")
    select: Optional[EpisodeSelection] = None
    __properties: ClassVar[List[str]] = ["benchmark_id", "policy", "max_workers", "idle_timeout_s", "images", "options", "mode", "policy_server", "any_policy", "select"]

    @field_validator('benchmark_id', mode="before")
    def benchmark_id_validate_regular_expression(cls, value):
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
        """Create an instance of SubmitRun from a JSON string"""
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
        # override the default output from pydantic by calling `to_dict()` of policy
        if self.policy:
            _dict['policy'] = self.policy.to_dict()
        # override the default output from pydantic by calling `to_dict()` of images
        if self.images:
            _dict['images'] = self.images.to_dict()
        # override the default output from pydantic by calling `to_dict()` of options
        if self.options:
            _dict['options'] = self.options.to_dict()
        # override the default output from pydantic by calling `to_dict()` of policy_server
        if self.policy_server:
            _dict['policy_server'] = self.policy_server.to_dict()
        # override the default output from pydantic by calling `to_dict()` of select
        if self.select:
            _dict['select'] = self.select.to_dict()
        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of SubmitRun from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "benchmark_id": obj.get("benchmark_id"),
            "policy": PolicyInfo.from_dict(obj["policy"]) if obj.get("policy") is not None else None,
            "max_workers": obj.get("max_workers"),
            "idle_timeout_s": obj.get("idle_timeout_s"),
            "images": ImageChoice.from_dict(obj["images"]) if obj.get("images") is not None else None,
            "options": CalibrationOptions.from_dict(obj["options"]) if obj.get("options") is not None else None,
            "mode": obj.get("mode"),
            "policy_server": PolicyServer.from_dict(obj["policy_server"]) if obj.get("policy_server") is not None else None,
            "any_policy": obj.get("any_policy"),
            "select": EpisodeSelection.from_dict(obj["select"]) if obj.get("select") is not None else None
        })
        return _obj
