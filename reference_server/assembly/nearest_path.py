"""The refusal of an unknown path, with the nearest path that exists (ERR-009)."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Sequence

from starlette.types import Receive, Scope, Send

from reference_server.http.problems import problem_response
from reference_server.rules.refusal import Refused

# Longer paths are not compared: they are not typing errors.
PATH_CHARS_MAX = 300
SEGMENTS_MAX = 16
LIKENESS_MIN = 0.6


class UnknownPath:
    """Refuses every request, and names the path that is nearest to that of it.

    paths: those that this server has, with their parameters in braces.
    """

    def __init__(self, paths: Iterable[str]) -> None:
        self._paths = [path.strip("/").split("/") for path in paths]

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        path = scope["path"]
        act = "Check the path, and the base URL before it."
        if nearest := self.nearest(path):
            act = f"The nearest is {nearest}."
            base, ending = path.removesuffix(nearest), path.endswith(nearest)
            if ending and base.strip("/"):
                act = f"Leave {base} out of the base URL: the nearest is {nearest}."
        detail = "This server has no such path."
        refused = Refused("not_found", detail, act=act)  # ERR-009
        await problem_response(refused)(scope, receive, send)

    def nearest(self, path: str) -> str:
        """A path of this server with the parameters of the given one; empty if none."""
        if len(path) > PATH_CHARS_MAX or path.count("/") > SEGMENTS_MAX:
            return ""
        sent = [segment for segment in path.split("/") if segment]
        # Without what stands before, as in a base URL that is too long.
        for start in range(len(sent)):
            for known in self._paths:
                if _fits(known, sent[start:]):
                    return _filled(known, sent[start:])
        candidates = [
            (likeness, _filled(known, sent))
            for known in self._paths
            if (likeness := _likeness(known, sent)) >= LIKENESS_MIN
        ]
        # And with what is missing before, as in a base URL that is too short.
        candidates += [
            (1.0, _filled(known, [*known[: len(known) - len(sent)], *sent]))
            for known in self._paths
            if len(known) > len(sent) and _fits(known[-len(sent) :], sent)
            and not any(map(_is_parameter, known[: len(known) - len(sent)]))
        ]  # fmt: skip
        return max(candidates, default=(0.0, ""))[1]


def _is_parameter(segment: str) -> bool:
    return segment.startswith("{")


def _fits(known: Sequence[str], sent: Sequence[str]) -> bool:
    """Whether the segments are those in letters of any size, one of them by name."""
    named = [segment for segment in known if not _is_parameter(segment)]
    return bool(named) and len(known) == len(sent) and all(
        _is_parameter(segment) or segment.lower() == part.lower()
        for segment, part in zip(known, sent, strict=True)
    )  # fmt: skip


def _likeness(known: Sequence[str], sent: Sequence[str]) -> float:
    """How alike the most different segments are, from 0 to 1; only one may differ."""
    if len(known) != len(sent):
        return 0.0
    differing = [
        (segment, part)
        for segment, part in zip(known, sent, strict=True)
        if not _is_parameter(segment) and segment != part
    ]
    if len(differing) != 1 or len(differing[0][1]) > 2 * len(differing[0][0]):
        return 0.0
    return difflib.SequenceMatcher(None, *differing[0]).ratio()


def _filled(known: Sequence[str], sent: Sequence[str]) -> str:
    """The path with the parameters that were sent; those that may not be shown stay."""
    parts = [
        part
        if _is_parameter(segment) and re.fullmatch(r"[\w.-]{1,64}", part)
        else segment
        for segment, part in zip(known, sent, strict=True)
    ]
    return "/" + "/".join(parts)
