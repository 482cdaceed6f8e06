"""`python -m benchmarks.postgresql_growth`: the same growth, stored in PostgreSQL.

Databases of one PostgreSQL are filled with finished runs, a real server is started on
each, and the requests of storage_growth.py are sent to them in turn. Nothing is forced
to disk, as in tests, so what writes costs less than it would: trust the ratios.

It writes the section `growth_postgresql` of build/benchmarks.json and of
build/performance.md.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import sys
import tempfile
from pathlib import Path

from benchmarks import performance_page, results
from benchmarks.filled_databases import (
    DatabaseCase,
    ServerProcess,
    filling_statements,
    running_server,
    store_templates,
)
from benchmarks.storage_growth import (
    DATABASE_CASES,
    TimedRequests,
    compare_requests,
    requests_table,
)
from tests.support.server.postgresql_server import PostgresqlServer

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


def main() -> int:
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--rounds", type=int, default=100)
    arguments.add_argument(
        "--try", action="store_true", dest="is_tried", help="no page"
    )
    options = arguments.parse_args()
    machine = results.machine()
    with contextlib.ExitStack() as stack:
        directory = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        postgresql = stack.enter_context(PostgresqlServer())
        requests = [
            TimedRequests(
                case, _server(stack, directory, case.name, fill(postgresql, case))
            )
            for case in CASES
        ]
        body = compare_requests(requests, options.rounds)
    text = requests_table(body, [case.name for case in CASES])
    print(text)
    if not options.is_tried:
        results.update("growth_postgresql", {"measured_on": machine, "requests": body})
        performance_page.put("growth_postgresql", "Growth on PostgreSQL", text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
