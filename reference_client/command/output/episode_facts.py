"""Facts of a run that follow from its episodes: players, clipping, the return.

Servers without the profile `attribution` send none of them; then they are left out.
"""

from __future__ import annotations

import statistics
from collections import Counter
from collections.abc import Sequence
from typing import Any

from proctor_client import Episode, EpisodeResult, PlayerView, Run

from reference_client.errors import as_sentence
from reference_record.comparison.difference_evidence import (
    Evidence,
    weigh_differences,
)
from reference_record.comparison.sequential_comparison import (
    SequentialComparison,
    compare_sequentially,
)
from reference_record.texts.counted_text import counted
from reference_record.texts.figures import figure
from reference_record.texts.left_reason import left_reason

Player = PlayerView | None
FAULTED_MAX = 5  # more names are left out
REASONS_MAX = 3


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


def split_means(
    baseline: Sequence[Episode], run: Sequence[Episode]
) -> dict[str, tuple[float, float]]:
    """Split → the means of baseline and run over what both have scored."""
    of_splits: dict[str, list[tuple[float, float]]] = {}
    for base, theirs in zip(baseline, run, strict=True):
        if base.result is not None and theirs.result is not None:
            scores = _score(base.result), _score(theirs.result)
            of_splits.setdefault(theirs.split, []).append(scores)
    return {
        split: (statistics.mean(before), statistics.mean(now))
        for split, scores in of_splits.items()
        for before, now in [zip(*scores, strict=True)]
    }


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


def episode_facts(
    episodes: Sequence[Episode], run: Run | None = None
) -> dict[str, str | None]:
    """Facts for a table; None where there is nothing to say."""
    results = [episode.result for episode in episodes if episode.result]
    return {
        **player_facts(episodes, run),
        "return": _return(results),
        "clipped": _clipped(results),
    }


def faults_text(episodes: Sequence[Episode], run: Run | None = None) -> str | None:
    """`3 of the simulator, in 2 episodes: e0001, e0003`; None if there was none.

    Void trials of a run on a robot are faults of episodes, and not of the robot.
    """
    faulted = [episode for episode in episodes if episode.faults]
    if not faulted:
        return None
    number = sum(episode.faults for episode in faulted)
    if run is not None and run.judged is not None:
        number -= sum(run.judged.voids.values())
        return f"{number} of the robot" if number else None
    names = _named([episode.episode_id for episode in faulted])
    return f"{number} of the simulator, in {names}"


def player_facts(episodes: Sequence[Episode], run: Run | None) -> dict[str, str | None]:
    """Who played, and what went wrong with whom: the simulator, the policy."""
    policy_faults = [(e.policy_fault, e) for e in episodes if e.policy_fault]
    left = [(reason, e) for e in episodes if (reason := _left_reason(e))]
    return {
        "played by": played_by(episodes, run),
        "faults": faults_text(episodes, run),
        **_reason_rows("policy fault", policy_faults),
        **_reason_rows("left by worker", left),
        "abandoned": _abandoned(episodes),
    }


def _reason_rows(
    what: str, given: Sequence[tuple[str, Episode]]
) -> dict[str, str | None]:
    """A row for each reason why attempts of episodes ended."""
    by_reason: dict[str, list[str]] = {}
    for reason, episode in given:
        by_reason.setdefault(reason, []).append(episode.episode_id)
    often = sorted(by_reason.items(), key=lambda row: -len(row[1]))
    rows: dict[str, str | None] = {}
    for number, (reason, ids) in enumerate(often[:REASONS_MAX], 1):
        name = f"{what} {number}" if len(often) > 1 else what
        rows[name] = f"{as_sentence(reason)} In {_named(ids)}"
    if (more := len(often) - REASONS_MAX) > 0:
        rows["and"] = counted(more, "more reason")
    return rows


def _left_reason(episode: Episode) -> str | None:
    return left_reason(episode.to_dict()) if episode.last_left else None


def _abandoned(episodes: Sequence[Episode]) -> str | None:
    """The abandoned episodes that no policy fault and no worker explains."""
    ids = [
        episode.episode_id
        for episode in episodes
        if episode.result
        and episode.result.outcome.value == "abandoned"
        and not episode.policy_fault
        and not episode.last_left
    ]
    if not ids:
        return None
    return (
        f"{_named(ids)}: in each attempt its worker detached, or was silent until its "
        "lease ended"
    )


def _named(ids: Sequence[str]) -> str:
    """`3 episodes: e0001, e0003, e0007`; long lists are cut."""
    more = len(ids) - FAULTED_MAX
    return (
        f"{counted(len(ids), 'episode')}: {', '.join(ids[:FAULTED_MAX])}"
        + f" and {more} more" * (more > 0)
    )


def played_by(episodes: Sequence[Episode], run: Run | None = None) -> str | None:
    """`hold with proctor-eval/0.1.0 (hold): 6 episodes; not declared: 2 episodes`.

    The policy of a push run has no client that could declare it.
    """
    if run is not None and run.mode == "push":
        number = sum(episode.result is not None for episode in episodes)
        called = f"{run.policy.name}, called by the server"
        return f"{called}: {counted(number, 'episode')}" if number else None
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
    if all(r.clipped_actions is None and r.player is None for r in results):
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
        f"mean {figure(statistics.mean(returns), 4)}, standard deviation "
        f"{figure(spread, 4)}, over {counted(len(returns), 'episode')}"
    )


def _clipped(results: Sequence[EpisodeResult]) -> str | None:
    clipped = [result for result in results if result.clipped_actions]
    if not clipped:
        return None
    actions = sum(result.clipped_actions or 0 for result in clipped)
    steps = sum(result.steps for result in results)
    where = f"{len(clipped)} of {counted(len(results), 'episode')}"
    return f"{actions} of {counted(steps, 'action')}, in {where}"
