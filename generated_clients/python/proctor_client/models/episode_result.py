# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from datetime import datetime
from pydantic import BaseModel, ConfigDict, Field, StrictBool, StrictFloat, StrictInt, StrictStr
from typing import Any, ClassVar, Dict, List, Optional, Union
from typing_extensions import Annotated
from proctor_client.models.outcome import Outcome
from proctor_client.models.player_view import PlayerView
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class EpisodeResult(BaseModel):
    """
    EpisodeResult
    """ # noqa: E501
    episode_id: StrictStr
    index: Annotated[int, Field(strict=True, ge=0)]
    task: StrictStr
    split: StrictStr
    seed: Optional[Annotated[int, Field(le=9007199254740991, strict=True, ge=0)]] = Field(default=None, description="Absent where `sealed_splits` of the benchmark names the split.")
    attempt: Annotated[int, Field(strict=True, ge=1)]
    faults: Annotated[int, Field(strict=True, ge=0)]
    outcome: Outcome
    score: Union[Annotated[float, Field(le=1, strict=True, ge=0)], Annotated[int, Field(le=1, strict=True, ge=0)]]
    steps: Annotated[int, Field(strict=True, ge=0)]
    terminated: StrictBool
    truncated: StrictBool
    think_s: Union[Annotated[float, Field(strict=True, ge=0)], Annotated[int, Field(strict=True, ge=0)]] = Field(description="Time between turns that the policy took.")
    finished_at: datetime
    player: Optional[PlayerView] = None
    clipped_actions: Optional[Annotated[int, Field(strict=True, ge=0)]] = Field(default=None, description="Actions of the attempt with a number outside of a range that is declared `clip`; for the profile `attribution`.")
    total_reward: Optional[Union[StrictFloat, StrictInt]] = Field(default=None, description="Sum of the rewards of the attempt, its return; for the profile `attribution`.")
    additional_properties: Dict[str, Any] = {}
    __properties: ClassVar[List[str]] = ["episode_id", "index", "task", "split", "seed", "attempt", "faults", "outcome", "score", "steps", "terminated", "truncated", "think_s", "finished_at", "player", "clipped_actions", "total_reward"]

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
        """Create an instance of EpisodeResult from a JSON string"""
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
        # override the default output from pydantic by calling `to_dict()` of player
        if self.player:
            _dict['player'] = self.player.to_dict()
        # puts key-value pairs in additional_properties in the top level
        if self.additional_properties is not None:
            for _key, _value in self.additional_properties.items():
                _dict[_key] = _value

        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of EpisodeResult from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "episode_id": obj.get("episode_id"),
            "index": obj.get("index"),
            "task": obj.get("task"),
            "split": obj.get("split"),
            "seed": obj.get("seed"),
            "attempt": obj.get("attempt"),
            "faults": obj.get("faults"),
            "outcome": obj.get("outcome"),
            "score": obj.get("score"),
            "steps": obj.get("steps"),
            "terminated": obj.get("terminated"),
            "truncated": obj.get("truncated"),
            "think_s": obj.get("think_s"),
            "finished_at": obj.get("finished_at"),
            "player": PlayerView.from_dict(obj["player"]) if obj.get("player") is not None else None,
            "clipped_actions": obj.get("clipped_actions"),
            "total_reward": obj.get("total_reward")
        })
        # store additional fields in additional_properties
        for _key in obj.keys():
            if _key not in cls.__properties:
                _obj.additional_properties[_key] = obj.get(_key)

        return _obj
