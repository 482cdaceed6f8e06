# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from pydantic import BaseModel, ConfigDict, Field, StrictBool, StrictFloat, StrictInt, StrictStr
from typing import Any, ClassVar, Dict, List, Optional, Union
from typing_extensions import Annotated
from proctor_client.models.episode_result import EpisodeResult
from proctor_client.models.episode_view import EpisodeView
from proctor_client.models.fault import Fault
from proctor_client.models.lease import Lease
from proctor_client.models.observation import Observation
from proctor_client.models.timing import Timing
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class Turn(BaseModel):
    """
    The answer to attach (seq 0) and to predict.
    """ # noqa: E501
    session_id: StrictStr
    seq: Annotated[int, Field(strict=True, ge=0)]
    episode: Optional[EpisodeView] = None
    observation: Optional[Observation] = None
    observations: Optional[Annotated[List[Observation], Field(max_length=65536)]] = Field(default=None, description="With `observe` all, one per executed action.")
    executed_steps: Annotated[int, Field(strict=True, ge=0)]
    stopped_early: StrictBool = Field(description="The episode ended before the chunk did.")
    rewards: Annotated[List[Union[StrictFloat, StrictInt]], Field(max_length=65536)] = Field(description="One per executed action.")
    terminated: StrictBool = Field(description="The task ended by itself in this turn.")
    truncated: StrictBool = Field(description="The step limit ended the episode in this turn.")
    episode_result: Optional[EpisodeResult] = None
    fault: Optional[Fault] = None
    done: StrictBool = Field(description="No episode is left for this session. It holds no slot any more; its last turn can be repeated until its lease ends.")
    lease: Lease
    timing: Timing
    additional_properties: Dict[str, Any] = {}
    __properties: ClassVar[List[str]] = ["session_id", "seq", "episode", "observation", "observations", "executed_steps", "stopped_early", "rewards", "terminated", "truncated", "episode_result", "fault", "done", "lease", "timing"]

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
        """Create an instance of Turn from a JSON string"""
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
        # override the default output from pydantic by calling `to_dict()` of episode
        if self.episode:
            _dict['episode'] = self.episode.to_dict()
        # override the default output from pydantic by calling `to_dict()` of observation
        if self.observation:
            _dict['observation'] = self.observation.to_dict()
        # override the default output from pydantic by calling `to_dict()` of each item in observations (list)
        _items = []
        if self.observations:
            for _item_observations in self.observations:
                _items.append(_item_observations.to_dict() if _item_observations is not None else None)
            _dict['observations'] = _items
        # override the default output from pydantic by calling `to_dict()` of episode_result
        if self.episode_result:
            _dict['episode_result'] = self.episode_result.to_dict()
        # override the default output from pydantic by calling `to_dict()` of fault
        if self.fault:
            _dict['fault'] = self.fault.to_dict()
        # override the default output from pydantic by calling `to_dict()` of lease
        if self.lease:
            _dict['lease'] = self.lease.to_dict()
        # override the default output from pydantic by calling `to_dict()` of timing
        if self.timing:
            _dict['timing'] = self.timing.to_dict()
        # puts key-value pairs in additional_properties in the top level
        if self.additional_properties is not None:
            for _key, _value in self.additional_properties.items():
                _dict[_key] = _value

        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of Turn from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "session_id": obj.get("session_id"),
            "seq": obj.get("seq"),
            "episode": EpisodeView.from_dict(obj["episode"]) if obj.get("episode") is not None else None,
            "observation": Observation.from_dict(obj["observation"]) if obj.get("observation") is not None else None,
            "observations": [Observation.from_dict(_item) for _item in obj["observations"]] if obj.get("observations") is not None else None,
            "executed_steps": obj.get("executed_steps"),
            "stopped_early": obj.get("stopped_early"),
            "rewards": obj.get("rewards"),
            "terminated": obj.get("terminated"),
            "truncated": obj.get("truncated"),
            "episode_result": EpisodeResult.from_dict(obj["episode_result"]) if obj.get("episode_result") is not None else None,
            "fault": Fault.from_dict(obj["fault"]) if obj.get("fault") is not None else None,
            "done": obj.get("done"),
            "lease": Lease.from_dict(obj["lease"]) if obj.get("lease") is not None else None,
            "timing": Timing.from_dict(obj["timing"]) if obj.get("timing") is not None else None
        })
        # store additional fields in additional_properties
        for _key in obj.keys():
            if _key not in cls.__properties:
                _obj.additional_properties[_key] = obj.get(_key)

        return _obj
