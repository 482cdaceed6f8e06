"""`python -m tests.campaigns chaos`: break a cluster while it is used, and judge it.

With --long, each fault is made as often as promised. What was played on this commit is
not played again, so a long campaign that is started again goes on where it ended;
several that are started at once, each with another seed, share their rounds.
"""

from __future__ import annotations

import argparse
import itertools
import os
import sys

from tests.campaigns.chaos import chaos_report as report
from tests.campaigns.chaos.chaos_campaign import OWN_DISKS, Campaign
from tests.campaigns.chaos.chaos_faults import HOSTS, LINKS, RAY, faults_of
from tests.campaigns.chaos.chaos_rounds import Counts, KeptRounds, faults_to_play
from tests.campaigns.promises import percentile
from tests.support.network import hosts
from tools.built_pages import BUILD
from tools.measurements.git_commit import read_commit

LOGS = BUILD / "chaos-logs"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--rounds", type=int, default=100, metavar="N")
    parser.add_argument("--first", type=int, default=0, help="number of the first one")
    parser.add_argument("--players", type=int, default=6)
    parser.add_argument("--lease-s", type=float, default=2.0, help="of nodes")
    parser.add_argument(
        "--simulators",
        choices=["local", "ray"],
        default="local",
        help="processes of the nodes, or on a Ray cluster whose machines fail, too",
    )
    parser.add_argument(
        "--network",
        choices=[HOSTS, LINKS],
        help="hosts in network namespaces, or links on this machine; the first where "
        "the machine lets it",
    )
    parser.add_argument(
        "--own-disks",
        action="store_true",
        help="hosts record to their own disks, not to a folder that they share",
    )


def run(options: argparse.Namespace, names: list[str]) -> bool:
    """Play rounds of these faults; whether every promise was kept."""
    kinds = _kinds(options)
    if HOSTS in kinds and not hosts.is_inside():
        command = [sys.executable, "-m", "tests.campaigns", *sys.argv[1:]]
        return hosts.run_inside([*command, "--network", HOSTS]) == 0
    names = [name for name in names if name in faults_of(kinds)]
    if not names:
        raise SystemExit(f"a cluster with {', '.join(kinds)} has none of these faults")
    kept = _kept_rounds(options)
    _play(options, names, kept)
    kept.refresh()
    print(report.summary(kept.rounds), *report.judge_all(kept.rounds), sep="\n")
    seeds = ", ".join(map(str, sorted({played.seed for played in kept.rounds})))
    conditions = (
        f"seeds {seeds}, {options.players} players and one of runs that nodes play, "
        f"lease {options.lease_s:g} s, load before half of the rounds "
        f"{percentile(kept.loads, 0.5):.1f} or less"
    )
    report.write(kept.rounds, conditions)
    return not any(played.findings for played in kept.rounds)


def _kinds(options: argparse.Namespace) -> set[str]:
    """The kinds of the cluster; says why it has no hosts, where it could have."""
    if options.simulators == "ray":
        return {RAY, LINKS}
    reason = "" if options.network == LINKS or hosts.is_inside() else hosts.why_none()
    if options.network == HOSTS and reason:
        raise SystemExit(reason)
    if options.network == LINKS or reason:
        print(f"links on this machine, no hosts: {reason or 'as asked for'}")
        return {LINKS}
    return {HOSTS, OWN_DISKS} if options.own_disks else {HOSTS}


def _play(options: argparse.Namespace, names: list[str], kept: KeptRounds) -> None:
    """Rounds of one cluster, until enough were played."""
    with Campaign.open(
        seed=options.seed,
        players=options.players,
        lease_s=options.lease_s,
        kinds=_kinds(options),
    ) as campaign:
        before = Counts()
        for number in itertools.count(options.first + kept.played_with(options.seed)):
            kept.refresh()
            chosen = names
            if options.long:
                chosen = [n for n in faults_to_play(kept.rounds) if n in names]
            is_over = number >= options.first + options.rounds and not options.long
            if is_over or not chosen:
                break
            load = os.getloadavg()[0]
            played = campaign.play(number, chosen)
            played.seed = options.seed
            played.counts, before = campaign.counts() - before, campaign.counts()
            kept.add(played, load)
            print(report.round_line(played), flush=True)
            if played.findings:
                _keep_logs(campaign, f"seed{options.seed}-round{number}")


def _keep_logs(campaign: Campaign, name: str) -> None:
    """Write the logs of the nodes until a finding into build/chaos-logs/."""
    LOGS.mkdir(parents=True, exist_ok=True)
    for node, log in enumerate(campaign.logs()):
        (LOGS / f"{name}-node{node}.log").write_text(log)


def _kept_rounds(options: argparse.Namespace) -> KeptRounds:
    """Those of earlier starts of the same long campaign, else none."""
    if not options.long:
        return KeptRounds({}, file=None)
    commit, _ = read_commit()
    names = ("players", "lease_s", "only", "simulators", "network", "own_disks")
    chosen = {name: getattr(options, name) for name in names}
    return KeptRounds({"commit": commit, **chosen})
