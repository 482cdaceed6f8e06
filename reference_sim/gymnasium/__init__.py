"""Any Gymnasium environment as a benchmark; see docs/host/benchmarks.md.

`benchmark_file` reads what the user wrote, `environments` makes the environment (and is
alone in importing Gymnasium), `entries` translates its spaces, `simulator` plays it,
`check` looks for its faults in a process of its own, `registration` starts that process
and describes the benchmark.
"""

from __future__ import annotations


class BadBenchmark(ValueError):
    """It cannot be offered; the text says which, where and why, in one line."""
