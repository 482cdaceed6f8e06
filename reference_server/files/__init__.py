"""Files that their owner alone may read."""
