"""The tables of the database; the stores write and read their rows.

A change here is a migration as well (`migrations/`): a test holds both equal.
"""

from __future__ import annotations

import sqlalchemy as sa

from reference_server.storage.tables.column_types import AnyText

TABLES = sa.MetaData()

runs = sa.Table(
    "runs",
    TABLES,
    sa.Column("number", sa.Integer, primary_key=True, autoincrement=True),
    sa.Column("run_id", sa.String(64), unique=True, nullable=False),
    sa.Column("account", sa.String(200), nullable=False),
    sa.Column("state", sa.String(16), nullable=False, index=True),
    sa.Column("reason", AnyText),
    sa.Column("retryable", sa.Boolean),
    sa.Column("manifest_sha256", sa.String(64), nullable=False),
    sa.Column("submission", sa.LargeBinary, nullable=False),
    sa.Column("max_workers", sa.Integer, nullable=False),
    sa.Column("idle_timeout_s", sa.Float, nullable=False),
    sa.Column("images", sa.LargeBinary, nullable=False),
    sa.Column("created_at_wall", sa.Float, nullable=False),
    sa.Column("updated_at_wall", sa.Float, nullable=False),
    sa.Column("queue_until_wall", sa.Float, nullable=False),
    # How many of its episodes have a result; NULL in rows older than this column.
    sa.Column("scored", sa.Integer),
    # NULL in rows older than these columns.
    sa.Column("benchmark_id", sa.String(64)),
    sa.Column("attempts_by_submitter", sa.Integer),
    # Bytes that count for its account; NULL in rows older than this column.
    sa.Column("stored_bytes", sa.BigInteger),
    # NULL if no action was executed in it.
    sa.Column("played_number", sa.Integer),
    # NULL unless it was deleted: its row stays, so that it stays counted.
    sa.Column("deleted_at_wall", sa.Float),
    # The node that acts for it, and how often that changed; NULL without a cluster.
    sa.Column("owner", sa.String(32)),
    sa.Column("fence", sa.Integer),
    # Who made it fail; NULL in other states, and in rows older than this column.
    sa.Column("failed_by", sa.String(16)),
    sa.Index("runs_of_account", "account", "number"),
    sa.Index("runs_of_benchmark", "account", "benchmark_id", "attempts_by_submitter"),
    sa.Index("runs_played", "account", "benchmark_id", "played_number"),
)
# The servers that share the database; times by its clock, in seconds since 1970.
nodes = sa.Table(
    "nodes",
    TABLES,
    sa.Column("node_id", sa.String(32), primary_key=True),
    # Where the other nodes reach it, and what they prove with that they are nodes.
    sa.Column("url", sa.String(400), nullable=False),
    sa.Column("secret", sa.String(64), nullable=False),
    sa.Column("renewed_at", sa.Float, nullable=False),
    # JSON, as SettingsComparison writes it.
    sa.Column("settings", sa.Text, nullable=False, server_default=""),
)
# Values that must be equal on all nodes, by name.
LEASE = "node_lease_s"
cluster_facts = sa.Table(
    "cluster_facts",
    TABLES,
    sa.Column("name", sa.String(32), primary_key=True),
    sa.Column("value", sa.Text, nullable=False),
)
# Updated by what counts the runs of an account, so that two nodes do not at once; the
# row * also by what adds to a sequence of the host, such as its statements.
accounts = sa.Table(
    "accounts",
    TABLES,
    sa.Column("account", sa.String(200), primary_key=True),
    sa.Column("counted", sa.BigInteger, nullable=False),
)
# A manifest is stored once, however many runs use it.
manifests = sa.Table(
    "manifests",
    TABLES,
    sa.Column("manifest_sha256", sa.String(64), primary_key=True),
    sa.Column("manifest", sa.LargeBinary, nullable=False),
)
# Only episodes that something happened to; the others follow from the manifest.
episodes = sa.Table(
    "episodes",
    TABLES,
    sa.Column("number", sa.ForeignKey("runs.number"), primary_key=True),
    sa.Column("index", sa.Integer, primary_key=True),
    sa.Column("attempt", sa.Integer, nullable=False),
    sa.Column("faults", sa.Integer, nullable=False),
    sa.Column("faults_forgiven", sa.Integer, nullable=False),
    sa.Column("result", sa.LargeBinary),
    sa.Column("policy_fault", AnyText),
    # NULL unless a worker has said why it left the episode.
    sa.Column("last_left", sa.LargeBinary),
    # Position of its result in the order of scoring; NULL in rows older than this
    # column.
    sa.Column("place", sa.Integer),
    # NULL if the episode was not recorded.
    sa.Column("recording", sa.LargeBinary),
)
idempotency_keys = sa.Table(
    "idempotency_keys",
    TABLES,
    sa.Column("account", sa.String(200), primary_key=True),
    sa.Column("key", sa.String(128), primary_key=True),
    sa.Column("body_sha256", sa.String(64), nullable=False),
    sa.Column("run_id", sa.String(64), nullable=False),
)

