# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from datetime import datetime
from pydantic import BaseModel, ConfigDict, Field, StrictFloat, StrictInt, StrictStr, field_validator
from typing import Any, ClassVar, Dict, List, Optional, Union
from typing_extensions import Annotated
from proctor_client.models.imported_policy import ImportedPolicy
from proctor_client.models.record_replay import RecordReplay
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class RecordImport(BaseModel):
    """
    A record that was handed in, and what is known of it here.
    """ # noqa: E501
    import_id: Annotated[str, Field(strict=True)]
    state: Annotated[str, Field(strict=True)] = Field(description="`waiting` for simulators, `replaying`, or `finished`.")
    level: Annotated[str, Field(strict=True)] = Field(description="`reported`: whole, by anyone; `signed` by a key that this server knows; `replayed` here with the same results; `diverged`: the replay came out otherwise.")
    level_text: StrictStr = Field(description="The level with who says it, as REC-031 has it.")
    signer: Optional[StrictStr] = Field(description="Whose key signed the record, as this server knows it; null for a key that it does not know.")
    keyid: StrictStr = Field(description="Of the key that signed the record.")
    archive_sha256: Annotated[str, Field(strict=True)]
    statement_sha256: Annotated[str, Field(strict=True)]
    size_bytes: Annotated[int, Field(strict=True, ge=1)]
    run_id: StrictStr = Field(description="In the statement, as are the members below it.")
    benchmark_id: StrictStr
    benchmark_version: StrictStr
    manifest_sha256: Annotated[str, Field(strict=True)]
    policy: ImportedPolicy
    score: Optional[Union[StrictFloat, StrictInt]] = Field(description="Null where an episode has no result.")
    episodes: Annotated[int, Field(strict=True, ge=1)]
    episodes_replayed: Annotated[int, Field(strict=True, ge=0)] = Field(description="How many of them were simulated so far.")
    replay: Optional[RecordReplay] = None
    reason: Optional[StrictStr] = Field(description="Why there is no replay.")
    imported_at: datetime
    finished_at: Optional[datetime]
    additional_properties: Dict[str, Any] = {}
    __properties: ClassVar[List[str]] = ["import_id", "state", "level", "level_text", "signer", "keyid", "archive_sha256", "statement_sha256", "size_bytes", "run_id", "benchmark_id", "benchmark_version", "manifest_sha256", "policy", "score", "episodes", "episodes_replayed", "replay", "reason", "imported_at", "finished_at"]

    @field_validator('import_id', mode="before")
    def import_id_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if isinstance(value, str) and not re.match(r"^[A-Za-z0-9_-]{1,64}$", value):
            raise ValueError(r"must validate the regular expression /^[A-Za-z0-9_-]{1,64}$/")
        return value

    @field_validator('state', mode="before")
    def state_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if isinstance(value, str) and not re.match(r"^[a-z][a-z0-9_]{0,63}$", value):
            raise ValueError(r"must validate the regular expression /^[a-z][a-z0-9_]{0,63}$/")
        return value

    @field_validator('level', mode="before")
    def level_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if isinstance(value, str) and not re.match(r"^[a-z][a-z0-9_]{0,63}$", value):
            raise ValueError(r"must validate the regular expression /^[a-z][a-z0-9_]{0,63}$/")
        return value

    @field_validator('archive_sha256', mode="before")
    def archive_sha256_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if isinstance(value, str) and not re.match(r"^[0-9a-f]{64}$", value):
            raise ValueError(r"must validate the regular expression /^[0-9a-f]{64}$/")
        return value

    @field_validator('statement_sha256', mode="before")
    def statement_sha256_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if isinstance(value, str) and not re.match(r"^[0-9a-f]{64}$", value):
            raise ValueError(r"must validate the regular expression /^[0-9a-f]{64}$/")
        return value

    @field_validator('manifest_sha256', mode="before")
    def manifest_sha256_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if isinstance(value, str) and not re.match(r"^[0-9a-f]{64}$", value):
            raise ValueError(r"must validate the regular expression /^[0-9a-f]{64}$/")
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
        """Create an instance of RecordImport from a JSON string"""
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
        # override the default output from pydantic by calling `to_dict()` of replay
        if self.replay:
            _dict['replay'] = self.replay.to_dict()
        # puts key-value pairs in additional_properties in the top level
        if self.additional_properties is not None:
            for _key, _value in self.additional_properties.items():
                _dict[_key] = _value

        # set to None if signer (nullable) is None
        # and model_fields_set contains the field
        if self.signer is None and "signer" in self.model_fields_set:
            _dict['signer'] = None

        # set to None if score (nullable) is None
        # and model_fields_set contains the field
        if self.score is None and "score" in self.model_fields_set:
            _dict['score'] = None

        # set to None if reason (nullable) is None
        # and model_fields_set contains the field
        if self.reason is None and "reason" in self.model_fields_set:
            _dict['reason'] = None

        # set to None if finished_at (nullable) is None
        # and model_fields_set contains the field
        if self.finished_at is None and "finished_at" in self.model_fields_set:
            _dict['finished_at'] = None

        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of RecordImport from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "import_id": obj.get("import_id"),
            "state": obj.get("state"),
            "level": obj.get("level"),
            "level_text": obj.get("level_text"),
            "signer": obj.get("signer"),
            "keyid": obj.get("keyid"),
            "archive_sha256": obj.get("archive_sha256"),
            "statement_sha256": obj.get("statement_sha256"),
            "size_bytes": obj.get("size_bytes"),
            "run_id": obj.get("run_id"),
            "benchmark_id": obj.get("benchmark_id"),
            "benchmark_version": obj.get("benchmark_version"),
            "manifest_sha256": obj.get("manifest_sha256"),
            "policy": ImportedPolicy.from_dict(obj["policy"]) if obj.get("policy") is not None else None,
            "score": obj.get("score"),
            "episodes": obj.get("episodes"),
            "episodes_replayed": obj.get("episodes_replayed"),
            "replay": RecordReplay.from_dict(obj["replay"]) if obj.get("replay") is not None else None,
            "reason": obj.get("reason"),
            "imported_at": obj.get("imported_at"),
            "finished_at": obj.get("finished_at")
        })
        # store additional fields in additional_properties
        for _key in obj.keys():
            if _key not in cls.__properties:
                _obj.additional_properties[_key] = obj.get(_key)

        return _obj
