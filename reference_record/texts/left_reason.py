"""The reason why a worker has left an episode, where it explains how an attempt ended.

A worker, or one that took the episode over, may have played on to a result: then the
reason explains nothing of what a reader sees.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


def left_reason(episode: Mapping[str, Any]) -> str | None:
    """The reason in `last_left` of an item of `list_episodes`; None without one."""
    left, result = episode.get("last_left"), episode.get("result") or {}
    if not left:
        return None
    has_played = result.get("outcome", "abandoned") != "abandoned"
    if has_played and result["attempt"] == left["attempt"]:
        return None
    return str(left["reason"])
