"""The parts of a server that play runs, from the simulators up to the use cases."""

from __future__ import annotations

import logging
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from reference_record.formats.opened_seeds import load_opened_seeds
from reference_server.accounts.account_service import AccountService
from reference_server.assembly.stored_parts import StoredParts
from reference_server.cells.act_log import ActLog
from reference_server.cells.cells import Cells
from reference_server.cluster.server_node import ServerNode
from reference_server.files.object_storage import storage_at
from reference_server.files.seed_secret import SeedSecret
from reference_server.process.age_guard import AgeGuard
from reference_server.process.hourly_work import HourlyWork
from reference_server.push.driver import PROTOCOLS, Driver
from reference_server.push.egress import EgressPolicy
from reference_server.push.key_encryption import KeyEncryption
from reference_server.push.policy_server_validator import PolicyServerValidator
from reference_server.records.board_history import BoardHistory
from reference_server.records.record_imports import ImportSettings, RecordImports
from reference_server.rules.capacity import Quota
from reference_server.rules.imported_record import ImportUsage
from reference_server.rules.submission import SubmissionLimits
from reference_server.runs.admission.disk_bound import DiskBound
from reference_server.runs.benchmarks import Benchmarks
from reference_server.runs.board_service import BoardService
from reference_server.runs.registry import RunRegistry
from reference_server.runs.service import (
    RunService,
    no_command_elsewhere,
    no_views_elsewhere,
)
from reference_server.runs.sessions.session_executor import SessionExecutor
from reference_server.settings import Settings
from reference_server.settings.database_settings import DatabaseSettings
from reference_server.settings.imported_record_settings import ImportedRecordSettings
from reference_server.settings.run_limit_settings import RunSettings
from reference_server.storage.import_store import ImportStore
from reference_sim.process.pool import SimulatorPool
from reference_sim.process.ray.ray_pool import RayPool

log = logging.getLogger("proctor.app")


@dataclass(frozen=True, slots=True)
class Pools:
    """Simulators of sessions, and of replays: records are files of this machine."""

    sessions: SimulatorPool
    replays: SimulatorPool

    @classmethod
    def of(cls, settings: Settings) -> Pools:
        limits = settings.max_simulators, settings.spares, settings.turn_timeout_s
        if settings.simulators == "local":
            pool = SimulatorPool(*limits)
            return cls(pool, pool)
        pool = RayPool(
            settings.simulators,
            settings.ray_resources,
            *limits,
        )
        return cls(pool, SimulatorPool(1, 0, settings.turn_timeout_s))


@dataclass(frozen=True, slots=True)
class Secrets:
    """Files that this host alone reads."""

    seeds: SeedSecret
    policy_keys: KeyEncryption

    @classmethod
    def of(cls, settings: DatabaseSettings) -> Secrets:
        return cls(
            SeedSecret(settings.seed_secret_path),
            KeyEncryption(settings.sealing_key_path),
        )

    def open(self) -> None:
        """Read or create the files. Raises OSError and ValueError."""
        self.policy_keys.open()
        self.seeds.open()


@dataclass(frozen=True, slots=True)
class RunParts:
    """The runs of a server, and those who act on them."""

    registry: RunRegistry
    executor: SessionExecutor
    service: RunService
    driver: Driver
    retention: HourlyWork
    disk_bound: DiskBound
    cells: Cells

    @classmethod
    def of(
        cls,
        settings: Settings,
        stored: StoredParts,
        pools: Pools,
        secrets: Secrets,
        node: ServerNode | None,
        *,
        accounts: AccountService | None = None,
    ) -> RunParts:
        """node: this server as one of several; None for one that is alone.

        accounts: the program that keeps them; None if there is none.
        """
        disk_bound = DiskBound(settings.max_disk_bytes, settings.kept_paths)
        registry = RunRegistry(
            stored.store,
            settings.max_active_runs,
            unused_s=settings.unused_s_max,
            quota=_quota_of(settings),
            ownership=None if node is None else node.membership,
            disk_bound=disk_bound,
        )
        cells = Cells(ActLog(settings.cell_acts_path))
        executor = SessionExecutor(
            registry,
            pools.sessions,
            secrets.seeds,
            cells=cells,
            unused_s=settings.unused_s_max,
            heartbeat_s_max=settings.heartbeat_s_max,
            recordings=stored.recordings,
            disk_bound=disk_bound,
        )
        sockets = Path(settings.policy_sockets) if settings.policy_sockets else None
        egress = EgressPolicy(settings.allow_private_policies, sockets)
        validator = PolicyServerValidator(egress, secrets.policy_keys, tuple(PROTOCOLS))
        service = RunService(
            SubmissionLimits(settings.max_workers, settings.idle_timeout_s_max),
            Benchmarks(settings.max_chunk, secrets.seeds),
            registry,
            executor,
            validator.validate_and_encrypt,
            validator.digest_key,
            stored.records,
            cells.second_judgements,
            deletes_played=settings.delete_played_runs == "on",
            is_kept=None if stored.board is None else stored.board.keeps_run,
            views_elsewhere=no_views_elsewhere if node is None else node.views.fetch,
            command_elsewhere=(
                no_command_elsewhere if node is None else node.commands.apply
            ),
            admission=accounts,
        )
        keys, max_bytes = secrets.policy_keys, settings.max_body_bytes
        driver = Driver(service, egress, keys, max_bytes)
        retention = _retention_of(settings, service)
        return cls(registry, executor, service, driver, retention, disk_bound, cells)


def _quota_of(settings: RunSettings) -> Quota:
    return Quota(
        settings.max_open_runs, settings.max_idempotency_keys, settings.max_stored_bytes
    )


def _retention_of(settings: RunSettings, service: RunService) -> HourlyWork:
    """DEL-007."""
    keep_days = settings.runs_keep_days
    guard = AgeGuard(keep_days, "the results and recordings", log)

    delete_old = partial(service.delete_old, keep_days)
    delete = partial(guard.delete, service.registry.newest_change, delete_old)
    work = delete if keep_days else None
    return HourlyWork(work, "old runs could not be deleted")


def make_board(
    stored: StoredParts,
    service: RunService,
    secrets: Secrets,
    accounts: AccountService | None,
    cells: Cells,
) -> BoardService | None:
    """The leaderboard; None without recordings, whose key signs its history."""
    if stored.board is None or stored.records is None:
        return None
    history = BoardHistory(stored.board, stored.records)
    return BoardService(
        service.registry,
        service.benchmarks,
        stored.board,
        history,
        check_publication=None if accounts is None else accounts.check_publication,
        seed_secret=secrets.seeds,
        judged=cells.judged,
    )


def make_imports(
    settings: ImportedRecordSettings,
    stored: StoredParts,
    pool: SimulatorPool,
    disk_bound: DiskBound,
    node: ServerNode | None = None,
) -> RecordImports | None:
    """The imports of records; None where none are taken in. pool: for their replays."""
    if stored.records is None or not settings.takes_records:
        return None
    most = ImportUsage(settings.max_waiting_imports, settings.max_imported_bytes)
    imports = ImportSettings(
        settings.imports_path,
        most,
        settings.max_record_bytes,
        settings.import_replay_s_max,
        [load_opened_seeds(path) for path in settings.opened_seeds_paths],
        is_shared=node is not None,
        storage=storage_at(settings.records_storage),
        may_replay=lambda: node is None or node.membership.is_first,
    )
    store = ImportStore(stored.store)
    return RecordImports(store, pool, stored.records, imports, disk_bound.check)
