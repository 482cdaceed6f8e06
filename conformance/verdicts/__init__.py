"""From observations to verdicts. Sends nothing."""
