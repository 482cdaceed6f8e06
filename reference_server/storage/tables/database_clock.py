"""The clock of the database, in SQL: it alone says which nodes live."""

from __future__ import annotations

from typing import Any

import sqlalchemy as sa
from sqlalchemy.ext.compiler import compiles
from sqlalchemy.sql.functions import FunctionElement

from reference_server.storage.tables.database_tables import nodes


class Now(FunctionElement[float]):
    """Seconds since 1970 by the clock of the database, when it is evaluated."""

    type = sa.Float()
    inherit_cache = True


@compiles(Now)
def _now_of_postgresql(_element: Now, _compiler: Any, **_: Any) -> str:
    return "extract(epoch from clock_timestamp())"


@compiles(Now, "sqlite")
def _now_of_sqlite(_element: Now, _compiler: Any, **_: Any) -> str:
    return "((julianday('now') - 2440587.5) * 86400.0)"


# Since a node renewed its lease. A clock that was set back would let a dead node live
# on for as long.
silent_s = sa.func.abs(Now() - nodes.c.renewed_at, type_=sa.Float())
