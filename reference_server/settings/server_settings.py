"""All settings of the server, from flags and environment variables; flags win.

Every field is a flag (`--max-workers`) and a variable (`PROCTOR_MAX_WORKERS`), whatever
its subject: a nested model would put the name of the subject before it. So the subjects
are classes that this one inherits, and a part that needs one of them asks for that one.
Here is only what holds between subjects.
"""

from __future__ import annotations

from pathlib import Path
from typing import Self

from pydantic import ValidationError, field_validator, model_validator
from pydantic_core import ErrorDetails
from pydantic_settings import BaseSettings, SettingsConfigDict

from reference_record.command_line.spelling import reason_of, shown
from reference_server.settings.allowed_hosts import is_loopback, own_address
from reference_server.settings.cluster_settings import ClusterSettings
from reference_server.settings.database_settings import DatabaseSettings
from reference_server.settings.imported_record_settings import ImportedRecordSettings
from reference_server.settings.network_settings import NetworkSettings
from reference_server.settings.operation_settings import OperationSettings
from reference_server.settings.profile_settings import ProfileSettings
from reference_server.settings.run_limit_settings import RunSettings
from reference_server.settings.simulation_settings import SimulationSettings


class Settings(
    # The last one comes first in --help and on the page of settings.
    OperationSettings,
    ProfileSettings,
    ImportedRecordSettings,
    RunSettings,
    SimulationSettings,
    ClusterSettings,
    DatabaseSettings,
    NetworkSettings,
    BaseSettings,
):
    """Evaluate robot policies over HTTP: the Proctor reference server."""

    model_config = SettingsConfigDict(
        env_prefix="PROCTOR_",
        extra="ignore",
    )

    @property
    def is_for_one_person(self) -> bool:
        """Whether the token that it has made, for this machine, is the only one."""
        others = self.tokens_file_path
        return (
            is_loopback(self.host)
            and not (self.tokens or self.public_url or self.cluster == "on")
            and not (others.exists() and others.stat().st_size)
        )

    @property
    def imports_path(self) -> Path:
        """In a cluster inside of the folder of recordings: it is shared, too."""
        if self.cluster == "off":
            return super().imports_path
        return self.records_path / ".imported"

    @property
    def folder_id_path(self) -> Path | None:
        """The file that says which database the files in its folder belong to.

        None where the name of the database says it, and where all are elsewhere.
        """
        is_kept = self.records_dir or self.records_storage
        are_elsewhere = (self.sealing_key and self.seed_secret) and (
            self.recordings == "off" or (is_kept and self.signing_key)
        )
        if self.cluster == "on" or "://" not in self.database or are_elsewhere:
            return None
        return self._beside_database("id")

    @field_validator("*", mode="before")
    @classmethod
    def _check_characters(cls, value: object) -> object:
        """Take blanks and line ends, as files have them, from both ends of a value.

        Others that are not seen are refused. The value, perhaps a secret, is not shown.
        """
        if not isinstance(value, str):
            return value
        value = value.strip()
        hidden = [c for c in value if not (c.isprintable() or c in "\n\t")]
        if hidden:
            raise ValueError(f"it has {hidden[0]!r}, which means nothing here")
        return value

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
    def _check_recordings(self) -> Self:
        """Refuse what is made of recordings where there are none."""
        for name in ("record_imports", "public_board"):
            if self.recordings == "off" and getattr(self, name) == "on":
                raise ValueError(
                    f"{name} on needs recordings, which are off: without them this "
                    "server has no key that signs"
                )
        if self.recordings == "off" and self.failover == "replay":
            raise ValueError("failover replay needs recordings, which are off")
        return self

    @model_validator(mode="after")
    def _check_body_sizes(self) -> Self:
        if self.max_control_body_bytes > self.max_body_bytes:
            raise ValueError(
                f"max_control_body_bytes ({self.max_control_body_bytes}) cannot exceed "
                f"max_body_bytes ({self.max_body_bytes}), the maximum of every request"
            )
        return self

    @model_validator(mode="after")
    def _check_cluster(self) -> Self:
        """Refuse a cluster whose nodes would not share all that they have to share."""
        if self.cluster == "off":
            return self
        if not self.node_url and self.host != own_address(self.host):
            raise ValueError(
                f"cluster with host {self.host!r} needs node_url: set it to the URL at "
                "which the other nodes reach this one, such as http://10.0.0.1:8460"
            )
        is_file = "://" not in self.database
        if not (is_file or (self.tokens and self.sealing_key and self.seed_secret)):
            raise ValueError(
                "cluster needs tokens, sealing_key and seed_secret, equal on all nodes"
            )
        is_kept = self.records_dir or self.records_storage
        is_shared = is_file or (is_kept and self.signing_key)
        if self.recordings != "off" and not is_shared:
            raise ValueError(
                "cluster needs records_dir, a folder that all nodes share, or "
                "records_storage, and signing_key, equal on all nodes; or recordings "
                "off"
            )
        return self


def describe_faults(error: ValidationError) -> str:
    """One line: each fault with the name of its setting, or those that contradict."""
    return "; ".join(map(_describe, error.errors(include_url=False)))


def _describe(fault: ErrorDetails) -> str:
    context = fault.get("ctx", {})
    if fault["type"] == "value_error":
        text = str(context["error"])
    elif fault["type"] == "string_too_short":
        default = Settings.model_fields[str(fault["loc"][0])].default
        text = f"it is set and empty; leave it out for the default, {default}"
    elif fault["type"] == "string_pattern_mismatch":
        text = f"{shown(fault['input'])} does not fit"
        field = Settings.model_fields.get(str(fault["loc"][0]))
        if field is not None:
            text += f"; it stands for: {field.description}"
    else:
        text = reason_of(fault)
    names = ".".join(map(str, fault["loc"]))
    # A fault between settings has no place; its text names all of them.
    return f"{names}: {text}" if names else text