# The statements of records, in the order in which they were signed.
statements = sa.Table(
    "statements",
    TABLES,
    sa.Column("number", sa.Integer, primary_key=True, autoincrement=True),
    sa.Column("run_id", sa.String(64), unique=True, nullable=False),
    sa.Column("statement", sa.LargeBinary, nullable=False),
    sa.Column("sha256", sa.String(64), nullable=False),
)
signing_keys = sa.Table(
    "signing_keys",
    TABLES,
    sa.Column("keyid", sa.String(80), primary_key=True),
    sa.Column("public_key", sa.LargeBinary, nullable=False),
    sa.Column("created_at_wall", sa.Float, nullable=False),
    sa.Column("retired_at_wall", sa.Float),
)

# The leaderboard: entries, and the leaves of its history.
entries = sa.Table(
    "entries",
    TABLES,
    sa.Column("number", sa.Integer, primary_key=True, autoincrement=True),
    sa.Column("entry_id", sa.String(64), unique=True, nullable=False),
    sa.Column("run_id", sa.String(64), unique=True, nullable=False),
    sa.Column("account", sa.String(200), nullable=False, index=True),
    sa.Column("benchmark_id", sa.String(64), nullable=False),
    sa.Column("manifest_sha256", sa.String(64), nullable=False, index=True),
    sa.Column("is_listed", sa.Boolean, nullable=False),
    sa.Column("is_public", sa.Boolean, nullable=False),
    sa.Column("entry", sa.LargeBinary, nullable=False),
)
history = sa.Table(
    "history",
    TABLES,
    sa.Column("index", sa.Integer, primary_key=True, autoincrement=False),
    sa.Column("leaf", sa.Text, nullable=False),
    sa.Column("leaf_sha256", sa.LargeBinary, nullable=False),
)

record_imports = sa.Table(
    "record_imports",
    TABLES,
    sa.Column("number", sa.Integer, primary_key=True, autoincrement=True),
    sa.Column("import_id", sa.String(64), unique=True, nullable=False),
    sa.Column("account", sa.String(200), nullable=False),
    sa.Column("archive_sha256", sa.String(64), nullable=False),
    sa.Column("size_bytes", sa.BigInteger, nullable=False),
    sa.Column("statement_sha256", sa.String(64), nullable=False),
    sa.Column("keyid", AnyText, nullable=False),
    sa.Column("run_id", AnyText, nullable=False),
    sa.Column("benchmark_id", AnyText, nullable=False),
    sa.Column("benchmark_version", AnyText, nullable=False),
    sa.Column("manifest_sha256", sa.String(64), nullable=False),
    sa.Column("policy_name", AnyText, nullable=False),
    sa.Column("policy_version", AnyText),
    sa.Column("score", sa.Float),
    sa.Column("episodes", sa.Integer, nullable=False),
    sa.Column("imported_at_wall", sa.Float, nullable=False),
    sa.Column("state", sa.String(16), nullable=False),
    sa.Column("replay", sa.LargeBinary),
    sa.Column("verdict", sa.LargeBinary),
    sa.Column("reason", AnyText),
    sa.Column("finished_at_wall", sa.Float),
    # One account does not have the same bytes twice (REC-119).
    sa.Index("archives_of_account", "account", "archive_sha256", unique=True),
)
