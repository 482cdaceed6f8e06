"""Alembic runs this for each command, to upgrade in the transaction it is given."""

from alembic import context

from reference_server.storage.tables.database_tables import TABLES

context.configure(
    connection=context.config.attributes["connection"],
    target_metadata=TABLES,
    render_as_batch=True,  # SQLite changes a column by copying the table
)
with context.begin_transaction():
    context.run_migrations()
