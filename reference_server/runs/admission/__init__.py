"""Which runs may be played: places, the queue, quotas, and what waits elsewhere."""
