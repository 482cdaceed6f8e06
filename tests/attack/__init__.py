"""Attacks on the reference server, while clients of other accounts watch it.

`python -m tests.attack` runs them all and judges the server by the promises of
`promises.py`. An attack (`attack.py`) is a small module in attacks/: what it sends, its
bound, and a function. The watchers (`watcher.py`) play runs of other accounts meanwhile
and time their requests; `server_usage.py` reads memory, descriptors and threads of the
server; `invariants.py` compares what the server says with what the watchers saw.

All traffic is on the loopback interface, and random choices follow from one seed.
"""
