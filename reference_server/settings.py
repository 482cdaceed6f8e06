"""The settings of the server, from flags and environment variables; flags win.

Every field is a flag (`--max-workers`) and a variable (`PROCTOR_MAX_WORKERS`). Its
description is its documentation: `--help` prints it, and the page of settings in docs/
is generated from it. Only validation here: what a setting does is decided where it is
used.
"""

from __future__ import annotations

from pathlib import Path
from typing import Literal, Self

from pydantic import Field, field_validator, model_validator
from pydantic_settings import BaseSettings, SettingsConfigDict

from reference_server.allowed_networks import AllowedNetworks
from reference_server.http.allowed_hosts import AllowedHosts, is_loopback
from reference_server.profiles.flageval.mode_table import ModeTable
from reference_sim.ray_resources import parse_resources


class Settings(BaseSettings):
    """Evaluate robot policies over HTTP: the Proctor reference server."""

    model_config = SettingsConfigDict(
        env_prefix="PROCTOR_",
        cli_prog_name="python -m reference_server",
        cli_kebab_case=True,
        cli_hide_none_type=True,
        cli_avoid_json=True,
        extra="ignore",
    )

    host: str = Field("127.0.0.1", description="Address to listen on.")
    port: int = Field(
        8460, ge=0, le=65535, description="Port to listen on; 0 chooses a free port."
    )
    public_url: str = Field(
        "",
        pattern=r"^(https?://\S+)?$",
        description="Base URL at which clients reach this server, used in "
        "run.endpoint. If empty, it is taken from each request.",
    )
    allowed_hosts: str = Field(
        "",
        description="Names that a request may have in its header Host, "
        "comma-separated and without ports, for example eval.example.org or "
        "*.example.org. If empty, any.",
    )
    database: str = Field(
        "var/proctor.sqlite",
        description="Path of an SQLite file, or the URL of a PostgreSQL database, "
        "postgresql://USER:PASSWORD@HOST/NAME. One server at a time uses it, or the "
        "nodes of one cluster.",
    )
    cluster: Literal["off", "on"] = Field(
        "off",
        description="Whether several servers share the database: each is a node that "
        "plays runs of its own, and passes requests for those of the others on. Needs "
        "equal settings on all nodes, record_imports off and, without an SQLite file, "
        "tokens, sealing_key and seed_secret; with recordings, signing_key and a "
        "folder records_dir that all nodes share, too.",
    )
    node_url: str = Field(
        "",
        pattern=r"^(http://[^\s/]{1,380})?$",
        description="Cluster: base URL at which the other nodes reach this one. If "
        "empty, host and port.",
    )
    node_lease_s: float = Field(
        5.0,
        ge=0.5,
        le=600,
        description="Cluster: time after which the runs of a node that does not reach "
        "the database are taken over by the others.",
    )
    simulators: str = Field(
        "local",
        pattern=r"^(local|ray|ray://[^\s/:]+:\d{1,5})$",
        description="Where simulators are executed. local: in processes of this "
        "machine. ray: on the Ray cluster that this machine is in. ray://HOST:PORT: on "
        "another one, by its server for Ray clients, usually port 10001. Ray needs "
        "the same software on all machines and, for recordings, a folder records_dir "
        "that they share.",
    )
    ray_resources: str = Field(
        "CPU=1",
        description="Ray: what one simulator takes of a machine, comma-separated, each "
        "NAME=AMOUNT with Ray's names, for example CPU=0.5,GPU=0.25. For benchmarks "
        "that declare none themselves.",
    )
    benchmarks: str = Field(
        "",
        description="Additional benchmarks, comma-separated: gymnasium:ID, a TOML "
        "file, a folder of TOML files, FILE.py:CLASS, a question file FILE.jsonl, or "
        "metaworld_mt50.",
    )
    tokens: str = Field(
        "",
        description="Bearer tokens, comma-separated, each account:scopes:token. scopes "
        "is read, run or read+run, with +read_all a reader of the runs of all "
        "accounts, and with +host one who flags entries of the leaderboard; token is "
        "the secret or sha256=<its hex digest>. If empty, one is made and printed. It "
        "is kept in a file next to the SQLite file, and stays the same; with "
        "PostgreSQL in var/postgresql.token.",
    )
    tokens_file: str = Field(
        "",
        description="File with more tokens, one on a line, each "
        "account:scopes:sha256=HEX; `proctor admin token` writes it. It is read again "
        "when it changes. If empty, a file next to the SQLite file; with PostgreSQL "
        "var/postgresql.tokens.",
    )
    profiles: str = Field(
        "",
        pattern=r"^((ebench|flageval)(,(ebench|flageval))*)?$",
        description="Third-party API profiles to enable, comma-separated: ebench, "
        "flageval.",
    )
    flageval_modes: str = Field(
        "",
        description="Benchmarks for the modes of FlagEval's scripts, comma-separated, "
        "each DOMAIN:MODE=BENCHMARK_ID with the domain NLP or MM and * for any other "
        "mode, for example NLP:Qnext=arithmetic,MM:*=question_answering.",
    )
    flageval_account: str = Field(
        "",
        pattern=r"^[A-Za-z0-9_.-]{0,64}$",
        description="Account of requests of the profile flageval that come from this "
        "machine without a token. If empty, there is none. Needs a loopback host and "
        "no public_url; every user of this machine can then use the account.",
    )
    ebench_prefixes: str = Field(
        "/eval",
        pattern=r"^((/[A-Za-z0-9_.-]+)+(,(/[A-Za-z0-9_.-]+)+)*)?$",
        description="Profile ebench: paths under which it answers besides the root, "
        "comma-separated.",
    )
    ebench_max_chunk: int = Field(
        1024,
        ge=1,
        le=4096,
        description="Profile ebench: maximum steps in one list of steps.",
    )
    ebench_max_attempts: int = Field(
        0,
        ge=0,
        le=1_000_000,
        description="Profile ebench: maximum attempts of an episode; if the last one "
        "ends without a result, the episode is abandoned. 0 for no limit.",
    )
    ebench_equal_steps: Literal["execute", "answer_chunks", "answer"] = Field(
        "execute",
        description="Profile ebench: what a step is that equals the last one of its "
        "worker, whose answer was sent. execute: a new step. answer: a repetition, "
        "answered and not executed. answer_chunks: a repetition if it is a list of "
        "steps that are not all equal.",
    )
    pages: Literal["off", "on"] = Field(
        "on",
        description="Whether the server has pages for people, under /pages.",
    )
    recordings: Literal["off", "actions", "pictures"] = Field(
        "actions",
        description="What is recorded of episodes. actions: what was executed, with "
        "rewards, digests of the simulator's state, faults and attempts. pictures: the "
        "images, too, as JPEG; without, they can be rendered again from the actions.",
    )
    records_dir: str = Field(
        "",
        description="Folder of the recordings; created if missing. If empty, a folder "
        "next to the SQLite file; with PostgreSQL, var/records; with a database in "
        "memory, a folder that is removed when the server stops.",
    )
    record_promise: Literal["exact", "outcome"] = Field(
        "outcome",
        description="What records promise of a replay with the same software on the "
        "same kind of machine: equal states after each turn, or equal results.",
    )
    signing_key: str = Field(
        "",
        description="File with the key that signs records; created if missing. If "
        "empty, a file next to the SQLite file; with PostgreSQL "
        "var/postgresql.signing-key.",
    )
    records_keep_days: float = Field(
        0,
        ge=0,
        allow_inf_nan=False,
        description="Days after which the recordings of a run that has ended are "
        "removed; 0 keeps them.",
    )
    public_board: Literal["off", "on"] = Field(
        "off",
        description="Whether the leaderboard can be read without a token: public "
        "entries, rankings and the history.",
    )
    record_imports: Literal["on", "off"] = Field(
        "off",
        description="Whether accounts may hand in records of any host, to be verified "
        "and replayed here with low priority, by one simulator beside max_simulators. "
        "Needs recordings.",
    )
    known_keys: str = Field(
        "",
        pattern=r"^([^,=]{1,64}=SHA256:[0-9a-f]{64}(,[^,=]{1,64}=SHA256:[0-9a-f]{64})*"
        r")?$",
        description="Keys of other hosts, comma-separated, each NAME=SHA256:HEX: a "
        "record that one of them signed is shown as signed by NAME.",
    )
    max_record_bytes: int = Field(
        256 * 2**20,
        ge=2**16,
        lt=2**32,
        description="Maximum size of a record that is handed in.",
    )
    max_waiting_imports: int = Field(
        16,
        ge=1,
        description="Maximum records of one account that are being received, or wait "
        "for their replay.",
    )
    max_imported_bytes: int = Field(
        4 * 2**30,
        ge=2**16,
        description="Maximum bytes of all records that one account has handed in.",
    )
    import_replay_s_max: float = Field(
        3600.0,
        gt=0,
        allow_inf_nan=False,
        description="Maximum time for the replay of one record that was handed in.",
    )
    opened_seeds: str = Field(
        "",
        description="Files with the seeds of sealed splits that hosts have opened, "
        "comma-separated: a record that is handed in is replayed with those to which "
        "it commits its host. Read at the start.",
    )
    runs_keep_days: float = Field(
        0,
        ge=0,
        allow_inf_nan=False,
        description="Days after which a run that has completed, failed or been stopped "
        "is deleted with all that is stored of it, unless it was resumed or has a "
        "public entry on the leaderboard; 0 keeps runs for ever.",
    )
    delete_played_runs: Literal["off", "on"] = Field(
        "off",
        description="Whether an account may delete its runs in which an action was "
        "executed. Runs that were never played it always may. What is deleted stays "
        "counted in `runs_played_before` and `attempts_by_submitter`.",
    )
    allow_private_policies: str = Field(
        "",
        description="Non-public networks in which this server may call policy servers, "
        "comma-separated, for example 127.0.0.1 or 10.0.0.0/8; all allows every "
        "address.",
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
        "file next to the SQLite file; with PostgreSQL var/postgresql.seeds. With a "
        "database in memory it is lost when the server stops.",
    )
    max_workers: int = Field(
        16, ge=1, le=1024, description="Maximum live workers per run."
    )
    max_active_runs: int = Field(
        1000,
        ge=1,
        description="Maximum runs that are played or about to be; others are queued.",
    )
    max_open_runs: int = Field(
        10_000,
        ge=1,
        description="Maximum runs of one account that are queued, ready, running or "
        "stopping.",
    )
    max_idempotency_keys: int = Field(
        1_000_000,
        ge=1,
        description="Maximum Idempotency-Keys of one account; they are kept for good.",
    )
    max_stored_bytes: int = Field(
        16 * 2**30,
        ge=1,
        description="Maximum bytes that the runs of one account may take in the "
        "database: their submissions, 512 for each episode, and what the history of "
        "the leaderboard says of their entries. They are kept for good.",
    )
    max_simulators: int = Field(
        64, ge=1, description="Maximum simulator processes, over all runs."
    )
    spare_simulators: int = Field(
        2,
        ge=0,
        description="Idle simulator processes that are kept started. On Ray none "
        "unless this is set: each holds its share of the cluster.",
    )
    turn_timeout_s: float = Field(
        60.0,
        gt=0,
        allow_inf_nan=False,
        description="Maximum time of a simulator for one turn; then it is killed.",
    )
    idle_timeout_s_max: float = Field(
        600.0,
        ge=1,
        allow_inf_nan=False,
        description="Maximum lease of a session, and the default.",
    )
    heartbeat_s_max: float = Field(
        3600.0,
        ge=1,
        allow_inf_nan=False,
        description="Maximum time that a session lives on heartbeats without a turn.",
    )
    unused_s_max: float = Field(
        120.0,
        ge=1,
        allow_inf_nan=False,
        description="When others wait: time after which a run without a worker may "
        "lose its place, and a session without a turn its simulator to an account that "
        "has fewer.",
    )
    wait_s_max: int = Field(
        30, ge=0, le=600, description="Maximum wait of a long-poll, in seconds."
    )
    max_body_bytes: int = Field(
        8 * 2**20, ge=2**16, description="Maximum size of a request body."
    )
    max_control_body_bytes: int = Field(
        2**16,
        ge=2**16,
        description="Maximum size of the body of a request of this protocol that is no "
        "predict.",
    )
    max_connections: int = Field(
        2000,
        ge=16,
        description="Maximum open connections of clients; fewer if the limit of open "
        "files is too low.",
    )
    max_connections_per_address: int = Field(
        1500,
        ge=1,
        description="Maximum open connections of one client address (of IPv6, a /64 "
        "network), at most three quarters of all. Behind a proxy all clients have its "
        "address.",
    )
    max_event_streams: int = Field(
        100,
        ge=1,
        description="Maximum open streams of events of one run; one account may have "
        "four times as many.",
    )
    request_timeout_s: float = Field(
        10.0,
        ge=0.1,
        le=600,
        description="Maximum time for the headers of a request; its body, and an "
        "answer that is slowly read, may take as long and 1 s more per 16 KiB.",
    )
    max_chunk: int = Field(
        64, ge=4, le=4096, description="Maximum actions in one turn."
    )
    metrics: Literal["off", "on"] = Field(
        "off",
        description="Whether metrics for Prometheus are served, at /metrics of a port "
        "of their own, with /livez and /readyz.",
    )
    metrics_host: str = Field(
        "127.0.0.1",
        description="Address of that port. There is no token: name one that only the "
        "operator reaches.",
    )
    metrics_port: int = Field(
        9464, ge=0, le=65535, description="That port; 0 chooses a free port."
    )
    traces: str = Field(
        "",
        description="URL of a collector of OpenTelemetry (OTLP over HTTP), such as "
        "http://127.0.0.1:4318, to which traces of requests are sent. If empty, none. "
        "Needs the extra traces.",
    )
    traces_ratio: float = Field(
        0.01,
        ge=0,
        le=1,
        allow_inf_nan=False,
        description="Traces: of those that begin at this server, how many are "
        "recorded, at random; 1 is all.",
    )
    traces_parent: Literal["nodes", "all"] = Field(
        "nodes",
        description="Traces: whose header traceparent a request goes on with, recorded "
        "or not as it says. nodes: that of the other nodes. all: that of every client, "
        "too, for servers that only a balancer of yours reaches: with it any client "
        "may have all of its requests recorded.",
    )
    drain_s: float = Field(
        10.0,
        ge=0,
        le=3600,
        description="After SIGTERM or Ctrl-C, how long the server waits for turns in "
        "progress and sends their answers. What is new is refused meanwhile. A second "
        "signal ends it at once.",
    )
    drain_notice_s: float = Field(
        0.0,
        ge=0,
        le=3600,
        description="After SIGTERM or Ctrl-C, how long the server listens in any case "
        "and answers /readyz with 503, so that a load balancer learns that it ends. "
        "drain_s begins after it.",
    )
    log_level: Literal["critical", "error", "warning", "info", "debug", "trace"] = (
        Field(
            "warning",
            description="What is logged, on the standard error. info: also what "
            "happens to every run.",
        )
    )
    log_format: Literal["text", "json"] = Field(
        "text", description="Log lines: text for people, or one JSON object each."
    )
    access_log: Literal["off", "on"] = Field(
        "off", description="Whether every answered request is logged."
    )

    @property
    def enabled_profiles(self) -> list[Literal["ebench", "flageval"]]:
        """The names in `profiles`, without repetitions."""
        known: tuple[Literal["ebench", "flageval"], ...] = ("ebench", "flageval")
        chosen = self.profiles.split(",")
        return [name for name in known if name in chosen]

    @property
    def mode_table(self) -> ModeTable:
        """`flageval_modes`, parsed."""
        return ModeTable.parse(self.flageval_modes)

    @field_validator("allowed_hosts")
    @classmethod
    def _check_hosts(cls, text: str) -> str:
        AllowedHosts.parse(text)  # raises ValueError
        return text

    @field_validator("flageval_modes")
    @classmethod
    def _check_modes(cls, text: str) -> str:
        ModeTable.parse(text)  # raises ValueError
        return text

    @model_validator(mode="after")
    def _check_account(self) -> Self:
        """FLE-024: no other machine uses the account without a token."""
        if self.flageval_account and (self.public_url or not is_loopback(self.host)):
            raise ValueError(
                "flageval_account needs a loopback host and no public_url: requests "
                "without a token are of that account"
            )
        return self

    @model_validator(mode="after")
    def _check_cluster(self) -> Self:
        """What is kept by each server alone cannot be shared by nodes."""
        if self.cluster == "off":
            return self
        if ":memory:" in self.database:
            raise ValueError("cluster needs a database that other servers can open")
        if self.record_imports != "off":
            raise ValueError("cluster needs record_imports off")
        if not self.node_url and self.host in ("0.0.0.0", "::", ""):  # noqa: S104
            raise ValueError(
                f"cluster with host {self.host!r} needs node_url: set it to the URL at "
                "which the other nodes reach this one, such as http://10.0.0.1:8460"
            )
        is_file = "://" not in self.database
        if not (is_file or (self.tokens and self.sealing_key and self.seed_secret)):
            raise ValueError(
                "cluster needs tokens, sealing_key and seed_secret, equal on all nodes"
            )
        is_shared = is_file or (self.records_dir and self.signing_key)
        if self.recordings != "off" and not is_shared:
            raise ValueError(
                "cluster needs records_dir, a folder that all nodes share, and "
                "signing_key, equal on all nodes; or recordings off"
            )
        return self

    @field_validator("ray_resources")
    @classmethod
    def _check_resources(cls, text: str) -> str:
        parse_resources(text)  # raises ValueError
        return text

    @model_validator(mode="after")
    def _check_simulators(self) -> Self:
        """Simulators write recordings where they are executed."""
        if self.simulators == "local" or self.recordings == "off":
            return self
        if not Path(self.records_dir).is_absolute():
            raise ValueError(
                f"simulators {self.simulators} needs records_dir: the absolute path of "
                "a folder that all machines of the Ray cluster share; or recordings off"
            )
        return self

    @field_validator("allow_private_policies")
    @classmethod
    def _check_networks(cls, text: str) -> str:
        AllowedNetworks.parse(text)  # raises ValueError
        return text

    @property
    def token_path(self) -> Path | None:
        """The file of the token that is made if none is set; None: it is not kept."""
        return self._beside_database("token")

    @property
    def tokens_file_path(self) -> Path | None:
        """The file of tokens that may change while the server runs."""
        return (
            Path(self.tokens_file)
            if self.tokens_file
            else self._beside_database("tokens")
        )

    @property
    def sealing_key_path(self) -> Path | None:
        """The file of the key that encrypts API keys; None for a key in memory."""
        return (
            Path(self.sealing_key) if self.sealing_key else self._beside_database("key")
        )

    @property
    def seed_secret_path(self) -> Path | None:
        """The file of the secret of sealed seeds; None for a secret in memory."""
        return (
            Path(self.seed_secret)
            if self.seed_secret
            else self._beside_database("seeds")
        )

    def _beside_database(self, ending: str) -> Path | None:
        """A file that is kept with the database; None for one that lasts no longer."""
        if self.database.startswith("postgres"):
            return Path(f"var/postgresql.{ending}")
        if "://" in self.database or ":memory:" in self.database:
            return None
        return Path(f"{self.database}.{ending}")

    @property
    def records_path(self) -> Path | None:
        """The folder of the recordings; None for one that lasts as long as the server.

        `recordings` says whether there are any.
        """
        if self.records_dir:
            return Path(self.records_dir)
        if ":memory:" in self.database:
            return None
        if "://" in self.database:
            return Path("var/records")
        return Path(f"{self.database}.records")

    @property
    def host_name(self) -> str:
        """What records call this host."""
        return self.public_url or self.host

    @property
    def spares(self) -> int:
        """`spare_simulators`, where they cost no other server its place."""
        is_set = "spare_simulators" in self.model_fields_set
        return self.spare_simulators if is_set or self.simulators == "local" else 0

    @property
    def imports_path(self) -> Path | None:
        """The folder of records that are handed in; None as for `records_path`."""
        path = self.records_path
        return None if path is None else path.with_name(f"{path.name}.imported")

    @property
    def takes_records(self) -> bool:
        """Whether records may be handed in: the key that signs is there, too."""
        return self.record_imports == "on" and self.recordings != "off"

    @property
    def key_names(self) -> dict[str, str]:
        """`known_keys`: keyid → whose key it is."""
        pairs = (text.partition("=") for text in self.known_keys.split(",") if text)
        return {keyid: name for name, _, keyid in pairs}

    @property
    def opened_seeds_paths(self) -> list[Path]:
        """`opened_seeds`: of records that are handed in."""
        return [Path(one.strip()) for one in self.opened_seeds.split(",") if one]

    @property
    def signing_key_path(self) -> Path | None:
        """The file of the key that signs records; None for a key in memory."""
        if self.signing_key:
            return Path(self.signing_key)
        return self._beside_database("signing-key")

    @property
    def database_url(self) -> str:
        """`database` as a SQLAlchemy URL."""
        if "://" in self.database:
            return self.database
        return f"sqlite+aiosqlite:///{self.database}"
