"""What must hold of every watched run, by this side's own arithmetic.

What was acknowledged exists once and as it was; what was commanded is what was scored;
steps are turns; attempts and faults are charged to no run; the score of a completed run
is the mean of its results. It knows the protocol's answers, and nothing of the server.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Any

from tests.campaigns.players.raw_client import RawClient
from tests.campaigns.players.run_history import History


def check_histories(
    client: RawClient, histories: Iterable[History], *, is_fault_expected: bool = False
) -> list[str]:
    """Sentences about what does not hold; empty when all does."""
    return [
        f"run {history.run_id}: {found}"
        for history in histories
        for found in _check_run(client, history, is_fault_expected)
    ]


def _check_run(
    client: RawClient, history: History, is_fault_expected: bool
) -> Iterator[str]:
    episodes = _list_episodes(client, history.run_id)
    if [one["index"] for one in episodes] != list(range(history.episodes)):
        yield f"has {len(episodes)} episodes of {history.episodes}"
        return
    for episode in episodes:
        index, result = episode["index"], episode.get("result")
        acknowledged = history.acknowledged.get(index)
        if acknowledged is not None and acknowledged != result:
            yield f"episode {index} was {acknowledged} and is {result}"
        if result is not None:
            seen = (result["score"], result["steps"])
            if seen != history.expected.get(index):
                expected = history.expected.get(index)
                yield f"episode {index}: {seen} is scored, {expected} was played"
        if episode["attempt"] > 1:
            yield f"episode {index} is charged an attempt"
        if episode["faults"] and not is_fault_expected:
            yield f"episode {index} is charged {episode['faults']} faults"
    yield from _check_score(client, history, episodes)


def _check_score(
    client: RawClient, history: History, episodes: list[dict[str, Any]]
) -> Iterator[str]:
    score = client.request("GET", f"/v1/runs/{history.run_id}/score").json()
    scored = [one["result"]["score"] for one in episodes if one.get("result")]
    if history.is_done and len(scored) < history.episodes:
        yield f"was done with {len(scored)} of {history.episodes} results"
    if score["complete"] != (len(scored) == history.episodes):
        yield f"complete is {score['complete']} with {len(scored)} results"
    mean = math.fsum(scored) / history.episodes
    if score["complete"] and abs(score["score"] - mean) > 1e-12:
        yield f"its score is {score['score']} and not {mean}"


def _list_episodes(client: RawClient, run_id: str) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = []
    cursor = ""
    while True:
        page = client.request("GET", f"/v1/runs/{run_id}/episodes{cursor}").json()
        found += page["episodes"]
        if not page["next_cursor"]:
            return found
        cursor = f"?cursor={page['next_cursor']}"
