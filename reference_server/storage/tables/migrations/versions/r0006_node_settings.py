"""Adds the settings of each node, which the others compare with theirs."""

from __future__ import annotations

from alembic import op
from sqlalchemy import Column, Text

revision = "0006"
down_revision = "0005"


def upgrade() -> None:
    settings = Column("settings", Text, nullable=False, server_default="")
    op.add_column("nodes", settings)
