"""Facts of a run that follow from its episodes: players, clipping, the return.

Servers without the profile `attribution` send none of them; then they are left out.
"""

from __future__ import annotations

import statistics
from collections import Counter
from collections.abc import Sequence
from typing import Any

from proctor_client import Episode, EpisodeResult, PlayerView

from reference_record.comparison.difference_evidence import (
    Evidence,
    weigh_differences,
)
from reference_record.comparison.sequential_comparison import (
    SequentialComparison,
    compare_sequentially,
)
from reference_record.counted_text import counted

Player = PlayerView | None
FAULTED_MAX = 5  # more names are left out


def compare_while_played(
    baseline: Sequence[Episode], run: Sequence[Episode]
) -> SequentialComparison:
    """Compare two runs while they are played; both are in the manifest's order."""
    sides = (
        [_succeeded(episode) for episode in episodes] for episodes in (baseline, run)
    )
    groups = [(f"split {episode.split}", f"task {episode.task}") for episode in run]
    return compare_sequentially(zip(*sides, strict=True), groups)


def evidence_of(baseline: Sequence[Episode], run: Sequence[Episode]) -> Evidence:
    """The evidence from the episodes that both runs have scored."""
    return weigh_differences(
        (theirs.task, _score(base.result), _score(theirs.result))
        for base, theirs in zip(baseline, run, strict=True)
        if base.result is not None and theirs.result is not None
    )


def _score(result: EpisodeResult) -> float:
    return 0.0 if result.outcome.value == "abandoned" else result.score


def _succeeded(episode: Episode) -> bool | None:
    result = episode.result
    return None if result is None else result.outcome.value == "success"


def players_of(episodes: Sequence[Episode]) -> list[dict[str, Any]]:
    """For JSON: each player with its number of scored episodes, the most first.

    `player` is None where none was declared, or several played an episode.
    """
    return [
        {"player": player and player.to_dict(), "episodes": number}
        for player, number in _counted(episodes)
    ]


def episode_facts(episodes: Sequence[Episode]) -> dict[str, str | None]:
    """Facts for a table; None where there is nothing to say."""
    results = [episode.result for episode in episodes if episode.result]
    return {
        "played by": played_by(episodes),
        "faults": faults_text(episodes),
        "return": _return(results),
        "clipped": _clipped(results),
    }


def faults_text(episodes: Sequence[Episode]) -> str | None:
    """`3 of the simulator, in 2 episodes: e0001, e0003`; None if there was none."""
    faulted = [episode for episode in episodes if episode.faults]
    if not faulted:
        return None
    names = [episode.episode_id for episode in faulted[:FAULTED_MAX]]
    more = len(faulted) - len(names)
    return (
        f"{sum(episode.faults for episode in faulted)} of the simulator, in "
        f"{counted(len(faulted), 'episode')}: {', '.join(names)}"
        + (f" and {more} more" if more else "")
    )


def played_by(episodes: Sequence[Episode]) -> str | None:
    """`hold with proctor-eval/0.1.0 (hold): 6 episodes; not declared: 2 episodes`."""
    players = _counted(episodes)
    if not players:
        return None
    return "; ".join(
        f"{label_of(player)}: {counted(number, 'episode')}"
        for player, number in players
    )


def label_of(player: Player) -> str:
    if player is None:
        return "not declared"
    version = f" {player.version}" if player.version else ""
    client = f" with {player.client}" if player.client else ""
    return f"{player.name}{version}{client}"


def _counted(episodes: Sequence[Episode]) -> list[tuple[Player, int]]:
    """Each player with its scored episodes; none if the server records no players."""
    results = [episode.result for episode in episodes if episode.result]
    if all(result.clipped_actions is None for result in results):
        return []
    by_label: dict[str, Player] = {}
    numbers: Counter[str] = Counter()
    for result in results:
        label = label_of(result.player)
        by_label.setdefault(label, result.player)
        numbers[label] += 1
    return [(by_label[label], number) for label, number in numbers.most_common()]


def _return(results: Sequence[EpisodeResult]) -> str | None:
    """The return of the episodes; None without rewards, or if it equals the score."""
    played = [r for r in results if r.outcome.value != "abandoned"]
    returns = [r.total_reward for r in played if r.total_reward is not None]
    if not any(returns) or all(r.total_reward == r.score for r in played):
        return None
    spread = statistics.stdev(returns) if len(returns) > 1 else 0.0
    return (
        f"mean {statistics.mean(returns):.4f}, standard deviation {spread:.4f}, over "
        f"{counted(len(returns), 'episode')}"
    )


def _clipped(results: Sequence[EpisodeResult]) -> str | None:
    clipped = [result for result in results if result.clipped_actions]
    if not clipped:
        return None
    actions = sum(result.clipped_actions or 0 for result in clipped)
    steps = sum(result.steps for result in results)
    where = f"{len(clipped)} of {counted(len(results), 'episode')}"
    return f"{actions} of {counted(steps, 'action')}, in {where}"
