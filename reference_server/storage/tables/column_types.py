"""Types of columns, and numbers to compare with them, for every database."""

from __future__ import annotations

import sqlalchemy as sa


def any_number(given: int) -> sa.BindParameter[int]:
    """A caller's number, which may be larger than an INTEGER of PostgreSQL can be."""
    return sa.literal(given, sa.BigInteger)


class AnyText(sa.types.TypeDecorator[str]):
    """Text of others, which may have U+0000: PostgreSQL stores none in a text.

    There U+0000 is stored as backslash and zero, and a backslash as two.
    """

    impl = sa.Text
    cache_ok = True

    def process_bind_param(self, value: str | None, dialect: sa.Dialect) -> str | None:
        if value is None or dialect.name != "postgresql":
            return value
        return value.replace("\\", "\\\\").replace("\x00", "\\0")

    def process_result_value(
        self, value: str | None, dialect: sa.Dialect
    ) -> str | None:
        if value is None or dialect.name != "postgresql" or "\\" not in value:
            return value
        parts = (part.replace("\\0", "\x00") for part in value.split("\\\\"))
        return "\\".join(parts)
