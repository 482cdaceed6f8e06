"""The commands on runs and benchmarks, from submit to results and compare."""
