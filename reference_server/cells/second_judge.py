"""The second judge: which episodes wait for him, and what he said of them.

All follows from the acts at the cells; no result of an episode does (PHY-028).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from reference_record.generated.answers import Rubric
from reference_server.cells import cell_rules
from reference_server.cells.act_log import ActLine, ActLog
from reference_server.rules.refusal import Refused


@dataclass(slots=True)
class JudgedEpisode:
    """An episode of a sample that was judged. benchmark_id: of its run.

    actors: the accounts that acted at a trial of it. is_judged_twice: the second
    judgement is there.
    """

    judgement_id: str
    benchmark_id: str
    run_id: str
    episode_id: str
    actors: set[str] = field(default_factory=set)
    is_judged_twice: bool = False


class SecondJudge:
    """The sample of every run, in the order of the first judgements."""

    def __init__(self, acts: ActLog) -> None:
        self._acts = acts
        self._lines_read = 0
        self._by_episode: dict[tuple[str, str], JudgedEpisode] = {}
        self._drawn: dict[str, JudgedEpisode] = {}

    def waiting_for(self, account: str) -> Iterator[JudgedEpisode]:
        """PHY-024, PHY-026: what the account may judge, the oldest first."""
        self._read_acts()
        for episode in self._drawn.values():
            if not episode.is_judged_twice and account not in episode.actors:
                yield episode

    def find(self, judgement_id: str, account: str) -> JudgedEpisode:
        """Raises Refused."""
        self._read_acts()
        episode = self._drawn.get(judgement_id)
        if episode is None or account in episode.actors:  # PHY-026
            raise Refused("not_found", "There is no such recording to judge.")
        return episode

    async def judge(
        self,
        episode: JudgedEpisode,
        account: str,
        rubric: Rubric,
        *,
        success: bool,
        met: Sequence[int],
        note: str,
    ) -> None:
        """Keep a second judgement, and change nothing else (PHY-028).

        Raises Refused and OSError.
        """
        refusal = cell_rules.refuse_criteria(met, rubric)
        if refusal is not None:
            raise Refused.from_verdict(refusal)
        if episode.is_judged_twice:
            raise Refused(
                "illegal_transition",
                "The recording has its second judgement; nothing was changed.",
                requirement="PHY-027",
            )
        self._acts.add(
            act="second_judge",
            operator=account,
            benchmark=episode.benchmark_id,
            run=episode.run_id,
            episode=episode.episode_id,
            success=success,
            score=cell_rules.score_of(success, met, rubric),
            met=sorted(set(met)),
            note=note,
        )
        self._read_acts()
        await self._acts.flush()

    def _read_acts(self) -> None:
        lines = self._acts.lines
        for line in lines[self._lines_read :]:
            self._read_act(line)
        self._lines_read = len(lines)

    def _read_act(self, line: ActLine) -> None:
        if "run" not in line:
            return
        run_id, episode_id = line["run"], line["episode"]
        episode = self._by_episode.get((run_id, episode_id))
        if episode is None:
            episode = self._by_episode[run_id, episode_id] = JudgedEpisode(
                self._acts.second_id(run_id, episode_id),
                line.get("benchmark", line.get("cell", "")),
                run_id,
                episode_id,
            )
        if line["act"] == "second_judge":
            episode.is_judged_twice = True
            return
        if "operator" in line:
            episode.actors.add(line["operator"])
        if line["act"] == "judge" and line.get("drawn"):
            self._drawn[episode.judgement_id] = episode
