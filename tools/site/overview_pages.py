"""The pages that no file of the repository holds: start, pictures, numbers, verdicts.

Texts are read from spec/ where it has them; the others are written here.
"""

import json
from typing import Any

from conformance.specification.document import SPEC_DIRECTORY, load_spec
from conformance.specification.ledger import OF_OTHER_PROGRAMS, PROFILES
from conformance.specification.rule_documents import rule_documents
from tools.diagrams import lifecycle_diagram, lifecycle_table
from tools.site.kit_reports import KitReports
from tools.site.markdown import picture, table
from tools.site.rule_pages import exchange_text
from tools.traceability import ROOT, traces

VECTORS = ROOT / "spec" / "vectors"


def pages(reports: KitReports) -> dict[str, str]:
    """Path → text."""
    return {
        "index.md": start_page(reports),
        "how-it-works.md": how_it_works_page(),
        "scoring-examples.md": scoring_page(),
        "calibration-examples.md": calibration_page(reports),
        "implementations.md": implementations_page(reports),
    }


def start_page(reports: KitReports) -> str:
    """The entry, with the contents of the site."""
    spec = load_spec()
    summary = [
        ["rules", f"[{len(traces())}](rules/index.md)"],
        ["operations", f"[{len(spec.operations)}](operations/index.md)"],
        ["codes of refusals", f"[{len(spec.problems)}](operations/problems.md)"],
        ["profiles", str(len(PROFILES))],
        ["judged servers", f"[{len(reports.verdicts)}](implementations.md)"],
    ]
    documents = "\n".join(
        path.relative_to(ROOT).with_suffix("").as_posix()
        for path in rule_documents(SPEC_DIRECTORY)
    )
    return f"""# Proctor {spec.version}

Proctor is an open HTTP protocol for evaluating robot policies. A server owns the
benchmark, the simulator, the clock and the score; a policy, in any language, connects
to it. A kit judges any server by its answers alone.

{table(["", "in this version"], summary)}
## Where to begin

- You **evaluate a policy**: [the command `proctor`](docs/evaluate/command.md).
- You **write a server**: [the overview](spec/overview.md), then
  [write a server](docs/implement/write-a-server.md), then
  [certify it](docs/implement/conformance.md).
- You **write a client**: [clients](docs/implement/clients.md).
- You **read a number**: [scoring](spec/scoring.md),
  [records](docs/evaluate/records.md).
- You **look up a word**: [glossary](docs/glossary.md).

```{{toctree}}
:hidden:
:caption: The standard

spec/README
spec/overview
how-it-works
{documents}
scoring-examples
calibration-examples
rules/index
operations/index
spec/security
spec/extensions
spec/registry/README
spec/VERSIONING
spec/CONFORMANCE
spec/CHANGELOG
implementations
```

```{{toctree}}
:hidden:
:caption: Guides

docs/README
docs/glossary
```
"""


def how_it_works_page() -> str:
    """The life of a run as a picture and as a table."""
    lifecycle = load_spec().lifecycle
    return f"""# How it works

## The life of a run

A client asks for one evaluation of one policy on one benchmark (`submit_run`). The run
waits for capacity, is played, and ends with a score. What is scored is kept, whatever
happens in between.

{picture(lifecycle_diagram(lifecycle))}

Every cell of the table is a rule of the area [LIFE](rules/LIFE.md); – is a refusal with
`illegal_transition`, an empty cell cannot happen.

{lifecycle_table(lifecycle)}

## A session, a turn, an episode

[The overview](spec/overview.md#who-talks-to-whom) shows them as pictures: who talks to
whom, what happens to a turn whose answer is lost, and what changes the state of a
session, an episode and an attempt. Rules: [attach](rules/ATT.md),
[turns](rules/PRED.md), [leases](rules/LEASE.md), [detach](rules/DET.md).
"""


def scoring_page() -> str:
    """The scoring vectors with their numbers."""
    lines = [
        (
            "# Scoring with numbers\n\nEpisodes in, score out: the examples of "
            "`spec/vectors/scoring/`, which any implementation can run. The formulas "
            "are those of [scoring](spec/scoring.md).\n"
        )
    ]
    for path in sorted((VECTORS / "scoring").glob("*.json")):
        vector = json.loads(path.read_text())
        lines += [f"## {path.stem.replace('_', ' ')}\n", *_vector(vector)]
    return "\n".join(lines)


def _vector(vector: dict[str, Any]) -> list[str]:
    lines = [f"{vector['description']}\n"] if "description" in vector else []
    rows = [
        [str(number), *(f"{one.get(key, '–')}" for key in EPISODE)]
        for number, one in enumerate(vector["episodes"])
    ]
    if len(rows) > ROWS_SHOWN:
        rows = [*rows[:ROWS_SHOWN], ["…", *("" for _ in EPISODE)]]
    lines.append(table(["episode", *EPISODE], rows))
    score = vector.get("score", vector.get("expected", {}))
    shown = [[f"`{key}`", _number(score[key])] for key in NUMBERS if key in score]
    lines.append(table(["member of the score", "value"], shown))
    return lines


EPISODE = ("task", "split", "outcome", "score")
NUMBERS = (
    *("complete", "counts", "score", "score_low", "score_high", "mean"),
    *("mean_interval", "success_rate", "success_interval"),
)
ROWS_SHOWN = 10


def _number(value: Any) -> str:
    if isinstance(value, dict):
        return ", ".join(f"{key} {item}" for key, item in value.items())
    return json.dumps(value)


def calibration_page(reports: KitReports) -> str:
    """Exchanges of the rules on the benchmark `calibration`."""
    lines = [
        (
            "# Calibration with messages\n\nWhat a server with the benchmark "
            "[calibration](spec/calibration.md) answers, recorded from the reference "
            "server.\n"
        )
    ]
    for id_, found in reports.exchanges.items():
        if id_.startswith("CAL-") and id_ in traces():
            lines += [f"## {id_}\n", f"{traces()[id_].rule.text}\n"]
            lines += [exchange_text(found[0])]
    return "\n".join(lines)


def implementations_page(reports: KitReports) -> str:
    """Who was judged, and with what result."""
    judged = reports.verdicts
    lines = [
        (
            "# Implementations\n\nServers that the kit has judged by all of its rules. "
            "What a claim of conformance says is in "
            "[conformance](spec/CONFORMANCE.md).\n"
        )
    ]
    rows = [
        [
            name,
            f"`{one['server']}`",
            one["specification"],
            one["date"],
            f"**{one['conclusion']}**: {one['headline']}",
        ]
        for name, one in judged.items()
    ]
    head = ["implementation", "announces itself as", "specification"]
    lines.append(table([*head, "judged", "verdict"], rows))
    profiles = sorted({trace.rule.profile for trace in traces().values()})
    rows = [
        [f"`{profile}`", *(_share(one["rules"], profile) for one in judged.values())]
        for profile in profiles
        if profile not in OF_OTHER_PROGRAMS
    ]
    lines += ["## By profile\n\nRules verified, of those that apply.\n"]
    lines.append(table(["profile", *judged], rows))
    return "\n".join(lines)


def _share(outcomes: dict[str, str], profile: str) -> str:
    found = [
        outcomes[trace.rule.id]
        for trace in traces().values()
        if trace.rule.profile == profile and trace.rule.id in outcomes
    ]
    applying = [one for one in found if one != "not_applicable"]
    if not applying:
        return "–"
    return f"{applying.count('passed')} of {len(applying)}"
