"""Mappings between the benchmark's names and those of a policy, from TOML files.

`members` has the type and the range of each member, and refuses others; `request_entry`
makes the request of an observation, `policy_answer` finds the rows of numbers in an
answer, `unread_numbers` notes those that are not read, `action_vector` makes vectors of
them, and `policy_mapping` is the whole file.
"""

from reference_client.policies.mapping.action_vector import ActionVector
from reference_client.policies.mapping.members import BadMapping
from reference_client.policies.mapping.policy_answer import (
    InvalidPolicyAnswer,
    NoNumbers,
)
from reference_client.policies.mapping.policy_mapping import Node, PolicyMapping
from reference_client.policies.mapping.request_entry import RequestEntry

__all__ = [
    "ActionVector",
    "BadMapping",
    "InvalidPolicyAnswer",
    "NoNumbers",
    "Node",
    "PolicyMapping",
    "RequestEntry",
]
