"""The database, and the files with secrets that are kept beside it."""

from __future__ import annotations

from pathlib import Path

from pydantic import BaseModel, Field, field_validator


class DatabaseSettings(BaseModel):
    """The database, and the files with secrets that are kept beside it."""

    database: str = Field(
        "var/proctor.sqlite",
        min_length=1,
        description="Path of an SQLite file, or the URL of a PostgreSQL database, "
        "postgresql://USER:PASSWORD@HOST/NAME. One server at a time uses it, or the "
        "nodes of one cluster.",
    )
    tokens: str = Field(
        "",
        description="Bearer tokens, comma-separated, each account:scopes:token. scopes "
        "is read, run or read+run, with +read_all a reader of the runs of all "
        "accounts, and with +host one who flags entries of the leaderboard; or it is "
        "operator, for people beside robot cells; token is "
        "the secret or sha256=<its hex digest>. If empty, one is made, and printed "
        "then and on terminals. It is kept in a file next to the SQLite file, and "
        "stays the same; with PostgreSQL in var/postgresql.token.",
    )
    tokens_file: str = Field(
        "",
        description="File with more tokens, one on a line, each "
        "account:scopes:sha256=HEX; `proctor admin token` writes it. It is read again "
        "when it changes. If empty, a file next to the SQLite file; with PostgreSQL "
        "var/postgresql.tokens.",
    )
    sealing_key: str = Field(
        "",
        description="File with the key that encrypts API keys of policy servers in the "
        "database; created if missing. If empty, a file next to the SQLite file; with "
        "PostgreSQL var/postgresql.key.",
    )
    seed_secret: str = Field(
        "",
        description="File with the secret that the seeds of sealed splits are drawn "
        "with; created if missing. Servers that share a database share it. If empty, a "
        "file next to the SQLite file; with PostgreSQL var/postgresql.seeds.",
    )

    @field_validator("database")
    @classmethod
    def _check_database(cls, text: str) -> str:
        if ":memory:" in text:
            raise ValueError("a database in memory keeps nothing: name a file")
        if "://" in text and not text.startswith("postgres"):
            kind = text.partition("://")[0]  # the rest may have a password
            raise ValueError(
                f"{kind}://… is neither the path of an SQLite file nor postgresql://…"
            )
        return text

    @property
    def database_url(self) -> str:
        """`database` as a SQLAlchemy URL."""
        if "://" in self.database:
            return self.database
        return f"sqlite:///{self.database}"

    @property
    def database_name(self) -> str:
        """The name of the database in the names of the files beside it."""
        return "postgresql" if "://" in self.database else Path(self.database).name

    @property
    def database_folder(self) -> Path:
        """The folder of the files beside the database."""
        return Path("var") if "://" in self.database else Path(self.database).parent

    @property
    def databases_beside(self) -> list[Path]:
        """Files in the folder of the database that may be other databases."""
        files = self.database_folder.glob("*.sqlite")
        return sorted(path for path in files if path.name != self.database_name)

    @property
    def token_path(self) -> Path:
        """The file of the token that is made if none is set."""
        return self._beside_database("token")

    @property
    def tokens_file_path(self) -> Path:
        """The file of tokens that may change while the server runs."""
        return (
            Path(self.tokens_file)
            if self.tokens_file
            else self._beside_database("tokens")
        )

    @property
    def sealing_key_path(self) -> Path:
        """The file of the key that encrypts API keys."""
        return (
            Path(self.sealing_key) if self.sealing_key else self._beside_database("key")
        )

    @property
    def seed_secret_path(self) -> Path:
        """The file of the secret of sealed seeds."""
        return (
            Path(self.seed_secret)
            if self.seed_secret
            else self._beside_database("seeds")
        )

    @property
    def cell_acts_path(self) -> Path:
        """The file of what operators did at robot cells."""
        return self._beside_database("cells.jsonl")

    def _beside_database(self, ending: str) -> Path:
        """A file that is kept with the database."""
        return self.database_folder / f"{self.database_name}.{ending}"
