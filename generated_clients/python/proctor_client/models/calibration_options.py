# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from pydantic import BaseModel, ConfigDict, Field, StrictBool
from typing import Any, ClassVar, Dict, List, Optional, Union
from typing_extensions import Annotated
from proctor_client.models.calibration_task import CalibrationTask
from proctor_client.models.success_rule import SuccessRule
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class CalibrationOptions(BaseModel):
    """
    Only for the benchmark `calibration`, which the submitter shapes.
    """ # noqa: E501
    tasks: Optional[Annotated[List[CalibrationTask], Field(min_length=1, max_length=1000)]] = Field(default=None, description="One entry per episode, in order; one `score` episode when absent.")
    max_steps: Optional[Annotated[int, Field(le=10000, strict=True, ge=1)]] = Field(default=None, description="10 when absent.")
    success_rule: Optional[SuccessRule] = None
    max_attempts: Optional[Annotated[int, Field(le=10, strict=True, ge=1)]] = Field(default=None, description="3 when absent.")
    max_faults: Optional[Annotated[int, Field(le=10, strict=True, ge=1)]] = Field(default=None, description="3 when absent.")
    sealed: Optional[StrictBool] = Field(default=None, description="Whether the seeds of the split `odd` are sealed; false when absent. Only for servers that announce the profile `sealed_seeds`.")
    queue_s: Optional[Union[Annotated[float, Field(le=10, strict=True, ge=0)], Annotated[int, Field(le=10, strict=True, ge=0)]]] = Field(default=None, description="Seconds for which the run stays queued after submit and after resume; 0 when absent.")
    __properties: ClassVar[List[str]] = ["tasks", "max_steps", "success_rule", "max_attempts", "max_faults", "sealed", "queue_s"]

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
        """Create an instance of CalibrationOptions from a JSON string"""
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
        """Create an instance of CalibrationOptions from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "tasks": obj.get("tasks"),
            "max_steps": obj.get("max_steps"),
            "success_rule": obj.get("success_rule"),
            "max_attempts": obj.get("max_attempts"),
            "max_faults": obj.get("max_faults"),
            "sealed": obj.get("sealed"),
            "queue_s": obj.get("queue_s")
        })
        return _obj
