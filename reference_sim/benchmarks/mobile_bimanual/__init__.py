"""Two arms on a base that drives: the benchmarks whose ids begin `mobile_bimanual`."""
