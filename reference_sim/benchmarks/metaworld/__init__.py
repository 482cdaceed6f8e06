"""Meta-World's fifty tasks as a benchmark; needs an environment of its own: `make
metaworld`. `benchmark.toml` describes it, `world` is alone in importing Meta-World."""
