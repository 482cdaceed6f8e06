"""One arm with a gripper, one table: the benchmarks `tabletop`, `tabletop_state`."""
