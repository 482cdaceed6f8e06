"""Parts of a server that outlive its process: the database, recorded episodes."""

from __future__ import annotations

from dataclasses import dataclass

from reference_record.history.merkle_tree import leaf_hash
from reference_server.files.object_storage import storage_at
from reference_server.records.recordings import Recordings
from reference_server.records.run_records import HostSettings, RunRecords
from reference_server.settings import Settings
from reference_server.storage.board_store import BoardStore
from reference_server.storage.runs.run_store import Store


@dataclass(frozen=True, slots=True)
class StoredParts:
    """recordings, records, board: None for a server that records nothing."""

    store: Store
    recordings: Recordings | None = None
    records: RunRecords | None = None
    board: BoardStore | None = None

    @classmethod
    def of(cls, settings: Settings) -> StoredParts:
        url, is_shared = settings.database_url, settings.cluster == "on"
        if settings.recordings == "off":
            return cls(Store(url, is_shared=is_shared))
        recordings = Recordings(
            settings.records_path,
            pictures=settings.recordings == "pictures",
            is_shared=is_shared,
            keeps_sessions=settings.failover == "replay",
            storage=storage_at(settings.records_storage),
        )
        store = Store(
            url,
            recordings.finish_unplayed,
            recordings.remove_parts,
            is_shared=is_shared,
        )
        records = RunRecords(store, recordings, _host_of(settings))
        return cls(store, recordings, records, BoardStore(store, leaf_hash))


def _host_of(settings: Settings) -> HostSettings:
    return HostSettings(
        settings.host_name,
        settings.signing_key_path,
        settings.record_promise,
        settings.records_keep_days,
        settings.key_names,
    )
