# coding: utf-8

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


from __future__ import annotations
import pprint
import re  # noqa: F401
import json

from pydantic import BaseModel, ConfigDict, Field, StrictFloat, StrictInt, StrictStr, field_validator
from typing import Any, ClassVar, Dict, List, Optional, Union
from typing_extensions import Annotated
from proctor_client.models.ranked_entry import RankedEntry
from typing import Optional, Set
from typing_extensions import Self
from pydantic_core import to_jsonable_python

class Ranking(BaseModel):
    """
    See board.md for every number here.
    """ # noqa: E501
    benchmark_id: StrictStr
    manifest_sha256: Annotated[str, Field(strict=True)] = Field(description="The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.")
    episodes_total: Optional[StrictInt] = Field(description="How many episodes each entry has; null where the manifest has no entry.")
    ranked: Annotated[int, Field(strict=True, ge=0)] = Field(description="How many entries have a rank.")
    comparisons: Annotated[int, Field(strict=True, ge=0)] = Field(description="How many pairs of them were tested.")
    alpha: Union[StrictFloat, StrictInt] = Field(description="How likely it is at most that any two equally good policies are distinguished; 0.05.")
    differing_min: Optional[StrictInt] = Field(description="Two entries that differ on fewer episodes can never be distinguished; null if the benchmark has fewer episodes.")
    differing_enough: Optional[StrictInt] = Field(description="Two entries that differ on so many episodes, all to the advantage of one, are distinguished, however the others fared; null if the benchmark has fewer episodes.")
    rows: Annotated[List[RankedEntry], Field(max_length=1000)]
    next_cursor: Optional[Annotated[str, Field(strict=True)]]
    additional_properties: Dict[str, Any] = {}
    __properties: ClassVar[List[str]] = ["benchmark_id", "manifest_sha256", "episodes_total", "ranked", "comparisons", "alpha", "differing_min", "differing_enough", "rows", "next_cursor"]

    @field_validator('manifest_sha256', mode="before")
    def manifest_sha256_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if isinstance(value, str) and not re.match(r"^[0-9a-f]{64}$", value):
            raise ValueError(r"must validate the regular expression /^[0-9a-f]{64}$/")
        return value

    @field_validator('next_cursor', mode="before")
    def next_cursor_validate_regular_expression(cls, value):
        """Validates the regular expression"""
        if value is None:
            return value

        if isinstance(value, str) and not re.match(r"^[A-Za-z0-9_-]{1,128}$", value):
            raise ValueError(r"must validate the regular expression /^[A-Za-z0-9_-]{1,128}$/")
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
        """Create an instance of Ranking from a JSON string"""
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
        # override the default output from pydantic by calling `to_dict()` of each item in rows (list)
        _items = []
        if self.rows:
            for _item_rows in self.rows:
                _items.append(_item_rows.to_dict() if _item_rows is not None else None)
            _dict['rows'] = _items
        # puts key-value pairs in additional_properties in the top level
        if self.additional_properties is not None:
            for _key, _value in self.additional_properties.items():
                _dict[_key] = _value

        # set to None if episodes_total (nullable) is None
        # and model_fields_set contains the field
        if self.episodes_total is None and "episodes_total" in self.model_fields_set:
            _dict['episodes_total'] = None

        # set to None if differing_min (nullable) is None
        # and model_fields_set contains the field
        if self.differing_min is None and "differing_min" in self.model_fields_set:
            _dict['differing_min'] = None

        # set to None if differing_enough (nullable) is None
        # and model_fields_set contains the field
        if self.differing_enough is None and "differing_enough" in self.model_fields_set:
            _dict['differing_enough'] = None

        # set to None if next_cursor (nullable) is None
        # and model_fields_set contains the field
        if self.next_cursor is None and "next_cursor" in self.model_fields_set:
            _dict['next_cursor'] = None

        return _dict

    @classmethod
    def from_dict(cls, obj: Optional[Dict[str, Any]]) -> Optional[Self]:
        """Create an instance of Ranking from a dict"""
        if obj is None:
            return None

        if not isinstance(obj, dict):
            return cls.model_validate(obj)

        _obj = cls.model_validate({
            "benchmark_id": obj.get("benchmark_id"),
            "manifest_sha256": obj.get("manifest_sha256"),
            "episodes_total": obj.get("episodes_total"),
            "ranked": obj.get("ranked"),
            "comparisons": obj.get("comparisons"),
            "alpha": obj.get("alpha"),
            "differing_min": obj.get("differing_min"),
            "differing_enough": obj.get("differing_enough"),
            "rows": [RankedEntry.from_dict(_item) for _item in obj["rows"]] if obj.get("rows") is not None else None,
            "next_cursor": obj.get("next_cursor")
        })
        # store additional fields in additional_properties
        for _key in obj.keys():
            if _key not in cls.__properties:
                _obj.additional_properties[_key] = obj.get(_key)

        return _obj
