# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from datetime import datetime
from pydantic import BaseModel, ConfigDict, Field, StrictBool, StrictStr, field_validator
from typing import Any, ClassVar, Dict, List, Optional
from typing_extensions import Annotated
from proctor_client.models.entry_flag import EntryFlag
from proctor_client.models.entry_score import EntryScore
from proctor_client.models.policy_info import PolicyInfo
from proctor_client.models.selection_view import SelectionView
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class BoardEntry(BaseModel):
    """
    BoardEntry
    """ # noqa: E501
    entry_id: StrictStr
    run_id: StrictStr
    submitter: StrictStr = Field(description="Name of the account that submitted the run.")
    benchmark_id: StrictStr
    benchmark_version: StrictStr
    manifest_sha256: Annotated[str, Field(strict=True)] = Field(description="The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.")
    select: Optional[SelectionView] = None
    policy: PolicyInfo
    model_name: StrictStr
    is_public: StrictBool
    model_type: Optional[StrictStr] = None
    organisation: Optional[StrictStr] = None
    homepage: Optional[StrictStr] = None
    code_url: Optional[StrictStr] = None
    notes: Optional[StrictStr] = None
    state: Annotated[str, Field(strict=True)]
    flag: Optional[EntryFlag] = None
    level: Annotated[str, Field(strict=True)] = Field(description="What is known of the score: `reported` by the server alone; `signed`, for the run has a record that this host signs.")
    attempts: Annotated[int, Field(strict=True, ge=1)] = Field(description="How many runs of the benchmark the account has submitted until now, published or not.")
    score: EntryScore
    published_at: datetime
    changed_at: datetime = Field(description="When the description, the state or the flag changed for the last time.")
    additional_properties: Dict[str, Any] = {}
    __properties: ClassVar[List[str]] = ["entry_id", "run_id", "submitter", "benchmark_id", "benchmark_version", "manifest_sha256", "select", "policy", "model_name", "is_public", "model_type", "organisation", "homepage", "code_url", "notes", "state", "flag", "level", "attempts", "score", "published_at", "changed_at"]

    @field_validator('manifest_sha256', mode="before")
    def manifest_sha256_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if isinstance(value, str) and not re.match(r"^[0-9a-f]{64}$", value):
            raise ValueError(r"must validate the regular expression /^[0-9a-f]{64}$/")
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
        """Create an instance of BoardEntry from a JSON string"""
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
        # override the default output from pydantic by calling `to_dict()` of select
        if self.select:
            _dict['select'] = self.select.to_dict()
        # override the default output from pydantic by calling `to_dict()` of policy
        if self.policy:
            _dict['policy'] = self.policy.to_dict()
        # override the default output from pydantic by calling `to_dict()` of flag
        if self.flag:
            _dict['flag'] = self.flag.to_dict()
        # override the default output from pydantic by calling `to_dict()` of score
        if self.score:
            _dict['score'] = self.score.to_dict()
        # puts key-value pairs in additional_properties in the top level
        if self.additional_properties is not None:
            for _key, _value in self.additional_properties.items():
                _dict[_key] = _value

        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of BoardEntry from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "entry_id": obj.get("entry_id"),
            "run_id": obj.get("run_id"),
            "submitter": obj.get("submitter"),
            "benchmark_id": obj.get("benchmark_id"),
            "benchmark_version": obj.get("benchmark_version"),
            "manifest_sha256": obj.get("manifest_sha256"),
            "select": SelectionView.from_dict(obj["select"]) if obj.get("select") is not None else None,
            "policy": PolicyInfo.from_dict(obj["policy"]) if obj.get("policy") is not None else None,
            "model_name": obj.get("model_name"),
            "is_public": obj.get("is_public"),
            "model_type": obj.get("model_type"),
            "organisation": obj.get("organisation"),
            "homepage": obj.get("homepage"),
            "code_url": obj.get("code_url"),
            "notes": obj.get("notes"),
            "state": obj.get("state"),
            "flag": EntryFlag.from_dict(obj["flag"]) if obj.get("flag") is not None else None,
            "level": obj.get("level"),
            "attempts": obj.get("attempts"),
            "score": EntryScore.from_dict(obj["score"]) if obj.get("score") is not None else None,
            "published_at": obj.get("published_at"),
            "changed_at": obj.get("changed_at")
        })
        # store additional fields in additional_properties
        for _key in obj.keys():
            if _key not in cls.__properties:
                _obj.additional_properties[_key] = obj.get(_key)

        return _obj
