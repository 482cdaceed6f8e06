"""Push mode: policy servers for a server under test, and the checks of policy servers.

`scripted_policy` and `scripted_chat` are called by a server under test; `python -m
conformance.policy` checks a policy server against policy.yaml.
"""
