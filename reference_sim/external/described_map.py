"""A map of a description, and the members of it that a server does not know.

Such a member is ignored, so that a later version of the protocol can have more. Most
often it is a mistyped one, and so each is named to the host.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import ClassVar

from pydantic import BaseModel, ConfigDict

from reference_record.command_line.spelling import ignored_member
from reference_sim.vector_spaces import is_extension


class DescribedMap(BaseModel):
    """others: members that are read elsewhere; None for a map that may have any."""

    model_config = ConfigDict(extra="allow", strict=True, frozen=True)
    others: ClassVar[tuple[str, ...] | None] = ("description",)

    def unknown_members(self, path: str = "") -> Iterator[str]:
        """Each one that is ignored: its path, and which was probably meant."""
        known = [*type(self).model_fields]
        if self.others is not None:
            known += [name for name in self.others if name not in known]
            for name in self.model_extra or ():
                if name not in known and not is_extension(name):
                    yield ignored_member(name, known, path)
        for name in type(self).model_fields:
            value = getattr(self, name)
            maps = value if isinstance(value, Mapping) else {"": value}
            for key, one in maps.items():
                if isinstance(one, DescribedMap):
                    yield from one.unknown_members(f"{path}{name}.{key and f'{key}.'}")
