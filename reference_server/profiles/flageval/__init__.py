"""The profile `flageval`: the API of FlagEval (spec/profiles/flageval.yaml)."""
