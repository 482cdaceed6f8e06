"""The profile `ebench`: the API of EBench (spec/profiles/ebench.yaml)."""
