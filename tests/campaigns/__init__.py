"""Campaigns against the reference server, while clients of other accounts use it.

`python -m tests.campaigns attack` attacks one server from outside (`attacks/`),
`python -m tests.campaigns chaos` breaks a cluster of nodes again and again (`chaos/`),
`python -m tests.campaigns soak` breaks a host while policies are handed in (`soak/`).
They share the clients that use the server meanwhile (`players/`): `watcher.py` plays
runs and times each request, `run_history.py` holds what was asked and answered,
`invariants.py` and `records.py` compare this with what the server says and records.
`promises.py` gives the verdicts, which `campaign_page.py` writes into build/attack.md,
build/chaos.md and build/soak.md.

All traffic is on the loopback interface, and random choices follow from one seed.
"""
