"""The parts of hosted submissions, put together in one folder of the host.

`uploads/`, `roots/` (which users of sandboxes enter), `logs/`, `presets/`, and
`sockets/`, which the server is given as `--policy-sockets`.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Final

from reference_platform.images.image_reviews import ImageReviews
from reference_platform.images.presets import Presets
from reference_platform.images.unpacked_roots import UnpackedRoots
from reference_platform.images.upload_folder import UploadFolder
from reference_platform.sandbox.bubblewrap import BubblewrapMaker
from reference_platform.sandbox.cluster.ray_sandboxes import RayMaker
from reference_platform.sandbox.sandbox_interface import (
    Limits,
    SandboxMaker,
    SandboxSpec,
    SandboxUnavailable,
)
from reference_platform.submissions.interfaces import AccountTokens
from reference_platform.submissions.lifecycle import FINAL
from reference_platform.submissions.policy_specs import PolicySpecs
from reference_platform.submissions.sandboxed_runner import (
    PolicyTimes,
    SandboxedRunner,
)
from reference_platform.submissions.submission_logs import FileLogs
from reference_platform.submissions.submission_store import SubmissionStore
from reference_platform.submissions.submission_supervisor import SubmissionSupervisor
from reference_platform.tracks.phase_draws import DrawHistory

# `sockets/` and a name; the path of a Unix socket has at most 107 bytes.
_FOLDER_CHARS_MAX: Final = 107 - len("/sockets/.sock") - 32


@dataclass(frozen=True, slots=True)
class HostedParts:
    """The parts; `supervisor.run` plays what is submitted."""

    folder: Path
    uploads: UploadFolder
    reviews: ImageReviews
    presets: Presets
    roots: UnpackedRoots
    logs: FileLogs
    supervisor: SubmissionSupervisor
    maker: SandboxMaker
    limits: Limits

    @classmethod
    def of(
        cls,
        folder: Path,
        store: SubmissionStore,
        tokens: AccountTokens,
        server_url: str,
        *,
        at_once: int,
        times: PolicyTimes | None = None,
        history: DrawHistory | None = None,
        limits: Limits | None = None,
        cluster: str = "",
    ) -> HostedParts:
        """history: of the server, for seeds that are drawn. cluster: of Ray, where
        sandboxes run; empty: on this machine.

        Raises SandboxUnavailable, and OSError.
        """
        folder = folder.absolute()
        if len(str(folder)) > _FOLDER_CHARS_MAX:
            text = f"The path {folder} is too long: a Unix socket is below it."
            raise SandboxUnavailable(text)
        folder.mkdir(mode=0o711, parents=True, exist_ok=True)

        def is_ended(submission_id: str) -> bool:
            is_final = store.get(submission_id).state in FINAL
            return is_final and supervisor.has_written(submission_id)

        uploads = UploadFolder(folder / "uploads")
        presets = Presets(folder / "presets")
        roots = UnpackedRoots(folder / "roots")
        logs = FileLogs(folder / "logs", is_ended, host_folders=[folder])
        reviews = ImageReviews(store.database, store.clock)
        limits = limits or Limits()
        maker: SandboxMaker = RayMaker(cluster) if cluster else BubblewrapMaker()
        runner = SandboxedRunner(
            maker=maker,
            specs=PolicySpecs(uploads, roots, presets, limits),
            tokens=tokens,
            logs=logs,
            server_url=server_url,
            sockets=sockets_of(folder),
            times=times,
        )
        supervisor = SubmissionSupervisor(
            store, reviews, runner, logs, at_once, history=history
        )
        return cls(
            *(folder, uploads, reviews, presets, roots),
            *(logs, supervisor, maker, limits),
        )

    async def try_sandbox(self) -> None:
        """Start a sandbox that has no program. Raises SandboxUnavailable."""
        binds = {"/roots": self.folder / "roots"}
        spec = SandboxSpec(["/trial"], binds=binds, limits=self.limits)
        sandbox = await self.maker.start(spec, lambda _source, _text: None)
        await sandbox.close("The trial is over.")

    def enforcement(self) -> str:
        return self.maker.enforcement(self.limits)

    def problems(self) -> list[str]:
        """Sentences on why submissions do not go on; none if they do."""
        texts = {
            "Submissions wait": self.supervisor.problem,
            "Submissions end later": self.logs.problem,
        }
        return [f"{what}: {why}" for what, why in texts.items() if why]


def sockets_of(folder: Path) -> Path:
    return folder.absolute() / "sockets"
