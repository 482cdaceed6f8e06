"""The review of an image: an administrator decides before it is run for the first time.

A decision is about bytes, by their digest: it holds for every account that uploads the
same bytes. A Dockerfile is shown to the reviewer, and never built. Code on a preset of
the host needs no review.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final, Literal

import msgspec

from reference_platform.storage.platform_database import Database, audit
from reference_server.rules.refusal import Refused

ImageState = Literal["waiting", "approved", "rejected"]
ImageDecision = Literal["approve", "reject"]
DOCKERFILE_CHARS_MAX: Final = 65_536

# state → decision → next state; what is not in the table is refused.
DECISIONS: Final[Mapping[ImageState, Mapping[ImageDecision, ImageState]]] = (
    MappingProxyType(
        {
            "waiting": {"approve": "approved", "reject": "rejected"},
            "approved": {"reject": "rejected"},
            "rejected": {"approve": "approved"},
        }
    )
)


class ReviewedImage(msgspec.Struct, frozen=True):
    """account: which uploaded it first. reason: of the last decision."""

    digest: str
    account: str
    size: int
    dockerfile: str
    state: ImageState
    reason: str
    created_at: float
    decided_at: float | None


@dataclass(frozen=True, slots=True)
class ImageReviews:
    """The stored images and the decisions on them."""

    database: Database
    clock: Callable[[], float] = time.time

    def get(self, digest: str) -> ReviewedImage | None:
        return self.database.row(
            ReviewedImage, "SELECT * FROM images WHERE digest = ?", digest
        )

    def add(self, digest: str, account: str, size: int, dockerfile: str) -> None:
        """An image has arrived; it waits, unless these bytes were decided on."""
        if len(dockerfile) > DOCKERFILE_CHARS_MAX:
            text = f"A Dockerfile has at most {DOCKERFILE_CHARS_MAX} characters."
            raise Refused("invalid_request", text, errors=[("/dockerfile", text)])
        if self.get(digest) is None:
            image = ReviewedImage(
                digest, account, size, dockerfile, "waiting", "", self.clock(), None
            )
            self.database.insert("images", image)

    def in_state(self, state: ImageState) -> Sequence[ReviewedImage]:
        return self.database.rows(
            ReviewedImage,
            "SELECT * FROM images WHERE state = ? ORDER BY created_at",
            state,
        )

    def decide(
        self, digest: str, decision: ImageDecision, reason: str, actor: str
    ) -> ReviewedImage:
        """Raises Refused. The audit log has the decision."""
        with self.database.transaction():
            image = self.get(digest)
            if image is None:
                raise Refused("not_found", "There is no such image.")
            state = DECISIONS[image.state].get(decision)
            if state is None:
                text = f"`{decision}` is not possible: the image is {image.state}."
                raise Refused("illegal_transition", text)
            if decision == "reject" and not reason.strip():
                wrong = [("/reason", "is required")]
                raise Refused("invalid_request", "It needs a reason.", errors=wrong)
            now = self.clock()
            self.database.execute(
                "UPDATE images SET state = ?, reason = ?, decided_at = ? "
                "WHERE digest = ?",
                *(state, reason.strip(), now, digest),
            )
            audit(
                self.database,
                now,
                actor=actor,
                act=f"{decision}_image",
                subject=digest,
                detail=reason.strip(),
            )
        changed = self.get(digest)
        assert changed is not None
        return changed
