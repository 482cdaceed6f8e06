"""Adds why a worker has left an episode."""

from __future__ import annotations

from alembic import op
from sqlalchemy import Column, LargeBinary

revision = "0005"
down_revision = "0004"


def upgrade() -> None:
    op.add_column("episodes", Column("last_left", LargeBinary))
