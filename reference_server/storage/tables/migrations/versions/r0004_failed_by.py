"""Adds to runs who made them fail."""

from __future__ import annotations

from alembic import op
from sqlalchemy import Column, String

revision = "0004"
down_revision = "0003"


def upgrade() -> None:
    op.add_column("runs", Column("failed_by", String(16)))
