"""The other direction: this server calls the policy. See docs/push.md.

`driver` plays a run as workers do, `policy` speaks policy.yaml, `calls` is HTTP with
every bound that a stranger's server needs, `addresses` says where it may connect.
"""
