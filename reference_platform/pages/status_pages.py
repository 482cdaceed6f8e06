"""The page of an administrator who operates a host: what waits, is stuck and used."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from starlette.responses import Response

from reference_platform.pages.form_calls import PageCall, Show
from reference_platform.storage.host_status import bytes_by_folder, host_status, uses
from reference_platform.submissions.hosted_parts import HostedParts

DAYS: Final = 30
_REFRESH_S: Final = 30


@dataclass(frozen=True, slots=True)
class OperationPages:
    """hosted: None on a host that runs no submissions."""

    hosted: HostedParts | None

    def shown(self) -> Mapping[str, tuple[Show, str]]:
        return {"/operation": (self.show_operation, "administrator")}

    async def show_operation(self, call: PageCall) -> Response:
        folder: Path | None = None
        problems: list[str] = []
        sizes: dict[str, int] = {}
        if self.hosted is not None:
            folder, problems = self.hosted.folder, self.hosted.problems()
            sizes = await asyncio.to_thread(bytes_by_folder, folder)
        response = call.page(
            "operation/operation",
            status=host_status(call.parts, folder, sizes, *problems),
            uses=uses(call.parts, DAYS),
            days=DAYS,
            enforcement="" if self.hosted is None else self.hosted.enforcement(),
        )
        response.headers["Refresh"] = str(_REFRESH_S)
        return response
