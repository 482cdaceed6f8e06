"""Policies that exist already: how one is named, loaded, and spoken to.

`source` loads what a reference names, `mapping` puts an observation into the words of
another house and its answer into ours, `openpi` speaks to a policy server.
"""

from reference_client.policies.mapping import BadMapping, Mapping
from reference_client.policies.policy_loader import BadPolicy, load

__all__ = ["BadMapping", "BadPolicy", "Mapping", "load"]
