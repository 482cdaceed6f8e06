"""Meta-World's fifty tasks as a benchmark, in a virtual environment of its own.

Installed by `make metaworld`. `benchmark.toml` describes the benchmark; only `world.py`
imports Meta-World.
"""
