"""Several servers on one database: nodes, and the owners of runs with their fences."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op
from sqlalchemy import Column, Integer, String

revision = "0002"
down_revision = "0001"


def upgrade() -> None:
    op.add_column("runs", Column("owner", String(32)))
    op.add_column("runs", Column("fence", Integer))
    op.create_table(
        "nodes",
        Column("node_id", String(32), primary_key=True),
        Column("url", String(400), nullable=False),
        Column("secret", String(64), nullable=False),
        Column("renewed_at", sa.Float, nullable=False),
    )
    op.create_table(
        "accounts",
        Column("account", String(200), primary_key=True),
        Column("counted", sa.BigInteger, nullable=False),
    )
