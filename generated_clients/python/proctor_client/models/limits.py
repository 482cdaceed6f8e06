# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from pydantic import BaseModel, ConfigDict, Field, StrictFloat, StrictInt
from typing import Any, ClassVar, Dict, List, Optional, Union
from typing_extensions import Annotated
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class Limits(BaseModel):
    """
    Limits
    """ # noqa: E501
    max_body_bytes: Annotated[int, Field(strict=True, ge=65536)] = Field(description="Longest request body that is read.")
    max_workers: Annotated[int, Field(strict=True, ge=1)] = Field(description="Most live workers a run may ask for.")
    max_chunk: Annotated[int, Field(strict=True, ge=4)] = Field(description="Most actions in one predict; a benchmark may allow fewer.")
    idle_timeout_s_min: Union[StrictFloat, StrictInt]
    idle_timeout_s_max: Union[StrictFloat, StrictInt]
    wait_s_max: StrictInt = Field(description="Longest wait that a long-poll is granted.")
    max_header_bytes: Optional[Annotated[int, Field(strict=True, ge=8192)]] = Field(default=None, description="Longest request line with its headers that is read; for the profile `limits`.")
    header_timeout_s: Optional[Union[Annotated[float, Field(strict=True, ge=0)], Annotated[int, Field(strict=True, ge=0)]]] = Field(default=None, description="Time in which the headers of a request are complete, from its first byte; for the profile `limits`.")
    body_timeout_s: Optional[Union[Annotated[float, Field(strict=True, ge=0)], Annotated[int, Field(strict=True, ge=0)]]] = Field(default=None, description="Time in which a part of a body arrives after the headers of its request; for the profile `limits`.")
    heartbeat_s_max: Optional[Union[Annotated[float, Field(strict=True, ge=1)], Annotated[int, Field(strict=True, ge=1)]]] = Field(default=None, description="Longest time that a session lives without a new turn, whatever its `idle_timeout_s`; for the profile `limits`.")
    unused_s_max: Optional[Union[Annotated[float, Field(strict=True, ge=0)], Annotated[int, Field(strict=True, ge=0)]]] = Field(default=None, description="When others wait: the time after which a run without a worker, or a session without a turn, may make room; for the profile `limits`.")
    max_control_body_bytes: Optional[Annotated[int, Field(strict=True, ge=65536)]] = Field(default=None, description="Longest body that is read of a request other than `predict`, where it is less than `max_body_bytes`; for the profile `limits`.")
    max_open_runs: Optional[Annotated[int, Field(strict=True, ge=1)]] = Field(default=None, description="Most runs of one account that are queued, ready, running or stopping; for the profile `limits`.")
    max_idempotency_keys: Optional[Annotated[int, Field(strict=True, ge=1)]] = Field(default=None, description="Most Idempotency-Keys that one account may use; for the profile `limits`.")
    max_stored_bytes: Optional[Annotated[int, Field(strict=True, ge=1)]] = Field(default=None, description="Most bytes that the submissions of one account may have together; what else a server stores for a run may count, too. For the profile `limits`.")
    max_record_bytes: Optional[Annotated[int, Field(strict=True, ge=65536)]] = Field(default=None, description="Longest archive that `import_record` reads; for the profile `record_import`.")
    max_waiting_imports: Optional[Annotated[int, Field(strict=True, ge=1)]] = Field(default=None, description="Most imports of one account that are not `finished`; for the profile `record_import`.")
    max_imported_bytes: Optional[Annotated[int, Field(strict=True, ge=65536)]] = Field(default=None, description="Most bytes that the archives of one account may have together; for the profile `record_import`.")
    run_keep_days: Optional[Union[Annotated[float, Field(strict=True, ge=0)], Annotated[int, Field(strict=True, ge=0)]]] = Field(default=None, description="Days without a change after which a run that has completed, failed or been stopped may be deleted; when absent, none is. For the profile `deletion`.")
    additional_properties: Dict[str, Any] = {}
    __properties: ClassVar[List[str]] = ["max_body_bytes", "max_workers", "max_chunk", "idle_timeout_s_min", "idle_timeout_s_max", "wait_s_max", "max_header_bytes", "header_timeout_s", "body_timeout_s", "heartbeat_s_max", "unused_s_max", "max_control_body_bytes", "max_open_runs", "max_idempotency_keys", "max_stored_bytes", "max_record_bytes", "max_waiting_imports", "max_imported_bytes", "run_keep_days"]

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
        """Create an instance of Limits from a JSON string"""
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
        # puts key-value pairs in additional_properties in the top level
        if self.additional_properties is not None:
            for _key, _value in self.additional_properties.items():
                _dict[_key] = _value

        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of Limits from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "max_body_bytes": obj.get("max_body_bytes"),
            "max_workers": obj.get("max_workers"),
            "max_chunk": obj.get("max_chunk"),
            "idle_timeout_s_min": obj.get("idle_timeout_s_min"),
            "idle_timeout_s_max": obj.get("idle_timeout_s_max"),
            "wait_s_max": obj.get("wait_s_max"),
            "max_header_bytes": obj.get("max_header_bytes"),
            "header_timeout_s": obj.get("header_timeout_s"),
            "body_timeout_s": obj.get("body_timeout_s"),
            "heartbeat_s_max": obj.get("heartbeat_s_max"),
            "unused_s_max": obj.get("unused_s_max"),
            "max_control_body_bytes": obj.get("max_control_body_bytes"),
            "max_open_runs": obj.get("max_open_runs"),
            "max_idempotency_keys": obj.get("max_idempotency_keys"),
            "max_stored_bytes": obj.get("max_stored_bytes"),
            "max_record_bytes": obj.get("max_record_bytes"),
            "max_waiting_imports": obj.get("max_waiting_imports"),
            "max_imported_bytes": obj.get("max_imported_bytes"),
            "run_keep_days": obj.get("run_keep_days")
        })
        # store additional fields in additional_properties
        for _key in obj.keys():
            if _key not in cls.__properties:
                _obj.additional_properties[_key] = obj.get(_key)

        return _obj
