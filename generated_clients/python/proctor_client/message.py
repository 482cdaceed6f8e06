"""The base class of all messages: it reads and writes them.

Written by hand, beside what is generated from the specification.
"""

from typing import Any, Self

from pydantic import (
    BaseModel,
    ConfigDict,
    SerializerFunctionWrapHandler,
    model_serializer,
)


class Message(BaseModel):
    """A message of the protocol: a pydantic model with the names of the specification.

    Ranges and patterns are checked when a message is made or read; pydantic's
    ValidationError says what is wrong. A member that a later version of the protocol
    added is kept, see `additional_properties`. A member that is None is not sent,
    unless the specification lets it be null.
    """

    model_config = ConfigDict(
        # A class is built when it is first used: importing the client stays fast.
        defer_build=True,
        extra="allow",
        protected_namespaces=(),
        ser_json_inf_nan="constants",
        validate_assignment=True,
    )

    @classmethod
    def from_dict(cls, members: dict[str, Any]) -> Self:
        """The message with these members."""
        return cls.model_validate(members)

    @classmethod
    def from_json(cls, text: str | bytes) -> Self:
        """The message that the JSON text holds."""
        return cls.model_validate_json(text)

    def to_dict(self) -> dict[str, Any]:
        """The members that are sent; times are datetimes, and enumerations members."""
        return self.model_dump()

    def to_json(self) -> str:
        """The message as JSON text."""
        return self.model_dump_json()

    @property
    def additional_properties(self) -> dict[str, Any]:
        """The members that this version of the client does not know."""
        return self.model_extra or {}

    @model_serializer(mode="wrap")
    def _without_absent_members(
        self, write: SerializerFunctionWrapHandler
    ) -> dict[str, Any]:
        fields = type(self).model_fields
        return {
            name: value
            for name, value in write(self).items()
            if value is not None or name not in fields or fields[name].is_required()
        }
