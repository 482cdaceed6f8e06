# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from pydantic import BaseModel, ConfigDict, Field, StrictFloat, StrictInt, StrictStr, field_validator
from typing import Any, ClassVar, Dict, List, Optional, Union
from typing_extensions import Annotated
from proctor_client.models.image_size import ImageSize
from proctor_client.models.observation_space import ObservationSpace
from proctor_client.models.simulator_info import SimulatorInfo
from proctor_client.models.vector_space import VectorSpace
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class Benchmark(BaseModel):
    """
    Everything about a benchmark that can change a score.
    """ # noqa: E501
    benchmark_id: StrictStr
    version: StrictStr
    title: StrictStr
    description: StrictStr
    manifest_sha256: Annotated[str, Field(strict=True)] = Field(description="The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.")
    episodes_total: Annotated[int, Field(strict=True, ge=1)]
    tasks: Annotated[List[StrictStr], Field(max_length=100000)]
    splits: Annotated[List[StrictStr], Field(max_length=100000)]
    sealed_splits: Optional[Annotated[List[StrictStr], Field(max_length=100000)]] = Field(default=None, description="Splits whose seeds the host draws in secret; none when absent.")
    seeds_sha256: Optional[Annotated[str, Field(strict=True)]] = Field(default=None, description="What the host commits itself to without showing it, the SHA-256 of a secret salt and the sealed seeds. With both disclosed later, anyone can prove which seeds were played.")
    control_rate_hz: Union[StrictFloat, StrictInt] = Field(description="Actions per simulated second.")
    max_steps: Annotated[int, Field(strict=True, ge=1)] = Field(description="Steps after which an episode is truncated.")
    max_chunk: Annotated[int, Field(strict=True, ge=1)]
    max_attempts: Annotated[int, Field(strict=True, ge=1)]
    max_faults: Annotated[int, Field(strict=True, ge=1)]
    success_rule: Annotated[str, Field(strict=True)] = Field(description="A `SuccessRule`, or one of a later version.")
    action_space: Dict[str, VectorSpace] = Field(description="Name of an action value → what it means.")
    observation_space: ObservationSpace
    image_sizes: Annotated[List[ImageSize], Field(max_length=1024)] = Field(description="Sizes that may be chosen at submit; the first is the default.")
    image_codecs: Annotated[List[Annotated[str, Field(strict=True)]], Field(max_length=256)] = Field(description="Codecs that may be chosen at submit; the first is the default.")
    simulator: SimulatorInfo
    unavailable_reason: Optional[StrictStr] = Field(description="Why a run cannot be submitted here now, and the cure; null when it can.")
    additional_properties: Dict[str, Any] = {}
    __properties: ClassVar[List[str]] = ["benchmark_id", "version", "title", "description", "manifest_sha256", "episodes_total", "tasks", "splits", "sealed_splits", "seeds_sha256", "control_rate_hz", "max_steps", "max_chunk", "max_attempts", "max_faults", "success_rule", "action_space", "observation_space", "image_sizes", "image_codecs", "simulator", "unavailable_reason"]

    @field_validator('manifest_sha256', mode="before")
    def manifest_sha256_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if isinstance(value, str) and not re.match(r"^[0-9a-f]{64}$", value):
            raise ValueError(r"must validate the regular expression /^[0-9a-f]{64}$/")
        return value

    @field_validator('seeds_sha256', mode="before")
    def seeds_sha256_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if value is None:
            return value

        if isinstance(value, str) and not re.match(r"^[0-9a-f]{64}$", value):
            raise ValueError(r"must validate the regular expression /^[0-9a-f]{64}$/")
        return value

    @field_validator('success_rule', mode="before")
    def success_rule_validate_regular_expression(cls, value):
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
        """Create an instance of Benchmark from a JSON string"""
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
        # override the default output from pydantic by calling `to_dict()` of each value in action_space (dict)
        _field_dict = {}
        if self.action_space:
            for _key_action_space in self.action_space:
                _field_dict[_key_action_space] = self.action_space[_key_action_space].to_dict() if self.action_space[_key_action_space] is not None else None
            _dict['action_space'] = _field_dict
        # override the default output from pydantic by calling `to_dict()` of observation_space
        if self.observation_space:
            _dict['observation_space'] = self.observation_space.to_dict()
        # override the default output from pydantic by calling `to_dict()` of each item in image_sizes (list)
        _items = []
        if self.image_sizes:
            for _item_image_sizes in self.image_sizes:
                _items.append(_item_image_sizes.to_dict() if _item_image_sizes is not None else None)
            _dict['image_sizes'] = _items
        # override the default output from pydantic by calling `to_dict()` of simulator
        if self.simulator:
            _dict['simulator'] = self.simulator.to_dict()
        # puts key-value pairs in additional_properties in the top level
        if self.additional_properties is not None:
            for _key, _value in self.additional_properties.items():
                _dict[_key] = _value

        # set to None if unavailable_reason (nullable) is None
        # and model_fields_set contains the field
        if self.unavailable_reason is None and "unavailable_reason" in self.model_fields_set:
            _dict['unavailable_reason'] = None

        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of Benchmark from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "benchmark_id": obj.get("benchmark_id"),
            "version": obj.get("version"),
            "title": obj.get("title"),
            "description": obj.get("description"),
            "manifest_sha256": obj.get("manifest_sha256"),
            "episodes_total": obj.get("episodes_total"),
            "tasks": obj.get("tasks"),
            "splits": obj.get("splits"),
            "sealed_splits": obj.get("sealed_splits"),
            "seeds_sha256": obj.get("seeds_sha256"),
            "control_rate_hz": obj.get("control_rate_hz"),
            "max_steps": obj.get("max_steps"),
            "max_chunk": obj.get("max_chunk"),
            "max_attempts": obj.get("max_attempts"),
            "max_faults": obj.get("max_faults"),
            "success_rule": obj.get("success_rule"),
            "action_space": dict(
                (_k, VectorSpace.from_dict(_v))
                for _k, _v in obj["action_space"].items()
            )
            if obj.get("action_space") is not None
            else None,
            "observation_space": ObservationSpace.from_dict(obj["observation_space"]) if obj.get("observation_space") is not None else None,
            "image_sizes": [ImageSize.from_dict(_item) for _item in obj["image_sizes"]] if obj.get("image_sizes") is not None else None,
            "image_codecs": obj.get("image_codecs"),
            "simulator": SimulatorInfo.from_dict(obj["simulator"]) if obj.get("simulator") is not None else None,
            "unavailable_reason": obj.get("unavailable_reason")
        })
        # store additional fields in additional_properties
        for _key in obj.keys():
            if _key not in cls.__properties:
                _obj.additional_properties[_key] = obj.get(_key)

        return _obj
