"""What several checks share: given states, samples, generated requests."""
