# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from datetime import datetime
from pydantic import BaseModel, ConfigDict, Field, StrictBool, StrictFloat, StrictInt, StrictStr, field_validator
from typing import Any, ClassVar, Dict, List, Optional, Union
from typing_extensions import Annotated
from proctor_client.models.image_choice import ImageChoice
from proctor_client.models.policy_info import PolicyInfo
from proctor_client.models.policy_server_view import PolicyServerView
from proctor_client.models.progress import Progress
from proctor_client.models.run_state import RunState
from proctor_client.models.selection_view import SelectionView
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class Run(BaseModel):
    """
    Run
    """ # noqa: E501
    run_id: StrictStr
    state: RunState
    reason: Optional[StrictStr] = Field(description="Why the run is in this state, for people; never null when failed.")
    retryable: Optional[StrictBool] = Field(description="Whether a failed run may be resumed; null in other states.")
    benchmark_id: StrictStr
    benchmark_version: StrictStr
    manifest_sha256: Annotated[str, Field(strict=True)] = Field(description="The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.")
    policy: PolicyInfo
    mode: Optional[Annotated[str, Field(strict=True)]] = Field(default=None, description="A `RunMode`, or one of a later version; `pull` when absent.")
    policy_server: Optional[PolicyServerView] = None
    any_policy: Optional[StrictBool] = Field(default=None, description="Whether workers may play for another policy than `policy`; for the profile `attribution`.")
    select: Optional[SelectionView] = None
    max_workers: StrictInt
    idle_timeout_s: Union[StrictFloat, StrictInt]
    images: ImageChoice
    endpoint: StrictStr = Field(description="Base URL of the data plane for this run; the path of an operation is appended to it.")
    queue_position: Optional[StrictInt] = Field(description="1 is next; null unless queued.")
    live_workers: Annotated[int, Field(strict=True, ge=0)]
    progress: Progress
    created_at: datetime
    updated_at: datetime
    runs_played_before: Optional[Annotated[int, Field(strict=True, ge=0)]] = Field(default=None, description="In how many runs of this benchmark its submitter had executed an action before the first one of this run, whether they were deleted or not; absent before that action. For the profile `deletion`.")
    attempts_by_submitter: Optional[Annotated[int, Field(strict=True, ge=1)]] = Field(default=None, description="How many runs of this benchmark its submitter had submitted, this one included; for the profile `record`.")
    additional_properties: Dict[str, Any] = {}
    __properties: ClassVar[List[str]] = ["run_id", "state", "reason", "retryable", "benchmark_id", "benchmark_version", "manifest_sha256", "policy", "mode", "policy_server", "any_policy", "select", "max_workers", "idle_timeout_s", "images", "endpoint", "queue_position", "live_workers", "progress", "created_at", "updated_at", "runs_played_before", "attempts_by_submitter"]

    @field_validator('manifest_sha256', mode="before")
    def manifest_sha256_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if isinstance(value, str) and not re.match(r"^[0-9a-f]{64}$", value):
            raise ValueError(r"must validate the regular expression /^[0-9a-f]{64}$/")
        return value

    @field_validator('mode', mode="before")
    def mode_validate_regular_expression(cls, value):
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
        """Create an instance of Run from a JSON string"""
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
        # override the default output from pydantic by calling `to_dict()` of policy
        if self.policy:
            _dict['policy'] = self.policy.to_dict()
        # override the default output from pydantic by calling `to_dict()` of policy_server
        if self.policy_server:
            _dict['policy_server'] = self.policy_server.to_dict()
        # override the default output from pydantic by calling `to_dict()` of select
        if self.select:
            _dict['select'] = self.select.to_dict()
        # override the default output from pydantic by calling `to_dict()` of images
        if self.images:
            _dict['images'] = self.images.to_dict()
        # override the default output from pydantic by calling `to_dict()` of progress
        if self.progress:
            _dict['progress'] = self.progress.to_dict()
        # puts key-value pairs in additional_properties in the top level
        if self.additional_properties is not None:
            for _key, _value in self.additional_properties.items():
                _dict[_key] = _value

        # set to None if reason (nullable) is None
        # and model_fields_set contains the field
        if self.reason is None and "reason" in self.model_fields_set:
            _dict['reason'] = None

        # set to None if retryable (nullable) is None
        # and model_fields_set contains the field
        if self.retryable is None and "retryable" in self.model_fields_set:
            _dict['retryable'] = None

        # set to None if queue_position (nullable) is None
        # and model_fields_set contains the field
        if self.queue_position is None and "queue_position" in self.model_fields_set:
            _dict['queue_position'] = None

        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of Run from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "run_id": obj.get("run_id"),
            "state": obj.get("state"),
            "reason": obj.get("reason"),
            "retryable": obj.get("retryable"),
            "benchmark_id": obj.get("benchmark_id"),
            "benchmark_version": obj.get("benchmark_version"),
            "manifest_sha256": obj.get("manifest_sha256"),
            "policy": PolicyInfo.from_dict(obj["policy"]) if obj.get("policy") is not None else None,
            "mode": obj.get("mode"),
            "policy_server": PolicyServerView.from_dict(obj["policy_server"]) if obj.get("policy_server") is not None else None,
            "any_policy": obj.get("any_policy"),
            "select": SelectionView.from_dict(obj["select"]) if obj.get("select") is not None else None,
            "max_workers": obj.get("max_workers"),
            "idle_timeout_s": obj.get("idle_timeout_s"),
            "images": ImageChoice.from_dict(obj["images"]) if obj.get("images") is not None else None,
            "endpoint": obj.get("endpoint"),
            "queue_position": obj.get("queue_position"),
            "live_workers": obj.get("live_workers"),
            "progress": Progress.from_dict(obj["progress"]) if obj.get("progress") is not None else None,
            "created_at": obj.get("created_at"),
            "updated_at": obj.get("updated_at"),
            "runs_played_before": obj.get("runs_played_before"),
            "attempts_by_submitter": obj.get("attempts_by_submitter")
        })
        # store additional fields in additional_properties
        for _key in obj.keys():
            if _key not in cls.__properties:
                _obj.additional_properties[_key] = obj.get(_key)

        return _obj
