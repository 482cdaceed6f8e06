"""Two arms on a mobile base: the benchmarks whose ids begin with `mobile_bimanual`."""
