"""Campaigns against the reference server, while clients of other accounts use it.

`python -m tests.campaigns attack` attacks one server from outside (`attacks/`),
`python -m tests.campaigns chaos` breaks a cluster of nodes again and again (`chaos/`).
Both share what is here: `watcher.py` plays runs and times each request, `history.py`
holds what was asked and answered, `invariants.py` and `records.py` compare this with
what the server says and records, `promises.py` gives the verdicts, and `page.py` writes
them into build/attack.md and build/chaos.md.

All traffic is on the loopback interface, and random choices follow from one seed.
"""
