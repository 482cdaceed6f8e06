"""The other direction: a policy server of the kit's own, and a kit for yours.

`scripted` is what a judged server is given to call; `python -m conformance.policy`
judges a policy server by policy.yaml.
"""
