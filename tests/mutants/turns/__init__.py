"""Mutants of sessions and turns, and of the simulator behind them."""
