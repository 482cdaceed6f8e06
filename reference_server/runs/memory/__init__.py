"""Facts that are kept in memory beside the runs: nothing here awaits or stores."""
