"""Any Gymnasium environment as a benchmark; see docs/host/benchmarks.md.

`benchmark_file` parses the user's file, `environments` makes the environment (only this
module imports Gymnasium), `entries` converts its spaces, `simulator` plays it, `plan`
completes the benchmark from the environment, `check` tests it in its own process, and
`registration` starts that process and registers the benchmark.
"""

from __future__ import annotations


class BadBenchmark(ValueError):
    """The benchmark cannot be registered; the text says why, in one line."""
