"""The growth of storage_growth.py, stored in PostgreSQL.

Databases of one PostgreSQL are filled with finished runs, a real server is started on
each, and the same requests are sent to them in turn. Nothing is forced to disk, as in
tests, so what writes costs less than it would: trust the ratios.
"""

import asyncio
import contextlib
import tempfile
from pathlib import Path

from benchmarks import measuring
from benchmarks.growth.filled_databases import (
    DatabaseCase,
    filling_statements,
    store_templates,
)
from benchmarks.growth.storage_growth import (
    DATABASE_CASES,
    ROUNDS,
    ROUNDS_TRIED,
    TimedRequests,
    compare_requests,
)
from benchmarks.measured_server import ServerProcess, running_server
from tests.support.server.postgresql_server import PostgresqlServer

TITLE = "Growth on PostgreSQL"
CASES = DATABASE_CASES[:3]
COLUMNS = (
    "SELECT column_name FROM information_schema.columns "
    "WHERE table_name = '{}' ORDER BY ordinal_position"
)
# Runs that the server adds come behind those that were copied.
GO_ON = "SELECT setval(pg_get_serial_sequence('runs', 'number'), max(number)) FROM runs"


def fill(postgresql: PostgresqlServer, database_case: DatabaseCase) -> str:
    """The URL of a new database with what the case says."""
    url = postgresql.create()
    name = url.partition("@/")[2].partition("?")[0]
    asyncio.run(store_templates(url, database_case.episodes))
    columns = {
        table: [row[0] for row in postgresql.execute(name, COLUMNS.format(table))]
        for table in ("runs", "episodes")
    }
    statements = filling_statements(database_case, columns)
    # As its own maintenance does after a while.
    postgresql.execute(name, *statements, "ANALYZE", GO_ON)
    return url


def _server(
    stack: contextlib.ExitStack, directory: Path, name: str, url: str
) -> ServerProcess:
    folder = directory / name
    folder.mkdir()
    files = {
        "PROCTOR_RECORDS_DIR": "records",
        "PROCTOR_SIGNING_KEY": "signing-key",
        "PROCTOR_SEALING_KEY": "key",
        "PROCTOR_SEED_SECRET": "seeds",
    }
    settings = {setting: str(folder / file) for setting, file in files.items()}
    return stack.enter_context(running_server(url, **settings))


def measure(*, trying: bool) -> str:
    """Send the requests to servers on three databases."""
    where = measuring.machine()
    with contextlib.ExitStack() as stack:
        directory = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        postgresql = stack.enter_context(PostgresqlServer())
        requests = [
            TimedRequests(
                case, _server(stack, directory, case.name, fill(postgresql, case))
            )
            for case in (CASES[:2] if trying else CASES)
        ]
        compared = compare_requests(requests, ROUNDS_TRIED if trying else ROUNDS)
    return f"{compared}\n\n{where}"
