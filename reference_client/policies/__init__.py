"""Adapters for existing policies.

`policy_loader` loads the policy of a reference, `mapping` converts observations and
actions to a policy's names and shapes, `servers` has clients of policy servers,
`lerobot_policy` loads LeRobot's, `policy_http_app` is a policy server.
"""

from reference_client.errors import BadPolicy
from reference_client.policies.mapping import BadMapping, PolicyMapping
from reference_client.policies.policy_loader import load, read_mapping

__all__ = ["BadMapping", "BadPolicy", "PolicyMapping", "load", "read_mapping"]
