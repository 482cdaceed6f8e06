"""Simulators in processes of their own, and the pool that lends them."""
