"""Records of other hosts that accounts hand in."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from pydantic import Field

from reference_server.settings.record_settings import RecordSettings


class ImportedRecordSettings(RecordSettings):
    """Records of other hosts that accounts hand in."""

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
    max_disk_bytes: int = Field(
        0,
        ge=0,
        description="Maximum bytes of all that this server keeps on its disk: an "
        "SQLite database, recordings, records that were handed in. At it no run is "
        "taken in, no episode begins and no record is handed in; nothing is deleted. "
        "0 for no bound.",
    )
    opened_seeds: str = Field(
        "",
        description="Files with the seeds of sealed splits that hosts have opened, "
        "comma-separated: a record that is handed in is replayed with those to which "
        "it commits its host. Read at the start.",
    )

    @property
    def takes_records(self) -> bool:
        """Whether records may be handed in: the key that signs is there, too."""
        return self.record_imports == "on" and self.recordings != "off"

    @property
    def kept_paths(self) -> list[Path]:
        """The files and folders of which max_disk_bytes is the bound."""
        paths = [self.records_path, self.imports_path]
        if self.records_path in self.imports_path.parents:
            paths.pop()
        if "://" not in self.database:
            paths += [Path(f"{self.database}{end}") for end in ("", "-wal", "-shm")]
        return paths

    @property
    def imports_path(self) -> Path:
        """The folder of records that are handed in."""
        path = self.records_path
        return path.with_name(f"{path.name}.imported")

    @property
    def key_names(self) -> dict[str, str]:
        """`known_keys`: keyid → whose key it is."""
        pairs = (text.partition("=") for text in self.known_keys.split(",") if text)
        return {keyid: name for name, _, keyid in pairs}

    @property
    def opened_seeds_paths(self) -> list[Path]:
        """`opened_seeds`: of records that are handed in."""
        return [Path(path.strip()) for path in self.opened_seeds.split(",") if path]
