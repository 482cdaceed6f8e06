"""Adds the table of values that must be equal on all nodes of a cluster."""

from __future__ import annotations

from alembic import op
from sqlalchemy import Column, String, Text

revision = "0003"
down_revision = "0002"


def upgrade() -> None:
    op.create_table(
        "cluster_facts",
        Column("name", String(32), primary_key=True),
        Column("value", Text, nullable=False),
    )
