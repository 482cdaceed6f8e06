"""Any program that can reset and step a world, as a benchmark; see spec/simulator.md.

`simulator_messages` has the messages, `supervisor` is the process that starts the
program and ends everything that it started, `program` exchanges frames with it,
`external_simulator` plays it, and `described_benchmark` makes a benchmark of its
`description`; `tried_tasks` plays the beginning of each task. `socket_address` is about
a program that the server does not start. `libraries` is for authors of programs:
nothing here imports it.
"""

from pathlib import Path

LIBRARIES = Path(__file__).with_name("libraries")
