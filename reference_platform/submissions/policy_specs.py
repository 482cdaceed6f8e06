"""From a submission to what its sandbox runs: an image, or code on a preset."""

from __future__ import annotations

import asyncio
from dataclasses import dataclass, field, replace

from reference_platform.images.presets import BadPreset, Presets
from reference_platform.images.unpacked_roots import UnpackedRoots, UnpackingFailed
from reference_platform.sandbox.sandbox_interface import CODE_PATH, Limits, SandboxSpec
from reference_platform.submissions.interfaces import Uploads
from reference_platform.submissions.lifecycle import Submission


@dataclass(frozen=True, slots=True)
class PolicySpecs:
    """Makes specifications of sandboxes."""

    uploads: Uploads
    roots: UnpackedRoots
    presets: Presets
    limits: Limits = field(default_factory=Limits)

    async def make(self, submission: Submission) -> tuple[SandboxSpec, list[str]]:
        """The specification of its sandbox, and remarks for the log.

        Raises InvalidArchive for a fault of the upload, UnpackingFailed otherwise.
        """
        try:
            archive = self.uploads.path_of(submission.account, submission.digest)
        except KeyError as error:
            raise UnpackingFailed("The upload is not there any more.") from error
        unpacked = await self.roots.get(submission.kind, submission.digest, archive)
        remarks = unpacked.program.remarks
        if submission.kind == "image":
            program = unpacked.program
            spec = SandboxSpec(
                command=program.command,
                root=unpacked.root,
                environment=program.environment,
                directory=program.directory,
                limits=self.limits,
            )
            return spec, remarks
        spec = await self._of_preset(submission.preset)
        return replace(spec, binds={**spec.binds, CODE_PATH: unpacked.root}), remarks

    def remove(self, submission: Submission, *, and_root: bool) -> None:
        """Remove the upload, unless it came later, and what was unpacked of it."""
        owner, digest = submission.account, submission.digest
        self.uploads.remove(owner, digest, submission.entered_at)
        if and_root:
            self.roots.remove(submission.digest)

    async def _of_preset(self, name: str) -> SandboxSpec:
        try:
            preset = self.presets.get(name)
            root = None
            if preset.archive:
                digest, path = await asyncio.to_thread(self.presets.archive_of, preset)
                root = (await self.roots.get("image", digest, path)).root
        except (BadPreset, KeyError, OSError) as error:
            raise UnpackingFailed(f"The preset {name} cannot be used.") from error
        return SandboxSpec(
            command=preset.command,
            root=root,
            binds=self.presets.binds_of(preset),
            environment=preset.environment,
            directory=CODE_PATH,
            limits=self.limits,
        )
